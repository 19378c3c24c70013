//! Iterated closest points find a motion again, and say why not.

use super::*;

fn tree(mesh: &TriMesh) -> ClosestPoint {
    ClosestPoint::new(mesh.vertices(), mesh.triangles()).unwrap()
}

fn exact() -> CheckedIcpParams {
    let params = IcpParams {
        max_iterations: 2_000,
        tolerance: 1e-10,
        ..IcpParams::default()
    };
    params.check().unwrap()
}

#[test]
fn a_motion_onto_a_surface_is_found_again() {
    let heart = heart();
    let there = motion([0.1, -0.15, 0.1], [3.0, -2.0, 4.0]);
    let away = moved(&there, heart.vertices());
    let progress = Progress::default();
    let found = icp(
        &away,
        &tree(&heart),
        &RigidMotion::identity(),
        &exact(),
        &progress,
    )
    .unwrap();
    assert!(found.converged && found.kept == away.len());
    for (p, q) in away.iter().zip(heart.vertices()) {
        let miss = (found.motion.apply(p) - q).norm();
        assert!(miss < 1e-4, "{miss} after {} rounds", found.iterations);
    }
    assert!(found.rms < 1e-5);
}

#[test]
fn trimming_leaves_out_what_has_no_counterpart() {
    let heart = heart();
    let there = motion([0.05, -0.05, 0.08], [1.0, -2.0, 1.0]);
    let mut away = moved(&there, heart.vertices());
    // A lump beside the heart, as of a liver: a tenth of the points.
    for (index, p) in away.iter_mut().step_by(10).enumerate() {
        *p += Vector3::new(40.0, 5.0 + 0.1 * index as f64, 0.0);
    }
    let progress = Progress::default();
    let with = |kept_share| {
        let params = IcpParams {
            kept_share,
            max_iterations: 2_000,
            tolerance: 1e-10,
        };
        let found = icp(
            &away,
            &tree(&heart),
            &RigidMotion::identity(),
            &params.check().unwrap(),
            &progress,
        );
        let found = found.unwrap();
        let misses = (away.iter().zip(heart.vertices()).enumerate())
            .filter(|(index, _)| index % 10 != 0)
            .map(|(_, (p, q))| (found.motion.apply(p) - q).norm());
        (misses.fold(0.0, f64::max), found.kept)
    };
    let (all, kept_all) = with(1.0);
    let (trimmed, kept) = with(0.85);
    assert_eq!((kept_all, kept), (642, 546));
    assert!(all > 0.5 && trimmed < 1e-3, "{all} {trimmed}");
}

#[test]
fn what_cannot_be_aligned_says_why() {
    let heart = heart();
    let (tree, progress) = (tree(&heart), Progress::default());
    let params = IcpParams::default().check().unwrap();
    let run = |points: &[Point3]| icp(points, &tree, &RigidMotion::identity(), &params, &progress);
    assert_eq!(
        run(&[]).unwrap_err().to_string(),
        "there are no points to align"
    );
    let nan = [Point3::origin(), Point3::new(f64::NAN, 0.0, 0.0)];
    assert_eq!(run(&nan), Err(IcpError::NotFinite { index: 1 }));
    assert!(run(&[Point3::new(1.0, 2.0, 3.0)]).unwrap().rms < 1e-9);
    assert!(point_target(&[]).is_none());
    for (wrong, name) in [
        (
            IcpParams {
                kept_share: 0.0,
                ..IcpParams::default()
            },
            "share",
        ),
        (
            IcpParams {
                kept_share: f64::NAN,
                ..IcpParams::default()
            },
            "share",
        ),
        (
            IcpParams {
                tolerance: -1.0,
                ..IcpParams::default()
            },
            "tolerance",
        ),
        (
            IcpParams {
                max_iterations: 0,
                ..IcpParams::default()
            },
            "rounds",
        ),
    ] {
        let error = wrong.check().unwrap_err().to_string();
        assert!(error.contains(name), "{error}");
    }
    progress.stop();
    assert_eq!(run(heart.vertices()), Err(IcpError::Stopped(Stopped)));
}

#[test]
fn threads_change_nothing() {
    let heart = heart();
    let away = moved(&motion([0.1, 0.0, 0.1], [3.0, 0.0, 4.0]), heart.vertices());
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let params = IcpParams {
            kept_share: 0.7,
            max_iterations: 9,
            tolerance: 0.0,
        };
        let params = params.check().unwrap();
        pool.install(|| {
            icp(
                &away,
                &tree(&heart),
                &RigidMotion::identity(),
                &params,
                &Progress::default(),
            )
            .unwrap()
        })
    };
    assert_eq!(with(1), with(3));
}
