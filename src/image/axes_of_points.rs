//! Along which axes points extend, and which of them is the long axis of a ventricle.

use nalgebra::{Matrix3, SymmetricEigen};

use crate::mesh::{Point3, Vector3, mean_point};

/// Share of the length at either end whose width says which end is the apex.
const END_SHARE: f64 = 0.25;

/// Where points lie and how far they extend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    /// Their mean.
    pub mean: Point3,
    /// Variances along the axes, descending: eigenvalues of Σ (p − p̄)(p − p̄)ᵀ / (n − 1).
    pub variances: [f64; 3],
    /// The axes, of length 1, in the order of variances; their signs are arbitrary.
    pub directions: [Vector3; 3],
}

/// The long axis of points of a ventricle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LongAxisEnds {
    /// The narrow end.
    pub apex: Point3,
    /// The wide end.
    pub base: Point3,
    /// Ratio of the greatest variance to the next, at least 1: near 1 the axis is arbitrary.
    pub elongation: f64,
}

/// The principal axes of points; `None` of fewer than two, and where all coincide or one is not finite.
pub fn principal_axes(points: &[Point3]) -> Option<PrincipalAxes> {
    if points.len() < 2 {
        return None;
    }
    let mean = mean_point(points.iter().copied());
    let reach = points.iter().fold(0.0_f64, |m, p| m.max((p - mean).amax()));
    let all_finite = points.iter().flat_map(|p| p.iter()).all(|x| x.is_finite());
    if !(all_finite && reach.is_finite() && reach > 0.0) {
        return None;
    }
    // Divided by the reach, so that squares do not overflow.
    let scatter: Matrix3<f64> = (points.iter().map(|p| (p - mean) / reach))
        .map(|away| away * away.transpose())
        .sum();
    let eigen = SymmetricEigen::new(scatter / (points.len() - 1) as f64);
    let mut order = [0, 1, 2];
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    Some(PrincipalAxes {
        mean,
        variances: order.map(|at| eigen.eigenvalues[at].max(0.0) * reach * reach),
        directions: order.map(|at| eigen.eigenvectors.column(at).into_owned()),
    })
}

/// The long axis of points that fill a ventricle, its cavity or its wall: the axis of their greatest variance through their
/// mean, as far as they reach. The apex is at the end where points lie closer to the axis, on the mean over a quarter of the
/// length.
///
/// `None` where there are no axes.
pub fn automatic_long_axis(points: &[Point3]) -> Option<LongAxisEnds> {
    let axes = principal_axes(points)?;
    let [direction, ..] = axes.directions;
    let along = |p: &Point3| direction.dot(&(p - axes.mean));
    let reach = points.iter().map(along);
    let (low, high) = reach.fold((f64::MAX, f64::MIN), |(low, high), x| {
        (low.min(x), high.max(x))
    });
    let width = |is_there: &dyn Fn(f64) -> bool| {
        let end = points.iter().filter(|&p| is_there(along(p)));
        let widths = end.map(|p| (p - axes.mean - direction * along(p)).norm());
        let (sum, count) = widths.fold((0.0, 0_usize), |(sum, count), width| {
            (sum + width, count + 1)
        });
        sum / count.max(1) as f64
    };
    let depth = END_SHARE * (high - low);
    let ends = [low, high].map(|end| axes.mean + direction * end);
    let [apex, base] = if width(&|x| x <= low + depth) <= width(&|x| x >= high - depth) {
        ends
    } else {
        [ends[1], ends[0]]
    };
    Some(LongAxisEnds {
        apex,
        base,
        elongation: axes.variances[0] / axes.variances[1].max(f64::MIN_POSITIVE),
    })
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use nalgebra::Rotation3;
    use proptest::prelude::*;

    use super::*;
    use crate::mesh::phantom;

    /// Points of half an ellipsoid, open above, its pole at (0, 0, −30).
    fn ventricle() -> Vec<Point3> {
        let bowl = phantom::bowl(1.0, 12, 24);
        let scaled = bowl
            .vertices()
            .iter()
            .map(|p| Point3::new(9.0 * p.x, 8.0 * p.y, 30.0 * p.z));
        scaled.collect()
    }

    #[test]
    fn points_without_extent_have_no_axes() {
        let same = [Point3::new(1.0, 2.0, 3.0); 5];
        assert_eq!(principal_axes(&same), None);
        assert_eq!(principal_axes(&same[..1]), None);
        assert_eq!(principal_axes(&[]), None);
        assert_eq!(
            automatic_long_axis(&[Point3::origin(), Point3::new(f64::NAN, 0.0, 0.0)]),
            None
        );
        let line = [
            Point3::origin(),
            Point3::new(0.0, 3.0, 4.0),
            Point3::new(0.0, 6.0, 8.0),
        ];
        let axes = principal_axes(&line).unwrap();
        assert!((axes.variances[0] - 25.0).abs() < 1e-12 && axes.variances[1] < 1e-12);
        assert!((axes.directions[0].dot(&Vector3::new(0.0, 0.6, 0.8)).abs() - 1.0).abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn the_apex_is_the_narrow_end_however_the_heart_lies(
            angles in prop::array::uniform3(-3.0..3.0_f64),
            shift in prop::array::uniform3(-90.0..90.0_f64),
        ) {
            let turn = Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
            let moved: Vec<Point3> = ventricle().iter().map(|p| turn * p + Vector3::from(shift)).collect();
            let found = automatic_long_axis(&moved).unwrap();
            let apex = turn * Point3::new(0.0, 0.0, -30.0) + Vector3::from(shift);
            prop_assert!((found.apex - apex).norm() < 1.0);
            prop_assert!((found.base - found.apex).norm() > 29.0);
            prop_assert!(found.elongation > 1.5);
        }
    }
}
