//! Thin-plate splines meet landmarks, leave affine maps alone and refuse what decides nothing.

use nalgebra::Matrix3;

use super::*;

fn landmarks() -> Vec<Point3> {
    let heart = heart();
    heart.vertices().iter().step_by(41).copied().collect()
}

fn bent(points: &[Point3]) -> Vec<Point3> {
    let bend = |p: &Point3| {
        Point3::new(
            p.x + 3.0 * (0.1 * p.y).sin(),
            1.1 * p.y,
            p.z - 0.004 * p.x * p.x,
        )
    };
    points.iter().map(bend).collect()
}

#[test]
fn landmarks_are_met_and_many_points_are_moved_as_one_is() {
    let (source, target) = (landmarks(), bent(&landmarks()));
    assert_eq!(source.len(), 16);
    let spline = ThinPlateSpline::new(&source, &target, 0.0).unwrap();
    for (p, q) in source.iter().zip(&target) {
        assert!((spline.apply(p) - q).norm() < 1e-10);
    }
    let heart = heart();
    let together = spline.apply_all(heart.vertices());
    for (p, q) in heart.vertices().iter().zip(&together) {
        assert!((spline.apply(p) - q).norm() < 1e-11);
    }
    assert_eq!(spline.foldovers(heart.vertices()), 0);
    assert!(spline.bending_energy() > 0.0);
    assert!(spline.apply_all(&[]).is_empty());
}

#[test]
fn smoothing_bends_less_and_less_and_ends_in_an_affine_map() {
    let (source, target) = (landmarks(), bent(&landmarks()));
    let mut last = f64::INFINITY;
    for smoothing in [0.0, 1.0, 10.0, 100.0, 1e4, 1e9] {
        let energy = ThinPlateSpline::new(&source, &target, smoothing)
            .unwrap()
            .bending_energy();
        assert!(energy < last && energy >= 0.0, "{smoothing}: {energy}");
        last = energy;
    }
    assert!(last < 1e-12, "{last}");
}

#[test]
fn the_derivative_is_that_of_the_map_and_a_folded_map_is_told() {
    let (source, target) = (landmarks(), bent(&landmarks()));
    let spline = ThinPlateSpline::new(&source, &target, 0.0).unwrap();
    let at = Point3::new(3.0, -7.0, 11.0);
    let step = 1e-4;
    for axis in 0..3 {
        let h = Vector3::ith(axis, step);
        let slope = (spline.apply(&(at + h)) - spline.apply(&(at - h))) / (2.0 * step);
        assert!((spline.derivative(&at).column(axis) - slope).norm() < 1e-7);
    }
    let mut crossed = target;
    // One landmark is pulled through to the other side.
    crossed[0] += Vector3::new(0.0, 0.0, -200.0);
    let folded = ThinPlateSpline::new(&source, &crossed, 0.0).unwrap();
    assert!(folded.foldovers(heart().vertices()) > 0);
    let mirrored: Vec<Point3> = source.iter().map(|p| Point3::new(-p.x, p.y, p.z)).collect();
    let mirror = ThinPlateSpline::new(&source, &mirrored, 0.0).unwrap();
    assert_eq!(mirror.foldovers(&source), 16);
}

#[test]
fn landmarks_that_decide_nothing_are_refused() {
    use ThinPlateSplineError as Error;
    let points = landmarks();
    let new = |source: &[Point3], target: &[Point3], smoothing| {
        ThinPlateSpline::new(source, target, smoothing).unwrap_err()
    };
    assert_eq!(
        new(&points[..3], &points[..3], 0.0),
        Error::TooFew { count: 3 }
    );
    assert_eq!(
        new(&points[..5], &points[..4], 0.0).to_string(),
        "5 landmarks cannot correspond with 4"
    );
    let many = vec![Point3::origin(); 1_025];
    assert_eq!(new(&many, &many, 0.0), Error::TooMany { count: 1_025 });
    let mut twice = points.clone();
    twice[7] = twice[2];
    let error = new(&twice, &points, 0.0);
    assert_eq!(
        error,
        Error::Coincident {
            first: 2,
            second: 7
        }
    );
    assert_eq!(error.to_string(), "landmarks 3 and 8 lie in one place");
    // Smoothed, both are approached.
    assert!(ThinPlateSpline::new(&twice, &points, 1.0).is_ok());
    let far = Vector3::new(1e6, -2e6, 3e6);
    for flat in [
        points
            .iter()
            .map(|p| Point3::new(p.x, p.y, 2.0 * p.x - p.y))
            .collect::<Vec<_>>(),
        points
            .iter()
            .map(|p| Point3::new(p.x, p.y, 0.0) + far)
            .collect(),
        points
            .iter()
            .map(|p| Point3::new(p.x, 2.0 * p.x, 1.0))
            .collect(),
        vec![Point3::new(0.1, 0.2, 0.3) + far; 16],
    ] {
        assert_eq!(new(&flat, &points, 0.0), Error::Coplanar);
        assert_eq!(new(&flat, &points, 5.0), Error::Coplanar);
    }
    let mut damaged = points.clone();
    damaged[5].y = f64::INFINITY;
    assert_eq!(new(&points, &damaged, 0.0), Error::NotFinite { index: 5 });
    assert_eq!(new(&damaged, &points, 0.0), Error::NotFinite { index: 5 });
    assert_eq!(new(&points, &points, -1.0), Error::Smoothing(-1.0));
    assert!(matches!(
        new(&points, &points, f64::NAN),
        Error::Smoothing(_)
    ));
}

#[test]
fn all_landmarks_may_have_one_target() {
    let points = landmarks();
    let spline = ThinPlateSpline::new(&points, &[Point3::new(100.0, -3.0, 7.0); 16], 0.0).unwrap();
    assert!((spline.apply(&Point3::origin()) - Point3::new(100.0, -3.0, 7.0)).norm() < 1e-9);
}

#[test]
fn threads_change_nothing() {
    let spline = ThinPlateSpline::new(&landmarks(), &bent(&landmarks()), 0.5).unwrap();
    let points = phantom::sphere(5, 40.0);
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| spline.apply_all(points.vertices()))
    };
    assert_eq!(with(1), with(3));
}

proptest! {
    #[test]
    fn affine_maps_are_left_as_they_are(
        entries in prop::array::uniform9(-2.0..2.0_f64),
        shift in prop::array::uniform3(-500.0..500.0_f64),
        smoothing in 0.0..50.0_f64,
    ) {
        let (linear, shift) = (Matrix3::from_row_slice(&entries), Vector3::from(shift));
        let source = landmarks();
        let target: Vec<Point3> = source.iter().map(|p| Point3::from(linear * p.coords + shift)).collect();
        let spline = ThinPlateSpline::new(&source, &target, smoothing).unwrap();
        for p in heart().vertices().iter().map(|p| p * 2.0) {
            let expected = Point3::from(linear * p.coords + shift);
            prop_assert!((spline.apply(&p) - expected).norm() < 1e-9);
        }
        prop_assert!((spline.linear() - linear).amax() < 1e-10);
    }

    #[test]
    fn moving_landmarks_and_targets_moves_the_map(
        angles in prop::array::uniform3(-3.0..3.0_f64),
        shift in prop::array::uniform3(-300.0..300.0_f64),
        smoothing in 0.0..50.0_f64,
    ) {
        let (source, target) = (landmarks(), bent(&landmarks()));
        let there = motion(angles, shift);
        let here = ThinPlateSpline::new(&source, &target, smoothing).unwrap();
        let far = ThinPlateSpline::new(&moved(&there, &source), &moved(&there, &target), smoothing).unwrap();
        for p in heart().vertices().iter().step_by(17) {
            let difference = there.apply(&here.apply(p)) - far.apply(&there.apply(p));
            prop_assert!(difference.norm() < 1e-8, "{}", difference.norm());
        }
    }
}
