//! Every mesh file of the shared real data.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

use cardiomorph::io::{Limits, mesh_file_endings, read_mesh};
use cardiomorph::mesh::Point3;
use cardiomorph::study::Severity;

use crate::shared::shared_data;

fn mesh_files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            mesh_files(&path, found);
        } else if path
            .extension()
            .and_then(|ending| ending.to_str())
            .is_some_and(|ending| ending != "csv" && mesh_file_endings().contains(&ending))
        {
            found.push(path);
        }
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn every_real_mesh_file_is_read() {
    let data = shared_data("");
    let mut files = Vec::new();
    mesh_files(&data, &mut files);
    assert!(files.len() > 800, "{} files", files.len());
    for path in files {
        let name = path.file_name().unwrap().to_str().unwrap();
        let file = read_mesh(name, &fs::read(&path).unwrap(), &Limits::default())
            .unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert_eq!(file.frames.len(), 1);
        let warning = file
            .notices
            .iter()
            .find(|n| n.severity == Severity::Warning);
        assert_eq!(warning, None, "{}", path.display());
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_real_beat_keeps_the_vertex_numbers_and_faces_of_its_files() {
    let data = shared_data("");
    let beat = data.join("cine_mri/bivme_patient1");
    let frames: Vec<Vec<u8>> = ["endo", "epi"]
        .iter()
        .flat_map(|surface| (0..25).map(move |frame| format!("lv_{surface}_{frame:03}.obj")))
        .map(|name| fs::read(beat.join(name)).unwrap())
        .collect();
    let start = Instant::now();
    let meshes: Vec<_> = frames
        .iter()
        .map(|bytes| read_mesh("a.obj", bytes, &Limits::default()).unwrap())
        .map(|file| file.frames.into_iter().next().unwrap())
        .collect();
    println!("25 frames of 2 surfaces read in {:?}", start.elapsed());
    for (surface, count) in [(&meshes[..25], 1572), (&meshes[25..], 1652)] {
        for mesh in surface {
            assert_eq!(mesh.vertices().len(), count);
            assert_eq!(mesh.faces(), surface[0].faces());
        }
    }
    assert_eq!(
        meshes[0].vertices()[0],
        Point3::new(33.994, -3.351, -93.517)
    );
}
