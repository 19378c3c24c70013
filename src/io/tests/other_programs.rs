//! Small files that other programs wrote (`tests/fixtures/formats`), with known volumes.

use std::fs;
use std::path::{Path, PathBuf};

use crate::io::{Limits, MeshFile, mesh_file_endings, read_mesh, read_mesh_with_siblings};
use crate::mesh::{Point3, TriMesh};

/// The octahedron of the fixtures: a base of diagonals 3 and 2.5 under a height of 2.125 and
/// above one of 1.75, so that its parts have these volumes.
const UPPER: f64 = 3.75 * 2.125 / 3.0;
const LOWER: f64 = 3.75 * 1.75 / 3.0;
const POINTS: [[f64; 3]; 6] = [
    [1.5, 0.0, 0.0],
    [0.0, 1.25, 0.0],
    [-1.5, 0.0, 0.0],
    [0.0, -1.25, 0.0],
    [0.0, 0.0, 2.125],
    [0.0, 0.0, -1.75],
];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/formats")
}

fn read(name: &str) -> MeshFile {
    let bytes = fs::read(folder().join(name)).unwrap();
    read_mesh(name, &bytes, &Limits::default()).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Σ a · (b × c) / 6 over the faces: the volume that a closed surface with outward faces holds.
fn volume(mesh: &TriMesh) -> f64 {
    let corner = |vertex: u32| mesh.vertices()[vertex as usize].coords;
    mesh.triangles()
        .iter()
        .map(|&[a, b, c]| corner(a).dot(&corner(b).cross(&corner(c))) / 6.0)
        .sum()
}

fn assert_closed_with_volume(name: &str, mesh: &TriMesh, expected: f64) {
    let closed = mesh
        .faces()
        .edge_valences()
        .iter()
        .all(|&(_, faces)| faces == 2);
    assert!(closed, "{name} is not closed");
    let found = volume(mesh);
    assert!(
        (found - expected).abs() < 1e-6,
        "{name}: {found}, not {expected}"
    );
}

fn texts(file: &MeshFile) -> Vec<&str> {
    file.notices
        .iter()
        .map(|notice| notice.text.as_str())
        .collect()
}

/// Names of all fixtures with one of these endings.
fn names(endings: &[&str]) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| endings.iter().any(|ending| name.ends_with(ending)))
        .filter(|name| !name.contains("refused"))
        .collect();
    names.sort();
    names
}

#[test]
fn every_variant_that_other_programs_write_is_the_same_body() {
    // Files of glTF here have several frames, and tests of their own.
    let mut endings = mesh_file_endings();
    endings.retain(|ending| !["gltf", "glb"].contains(ending));
    let names = names(&endings);
    assert!(names.len() >= 40, "{names:?}");
    for name in names {
        let file = read(&name);
        assert_eq!(file.frames.len(), 1);
        assert_eq!(file.times_s, None);
        let mesh = &file.frames[0];
        let quad_below = name.contains("grid") || name.contains("meshio") && !name.contains("stl");
        let expected = if quad_below {
            UPPER
        } else if name.contains("mixed") || name == "vtp_ascii.vtp" {
            LOWER
        } else {
            UPPER + LOWER
        };
        assert_closed_with_volume(&name, mesh, expected);
        if !name.ends_with(".stl") {
            let points: Vec<Point3> = POINTS.iter().map(|&xyz| Point3::from(xyz)).collect();
            assert_eq!(mesh.vertices(), points, "{name}");
        }
    }
}

#[test]
fn what_is_split_or_left_out_is_reported() {
    let mixed = read("vtk_ascii_5_1_mixed.vtk");
    assert_eq!(
        texts(&mixed),
        [
            "1 polygon triangulated as a fan from the first corner",
            "2 points or lines beside the faces ignored",
            "1 vertex used by no face (kept)",
        ]
    );
    assert_eq!(texts(&read("vtp_ascii.vtp")), texts(&mixed));
    let stl = read("stl_vtk_binary.stl");
    assert_eq!(stl.frames[0].vertices().len(), 6);
    assert!(texts(&stl)[0].contains("merged into 6 vertices"));
}

#[test]
fn text_and_binary_stl_weld_to_the_same_vertices() {
    assert_eq!(
        read("stl_vtk_ascii.stl").frames,
        read("stl_vtk_binary.stl").frames
    );
}

#[test]
fn a_compressor_that_is_not_read_is_named() {
    let bytes = fs::read(folder().join("vtp_lz4_refused.vtp")).unwrap();
    let error = read_mesh("a.vtp", &bytes, &Limits::default()).unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 2: compressed by \"vtkLZ4DataCompressor\"; only vtkZLibDataCompressor or none is read"
    );
}

#[test]
fn a_node_transform_places_the_mesh() {
    let mesh = &read("glb_trimesh.glb").frames[0];
    assert_closed_with_volume("glb_trimesh", mesh, 2.0 * (UPPER + LOWER));
    assert_eq!(mesh.vertices()[0], Point3::new(13.0, 20.0, 30.0));
}

#[test]
fn numbers_in_files_beside_a_gltf_are_asked_for() {
    let bytes = fs::read(folder().join("gltf_external.gltf")).unwrap();
    let beside = |name: &str| fs::read(folder().join(name)).ok();
    let file = read_mesh_with_siblings("a.gltf", &bytes, &Limits::default(), &beside).unwrap();
    assert_eq!(file.frames, read("glb_trimesh.glb").frames);
    let error = read_mesh("a.gltf", &bytes, &Limits::default()).unwrap_err();
    assert!(
        error
            .to_string()
            .starts_with("buffers[0]: the file \"gltf_buffer_0.bin\" in the same folder"),
        "{error}"
    );
}

#[test]
fn morph_targets_are_frames() {
    let file = read("glb_morph_targets.glb");
    assert_eq!(file.times_s, None);
    assert_eq!(
        texts(&file),
        ["frame 0 is the mesh, frames 1 to 2 each one of its morph targets at full weight"]
    );
    let whole = UPPER + LOWER;
    for (frame, scale) in [1.0_f64, 1.1, 0.8].into_iter().enumerate() {
        assert_closed_with_volume("morph", &file.frames[frame], whole * scale.powi(3));
    }
    // the node turns x to y and moves by (1, 2, 3)
    let first = file.frames[0].vertices()[0];
    assert!(
        (first - Point3::new(1.0, 3.5, 3.0)).norm() < 1e-6,
        "{first}"
    );
    let faces = file.frames[0].faces();
    assert!(
        file.frames
            .iter()
            .all(|mesh| std::sync::Arc::ptr_eq(mesh.faces(), faces))
    );
}

#[test]
fn an_animation_of_weights_gives_frames_and_times() {
    let file = read("glb_morph_animation.glb");
    assert_eq!(file.times_s, Some(vec![0.0, 0.25, 0.75]));
    for (frame, scale) in [1.0_f64, 1.1, 0.85].into_iter().enumerate() {
        let expected = (UPPER + LOWER) * scale.powi(3);
        assert_closed_with_volume("animation", &file.frames[frame], expected);
    }
    assert_eq!(read("gltf_morph_animation_data_uri.gltf"), file);
}

#[test]
fn a_sparse_morph_target_moves_only_the_vertices_it_names() {
    let frames = read("glb_morph_sparse.glb").frames;
    let moved: Vec<f64> = frames[0]
        .vertices()
        .iter()
        .zip(frames[2].vertices())
        .map(|(from, to)| ((to - from).norm() * 1e6).round() / 1e6)
        .collect();
    assert_eq!(moved, [0.0, 1.0, 0.0, 0.0, 1.0, 0.0]);
}
