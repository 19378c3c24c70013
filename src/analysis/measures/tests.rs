//! Measures of subjects whose sizes are known.

mod notes;

use std::f64::consts::PI;

use super::*;
use crate::mesh::{Faces, Point3, TriMesh, phantom};
use crate::progress::{Progress, Stopped};
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

fn subject(surfaces: Vec<(SurfaceKind, Vec<TriMesh>)>, unit: LengthUnit) -> Subject {
    let surfaces = surfaces
        .into_iter()
        .map(|(kind, frames)| SurfaceSequence::new(kind, frames).unwrap())
        .collect();
    Subject::new("a heart", MeshSequence::new(surfaces).unwrap(), unit)
}

fn of_one(kind: SurfaceKind, mesh: &TriMesh) -> Subject {
    subject(vec![(kind, vec![mesh.clone()])], LengthUnit::FileUnit)
}

fn moved(mesh: &TriMesh, place: impl Fn(&Point3) -> Point3) -> TriMesh {
    let points: Vec<Point3> = mesh.vertices().iter().map(place).collect();
    TriMesh::new(points, mesh.faces().clone()).unwrap()
}

fn joined(one: &TriMesh, other: &TriMesh) -> TriMesh {
    let points: Vec<Point3> = [one.vertices(), other.vertices()].concat();
    TriMesh::new(points, Faces::joined(&[one.faces(), other.faces()])).unwrap()
}

fn turned_inside_out(mesh: &TriMesh) -> TriMesh {
    let faces = mesh.triangles().iter().map(|&[a, b, c]| [a, c, b]);
    let faces = Faces::new(mesh.vertices().len(), faces.collect()).unwrap();
    TriMesh::new(mesh.shared_vertices(), faces).unwrap()
}

/// A cup between two half spheres whose rims a flat ring joins: one closed surface.
fn cup(inner: f64, outer: f64, rings: u32) -> TriMesh {
    let around = 4 * rings;
    let (hollow, shell) = (
        turned_inside_out(&phantom::bowl(inner, rings, around)),
        phantom::bowl(outer, rings, around),
    );
    let both = joined(&hollow, &shell);
    let count = hollow.vertices().len() as u32;
    let first = count - around;
    let mut triangles = both.triangles().to_vec();
    for step in 0..around {
        let [a, b] = [first + step, first + (step + 1) % around];
        let [c, d] = [a + count, b + count];
        triangles.extend([[a, c, b], [b, c, d]]);
    }
    let faces = Faces::new(both.vertices().len(), triangles).unwrap();
    TriMesh::new(both.shared_vertices(), faces).unwrap()
}

fn half_ball(radius: f64) -> f64 {
    2.0 / 3.0 * PI * radius.powi(3)
}

#[test]
fn an_open_shell_has_the_volumes_areas_and_mass_of_its_half_spheres() {
    let shell = subject(
        vec![
            (SurfaceKind::Endocardium, vec![phantom::bowl(20.0, 60, 240)]),
            (SurfaceKind::Epicardium, vec![phantom::bowl(30.0, 60, 240)]),
        ],
        LengthUnit::Millimetre,
    );
    let measured = measure_subject(&shell);
    let frame = &measured.frames[0];
    // 240 sides around leave 2 (2π/240)²/6 = 2e-4 of the volume out, half of that of the area.
    let near = |value: Option<f64>, exact: f64| (value.unwrap() / exact - 1.0).abs() < 4e-4;
    assert!(near(frame.endo_volume, 1e-3 * half_ball(20.0)));
    assert!(near(frame.epi_volume, 1e-3 * half_ball(30.0)));
    assert!(near(frame.endo_area, 1e-2 * 2.0 * PI * 400.0));
    let muscle_ml = 1e-3 * (half_ball(30.0) - half_ball(20.0));
    assert!(near(frame.wall_volume, muscle_ml));
    assert!(near(measured.mass.map(|mass| mass.0), 1.05 * muscle_ml));
    assert_eq!(frame.bounding_box[0], [-30.0; 3]);
}

#[test]
fn normals_may_point_either_way_and_single_faces_too() {
    let bowl = phantom::bowl(1.0, 12, 48);
    let volume = |mesh: &TriMesh| {
        measure_subject(&of_one(SurfaceKind::Endocardium, mesh)).frames[0]
            .endo_volume
            .unwrap()
    };
    let right = volume(&bowl);
    assert!((volume(&turned_inside_out(&bowl)) - right).abs() < 1e-12);
    let mut triangles = bowl.triangles().to_vec();
    for face in [0, 5, 6, 90, 200] {
        triangles[face].swap(0, 1);
    }
    let faces = Faces::new(bowl.vertices().len(), triangles).unwrap();
    let damaged = TriMesh::new(bowl.shared_vertices(), faces).unwrap();
    assert!((volume(&damaged) - right).abs() < 1e-12);
}

#[test]
fn a_closed_cup_tells_its_inner_side() {
    let found = measure_subject(&of_one(SurfaceKind::Wall, &cup(2.0, 3.0, 40)));
    let frame = &found.frames[0];
    let near = |value: Option<f64>, exact: f64| (value.unwrap() / exact - 1.0).abs() < 2e-3;
    assert!(near(frame.wall_volume, half_ball(3.0) - half_ball(2.0)));
    assert!(near(frame.endo_volume, half_ball(2.0)));
    assert!(near(frame.epi_volume, half_ball(3.0)));
    assert!(near(frame.endo_area, 2.0 * PI * 4.0));
    assert!(unknown_volumes(&of_one(SurfaceKind::Wall, &cup(2.0, 3.0, 10))).is_empty());
    let inside_out = turned_inside_out(&cup(2.0, 3.0, 40));
    let again = measure_subject(&of_one(SurfaceKind::Wall, &inside_out));
    assert!((again.frames[0].endo_volume.unwrap() - frame.endo_volume.unwrap()).abs() < 1e-9);
}

#[test]
fn a_wall_of_two_sheets_has_its_cavity_in_the_inner_one() {
    let closed = joined(&phantom::sphere(4, 3.0), &phantom::sphere(4, 2.0));
    let open = joined(&phantom::bowl(2.0, 40, 160), &phantom::bowl(3.0, 40, 160));
    for (wall, inner, outer) in [
        (closed, 2.0 * half_ball(2.0), 2.0 * half_ball(3.0)),
        (open, half_ball(2.0), half_ball(3.0)),
    ] {
        let found = measure_subject(&of_one(SurfaceKind::Wall, &wall));
        let near = |value: Option<f64>, exact: f64| (value.unwrap() / exact - 1.0).abs() < 5e-3;
        assert!(near(found.frames[0].endo_volume, inner));
        assert!(near(found.frames[0].epi_volume, outer));
        assert!(near(found.frames[0].wall_volume, outer - inner));
    }
}

#[test]
fn what_cannot_be_told_is_said_with_its_reason() {
    let ball = phantom::sphere(2, 1.0);
    let beside = joined(&ball, &moved(&ball, |p| p + nalgebra::Vector3::x() * 5.0));
    let three = joined(&beside, &moved(&ball, |p| p * 0.5));
    let branching = TriMesh::new(
        vec![
            Point3::origin(),
            Point3::new(1.0, 0.0, 0.0),
            Point3::new(0.0, 1.0, 0.0),
            Point3::new(0.0, 0.0, 1.0),
            Point3::new(0.0, 0.0, -1.0),
        ],
        Faces::new(5, vec![[0, 1, 2], [0, 1, 3], [0, 1, 4]]).unwrap(),
    )
    .unwrap();
    for (kind, mesh, reason) in [
        (SurfaceKind::Wall, &beside, "neither lies inside the other"),
        (SurfaceKind::Wall, &three, "3 separate sheets"),
        (SurfaceKind::Wall, &ball, "lies in the myocardium"),
        (SurfaceKind::Wall, &phantom::bowl(1.0, 5, 20), "1 open ends"),
        (
            SurfaceKind::Cavity,
            &branching,
            "1 edges have more than two faces",
        ),
        (SurfaceKind::Other, &ball, "no surface is labelled"),
    ] {
        let subject = of_one(kind, mesh);
        let found = measure_subject(&subject);
        assert_eq!(found.frames[0].endo_volume, None);
        assert_eq!((found.edv, found.ef, found.end_systole), (None, None, None));
        let reasons: Vec<_> = unknown_volumes(&subject)
            .iter()
            .map(ToString::to_string)
            .collect();
        assert!(
            reasons.len() == 1 && reasons[0].contains(reason),
            "{reasons:?}"
        );
    }
}

#[test]
fn a_surface_without_faces_has_no_volume_and_does_no_harm() {
    let points = TriMesh::new(
        vec![Point3::new(1.0, 2.0, 3.0); 3],
        Faces::new(3, Vec::new()).unwrap(),
    )
    .unwrap();
    for kind in [SurfaceKind::Endocardium, SurfaceKind::Wall] {
        let found = measure_subject(&of_one(kind, &points));
        assert!(
            found.frames[0]
                .endo_volume
                .is_none_or(|volume| volume == 0.0)
        );
        assert_eq!(found.ef, None);
        assert_eq!(found.frames[0].bounding_box, [[1.0, 2.0, 3.0]; 2]);
    }
}

#[test]
fn phases_are_the_extremes_unless_they_are_stated() {
    let ball = phantom::sphere(2, 1.0);
    let beat = [1.0, 0.9, 0.7, 0.7, 1.1, 1.1].map(|scale| moved(&ball, |p| p * scale));
    let mut heart = subject(
        vec![(SurfaceKind::Cavity, beat.to_vec())],
        LengthUnit::FileUnit,
    );
    let found = measure_subject(&heart);
    assert_eq!((found.end_diastole, found.end_systole), (Some(4), Some(2)));
    assert_eq!(found.phase_source, PhaseSource::VolumeCurve);
    assert!((found.ef.unwrap() - (1.0 - (0.7_f64 / 1.1).powi(3))).abs() < 1e-12);
    assert_eq!(found.mass, None);
    heart.end_diastole = Some(0);
    heart.end_systole = Some(9);
    let found = measure_subject(&heart);
    assert_eq!((found.end_diastole, found.end_systole), (Some(0), Some(2)));
    assert_eq!(found.phase_source, PhaseSource::Stated);
    assert!((found.ef.unwrap() - (1.0 - 0.343)).abs() < 1e-12);
}

#[test]
fn one_frame_is_no_beat() {
    let found = measure_subject(&of_one(SurfaceKind::Cavity, &phantom::sphere(2, 1.0)));
    assert_eq!((found.end_diastole, found.end_systole), (Some(0), None));
    assert!(found.edv.is_some());
    assert_eq!((found.esv, found.ef), (None, None));
}

#[test]
fn the_built_in_hearts_measure_as_they_were_designed() {
    let made = cohort(&BuiltInParams::default()).unwrap();
    let found = measure_study(&made.study, &Progress::default()).unwrap();
    for (measures, truth) in found.iter().zip(&made.truths) {
        assert_eq!(measures.end_diastole, Some(0));
        assert!((measures.ef.unwrap() - truth.ejection_fraction).abs() < 0.008);
        // From a small normal subject to a large hypertrophic one.
        assert!((60.0..260.0).contains(&measures.mass.unwrap().0));
    }
}

#[test]
fn a_stopped_measurement_returns_stopped() {
    let made = cohort(&BuiltInParams::default()).unwrap();
    let progress = Progress::default();
    progress.stop();
    assert_eq!(measure_study(&made.study, &progress), Err(Stopped));
    assert_eq!(measure_study(&Study::default(), &progress), Ok(Vec::new()));
}

proptest::proptest! {
    #[test]
    fn rigid_motions_change_no_measure(
        angles in proptest::array::uniform3(-3.0..3.0_f64),
        shift in proptest::array::uniform3(-500.0..500.0_f64),
    ) {
        let motion = nalgebra::Isometry3::new(shift.into(), angles.into());
        let bowl = cup(2.0, 3.0, 8);
        let place = |mesh: &TriMesh| of_one(SurfaceKind::Wall, &moved(mesh, |p| motion * p));
        let (here, there) = (
            measure_subject(&of_one(SurfaceKind::Wall, &bowl)),
            measure_subject(&place(&bowl)),
        );
        let sizes = |m: &SubjectMeasures| {
            let f = &m.frames[0];
            [f.endo_volume, f.epi_volume, f.wall_volume, f.endo_area].map(Option::unwrap)
        };
        for (a, b) in sizes(&here).into_iter().zip(sizes(&there)) {
            // Coordinates of 500 with sizes of 10 leave 1e-16 · 500 / 1 · a few.
            proptest::prop_assert!((a - b).abs() < 1e-9 * a);
        }
    }
}
