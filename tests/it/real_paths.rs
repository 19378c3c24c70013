//! Cheapest paths between real poses: a horse at a gallop, a heart from end-diastole to end-systole.

use std::path::PathBuf;

use cardiomorph::analysis::alignment::rigid_motion;
use cardiomorph::analysis::geodesics::{GeodesicParams, GeodesicPath, geodesic};
use cardiomorph::analysis::transport::{TransportParams, transport_deformation};
use cardiomorph::mesh::{CappedSheet, Faces, Point3, sheets};
use cardiomorph::progress::Progress;
use cardiomorph::study::built_in::{BuiltInParams, cohort};
use cardiomorph::study::{SurfaceKind, SurfaceSequence};

use crate::shared::{opened, shared_data};

fn surface(folder: PathBuf, kind: SurfaceKind) -> SurfaceSequence {
    let study = opened(folder);
    let sequence = &study.subjects[0].sequence;
    sequence.surface(kind).unwrap().clone()
}

/// Volume inside the surface, its openings closed by lids.
fn volumes(faces: &Faces, poses: &[Vec<Point3>]) -> Vec<f64> {
    let caps: Vec<CappedSheet> = (sheets(faces).unwrap().iter())
        .map(|sheet| CappedSheet::new(faces.vertex_count(), sheet).unwrap())
        .collect();
    let of = |pose: &Vec<Point3>| caps.iter().map(|cap| cap.signed_volume(pose)).sum::<f64>();
    poses.iter().map(|pose| of(pose).abs()).collect()
}

/// With the default metric and 7 interpolated poses: volumes within the range of the ends and a margin, no step
/// over twice another, cheaper than the straight line.
fn is_sound(
    name: &str,
    surface: &SurfaceSequence,
    [from, to]: [usize; 2],
    tolerance: f64,
    margin: f64,
) -> GeodesicPath {
    let params = GeodesicParams {
        interpolated_poses: 7,
        tolerance,
        ..GeodesicParams::default()
    };
    let faces = surface.faces();
    let (start, end) = (
        surface.frames()[from].vertices(),
        surface.frames()[to].vertices(),
    );
    let params = params.check().unwrap();
    let path = geodesic(faces, start, end, &params, &Progress::default()).unwrap();
    let volumes = volumes(faces, &path.poses);
    let steps = path.step_lengths.iter();
    let longest = steps.clone().copied().fold(0.0, f64::max);
    let shortest = steps.copied().fold(f64::INFINITY, f64::min);
    let (ends, inside) = ([volumes[0], volumes[8]], &volumes[1..8]);
    println!(
        "{name}: energy {:.4} of the straight line's, longest step {:.3} of the shortest, {} iterations, \
         {} pairs of faces cross, volumes {volumes:.4?}",
        path.energy / path.energy_linear,
        longest / shortest,
        path.iterations,
        path.self_intersections,
    );
    let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    for volume in inside {
        assert!(
            ((1.0 - margin) * low..=(1.0 + margin) * high).contains(volume),
            "{name}: {volumes:?}"
        );
    }
    assert!(longest <= 2.0 * shortest, "{name}: {:?}", path.step_lengths);
    assert!(path.energy < path.energy_linear, "{name}");
    path
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_way_from_end_diastole_to_end_systole_does_not_collapse() {
    for (kind, name) in [
        (SurfaceKind::Endocardium, "endocardium"),
        (SurfaceKind::Epicardium, "epicardium"),
    ] {
        let folder = shared_data("cine_mri/bivme_patient1");
        let tolerance = GeodesicParams::default().tolerance;
        // End-diastole is the largest volume of the table, end-systole the smallest.
        let path = is_sound(name, &surface(folder, kind), [24, 9], tolerance, 0.02);
        assert_eq!(path.self_intersections, 0, "{name}");
    }
}

/// Legs that turn lose volume along the straight line, 3.2 % below the smaller end; the path keeps it within 0.6 %
/// above the larger one.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_way_of_a_galloping_horse_does_not_collapse() {
    let folder = shared_data("horse_gallop");
    is_sound(
        "horse",
        &surface(folder, SurfaceKind::Other),
        [0, 5],
        GeodesicParams::default().tolerance,
        0.02,
    );
}

/// Root mean square distance over vertices, of the frame where it is largest.
fn apart(a: &[Vec<Point3>], b: &[Vec<Point3>]) -> f64 {
    let frames = a.iter().zip(b).map(|(a, b)| {
        let squares = a.iter().zip(b).map(|(p, q)| (p - q).norm_squared());
        (squares.sum::<f64>() / a.len() as f64).sqrt()
    });
    frames.fold(0.0, f64::max)
}

/// By how much a motion that was transported onto another subject and back differs from itself, as a share of the motion,
/// with 0, 1, 3 and 7 interpolated poses. Both ways go along the same geodesic, which is searched for from either end.
fn loops(faces: &Faces, source: &[Vec<Point3>], onto: &[Point3]) -> [f64; 4] {
    let still = vec![source[0].clone(); source.len()];
    let moved = apart(source, &still);
    [0, 1, 3, 7].map(|interpolated_poses| {
        let params = TransportParams {
            interpolated_poses,
            ..TransportParams::default()
        };
        let (params, progress) = (params.check().unwrap(), Progress::default());
        let transport = |source: &[Vec<Point3>], onto: &[Point3]| {
            let found = transport_deformation(faces, source, onto, &params, &progress).unwrap();
            assert_eq!(found.account.not_converged(), 0, "{:?}", found.account);
            found.poses
        };
        let there = transport(source, onto);
        apart(&transport(&there, &source[0]), source) / moved
    })
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_real_motion_that_is_transported_there_and_back_returns() {
    for kind in [SurfaceKind::Endocardium, SurfaceKind::Epicardium] {
        let of = |folder| surface(shared_data(folder), kind);
        let from = of("cine_mri/bivme_patient1");
        let onto = of("cine_mri/bivme_testpatient2_EDES");
        let onto = onto.frames()[0].vertices();
        let laid = rigid_motion(from.frames()[0].vertices(), onto).unwrap();
        let source: Vec<Vec<Point3>> = (from.frames().iter())
            .map(|frame| frame.vertices().iter().map(|p| laid.apply(p)).collect())
            .collect();
        let gaps = loops(from.faces(), &source, onto);
        println!("cine_mri, {kind:?}, there and back, as shares of the motion: {gaps:.4?}");
        // Endocardium 2.6, 1.6, 1.0 % with 1, 3 and 7 poses; epicardium 0.9, 0.5, 0.8 %.
        returns(&gaps, 0.04);
    }
}

#[test]
fn a_built_in_motion_that_is_transported_there_and_back_returns() {
    let params = BuiltInParams {
        vertices: 800,
        ..BuiltInParams::default()
    };
    let study = cohort(&params).unwrap().study;
    // N01, and P05 with a large patch.
    let [from, onto] = [0, 13].map(|index| &study.subjects[index].sequence);
    let faces = from.joined_faces();
    let onto = onto.pose(0).unwrap();
    let laid = rigid_motion(&from.pose(0).unwrap(), &onto).unwrap();
    let source: Vec<Vec<Point3>> = (0..from.frame_count())
        .map(|frame| {
            from.pose(frame)
                .unwrap()
                .iter()
                .map(|p| laid.apply(p))
                .collect()
        })
        .collect();
    let gaps = loops(&faces, &source, &onto);
    println!("built-in, there and back, as shares of the motion: {gaps:.4?}");
    // 0.04, 0.02 and 0.01 %.
    returns(&gaps, 0.001);
}

/// Along the straight line nothing is lost on the way back; along a geodesic, which is searched for from either end, as much
/// as was measured, with a margin.
fn returns(gaps: &[f64; 4], most: f64) {
    assert!(gaps[0] < 1e-9, "{gaps:?}");
    assert!(gaps.iter().all(|gap| *gap < most), "{gaps:?}");
}

/// Of one subject onto another, from end-diastole on, endocardium and epicardium.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn interpolated_poses_change_a_real_transport_and_more_of_them_change_it_less() {
    for kind in [SurfaceKind::Endocardium, SurfaceKind::Epicardium] {
        let from = surface(shared_data("cine_mri/bivme_patient1"), kind);
        let onto = surface(shared_data("cine_mri/bivme_testpatient2_EDES"), kind);
        let changes = changes_of_transport(&from, onto.frames()[0].vertices());
        println!("{kind:?}: changes, as shares of the motion: {changes:.4?}");
        assert!(changes[0] > 0.03, "{changes:?}");
        assert!(
            changes.windows(2).all(|pair| pair[1] < pair[0]),
            "{changes:?}"
        );
    }
}

/// By how much a transported motion changes from 0 to 1, 3, 7 and 15 interpolated poses: root mean square over vertices of
/// the frame where it is largest, over that of the motion.
fn changes_of_transport(from: &SurfaceSequence, onto: &[Point3]) -> Vec<f64> {
    let laid = rigid_motion(from.frames()[0].vertices(), onto).unwrap();
    let source: Vec<Vec<Point3>> = (from.frames().iter())
        .map(|frame| frame.vertices().iter().map(|p| laid.apply(p)).collect())
        .collect();
    let transported = [0, 1, 3, 7, 15].map(|interpolated_poses| {
        let params = TransportParams {
            interpolated_poses,
            ..TransportParams::default()
        };
        let (params, progress) = (params.check().unwrap(), Progress::default());
        let found = transport_deformation(from.faces(), &source, onto, &params, &progress).unwrap();
        let account = &found.account;
        assert_eq!(account.steps.len(), source.len() - 1);
        assert!(account.norm_change() < 1e-9 && account.product_change() < 1e-9);
        for path in &account.paths {
            println!(
                "{interpolated_poses}: energy {:.4} of the straight line's",
                path.energy_share()
            );
            assert!(
                path.converged && path.energy < 0.99 * path.energy_linear,
                "{path:?}"
            );
        }
        assert_eq!(account.paths.len(), usize::from(interpolated_poses > 0));
        found.poses
    });
    let moved = apart(&transported[0], &vec![onto.to_vec(); source.len()]);
    (transported.windows(2))
        .map(|pair| apart(&pair[0], &pair[1]) / moved)
        .collect()
}
