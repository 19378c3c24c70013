//! Every OBJ file that the tests know, read by the program and by tobj: the corners of all triangles are the same numbers.
//!
//! tobj keeps no numbers of vertices, so corners are compared by their coordinates, triangle by triangle in the order of the
//! file. Where the two differ, it is said here: tobj is given lines as it knows them, triangles with a repeated corner, which
//! the program leaves out, are left out of what it found, and files that are read otherwise are named.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use cardiomorph::io::{Limits, read_mesh, write_obj};
use cardiomorph::study::built_in::{BuiltInParams, cohort};

use crate::shared::shared;

type Triangle = [[f64; 3]; 3];

/// Triangles in the order of the file, by the program.
fn own(bytes: &[u8]) -> Result<Vec<Triangle>, String> {
    let file = read_mesh("a.obj", bytes, &Limits::default()).map_err(|error| error.to_string())?;
    let mesh = &file.frames[0];
    let corner = |v: u32| mesh.vertices()[v as usize].coords.into();
    Ok((mesh.triangles().iter().map(|t| t.map(corner))).collect())
}

/// Triangles in the order of the file, by tobj; objects and groups follow one another.
fn of_tobj(bytes: &[u8]) -> Result<Vec<Triangle>, String> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..tobj::LoadOptions::default()
    };
    let text = with_lines_of_tobj(bytes);
    let no_materials = |_: &Path| Ok(Default::default());
    let (models, _) = tobj::load_obj_buf(&mut text.as_bytes(), &options, no_materials)
        .map_err(|error| error.to_string())?;
    let mut found = Vec::new();
    for tobj::Model { mesh, .. } in &models {
        let corner = |v: u32| -> [f64; 3] {
            let at = 3 * v as usize;
            mesh.positions[at..at + 3].try_into().unwrap()
        };
        let triangles = mesh.indices.chunks_exact(3).map(|t| [t[0], t[1], t[2]]);
        let whole = triangles.filter(|[a, b, c]| a != b && b != c && a != c);
        found.extend(whole.map(|t| t.map(corner)));
    }
    Ok(found)
}

/// The text with lines that tobj knows: it takes a lone carriage return, as old Macs write it, for a space, joins no lines at
/// a backslash, and takes a comment behind a face for corners.
fn with_lines_of_tobj(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).replace("\r\n", "\n");
    let text = text.replace('\r', "\n");
    let mut lines = String::new();
    for line in text.lines() {
        let line = line.split('#').next().unwrap_or_default().trim_end();
        match line.strip_suffix('\\') {
            Some(part) => lines += &format!("{part} "),
            None => lines += &format!("{line}\n"),
        }
    }
    lines
}

fn assert_alike(bytes: &[u8], what: &str) {
    let own = own(bytes).unwrap_or_else(|error| panic!("{what}: {error}"));
    let other = of_tobj(bytes).unwrap_or_else(|error| panic!("{what}, tobj: {error}"));
    assert_eq!(own.len(), other.len(), "triangles of {what}");
    let apart = own.iter().zip(&other).position(|(a, b)| a != b);
    if let Some(at) = apart {
        panic!("{what}, triangle {at}: {:?}, tobj {:?}", own[at], other[at]);
    }
}

/// All OBJ files in a folder and those in it, sorted. A link to nowhere is no file.
fn obj_files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(obj_files(&path));
        } else if path.extension().is_some_and(|ending| ending == "obj") && path.exists() {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Files of the cases with coordinates that are no numbers: refused by the program, not all of them by tobj.
const REFUSED: [&str; 2] = ["ok_obj_nan", "obj_msvc_ind"];
/// Compares all files of a folder and returns how many agree.
fn all_alike(folder: &Path) -> usize {
    let (mut alike, mut refused) = (0, BTreeSet::<&str>::new());
    let files = obj_files(folder);
    for path in &files {
        let what = path.display().to_string();
        let bytes = fs::read(path).unwrap();
        let is_one_of = |names: &[&str]| names.iter().any(|name| what.contains(name));
        if is_one_of(&REFUSED) && own(&bytes).is_err() {
            // Other frames of such a case are whole, and read like all others.
            refused.extend(REFUSED.iter().filter(|name| what.contains(**name)));
        } else {
            assert_alike(&bytes, &what);
            alike += 1;
        }
    }
    for name in REFUSED {
        let is_there = files
            .iter()
            .any(|path| path.display().to_string().contains(name));
        assert!(
            !is_there || refused.contains(name),
            "{name} is no longer refused"
        );
    }
    alike
}

#[test]
fn files_of_other_programs_and_of_oracles_are_read_as_by_tobj() {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let alike = all_alike(&tests);
    assert!(alike >= 50, "{alike} files");
}

#[test]
fn whatever_the_format_allows_is_read_as_by_tobj() {
    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    for faces in [
        "f 1 2 3 4\n",
        "v 0.5 1.5 0\nf 1 2 3 5 4\n",
        "f -4 -3 -2\nf -4 -2 -1\n",
        "vt 0 0\nvn 0 0 1\nf 1/1 2/1 3/1\nf 1//1 3//1 4//1\nf 1/1/1 3/1/1 4/1/1\n",
        "p 1\nl 1 2\nf 1 2 3\n",
        "f 1 2 2\nf 1 1 2 3\nf 1 2 3\n",
        "o one\nf 1 2 3\no two\nf 3 4 1\ng three\nf 2 3 4\n",
        "v 1e-3 -2.5E+2 0.5 1\nf 3 4 5\n",
        "f 1 2 \\\n3 4\n",
        "f 1 2 3 # a triangle\nusemtl red\ns off\nf 1 3 4\n",
    ] {
        assert_alike(format!("{SQUARE}{faces}").as_bytes(), faces);
    }
    let coloured = "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n";
    assert_alike(coloured.as_bytes(), "coloured vertices");
    let old_mac = format!("{SQUARE}f 1 2 3\n").replace('\n', "\r");
    assert_alike(old_mac.as_bytes(), "lines of old Macs");
}

#[test]
fn what_the_program_writes_is_read_as_by_tobj() {
    let params = BuiltInParams {
        vertices: 400,
        ..BuiltInParams::default()
    };
    for subject in &cohort(&params).unwrap().study.subjects {
        for surface in subject.sequence.surfaces() {
            for mesh in surface.frames() {
                let mut bytes = Vec::new();
                write_obj(&mut bytes, mesh).unwrap();
                assert_alike(&bytes, &subject.id);
            }
        }
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn real_hearts_and_odd_files_are_read_as_by_tobj() {
    let real = all_alike(&shared("data"));
    assert!(real >= 800, "{real} files");
    let odd = all_alike(&shared("cases"));
    assert!(odd >= 80, "{odd} files");
    let oracles = all_alike(&shared("oracles"));
    assert!(oracles >= 50, "{oracles} files");
}
