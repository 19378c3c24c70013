//! Thickness on walls whose thickness is known.

use std::f64::consts::PI;
use std::sync::Arc;

use nalgebra::Rotation3;

use super::*;
use crate::mesh::{Faces, Point3, TriMesh, Vector3, phantom};
use crate::progress::{Progress, Stopped};
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

fn subject(surfaces: Vec<(SurfaceKind, TriMesh)>) -> Subject {
    let surfaces = (surfaces.into_iter())
        .map(|(kind, mesh)| SurfaceSequence::new(kind, vec![mesh]).unwrap())
        .collect();
    let sequence = MeshSequence::new(surfaces).unwrap();
    Subject::new("phantom", sequence, LengthUnit::Millimetre)
}

fn pair(inner: TriMesh, outer: TriMesh) -> Subject {
    subject(vec![
        (SurfaceKind::Endocardium, inner),
        (SurfaceKind::Epicardium, outer),
    ])
}

/// Half shells of 20 and 28 mm around the origin, open at z = 0.
fn half_shell() -> Subject {
    pair(phantom::bowl(20.0, 24, 64), phantom::bowl(28.0, 24, 64))
}

fn moved(mesh: &TriMesh, motion: impl Fn(Point3) -> Point3) -> TriMesh {
    let points: Vec<Point3> = mesh.vertices().iter().map(|&p| motion(p)).collect();
    TriMesh::new(points, Arc::clone(mesh.faces())).unwrap()
}

fn params(voxels_across: f64) -> CheckedThicknessParams {
    let settings = ThicknessParams {
        voxels_across,
        ..ThicknessParams::default()
    };
    settings.check().unwrap()
}

fn measured(subject: &Subject, method: ThicknessMethod) -> Result<ThicknessMap, ThicknessError> {
    thickness(subject, 0, method, &params(8.0), &Progress::default())
}

/// Endocardial vertices deeper than one wall thickness below the rim, with their values.
fn away_from_rim(subject: &Subject, map: &ThicknessMap) -> Vec<(Point3, Option<f64>)> {
    let inner = subject.sequence.surfaces()[0].frames()[0].vertices();
    (inner.iter().copied())
        .zip(map.thickness.iter().copied())
        .filter(|(point, _)| point.z < -8.0)
        .collect()
}

#[test]
fn nearest_distance_and_field_lines_of_a_half_shell_are_its_thickness() {
    let shell = half_shell();
    // The facets of 64 sides around lie 28 (1 − cos π/64) = 0.03 inside the sphere.
    for (method, tolerance) in [
        (ThicknessMethod::Nearest, 0.06),
        (ThicknessMethod::Laplace, 0.16),
    ] {
        let map = measured(&shell, method).unwrap();
        assert_eq!(map.surface, SurfaceKind::Endocardium);
        for (point, value) in away_from_rim(&shell, &map) {
            let value = value.unwrap();
            assert!(
                (value - 8.0).abs() < tolerance,
                "{method:?} {point} {value}"
            );
        }
    }
}

#[test]
fn field_lines_of_closed_spheres_converge_with_the_voxels() {
    let shell = subject(vec![
        (SurfaceKind::Cavity, phantom::sphere(5, 20.0)),
        (SurfaceKind::Epicardium, phantom::sphere(5, 28.0)),
    ]);
    let errors: Vec<f64> = [3.0, 6.0, 12.0]
        .map(|voxels| {
            let progress = Progress::default();
            let map = thickness(
                &shell,
                0,
                ThicknessMethod::Laplace,
                &params(voxels),
                &progress,
            )
            .unwrap();
            assert_eq!(map.count(), map.thickness.len());
            let errors = map.thickness.iter().flatten().map(|t| (t - 8.0).powi(2));
            (errors.sum::<f64>() / map.count() as f64).sqrt()
        })
        .to_vec();
    // Upwind differences are of first order: errors halve.
    for both in errors.windows(2) {
        assert!(both[1] < 0.65 * both[0], "{errors:?}");
    }
    assert!(errors[2] < 0.06, "{errors:?}");
}

#[test]
fn a_slab_of_voxels_is_as_thick_as_its_voxels_whatever_their_shape() {
    let dims = [5, 4, 9];
    let labels = (0..5 * 4 * 9)
        .map(|voxel| match voxel / 20 {
            0 => VoxelLabel::Cavity,
            1..=7 => VoxelLabel::Wall,
            _ => VoxelLabel::Outside,
        })
        .collect();
    let grid = LabelGrid::new(dims, [0.7, 1.1, 1.5], labels).unwrap();
    let field = laplace_field(&grid, &Progress::default()).unwrap();
    assert_eq!(grid.wall_voxels(), field.voxels.len());
    for ((&voxel, u), thickness) in (field.voxels.iter())
        .zip(&field.potential)
        .zip(&field.thickness)
    {
        assert!((u - f64::from(voxel / 20) / 8.0).abs() < 1e-8);
        assert!((thickness - 7.0 * 1.5).abs() < 1e-6, "{thickness}");
    }
}

#[test]
fn chords_of_a_slice_of_a_half_shell_join_its_circles() {
    let shell = half_shell();
    let map = measured(&shell, ThicknessMethod::Centreline).unwrap();
    let inner = shell.sequence.surfaces()[0].frames()[0].vertices();
    for (point, value) in inner.iter().zip(&map.thickness) {
        if point.z < -0.5 && point.z > -17.0 {
            let (z, value) = (point.z, value.unwrap());
            let exact = (784.0 - z * z).sqrt() - (400.0 - z * z).sqrt();
            assert!(
                (value / exact - 1.0).abs() < 0.02,
                "{point} {value} {exact}"
            );
        }
    }
    // Over the tip slices do not tell; the pole is the first vertex.
    assert_eq!(map.thickness[0], None);
}

#[test]
fn chords_between_ellipses_run_across_the_middle_and_not_along_the_rays() {
    // A tube between ellipses of equal wall along the axes: across the centre line the wall
    // is nowhere thicker than along the rays, and at the axes both are 8.
    let squeeze = |a: f64, b: f64| {
        move |p: Point3| {
            let polar = (p.x.hypot(p.y)).max(1e-9);
            Point3::new(a * p.x / polar, b * p.y / polar, 3.0 * p.z)
        }
    };
    let bowl = phantom::bowl(20.0, 24, 96);
    let tube = pair(
        moved(&bowl, squeeze(30.0, 15.0)),
        moved(&bowl, squeeze(38.0, 23.0)),
    );
    let map = measured(&tube, ThicknessMethod::Centreline).unwrap();
    let inner = tube.sequence.surfaces()[0].frames()[0].vertices();
    let (mut least, mut at_axes) = (f64::INFINITY, 0);
    for (point, value) in inner
        .iter()
        .zip(&map.thickness)
        .filter(|(p, _)| (-40.0..-20.0).contains(&p.z))
    {
        let value = value.unwrap();
        assert!(value < 8.1, "{point} {value}");
        least = least.min(value);
        if point.y.abs() < 1e-6 || point.x.abs() < 1e-6 {
            at_axes += 1;
            assert!((value - 8.0).abs() < 0.05, "{point} {value}");
        }
    }
    assert!(at_axes > 0 && least < 7.9, "{least}");
}

#[test]
fn volume_over_area_of_a_half_shell_is_its_thickness_in_every_piece() {
    let shell = half_shell();
    // Between two heights V = 384 π h and A = (56 + 40) π h / 2.
    let map = measured(&shell, ThicknessMethod::VolumeOverArea).unwrap();
    for (point, value) in away_from_rim(&shell, &map) {
        if point.z > -19.99 {
            assert!(
                (value.unwrap() / 8.0 - 1.0).abs() < 0.015,
                "{point} {value:?}"
            );
        }
    }
    let whole = mean_wall_thickness(&phantom::bowl(20.0, 60, 240), &phantom::bowl(28.0, 60, 240));
    let exact = 2.0 / 3.0 * PI * (28.0_f64.powi(3) - 8000.0) / (PI * (784.0 + 400.0));
    assert!((whole.unwrap() / exact - 1.0).abs() < 1e-3);
}

#[test]
fn a_wall_given_as_one_closed_surface_is_measured_as_its_two_sides() {
    let (inner, outer) = (phantom::bowl(20.0, 24, 64), phantom::bowl(28.0, 24, 64));
    let count = inner.vertices().len() as u32;
    let turned = inner.triangles().iter().map(|&[a, b, c]| [a, c, b]);
    let shifted = outer.triangles().iter().map(|t| t.map(|v| v + count));
    let rim = (0..64).flat_map(|step| {
        let [a, b] = [count - 64 + step, count - 64 + (step + 1) % 64];
        [[a, b, a + count], [b, b + count, a + count]]
    });
    let points = [inner.vertices(), outer.vertices()].concat();
    let faces = Faces::new(points.len(), turned.chain(shifted).chain(rim).collect()).unwrap();
    let wall = subject(vec![(
        SurfaceKind::Wall,
        TriMesh::new(points, faces).unwrap(),
    )]);
    for method in [
        ThicknessMethod::Nearest,
        ThicknessMethod::Laplace,
        ThicknessMethod::Centreline,
    ] {
        let [joined, apart] = [&wall, &half_shell()].map(|heart| measured(heart, method).unwrap());
        assert_eq!(joined.surface, SurfaceKind::Wall);
        let inner = &joined.thickness[..count as usize];
        assert!(
            joined.thickness[count as usize + 1..count as usize + 65]
                .iter()
                .all(Option::is_none)
        );
        let deep = away_from_rim(&half_shell(), &apart);
        let same = (deep.iter().zip(inner))
            .filter(|((_, a), b)| match (a, b) {
                (Some(a), Some(b)) => (a - b).abs() < 0.1,
                (a, b) => a.is_none() && b.is_none(),
            })
            .count();
        assert_eq!(same, deep.len(), "{method:?}");
    }
}

#[test]
fn a_rigid_motion_changes_no_thickness() {
    let turn = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    let to = |p: Point3| turn * p + Vector3::new(31.0, -170.0, 66.0);
    let [inner, outer] = [20.0, 28.0].map(|radius| {
        moved(&phantom::bowl(radius, 18, 48), |p| {
            Point3::new(p.x, 0.8 * p.y, 2.0 * p.z)
        })
    });
    let still = pair(inner.clone(), outer.clone());
    let after = pair(moved(&inner, to), moved(&outer, to));
    // Voxels lie otherwise: a tenth of one is allowed.
    for (method, tolerance) in [
        (ThicknessMethod::Nearest, 1e-9),
        (ThicknessMethod::Centreline, 1e-6),
        (ThicknessMethod::Laplace, 0.25),
        (ThicknessMethod::VolumeOverArea, 0.15),
    ] {
        let [before, after] = [&still, &after].map(|heart| measured(heart, method).unwrap());
        for ((point, before), (_, after)) in away_from_rim(&still, &before)
            .into_iter()
            .zip(away_from_rim(&still, &after))
        {
            if let (Some(a), Some(b)) = (before, after) {
                assert!((a - b).abs() < tolerance, "{method:?} {point} {a} {b}");
            } else {
                assert_eq!(before, after, "{method:?} {point}");
            }
        }
    }
}

#[test]
fn methods_agree_on_hearts_of_the_built_in_cohort() {
    let built = cohort(&BuiltInParams::default()).unwrap();
    let heart = &built.study.subjects[0];
    let maps = all_methods(heart, 0, &params(6.0), &Progress::default()).unwrap();
    let medians: Vec<f64> = maps
        .iter()
        .map(|m| m.as_ref().unwrap().median().unwrap())
        .collect();
    for median in &medians {
        assert!((median / medians[0] - 1.0).abs() < 0.12, "{medians:?}");
    }
}

#[test]
fn any_number_of_threads_gives_the_same_bits() {
    let shell = half_shell();
    for method in ThicknessMethod::ALL {
        let [one, three] = [1, 3].map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| measured(&shell, method).unwrap())
        });
        assert_eq!(one, three);
    }
}

#[test]
fn hearts_without_a_wall_are_refused_and_damage_does_no_harm() {
    let sphere = || phantom::sphere(2, 20.0);
    let alone = subject(vec![(SurfaceKind::Endocardium, sphere())]);
    assert_eq!(
        measured(&alone, ThicknessMethod::Nearest),
        Err(ThicknessError::NoSide { missing: "outer" })
    );
    let same = pair(sphere(), sphere());
    assert!(measured(&same, ThicknessMethod::Laplace).is_err());
    let closed = pair(sphere(), phantom::sphere(2, 28.0));
    assert!(matches!(
        measured(&closed, ThicknessMethod::Centreline),
        Err(ThicknessError::Axis(_))
    ));
    let swapped = pair(phantom::sphere(2, 28.0), sphere());
    assert!(matches!(
        measured(&swapped, ThicknessMethod::Laplace),
        Err(ThicknessError::NoWall { voxels: 0, .. })
    ));
    let triangle = |z: f64| {
        let points = vec![
            Point3::new(0.0, 0.0, z),
            Point3::new(9.0, 0.0, z),
            Point3::new(0.0, 9.0, z),
        ];
        TriMesh::new(points, Faces::new(3, vec![[0, 1, 2]]).unwrap()).unwrap()
    };
    let flat = pair(triangle(0.0), triangle(2.0));
    for method in ThicknessMethod::ALL {
        if let Ok(map) = measured(&flat, method) {
            assert!(map.thickness.iter().flatten().all(|t| t.is_finite()));
        }
    }
    assert_eq!(
        thickness(
            &flat,
            4,
            ThicknessMethod::Nearest,
            &params(8.0),
            &Progress::default()
        ),
        Err(ThicknessError::NoFrame {
            frame: 4,
            frames: 1
        })
    );
    let wrong = ThicknessParams {
        chords: 3,
        ..ThicknessParams::default()
    };
    assert_eq!(
        wrong.check().unwrap_err().to_string(),
        "number of chords is 3, but must be from 12 to 2000"
    );
    assert!(LabelGrid::new([2, 2, 2], [1.0; 3], vec![VoxelLabel::Wall; 7]).is_err());
    // Wall without any side: no thickness, no endless loop.
    let lonely = LabelGrid::new([2, 2, 2], [1.0; 3], vec![VoxelLabel::Wall; 8]).unwrap();
    let field = laplace_field(&lonely, &Progress::default()).unwrap();
    assert!(field.thickness.iter().all(|t| t.is_nan()));
}

#[test]
fn every_method_hears_stop() {
    let shell = half_shell();
    let progress = Progress::default();
    progress.stop();
    for method in ThicknessMethod::ALL {
        assert_eq!(
            thickness(&shell, 0, method, &params(8.0), &progress),
            Err(ThicknessError::Stopped(Stopped))
        );
    }
    assert_eq!(
        all_methods(&shell, 0, &params(8.0), &progress),
        Err(Stopped)
    );
}
