//! Surfaces of spheres, tori, noise and damage.

use std::f64::consts::PI;
use std::sync::Arc;

use proptest::prelude::*;
use rand::{Rng, SeedableRng};

use super::*;
use crate::analysis::surface_extraction::{SurfaceError, isosurface, mask_surface};
use crate::image::Mask;
use crate::mesh::{area, crossing_faces};
use crate::progress::{Progress, Stopped};

fn surface(frame: &VolumeFrame, values: &[f32], threshold: f64) -> Result<TriMesh, SurfaceError> {
    isosurface(frame, values, threshold, &Progress::default())
}

fn noise(size: [usize; 3], seed: u64) -> Vec<f32> {
    let mut random = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let count = size.iter().product();
    (0..count).map(|_| random.random_range(-1.0..1.0)).collect()
}

#[test]
fn a_sphere_converges_with_the_square_of_the_spacing() {
    let mut last: Option<[f64; 2]> = None;
    for n in [20_usize, 40, 80] {
        let spacing = 40.0 / n as f64;
        let frame = centred_frame([n, n, n], [spacing; 3]);
        let values = sampled(&frame, |p| 15.0 - p.coords.norm());
        let found = surface(&frame, &values, 0.0).unwrap();
        assert!(is_closed_manifold(&found));
        assert_eq!(euler(&found), 2);
        let errors = [
            1.0 - volume(&found) / (4.0 / 3.0 * PI * 15.0_f64.powi(3)),
            1.0 - area(found.vertices(), found.triangles()) / (4.0 * PI * 225.0),
        ];
        assert!(
            errors.iter().all(|error| (0.0..0.03).contains(error)),
            "{errors:?}"
        );
        if let Some(last) = last {
            assert!(
                (3.2..4.8).contains(&(last[0] / errors[0])),
                "{n}: {errors:?} after {last:?}"
            );
            assert!(
                (2.5..5.5).contains(&(last[1] / errors[1])),
                "{n}: {errors:?} after {last:?}"
            );
        }
        last = Some(errors);
    }
}

#[test]
fn a_torus_has_a_hole_and_two_spheres_are_two_pieces() {
    let frame = centred_frame([40, 40, 20], [1.0, 1.0, 1.5]);
    let ring = |p: Point3| 4.0 - (p.x.hypot(p.y) - 11.3).hypot(p.z);
    let torus = surface(&frame, &sampled(&frame, ring), 0.0).unwrap();
    assert!(is_closed_manifold(&torus));
    assert_eq!(euler(&torus), 0);
    let two = |p: Point3| 5.0 - (p.coords - Vector3::x() * 8.0 * p.x.signum()).norm();
    let both = surface(&frame, &sampled(&frame, two), 0.0).unwrap();
    assert_eq!(euler(&both), 4);
}

#[test]
fn normals_point_outwards_on_grids_of_either_hand() {
    for sign in [1.0, -1.0] {
        let steps = [
            Vector3::new(0.0, sign, 0.1),
            Vector3::new(1.0, 0.0, 0.0),
            Vector3::new(0.0, 0.2, -2.0),
        ];
        let frame = VolumeFrame::new([24, 24, 12], Point3::new(50.0, -20.0, 9.0), steps).unwrap();
        let centre = frame.position(Point3::new(11.6, 11.7, 5.4));
        let values = sampled(&frame, |p| 7.0 - (p - centre).norm());
        let found = surface(&frame, &values, 0.0).unwrap();
        let exact = 4.0 / 3.0 * PI * 343.0;
        assert!(
            (volume(&found) / exact - 1.0).abs() < 0.05,
            "{}",
            volume(&found) / exact
        );
    }
}

#[test]
fn noise_of_any_kind_gives_a_closed_manifold() {
    for seed in 0..60 {
        let size = [9, 8, 7];
        let frame = centred_frame(size, [1.0, 1.2, 3.0]);
        let mut values = noise(size, seed);
        match seed % 3 {
            // Few values, among them the threshold: ties everywhere.
            0 => values.iter_mut().for_each(|v| *v = (2.0 * *v).round()),
            1 => values.iter_mut().step_by(7).for_each(|v| *v = f32::NAN),
            _ => {}
        }
        let found = surface(&frame, &values, 0.0).unwrap();
        assert!(is_closed_manifold(&found), "{seed}");
        assert!(euler(&found) % 2 == 0);
        let degenerate = (found.triangles().iter())
            .filter(|t| area(found.vertices(), &[**t]) <= 0.0)
            .count();
        assert_eq!(degenerate, 0, "{seed}");
        assert!(volume(&found) > 0.0);
    }
}

#[test]
fn no_vertex_is_more_than_there_are_edges_with_a_change_of_side() {
    let size = [7, 6, 5];
    let values = noise(size, 5);
    let at = |i: usize, j: usize, k: usize| {
        let within = (1..=7).contains(&i) && (1..=6).contains(&j) && (1..=5).contains(&k);
        within && values[i - 1 + 7 * (j - 1 + 6 * (k - 1))] > 0.25
    };
    let mut expected = 0;
    for (i, j, k) in (0..8).flat_map(|i| (0..7).flat_map(move |j| (0..6).map(move |k| (i, j, k)))) {
        let here = at(i, j, k);
        let beside = [at(i + 1, j, k), at(i, j + 1, k), at(i, j, k + 1)];
        expected += beside.iter().filter(|&&next| next != here).count();
    }
    let found = surface(&centred_frame(size, [1.0; 3]), &values, 0.25).unwrap();
    assert_eq!(found.vertices().len(), expected);
}

#[test]
fn what_reaches_the_border_or_padding_is_closed_there() {
    let frame = centred_frame([6, 6, 6], [2.0; 3]);
    let values = sampled(&frame, |p| if p.x < 0.0 { 10.0 } else { 0.0 });
    let found = surface(&frame, &values, 5.0).unwrap();
    assert!(is_closed_manifold(&found));
    assert_eq!(euler(&found), 2);
    // Half a voxel beyond voxels, less the corners and edges that marching cubes cut off.
    let full = 6.0 * 12.0 * 12.0;
    assert!(
        (0.9..1.0).contains(&(volume(&found) / full)),
        "{}",
        volume(&found) / full
    );
    let padded: Vec<f32> = values
        .iter()
        .map(|&v| if v == 0.0 { f32::NAN } else { v })
        .collect();
    let constant = SurfaceError::Constant { value: 10.0 };
    assert_eq!(surface(&frame, &padded, 5.0), Err(constant));
    let mask = Mask::above([6; 3], &padded, 5.0).unwrap();
    let again = mask_surface(&frame, &mask, &Progress::default()).unwrap();
    assert_eq!(again.triangles(), found.triangles());
    for (p, q) in found.vertices().iter().zip(again.vertices()) {
        assert!((p - q).norm() < 1e-12);
    }
}

#[test]
fn a_mask_that_fills_its_grid_has_a_surface() {
    let frame = centred_frame([1, 1, 1], [1.0; 3]);
    let mask = Mask::new([1, 1, 1], vec![true]).unwrap();
    let found = mask_surface(&frame, &mask, &Progress::default()).unwrap();
    assert_eq!((found.vertices().len(), found.triangles().len()), (6, 8));
    assert!((volume(&found) - 1.0 / 6.0).abs() < 1e-12);
}

#[test]
fn a_volume_without_a_surface_says_why() {
    let frame = centred_frame([3, 3, 3], [1.0; 3]);
    let mut values = vec![1.0_f32; 27];
    values[13] = 3.0;
    let error = |values: &[f32], threshold| surface(&frame, values, threshold).unwrap_err();
    assert_eq!(
        error(&values, 3.0).to_string(),
        "no voxel lies above the threshold 3: the greatest value is 3"
    );
    assert_eq!(
        error(&values, 0.5),
        SurfaceError::NothingOutside {
            threshold: 0.5,
            smallest: 1.0
        }
    );
    assert!(surface(&frame, &values, 1.0).is_ok());
    assert_eq!(
        error(&[2.0; 27], 2.0),
        SurfaceError::Constant { value: 2.0 }
    );
    assert_eq!(error(&[f32::NAN; 27], 2.0), SurfaceError::NoValues);
    assert_eq!(error(&values, f64::NAN), SurfaceError::Threshold);
    assert_eq!(
        error(&values[..9], 2.0),
        SurfaceError::Count {
            values: 9,
            voxels: 27
        }
    );
    let mask = Mask::new([3; 3], vec![false; 27]).unwrap();
    let empty = mask_surface(&frame, &mask, &Progress::default());
    assert_eq!(empty, Err(SurfaceError::EmptyMask));
    let other = Mask::new([3, 3, 2], vec![true; 18]).unwrap();
    assert!(mask_surface(&frame, &other, &Progress::default()).is_err());
}

#[test]
fn the_greatest_and_smallest_numbers_make_a_mesh() {
    let frame = centred_frame([3, 3, 3], [1.0; 3]);
    let mut values = vec![f32::MIN; 27];
    values[13] = f32::MAX;
    values[12] = f32::INFINITY;
    values[14] = f32::NEG_INFINITY;
    let found = surface(&frame, &values, 0.0).unwrap();
    assert!(is_closed_manifold(&found));
    assert_eq!(found.vertices().len(), 6);
}

#[test]
fn more_vertices_than_a_mesh_may_have_are_refused() {
    // A chequerboard of voxels: every edge of the grid changes side.
    let n = 120;
    let frame = centred_frame([n, n, n], [1.0; 3]);
    let values: Vec<f32> = (0..n * n * n)
        .map(|v| ((v % n + v / n % n + v / n / n) % 2) as f32)
        .collect();
    assert!(matches!(
        surface(&frame, &values, 0.5),
        Err(SurfaceError::TooManyVertices {
            vertices: 5_000_001..,
            ..
        })
    ));
}

#[test]
fn a_stopped_extraction_says_so_and_threads_change_nothing() {
    let frame = centred_frame([20, 20, 20], [1.0; 3]);
    let values = noise([20; 3], 1);
    let progress = Progress::default();
    progress.stop();
    let stopped = isosurface(&frame, &values, 0.0, &progress);
    assert_eq!(stopped, Err(SurfaceError::Stopped(Stopped)));
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        Arc::new(pool.install(|| surface(&frame, &values, 0.0)).unwrap())
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn surfaces_of_masks_do_not_cross_themselves() {
    for seed in 0..40 {
        let size = [9, 8, 7];
        let mask = Mask::above(size, &noise(size, seed), 0.5 - 0.025 * seed as f64).unwrap();
        let found = mask_surface(&centred_frame(size, [1.0; 3]), &mask, &Progress::default());
        let found = found.unwrap();
        let crossing = crossing_faces(found.vertices(), found.triangles(), || true);
        assert_eq!(crossing, Some(0), "{seed}");
        assert!(is_closed_manifold(&found));
    }
}

#[test]
fn smooth_surfaces_do_not_cross_themselves() {
    let frame = centred_frame([24, 24, 24], [1.0, 1.0, 2.0]);
    let waves = |p: Point3| {
        (0.7 * p.x).sin() * (0.6 * p.y + 0.4 * p.z).cos() + (0.5 * p.z - 0.2 * p.x).sin()
    };
    for threshold in [-0.6, -0.1, 0.0, 0.3, 0.9] {
        let found = surface(&frame, &sampled(&frame, waves), threshold).unwrap();
        let crossing = crossing_faces(found.vertices(), found.triangles(), || true);
        assert_eq!(crossing, Some(0), "{threshold}");
    }
}

proptest! {
    #[test]
    fn a_moved_grid_moves_the_surface(
        shift in prop::array::uniform3(-50.0..50.0_f64),
        angles in prop::array::uniform3(-3.0..3.0_f64),
    ) {
        let frame = centred_frame([9, 8, 7], [1.0, 1.5, 2.0]);
        let turn = nalgebra::Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let moved = VolumeFrame::new(
            frame.size(),
            turn * frame.origin() + Vector3::from(shift),
            frame.steps().map(|step| turn * step),
        ).unwrap();
        let values = noise([9, 8, 7], 3);
        let (here, there) = (surface(&frame, &values, 0.1).unwrap(), surface(&moved, &values, 0.1).unwrap());
        prop_assert_eq!(here.triangles(), there.triangles());
        for (p, q) in here.vertices().iter().zip(there.vertices()) {
            prop_assert!((turn * p + Vector3::from(shift) - q).norm() < 1e-12 * 100.0);
        }
    }
}
