//! Turning a heart upright: its long axis along z, its septum towards x.

use nalgebra::Matrix3;

use super::{FrameError, VolumeFrame};
use crate::mesh::{Point3, Vector3};

/// Sine of the angle between the long axis and the direction of the septum below which the latter says nothing.
const MIN_SINE: f64 = 1e-3;

/// A rotation about a point that stays where it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reorientation {
    /// R, with determinant +1.
    pub rotation: Matrix3<f64>,
    /// The point that stays.
    pub pivot: Point3,
}

/// Why points say no orientation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ReorientationError {
    /// A coordinate is NaN or infinite.
    #[error("a landmark has a coordinate that is not a finite number")]
    NotFinite,
    /// Apex and base are one place.
    #[error("apex and base lie in one place: there is no long axis")]
    NoAxis,
    /// The septum is not beside the axis.
    #[error("the septum lies on the long axis: it says no direction across it")]
    SeptumOnAxis,
}

/// The smallest rotation that takes a direction to z; for −z, where all half turns are as small, that about x.
///
/// With n the direction and v = n × z, R = I + \[v\]× + \[v\]×² / (1 + n·z) (Rodrigues), written so that nothing cancels near −z. `None` if there is no direction.
pub fn rotation_to_z(direction: Vector3) -> Option<Matrix3<f64>> {
    // Scaled first, so that the squares of very small and large numbers are neither lost nor too large.
    let greatest = direction.amax();
    if !direction.iter().all(|x| x.is_finite()) || greatest == 0.0 {
        return None;
    }
    let n = (direction / greatest).normalize();
    let (x, y, z) = (n.x, n.y, n.z);
    let aside = x.abs().max(y.abs());
    if aside == 0.0 {
        let diagonal = if z > 0.0 {
            [1.0, 1.0, 1.0]
        } else {
            [1.0, -1.0, -1.0]
        };
        return Some(Matrix3::from_diagonal(&Vector3::from(diagonal)));
    }
    let across = (x / aside).hypot(y / aside);
    let (a, b) = (x / aside / across, y / aside / across);
    // 1 − z, where that would be lost in rounding by (x² + y²) / (1 + z).
    let m = if z > 0.0 {
        (x * x + y * y) / (1.0 + z)
    } else {
        1.0 - z
    };
    Some(Matrix3::new(
        1.0 - m * a * a,
        -m * a * b,
        -x,
        -m * a * b,
        1.0 - m * b * b,
        -y,
        x,
        y,
        z,
    ))
}

impl Reorientation {
    /// Takes the direction from the apex to the base to +z, about their middle, and, if a point towards the septum is given,
    /// its direction across the axis to +x; the anterior wall is then towards +y. Without it the rotation is the smallest.
    ///
    /// # Errors
    /// If a number is not finite, apex and base are one place, or the septum lies on the axis.
    pub fn upright(
        apex: Point3,
        base: Point3,
        septum: Option<Point3>,
    ) -> Result<Self, ReorientationError> {
        let all = [Some(apex), Some(base), septum];
        if !all
            .iter()
            .flatten()
            .flat_map(|p| p.iter())
            .all(|x| x.is_finite())
        {
            return Err(ReorientationError::NotFinite);
        }
        let smallest = rotation_to_z(base - apex).ok_or(ReorientationError::NoAxis)?;
        let pivot = nalgebra::center(&apex, &base);
        let rotation = match septum {
            None => smallest,
            Some(septum) => {
                let towards = smallest * (septum - pivot);
                let across = towards.x.hypot(towards.y);
                if across.is_nan() || across <= MIN_SINE * towards.norm() {
                    return Err(ReorientationError::SeptumOnAxis);
                }
                let (cos, sin) = (towards.x / across, towards.y / across);
                Matrix3::new(cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0, 1.0) * smallest
            }
        };
        Ok(Self { rotation, pivot })
    }

    /// The point after the rotation.
    pub fn apply(&self, point: &Point3) -> Point3 {
        self.pivot + self.rotation * (point - self.pivot)
    }

    /// The point back where it was.
    pub fn restored(&self, point: &Point3) -> Point3 {
        self.pivot + self.rotation.transpose() * (point - self.pivot)
    }

    /// The grid of a volume after the rotation: values stay with their voxels, which are turned.
    ///
    /// # Errors
    /// If positions overflow.
    pub fn turned_frame(&self, frame: &VolumeFrame) -> Result<VolumeFrame, FrameError> {
        let steps = frame.steps().map(|step| self.rotation * step);
        VolumeFrame::new(frame.size(), self.apply(&frame.origin()), steps)
    }

    /// A grid along the axes of the world with voxels of `spacing_mm` that covers a volume after the rotation: what
    /// [`Sampler::resampled`](super::Sampler::resampled) may be given together with [`turned_frame`](Self::turned_frame).
    ///
    /// # Errors
    /// If the spacing is not positive, or the grid would have more voxels than can be counted.
    pub fn upright_frame(
        &self,
        frame: &VolumeFrame,
        spacing_mm: [f64; 3],
    ) -> Result<VolumeFrame, FrameError> {
        let turned = self.turned_frame(frame)?;
        let last = frame.size().map(|n| (n - 1) as f64);
        let (mut low, mut high) = ([f64::MAX; 3], [f64::MIN; 3]);
        for corner in 0..8 {
            let place = [0, 1, 2].map(|axis| last[axis] * f64::from(corner >> axis & 1));
            let position = turned.position(Point3::from(place));
            for axis in 0..3 {
                low[axis] = low[axis].min(position[axis]);
                high[axis] = high[axis].max(position[axis]);
            }
        }
        // What is no number or negative becomes 0 voxels, which is no grid.
        let size = [0, 1, 2].map(|axis| {
            let steps = (high[axis] - low[axis]) / spacing_mm[axis];
            let is_usable = spacing_mm[axis] > 0.0 && steps.is_finite();
            if is_usable {
                ((steps - 1e-9).ceil() as usize).saturating_add(1)
            } else {
                0
            }
        });
        let steps = [0, 1, 2].map(|axis| Vector3::ith(axis, spacing_mm[axis]));
        VolumeFrame::new(size, Point3::from(low), steps)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::image::{Interpolation, Sampler};
    use crate::progress::Progress;

    #[test]
    fn directions_along_z_and_close_to_it_are_turned_exactly() {
        let turned = |x: f64, y: f64, z: f64| rotation_to_z(Vector3::new(x, y, z)).unwrap();
        assert_eq!(turned(0.0, 0.0, 7.0), Matrix3::identity());
        assert_eq!(
            turned(0.0, 0.0, -7.0) * Vector3::new(0.0, 0.0, -1.0),
            Vector3::z()
        );
        for small in [1e-3, 1e-7, 1e-9, 1e-12, 1e-160, 5e-324] {
            for z in [1.0, -1.0, 1e-3, 1e200, -1e-300] {
                let direction = Vector3::new(small, -2.0 * small, z);
                let rotation = turned(direction.x, direction.y, direction.z);
                let unit = (direction / direction.amax()).normalize();
                assert!(
                    (rotation * unit - Vector3::z()).amax() < 1e-14,
                    "{small} {z}"
                );
                assert!((rotation * rotation.transpose() - Matrix3::identity()).amax() < 1e-14);
                assert!((rotation.determinant() - 1.0).abs() < 1e-14);
            }
        }
        assert_eq!(rotation_to_z(Vector3::zeros()), None);
        assert_eq!(rotation_to_z(Vector3::new(f64::NAN, 0.0, 1.0)), None);
    }

    #[test]
    fn landmarks_that_say_no_orientation_are_refused() {
        let (apex, base) = (Point3::new(1.0, 2.0, 3.0), Point3::new(1.0, 2.0, 93.0));
        let upright = Reorientation::upright;
        assert_eq!(upright(apex, apex, None), Err(ReorientationError::NoAxis));
        let on_axis = Some(Point3::new(1.0, 2.0, 40.0));
        assert_eq!(
            upright(apex, base, on_axis),
            Err(ReorientationError::SeptumOnAxis)
        );
        assert_eq!(
            upright(apex, base, Some(nalgebra::center(&apex, &base))),
            Err(ReorientationError::SeptumOnAxis)
        );
        let nan = Point3::new(f64::NAN, 0.0, 0.0);
        assert_eq!(upright(apex, nan, None), Err(ReorientationError::NotFinite));
        assert_eq!(
            upright(apex, base, Some(nan)),
            Err(ReorientationError::NotFinite)
        );
        let frame =
            VolumeFrame::new([2, 2, 2], apex, [Vector3::x(), Vector3::y(), Vector3::z()]).unwrap();
        let still = upright(apex, base, None).unwrap();
        for wrong in [0.0, -1.0, f64::NAN, 1e-300] {
            assert!(
                still.upright_frame(&frame, [1.0, wrong, 1.0]).is_err(),
                "{wrong}"
            );
        }
    }

    #[test]
    fn what_was_at_a_place_is_found_where_that_place_is_turned_to() {
        let steps = [
            Vector3::new(1.0, 0.0, 0.0),
            Vector3::new(0.0, 1.0, 0.0),
            Vector3::new(0.0, 0.0, 2.0),
        ];
        let frame =
            VolumeFrame::new([40, 40, 20], Point3::new(-20.0, -20.0, -20.0), steps).unwrap();
        let blob = Point3::new(3.0, -5.0, 4.0);
        let [nx, ny, _] = frame.size();
        let values: Vec<f32> = (0..frame.voxel_count())
            .map(|v| Point3::new((v % nx) as f64, (v / nx % ny) as f64, (v / nx / ny) as f64))
            .map(|place| (-(frame.position(place) - blob).norm_squared() / 20.0).exp() as f32)
            .collect();
        let (apex, base) = (Point3::new(10.0, 4.0, -9.0), Point3::new(-8.0, 2.0, 7.0));
        let turn = Reorientation::upright(apex, base, Some(Point3::new(0.0, 12.0, 3.0))).unwrap();
        let (turned, upright) = (
            turn.turned_frame(&frame).unwrap(),
            turn.upright_frame(&frame, [1.0; 3]).unwrap(),
        );
        let sampler = Sampler::new(&turned, &values).unwrap();
        let found = sampler
            .resampled(&upright, Interpolation::Linear, 0.0, &Progress::default())
            .unwrap();
        let brightest = (0..found.len())
            .max_by(|&a, &b| found[a].total_cmp(&found[b]))
            .unwrap();
        let [nx, ny, _] = upright.size();
        let place = [brightest % nx, brightest / nx % ny, brightest / nx / ny].map(|n| n as f64);
        let there = upright.position(Point3::from(place));
        assert!((there - turn.apply(&blob)).norm() < 1.0);
    }

    proptest! {
        #[test]
        fn the_axis_is_upright_and_the_septum_is_towards_x(
            apex in prop::array::uniform3(-90.0..90.0_f64),
            base in prop::array::uniform3(-90.0..90.0_f64),
            septum in prop::array::uniform3(-90.0..90.0_f64),
        ) {
            let [apex, base, septum] = [apex, base, septum].map(Point3::from);
            let length = (base - apex).norm();
            prop_assume!(length > 1.0);
            if let Ok(turn) = Reorientation::upright(apex, base, Some(septum)) {
                let axis = turn.apply(&base) - turn.apply(&apex);
                prop_assert!((axis - Vector3::z() * length).amax() < 1e-10);
                let towards = turn.apply(&septum) - turn.pivot;
                prop_assert!(towards.y.abs() < 1e-10 && towards.x > 0.0);
                prop_assert!((turn.restored(&turn.apply(&septum)) - septum).amax() < 1e-10);
                prop_assert!((turn.rotation.determinant() - 1.0).abs() < 1e-12);
            }
            // The smallest rotation turns about an axis at right angles to z.
            let smallest = Reorientation::upright(apex, base, None).unwrap().rotation;
            prop_assert!((smallest[(0, 1)] - smallest[(1, 0)]).abs() < 1e-12);
        }
    }
}
