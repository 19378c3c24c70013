//! Damaged files: each mistake has its line or byte, and no cut makes a panic.

use std::fs;
use std::path::Path;

use super::error;
use crate::io::{Limits, ReadMeshError, mesh_format_names, read_mesh};

fn error_with(name: &str, bytes: &[u8], limits: &Limits) -> String {
    read_mesh(name, bytes, limits).unwrap_err().to_string()
}

fn fixture(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/formats");
    fs::read(folder.join(name)).unwrap()
}

/// A fixture with one text replaced by another.
fn with(name: &str, from: &str, to: &str) -> Vec<u8> {
    let bytes = fixture(name);
    let at = bytes
        .windows(from.len())
        .position(|window| window == from.as_bytes())
        .unwrap_or_else(|| panic!("{name} holds no {from:?}"));
    [&bytes[..at], to.as_bytes(), &bytes[at + from.len()..]].concat()
}

#[test]
fn obj_errors_name_the_line() {
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let cases = [
        (
            "f 1 2 9041",
            "line 4: face refers to vertex 9041, but only 3 are defined",
        ),
        (
            "f 1 2 0",
            "line 4: face refers to vertex 0, but vertices count from 1",
        ),
        (
            "f 1 2 -4",
            "line 4: face refers to vertex -4, but only 3 are defined before it",
        ),
        ("f 1 2 x", "line 4: \"x\" is not a whole number"),
        ("v 1 nan 0", "line 4: coordinate NaN is not a finite number"),
        (
            "v 1 1e999 0",
            "line 4: coordinate inf is not a finite number",
        ),
        ("v 1 2", "line 4: 2 coordinates, but 3 are needed"),
        ("v 1 2 3 4 5", "line 4: vertex has 5 numbers"),
        ("x 1 2 3", "line 4: unknown keyword \"x\""),
        ("# no face", "holds no triangles"),
    ];
    for (line, expected) in cases {
        assert_eq!(error("a.obj", format!("{triangle}{line}\n")), expected);
    }
    let ahead = "f 1 2 3\nf 1 2 5\nf 1 2 4\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
    assert_eq!(
        error("a.obj", ahead),
        "line 2: face refers to vertex 5, but only 3 are defined"
    );
}

#[test]
fn ply_errors_name_line_or_byte() {
    let text = |body: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
             property float z\nelement face 1\nproperty list uchar int vertex_indices\n\
             end_header\n{body}"
        )
    };
    let cases = [
        (
            "0 0 0\n1 0 0\n0 1 0\n3 0 1 3",
            "line 13: face refers to vertex 3, but there are only 3, counted from 0",
        ),
        (
            "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1",
            "line 13: -1 is not the index of a vertex",
        ),
        (
            "0 0 0\n1 0 0\n0 1 0\n3 0 1",
            "line 13: fewer numbers than the header announces",
        ),
        (
            "0 0 0\n1 0 0 7\n0 1 0\n3 0 1 2",
            "line 11: more numbers than the header announces",
        ),
        (
            "0 0 0\n1 inf 0\n0 1 0\n3 0 1 2",
            "line 11: coordinate inf is not a finite number",
        ),
        (
            "0 0 0\n1 0 0",
            "line 11: the file ends where an element \"vertex\" is expected",
        ),
    ];
    for (body, expected) in cases {
        assert_eq!(error("a.ply", text(body)), expected);
    }
    let header = text("");
    assert_eq!(
        error("a.ply", header.replace("vertex 3", "vertex 4000000000")),
        "4000000000 vertices; the limit is 5000000"
    );
    let binary = fixture("ply_vtk_binary.ply");
    let cut = binary.len() - 2;
    assert_eq!(
        error("a.ply", &binary[..cut]),
        format!(
            "byte {}: a number needs 4 bytes, but only 2 are left",
            cut - 2
        )
    );
}

#[test]
fn stl_errors_name_line_or_byte() {
    let text = |vertex: &str| {
        format!(
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n{vertex}\n\
             endloop\nendfacet\nendsolid a\n"
        )
    };
    assert_eq!(
        error("a.stl", text("vertex 0 -nan 0")),
        "line 6: coordinate NaN is not a finite number"
    );
    assert_eq!(
        error("a.stl", text("")),
        "line 8: a facet has 2 vertices, but needs 3"
    );
    assert_eq!(
        error("a.stl", text("vertex 0 1 0\nvortex")),
        "line 7: unknown keyword \"vortex\""
    );
    assert_eq!(
        error("a.stl", text("vertex 0 1 0").replace("endsolid a\n", "")),
        "line 8: the file ends within a solid"
    );
    let binary = fixture("stl_vtk_binary.stl");
    assert_eq!(
        error("a.stl", &binary[..150]),
        "byte 134: a triangle needs 50 bytes, but only 16 are left"
    );
    let mut not_finite = binary;
    not_finite[84 + 12..84 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_eq!(
        error("a.stl", not_finite),
        "byte 96: coordinate NaN is not a finite number"
    );
}

#[test]
fn vtk_errors_name_line_or_byte() {
    let cases = [
        (
            with("vtk_ascii_4_2.vtk", "3 1 2 4", "3 1 2 6"),
            "line 18: face refers to vertex 6, but there are only 6, counted from 0",
        ),
        (
            with("vtk_ascii_4_2.vtk", "POLYGONS 8 32", "POLYGONS 8 31"),
            "line 24: cells hold more than 31 numbers",
        ),
        (
            with("vtk_ascii_4_2.vtk", "POLYDATA", "STRUCTURED_GRID"),
            "line 4: \"DATASET STRUCTURED_GRID\" is not DATASET POLYDATA or DATASET UNSTRUCTURED_GRID",
        ),
        (
            with("vtk_ascii_5_1.vtk", "0 3 6 9", "0 3 2 9"),
            "line 18: offset 2 is not between 3 and 24",
        ),
        (
            with("vtk_ascii_5_1.vtk", "2.125", "2,125"),
            "line 14: \"2,125\" is not a number",
        ),
        (
            with(
                "vtk_grid_ascii_5_1.vtk",
                "CELL_TYPES 6\n5",
                "CELL_TYPES 6\n10",
            ),
            "line 16: cell type 10 is not a flat surface (triangle, strip, polygon, pixel or quad)",
        ),
    ];
    for (bytes, expected) in cases {
        assert_eq!(error("a.vtk", bytes), expected);
    }
    let mut binary = fixture("vtk_binary_4_2.vtk");
    let points = binary.windows(7).position(|w| w == b"double\n").unwrap();
    let start = binary[points + 7..]
        .windows(7)
        .position(|w| w == b"double\n")
        .unwrap()
        + points
        + 14;
    binary[start..start + 8].copy_from_slice(&f64::INFINITY.to_be_bytes());
    assert_eq!(
        error("a.vtk", binary),
        format!("byte {start}: coordinate inf is not a finite number")
    );
}

#[test]
fn vtp_errors_name_line_or_byte() {
    let ascii = "vtp_ascii.vtp";
    let text = String::from_utf8(fixture(ascii)).unwrap();
    let line_of = |needle: &str| {
        let at = text.find(needle).unwrap();
        text[..=at].lines().count()
    };
    assert_eq!(
        error("a.vtp", with(ascii, "0 0 2.125", "0 0 nan")),
        format!(
            "line {}: coordinate NaN is not a finite number",
            line_of("0 0 2.125")
        )
    );
    assert!(
        error(
            "a.vtp",
            with(ascii, "NumberOfPoints=\"6\"", "NumberOfPoints=\"7\"")
        )
        .ends_with("18 coordinates for 7 points")
    );
    assert!(error("a.vtp", with(ascii, "</Polys>", "</Poly>")).starts_with("line "));
    let raw = fixture("vtp_appended_raw_plain_u64.vtp");
    let underscore = raw
        .windows(3)
        .position(|w| w == b" _\x90" || w == b"  _")
        .unwrap();
    let start = raw[underscore..].iter().position(|&b| b == b'_').unwrap() + underscore + 1;
    let mut long = raw;
    long[start + 1] = 1;
    assert_eq!(
        error("a.vtp", long),
        format!("byte {start}: an array of 400 bytes, but 144 are expected at most")
    );
}

#[test]
fn gltf_errors_name_line_byte_or_item() {
    let name = "gltf_morph_animation_data_uri.gltf";
    assert!(error("a.gltf", with(name, "\"nodes\"", "nodes")).starts_with("line "));
    let glb = fixture("glb_morph_targets.glb");
    assert_eq!(
        error("a.glb", &glb[..glb.len() - 4]),
        format!(
            "byte 8: the header says {} bytes, but the file has {}",
            glb.len(),
            glb.len() - 4
        )
    );
    let mut header = glb;
    header[8..12].copy_from_slice(&5_u32.to_le_bytes()); // the gltf crate panics here
    assert!(error("a.glb", header).starts_with("byte 8: the header says 5 bytes"));
    // and here, in its validation
    assert_eq!(
        error("a.gltf", with(name, "\"POSITION\": 0", "\"POSITION\": 77")),
        "meshes[0].primitives[0]: refers to accessors[77], but there are only 6"
    );
    assert_eq!(
        error(
            "a.gltf",
            with(name, "\"path\": \"weights\"", "\"path\": \"wights\"")
        ),
        "animations[0].channels[0]: moves neither a node nor weights"
    );
    let two_parents = with(name, "\"scenes\"", "\"scenes\":[{\"nodes\":[0,0]}],\"x\"");
    assert!(error("a.gltf", two_parents).contains("nodes[0]"));
}

#[test]
fn csv_errors_name_the_line() {
    let rows = "kind,x,y,z\nv,0,0,0\nv,1,0,0\n# a remark\n\nv,0,1,0\n";
    let cases = [
        (
            "f,0,1,3",
            "line 7: face refers to vertex 3, but there are only 3, counted from 0",
        ),
        ("f,0,1,-2", "line 7: \"-2\" is not a count"),
        ("v,0,1", "line 7: 2 coordinates, but 3 are needed"),
        (
            "w,0,1",
            "line 7: a row begins with \"w\", but \"v\" (vertex) or \"f\" (face) is needed",
        ),
    ];
    for (row, expected) in cases {
        assert_eq!(error("a.csv", format!("{rows}{row}\n")), expected);
    }
    let mesh = read_mesh(
        "a.csv",
        format!("{rows}f,0,1,2").as_bytes(),
        &Limits::default(),
    );
    assert_eq!(mesh.unwrap().frames[0].triangles(), [[0, 1, 2]]);
}

#[test]
fn a_file_cut_at_any_byte_is_an_error_or_a_mesh() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/formats");
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        let bytes = fs::read(&path).unwrap();
        let whole = read_mesh(&name, &bytes, &Limits::default());
        for end in 0..bytes.len() {
            let cut = read_mesh(&name, &bytes[..end], &Limits::default());
            // binary formats say how much follows, so that none reads as whole when much is gone
            let binary = name.contains("binary") || name.ends_with(".glb");
            if binary && end < bytes.len() / 2 {
                assert!(cut.is_err() || whole.is_err(), "{name} cut at {end}");
            }
        }
    }
}

#[test]
fn limits_are_errors_that_say_the_limit() {
    let small = Limits {
        vertices: 5,
        faces: 7,
        frames: 2,
        file_bytes: 10_000,
        ..Limits::default()
    };
    let few_faces = Limits {
        vertices: 6,
        ..small
    };
    for name in [
        "ply_vtk_ascii.ply",
        "vtk_binary_5_1.vtk",
        "vtp_inline_zlib_u32.vtp",
        "stl_vtk_ascii.stl",
        "obj_trimesh.obj",
        "glb_morph_targets.glb",
    ] {
        let bytes = fixture(name);
        if !name.ends_with(".stl") {
            assert_eq!(
                error_with(name, &bytes, &small),
                "6 vertices; the limit is 5",
                "{name}"
            );
        }
        let text = error_with(name, &bytes, &few_faces);
        assert!(
            text == "8 faces; the limit is 7" || text == "3 frames; the limit is 2",
            "{name}: {text}"
        );
    }
    let tiny = Limits {
        file_bytes: 3,
        ..small
    };
    assert_eq!(
        read_mesh("a.obj", b"v 0 0 0", &tiny),
        Err(ReadMeshError::TooLarge { size: 7, most: 3 })
    );
    assert_eq!(
        read_mesh("a.txt", b"hello", &small),
        Err(ReadMeshError::UnknownFormat {
            known: mesh_format_names().join(", ")
        })
    );
}
