//! Surfaces that are smoothed, decimated and normalised.

use proptest::prelude::*;

use super::*;
use crate::analysis::surface_extraction::{
    Centre, Normalisation, SurfaceError, TaubinParams, decimated, mask_surface, taubin,
};
use crate::image::Mask;
use crate::mesh::{Faces, crossing_faces, phantom};
use crate::progress::{Progress, Stopped};

/// The stepped surface of the voxels within 11 of the centre, and of a smaller sphere beside it.
fn stepped() -> TriMesh {
    let frame = centred_frame([48, 28, 28], [1.0; 3]);
    let field = |p: Point3| {
        let large = 11.0 - (p - Point3::new(-9.0, 0.2, 0.1)).norm();
        large.max(5.0 - (p - Point3::new(15.0, 0.0, 0.0)).norm())
    };
    let mask = Mask::above(frame.size(), &sampled(&frame, field), 0.0).unwrap();
    mask_surface(&frame, &mask, &Progress::default()).unwrap()
}

fn smoothed(mesh: &TriMesh, params: TaubinParams) -> TriMesh {
    taubin(mesh, &params.check().unwrap(), &Progress::default()).unwrap()
}

/// Root mean square distance of the vertices of the larger sphere from a sphere.
fn roughness(mesh: &TriMesh) -> f64 {
    let own = mesh.vertices().iter().filter(|p| p.x < 4.0);
    let away: Vec<f64> = own
        .map(|p| (p - Point3::new(-9.0, 0.2, 0.1)).norm())
        .collect();
    let mean = away.iter().sum::<f64>() / away.len() as f64;
    (away.iter().map(|r| (r - mean).powi(2)).sum::<f64>() / away.len() as f64).sqrt()
}

/// Volumes of the two spheres.
fn both(mesh: &TriMesh) -> [f64; 2] {
    let of = |left: bool| {
        let own = mesh
            .triangles()
            .iter()
            .filter(|t| (mesh.vertices()[t[0] as usize].x < 4.0) == left);
        signed_volume(
            own.map(|t| t.map(|v| mesh.vertices()[v as usize])),
            Point3::origin(),
        )
    };
    [of(true), of(false)]
}

#[test]
fn steps_of_voxels_go_and_every_part_keeps_its_volume() {
    let rough = stepped();
    let smooth = smoothed(&rough, TaubinParams::default());
    assert_eq!(smooth.faces(), rough.faces());
    for (before, after) in both(&rough).into_iter().zip(both(&smooth)) {
        assert!((after / before - 1.0).abs() < 1e-10, "{before} {after}");
    }
    let (before, after) = (roughness(&rough), roughness(&smooth));
    assert!(after < 0.5 * before, "{before} {after}");
    let crossing = crossing_faces(smooth.vertices(), smooth.triangles(), || true);
    assert_eq!(crossing, Some(0));
    let none = TaubinParams {
        sweeps: 0,
        ..TaubinParams::default()
    };
    assert_eq!(smoothed(&rough, none), rough);
}

#[test]
fn specks_of_one_voxel_keep_their_volume_too() {
    let size = [12, 12, 12];
    let mut inside = vec![false; 1_728];
    for (k, j, i) in (1..8).flat_map(|k| (1..8).flat_map(move |j| (1..8).map(move |i| (k, j, i)))) {
        inside[i + 12 * (j + 12 * k)] = true;
    }
    // A speck, and a rod.
    inside[10 + 12 * (10 + 12 * 10)] = true;
    inside[12 * 11 + 10] = true;
    inside[12 * 11 + 9] = true;
    let mask = Mask::new(size, inside).unwrap();
    let rough = mask_surface(&centred_frame(size, [1.0; 3]), &mask, &Progress::default()).unwrap();
    assert_eq!(euler(&rough), 6);
    for sweeps in [1, 20, 1_000] {
        let smooth = smoothed(
            &rough,
            TaubinParams {
                sweeps,
                ..TaubinParams::default()
            },
        );
        assert!(
            (volume(&smooth) / volume(&rough) - 1.0).abs() < 1e-9,
            "{sweeps}"
        );
        let crossing = crossing_faces(smooth.vertices(), smooth.triangles(), || true);
        assert_eq!(crossing, Some(0));
        let reach = smooth.vertices().iter().map(|p| p.coords.amax());
        assert!(reach.fold(0.0, f64::max) < 6.5);
    }
}

#[test]
fn a_sphere_stays_a_sphere_and_the_rim_of_a_bowl_a_circle() {
    let sphere = phantom::sphere(4, 10.0);
    for p in smoothed(&sphere, TaubinParams::default()).vertices() {
        assert!((p.coords.norm() - 10.0).abs() < 0.02, "{}", p.coords.norm());
    }
    let bowl = phantom::bowl(10.0, 24, 64);
    let smooth = smoothed(&bowl, TaubinParams::default());
    for (index, on_rim) in bowl.faces().boundary_vertices().iter().enumerate() {
        let p = smooth.vertices()[index];
        assert!(!on_rim || (p.z.abs() < 1e-12 && (p.coords.norm() - 10.0).abs() < 0.05));
    }
}

#[test]
fn a_decimated_surface_has_its_budget_its_volume_and_its_topology() {
    let smooth = smoothed(&stepped(), TaubinParams::default());
    for budget in [2_000, 800, 300] {
        let coarse = decimated(&smooth, budget, &Progress::default()).unwrap();
        assert!(coarse.vertices().len() <= budget);
        assert!(is_closed_manifold(&coarse));
        assert_eq!(euler(&coarse), 4);
        for (before, after) in both(&smooth).into_iter().zip(both(&coarse)) {
            assert!(
                (after / before - 1.0).abs() < 1e-10,
                "{budget}: {before} {after}"
            );
        }
        let crossing = crossing_faces(coarse.vertices(), coarse.triangles(), || true);
        assert_eq!(crossing, Some(0));
    }
    let same = decimated(&smooth, usize::MAX, &Progress::default()).unwrap();
    assert_eq!(same, smooth);
    // Two tetrahedra are the least.
    let least = decimated(&smooth, 0, &Progress::default()).unwrap();
    assert!((8..60).contains(&least.vertices().len()) && euler(&least) == 4);
}

#[test]
fn damage_is_smoothed_too_and_settings_that_are_none_are_refused() {
    // A fan of three faces on one edge, a face without area, and a vertex without a face.
    let points = vec![
        Point3::origin(),
        Point3::new(1.0, 0.0, 0.0),
        Point3::new(0.0, 1.0, 0.0),
        Point3::new(0.0, 0.0, 1.0),
        Point3::new(0.0, -1.0, 0.0),
        Point3::new(2.0, 0.0, 0.0),
        Point3::new(9.0, 9.0, 9.0),
    ];
    let faces = Faces::new(7, vec![[0, 1, 2], [0, 1, 3], [1, 0, 4], [0, 1, 5]]).unwrap();
    let damaged = TriMesh::new(points, faces).unwrap();
    let smooth = smoothed(&damaged, TaubinParams::default());
    assert_eq!(smooth.vertices()[6], damaged.vertices()[6]);
    let empty = TriMesh::new(Vec::new(), Faces::new(0, Vec::new()).unwrap()).unwrap();
    assert_eq!(smoothed(&empty, TaubinParams::default()), empty);
    assert_eq!(decimated(&empty, 0, &Progress::default()).unwrap(), empty);
    let default = TaubinParams::default();
    for (wrong, name) in [
        (
            TaubinParams {
                sweeps: 10_001,
                ..default
            },
            "sweeps",
        ),
        (
            TaubinParams {
                shrink: 0.0,
                ..default
            },
            "λ",
        ),
        (
            TaubinParams {
                shrink: f64::NAN,
                ..default
            },
            "λ",
        ),
        (
            TaubinParams {
                pass_band: 0.6,
                ..default
            },
            "pass band",
        ),
    ] {
        let error = wrong.check().unwrap_err().to_string();
        assert!(error.contains(name), "{error}");
    }
}

#[test]
fn a_stopped_computation_says_so() {
    let rough = stepped();
    let progress = Progress::default();
    progress.stop();
    let params = TaubinParams::default().check().unwrap();
    assert_eq!(
        taubin(&rough, &params, &progress),
        Err(SurfaceError::Stopped(Stopped))
    );
    assert_eq!(
        decimated(&rough, 100, &progress),
        Err(SurfaceError::Stopped(Stopped))
    );
}

#[test]
fn one_scale_serves_all_frames_of_a_sequence() {
    let small = [Point3::new(10.0, 0.0, 0.0), Point3::new(14.0, 1.0, 2.0)];
    let large = [Point3::new(8.0, 0.0, 0.0), Point3::new(16.0, 4.0, 2.0)];
    let found = Normalisation::of_sequence(&[&small, &large], Centre::Box).unwrap();
    assert_eq!(found.largest_side, 8.0);
    assert_eq!(found.apply(&large[0]), Point3::new(-0.5, -0.25, -0.125));
    assert_eq!(found.restored(&found.apply(&small[1])), small[1]);
    let mean = Normalisation::of_sequence(&[&small, &large], Centre::Mean).unwrap();
    assert_eq!(mean.centre, Point3::new(12.0, 1.25, 1.0));
    assert_eq!(Normalisation::of_sequence(&[], Centre::Box), None);
    assert_eq!(
        Normalisation::of_sequence(&[&small[..1]], Centre::Box),
        None
    );
    let nan = [Point3::origin(), Point3::new(1.0, f64::NAN, 0.0)];
    assert_eq!(Normalisation::of_sequence(&[&nan], Centre::Box), None);
    let huge = [
        Point3::new(f64::MAX, 0.0, 0.0),
        Point3::new(f64::MIN, 0.0, 0.0),
    ];
    assert_eq!(Normalisation::of_sequence(&[&huge], Centre::Mean), None);
}

proptest! {
    #[test]
    fn smoothing_moves_with_the_surface(
        angles in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-90.0..90.0_f64),
    ) {
        let turn = nalgebra::Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let torus = phantom::torus(5.0, 2.0, 20, 12);
        let moved: Vec<Point3> = torus.vertices().iter().map(|p| turn * p + Vector3::from(shift)).collect();
        let moved = TriMesh::new(moved, torus.faces().clone()).unwrap();
        let (here, there) = (smoothed(&torus, TaubinParams::default()), smoothed(&moved, TaubinParams::default()));
        for (p, q) in here.vertices().iter().zip(there.vertices()) {
            prop_assert!((turn * p + Vector3::from(shift) - q).norm() < 1e-10);
        }
    }
}
