//! Volumes, areas, mass and ejection fraction against trimesh, scipy and the definitions.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot read its input fails"
)]

use std::path::{Path, PathBuf};

use cardiomorph::analysis::measures::{SubjectMeasures, measure_subject};
use cardiomorph::analysis::segments::Segment;
use cardiomorph::analysis::thickness_methods::{
    ThicknessMethod, ThicknessParams, mean_wall_thickness, thickness,
};
use cardiomorph::io::{Limits, read_mesh};
use cardiomorph::mesh::{Faces, TriMesh};
use cardiomorph::progress::Progress;
use cardiomorph::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
use cardiomorph::units::LengthUnit;
use serde_json::Value;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/oracles/clinical")
}

fn case(name: &str) -> Value {
    let text = std::fs::read_to_string(folder().join("cases.json")).unwrap();
    let cases: Value = serde_json::from_str(&text).unwrap();
    let all = cases["cases"].as_array().unwrap();
    all.iter()
        .find(|case| case["name"] == name)
        .unwrap()
        .clone()
}

fn mesh(file: &str) -> TriMesh {
    let bytes = std::fs::read(folder().join(file)).unwrap();
    let mut read = read_mesh(file, &bytes, &Limits::default()).unwrap();
    read.frames.remove(0)
}

fn without_lid(mesh: &TriMesh, base_z: f64) -> TriMesh {
    let on_lid = |&v: &u32| (mesh.vertices()[v as usize].z - base_z).abs() < 1e-9;
    let kept: Vec<_> = mesh
        .triangles()
        .iter()
        .filter(|triangle| !triangle.iter().all(on_lid))
        .copied()
        .collect();
    assert!(kept.len() < mesh.triangles().len());
    let faces = Faces::new(mesh.vertices().len(), kept).unwrap();
    TriMesh::new(mesh.shared_vertices(), faces).unwrap()
}

fn measured(endo: TriMesh, epi: TriMesh) -> SubjectMeasures {
    let sequence = MeshSequence::new(vec![
        SurfaceSequence::new(SurfaceKind::Endocardium, vec![endo]).unwrap(),
        SurfaceSequence::new(SurfaceKind::Epicardium, vec![epi]).unwrap(),
    ])
    .unwrap();
    measure_subject(&Subject::new("shell", sequence, LengthUnit::Millimetre))
}

fn near(value: f64, expected: &Value, tolerance: f64) {
    let expected = expected.as_f64().unwrap();
    assert!(
        (value / expected - 1.0).abs() <= tolerance,
        "{value} where {expected} is expected"
    );
}

#[test]
fn shells_have_the_volumes_areas_and_mass_of_trimesh() {
    for name in ["shell_0", "shell_1"] {
        let case = case(name);
        let expected = &case["expected"];
        let read = |layer: &str| mesh(case["inputs"][layer]["obj"].as_str().unwrap());
        let found = measured(read("endo"), read("epi"));
        let frame = &found.frames[0];
        near(
            1e3 * frame.endo_volume.unwrap(),
            &expected["mesh_volume_endo_mm3"],
            1e-12,
        );
        near(
            1e3 * frame.epi_volume.unwrap(),
            &expected["mesh_volume_epi_mm3"],
            1e-12,
        );
        near(
            1e2 * frame.endo_area.unwrap(),
            &expected["mesh_area_endo_with_lid_mm2"],
            1e-12,
        );
        near(
            1e2 * frame.epi_area.unwrap(),
            &expected["mesh_area_epi_with_lid_mm2"],
            1e-12,
        );
        near(
            frame.wall_volume.unwrap(),
            &expected["myocardium_mL_mesh"],
            1e-12,
        );
        near(found.mass.unwrap().0, &expected["LVM_g_mesh"], 1e-12);
        near(found.mass.unwrap().0, &expected["LVM_g_analytic"], 0.008);
    }
}

#[test]
fn a_shell_without_its_lid_holds_as_much_and_has_the_lateral_area() {
    for name in ["shell_0", "shell_1"] {
        let case = case(name);
        let expected = &case["expected"];
        let base_z = case["params"]["base_z"].as_f64().unwrap();
        let open = |layer: &str| {
            without_lid(
                &mesh(case["inputs"][layer]["obj"].as_str().unwrap()),
                base_z,
            )
        };
        let found = measured(open("endo"), open("epi"));
        let frame = &found.frames[0];
        // The lid is flat, so that any fan over its rim closes the same volume.
        near(
            1e3 * frame.endo_volume.unwrap(),
            &expected["mesh_volume_endo_mm3"],
            1e-12,
        );
        near(
            1e3 * frame.epi_volume.unwrap(),
            &expected["mesh_volume_epi_mm3"],
            1e-12,
        );
        near(
            1e3 * frame.endo_volume.unwrap(),
            &expected["analytic_volume_endo_mm3"],
            0.008,
        );
        near(
            1e2 * frame.endo_area.unwrap(),
            &expected["analytic_lateral_area_endo_mm2"],
            0.008,
        );
        near(
            1e2 * frame.epi_area.unwrap(),
            &expected["analytic_lateral_area_epi_mm2"],
            0.008,
        );
    }
}

#[test]
fn places_lie_in_the_segments_of_the_standard() {
    let case = case("aha17");
    let numbers = |value: &Value| -> Vec<f64> {
        let all = value.as_array().unwrap();
        all.iter().map(|x| x.as_f64().unwrap()).collect()
    };
    let depths = numbers(&case["inputs"]["z_norm"]);
    let angles = numbers(&case["inputs"]["theta_deg"]);
    let expected = numbers(&case["expected"]["segment"]);
    assert_eq!(depths.len(), 60);
    for ((depth, angle), expected) in depths.iter().zip(&angles).zip(&expected) {
        let found = Segment::at(*depth, angle.to_radians());
        assert_eq!(f64::from(found.number()), *expected, "{depth} {angle}");
    }
    let names: Vec<&str> = Segment::all().map(Segment::name).collect();
    assert_eq!(serde_json::json!(names), case["expected"]["names"]);
}

#[test]
fn shells_are_as_thick_as_their_equations_say_by_every_method() {
    for name in ["shell_0", "shell_1"] {
        let case = case(name);
        let expected = &case["expected"];
        let base_z = case["params"]["base_z"].as_f64().unwrap();
        let [endo, epi] = ["endo", "epi"].map(|layer| {
            let file = case["inputs"][layer]["obj"].as_str().unwrap();
            without_lid(&mesh(file), base_z)
        });
        near(
            mean_wall_thickness(&endo, &epi).unwrap(),
            &expected["LWT_mean"],
            0.01,
        );
        let sequence = MeshSequence::new(vec![
            SurfaceSequence::new(SurfaceKind::Endocardium, vec![endo.clone()]).unwrap(),
            SurfaceSequence::new(SurfaceKind::Epicardium, vec![epi]).unwrap(),
        ])
        .unwrap();
        let shell = Subject::new(name, sequence, LengthUnit::Millimetre);
        let params = ThicknessParams::default().check().unwrap();
        // Apex and the place nearest to the equator; slices say nothing of the apex.
        let lowest = |key: &dyn Fn(usize) -> f64| {
            let all = 0..endo.vertices().len();
            all.min_by(|&a, &b| key(a).total_cmp(&key(b))).unwrap()
        };
        let tip = lowest(&|v| endo.vertices()[v].z);
        let side = lowest(&|v| endo.vertices()[v].z.abs());
        let (apex, equator) = ("wall_thickness_apex", "wall_thickness_equator_radial");
        for (method, places) in [
            (ThicknessMethod::Nearest, vec![(tip, apex), (side, equator)]),
            (ThicknessMethod::Laplace, vec![(tip, apex), (side, equator)]),
            (ThicknessMethod::Centreline, vec![(side, equator)]),
        ] {
            let map = thickness(&shell, 0, method, &params, &Progress::default()).unwrap();
            for (vertex, which) in places {
                near(map.thickness[vertex].unwrap(), &expected[which], 0.03);
            }
        }
    }
}

#[test]
fn volumes_over_a_beat_give_the_defined_indices() {
    let case = case("volumetrics");
    let volumes = case["inputs"]["lv_volumes_mL"].as_array().unwrap();
    let cavity = cardiomorph::mesh::phantom::sphere(3, 1.0);
    let unit_ml = {
        let sequence = MeshSequence::new(vec![
            SurfaceSequence::new(SurfaceKind::Cavity, vec![cavity.clone()]).unwrap(),
        ])
        .unwrap();
        let found = measure_subject(&Subject::new("one", sequence, LengthUnit::Millimetre));
        found.frames[0].endo_volume.unwrap()
    };
    let frames = volumes
        .iter()
        .map(|volume| {
            let scale = (volume.as_f64().unwrap() / unit_ml).cbrt();
            let points: Vec<_> = cavity.vertices().iter().map(|p| p * scale).collect();
            TriMesh::new(points, cavity.faces().clone()).unwrap()
        })
        .collect();
    let sequence = MeshSequence::new(vec![
        SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap(),
    ])
    .unwrap();
    let found = measure_subject(&Subject::new("beat", sequence, LengthUnit::Millimetre));
    let expected = &case["expected"];
    near(found.edv.unwrap(), &expected["EDV_mL"], 1e-13);
    near(found.esv.unwrap(), &expected["ESV_mL"], 1e-13);
    near(found.sv.unwrap(), &expected["SV_mL"], 1e-13);
    near(1e2 * found.ef.unwrap(), &expected["EF_percent"], 1e-13);
    assert_eq!(found.end_diastole, Some(0));
    assert_eq!(found.end_systole, Some(1));
}
