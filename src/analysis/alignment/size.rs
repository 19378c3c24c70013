//! One isotropic scale per sequence, kept so that millimetres can be restored.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

use crate::mesh::{Point3, mean_point};

/// The factor that a sequence's coordinates are divided by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeScale {
    /// The largest box side at end-diastole, in the length unit of the coordinates.
    pub largest_side: f64,
}

impl SizeScale {
    /// The scale of a sequence from its vertices at end-diastole.
    ///
    /// Lengths over this one are comparable between subjects; size changes within the beat stay.
    /// The box lies along the principal axes of the vertices and not along those of the file, so
    /// that turning a subject does not change its scale.
    ///
    /// `None` where all points coincide, there are none, or their extent overflows.
    pub fn of_end_diastole(points: &[Point3]) -> Option<Self> {
        let largest_side = principal_box_sides(points)?[0];
        (largest_side.is_finite() && largest_side > 0.0).then_some(Self { largest_side })
    }

    /// The point in units of the largest side.
    pub fn normalised(&self, point: &Point3) -> Point3 {
        point / self.largest_side
    }

    /// The point back in the coordinates of the file.
    pub fn restored(&self, point: &Point3) -> Point3 {
        point * self.largest_side
    }
}

/// Sides of the box along the principal axes of the points, descending; `None` without points.
///
/// The axes are eigenvectors of Σ (p − p̄)(p − p̄)ᵀ. Where two eigenvalues are equal the axes
/// between them are not fixed, and the two sides may exchange a little length.
pub fn principal_box_sides(points: &[Point3]) -> Option<[f64; 3]> {
    if points.is_empty() {
        return None;
    }
    let centre = mean_point(points.iter().copied()).coords;
    let reach = points
        .iter()
        .fold(0.0_f64, |m, p| m.max((p.coords - centre).amax()));
    // Points that coincide, or whose extent overflows, have no axes.
    if !(reach.is_finite() && reach > 0.0) {
        return Some([reach; 3]);
    }
    // Divided by the reach, so that squares of large coordinates do not overflow.
    let scatter: Matrix3<f64> = points
        .iter()
        .map(|p| (p.coords - centre) / reach)
        .map(|offset| offset * offset.transpose())
        .sum();
    // Eigenvectors turn with the points, so that the box does not depend on the axes of the file.
    let axes = SymmetricEigen::new(scatter).eigenvectors;
    let mut sides = [0, 1, 2].map(|column| {
        let axis: Vector3<f64> = axes.column(column).into();
        let along = points.iter().map(|p| axis.dot(&(p.coords - centre)));
        let (low, high) = along.fold((f64::MAX, f64::MIN), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        high - low
    });
    sides.sort_by(|a, b| b.total_cmp(a));
    Some(sides)
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Rotation3;

    #[test]
    fn the_scale_is_the_long_axis_however_the_heart_lies() {
        let corners = (0..8).map(|i| {
            Point3::new(
                f64::from(i & 1) * 10.0,
                f64::from(i >> 1 & 1) * 4.0,
                f64::from(i >> 2) * 3.0,
            )
        });
        let turn = Rotation3::from_euler_angles(0.4, 1.1, -2.0);
        let turned: Vec<Point3> = corners.map(|p| turn * p).collect();
        let scale = SizeScale::of_end_diastole(&turned).unwrap();
        assert!((scale.largest_side - 10.0).abs() < 1e-12);
        let back = scale.restored(&scale.normalised(&turned[7]));
        assert!((back - turned[7]).norm() < 1e-13);
    }

    #[test]
    fn coinciding_points_have_no_scale() {
        assert_eq!(SizeScale::of_end_diastole(&[]), None);
        let same = vec![Point3::new(1.0, 1.0, 1.0); 4];
        assert_eq!(SizeScale::of_end_diastole(&same), None);
    }
}
