//! What is written is read again, to the last bit.

use proptest::prelude::*;

use crate::io::{Limits, read_mesh, write_obj, write_ply, write_pvd, write_vtp};
use crate::mesh::{Faces, Point3, TriMesh, phantom};

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        -300.0..300.0_f64,
        any::<f64>().prop_filter("finite", |x| x.is_finite()),
        Just(-0.0),
        Just(f64::MIN_POSITIVE / 4.0),
    ]
}

/// Any finite positions on any faces without repeated corners.
fn meshes() -> impl Strategy<Value = TriMesh> {
    (3..40_u32)
        .prop_flat_map(|count| {
            let points =
                prop::collection::vec([coordinate(), coordinate(), coordinate()], count as usize);
            let faces = prop::collection::vec([0..count, 0..count, 0..count], 1..60);
            (points, faces)
        })
        .prop_map(|(points, mut faces)| {
            faces.retain(|[a, b, c]| a != b && b != c && a != c);
            faces.push([0, 1, 2]);
            let faces = Faces::new(points.len(), faces).unwrap();
            let points: Vec<Point3> = points.into_iter().map(Point3::from).collect();
            TriMesh::new(points, faces).unwrap()
        })
}

fn bits(mesh: &TriMesh) -> Vec<u64> {
    let coordinates = mesh
        .vertices()
        .iter()
        .flat_map(|point| [point.x, point.y, point.z]);
    coordinates.map(f64::to_bits).collect()
}

fn read_back(name: &str, bytes: &[u8]) -> TriMesh {
    let file = read_mesh(name, bytes, &Limits::default()).unwrap();
    file.frames.into_iter().next().unwrap()
}

proptest! {
    #[test]
    fn every_mesh_survives_each_format_that_is_written(mesh in meshes()) {
        let (mut obj, mut ply, mut vtp) = (Vec::new(), Vec::new(), Vec::new());
        write_obj(&mut obj, &mesh).unwrap();
        write_ply(&mut ply, &mesh).unwrap();
        let heights: Vec<f64> = mesh.vertices().iter().map(|point| point.z).collect();
        write_vtp(&mut vtp, &mesh, &[("height_mm", &heights)]).unwrap();
        for (name, bytes) in [("a.obj", obj), ("a.ply", ply), ("a.vtp", vtp)] {
            let again = read_back(name, &bytes);
            prop_assert_eq!(bits(&again), bits(&mesh), "{}", name);
            prop_assert_eq!(again.triangles(), mesh.triangles(), "{}", name);
        }
    }
}

#[test]
fn scalars_must_be_one_for_each_vertex() {
    let mesh = phantom::sphere(1, 1.0);
    let error = write_vtp(&mut Vec::new(), &mesh, &[("x", &[1.0])]).unwrap_err();
    assert_eq!(error.to_string(), "1 values of \"x\" for 42 vertices");
}

#[test]
fn names_with_markup_do_not_break_the_file() {
    let mesh = phantom::sphere(1, 1.0);
    let mut vtp = Vec::new();
    write_vtp(&mut vtp, &mesh, &[("<a> & \"b\"\u{1}", &[0.5; 42])]).unwrap();
    assert_eq!(read_back("a.vtp", &vtp), mesh);
}

#[test]
fn a_pvd_lists_files_with_their_times() {
    let mut pvd = Vec::new();
    let entries = [(0.0, "a_0.vtp".to_owned()), (0.04, "R&D 1.vtp".to_owned())];
    write_pvd(&mut pvd, &entries).unwrap();
    let text = String::from_utf8(pvd).unwrap();
    let document = roxmltree::Document::parse(&text).unwrap();
    let listed: Vec<_> = document
        .descendants()
        .filter(|node| node.has_tag_name("DataSet"))
        .map(|node| {
            let time_s: f64 = node.attribute("timestep").unwrap().parse().unwrap();
            (time_s, node.attribute("file").unwrap().to_owned())
        })
        .collect();
    assert_eq!(listed, entries);
}
