//! Where the voxels of a volume stand in the world.

use nalgebra::{Matrix3, Matrix4};

use crate::mesh::{Point3, Vector3};

/// The grid of a volume: how many voxels along each axis, and where each of them stands.
///
/// The world is that of DICOM: x grows towards the left of the patient, y towards the back, z towards the head (LPS),
/// in millimetres. A position is that of a voxel's centre. The axes need be neither orthogonal (a tilted gantry)
/// nor right-handed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumeFrame {
    size: [usize; 3],
    origin: Point3,
    /// Columns: the step from one voxel to the next along i, j and k.
    steps: Matrix3<f64>,
    to_voxel: Matrix3<f64>,
}

/// Why numbers of a file place no grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameError {
    /// One of the sizes is 0, or their product is beyond what can be counted.
    #[error("the size {}×{}×{} is not that of a volume", .0[0], .0[1], .0[2])]
    Size([usize; 3]),
    /// A coordinate is NaN or infinite.
    #[error("the position or the directions of the voxels are not finite numbers")]
    NotFinite,
    /// Two axes are parallel, or one has no length.
    #[error("the directions of the voxels span no volume (their matrix is singular)")]
    Singular,
}

impl VolumeFrame {
    /// A grid whose voxel (i, j, k) stands at `origin + i·steps[0] + j·steps[1] + k·steps[2]`, in millimetres (LPS).
    ///
    /// # Errors
    /// If a size is 0, a number is not finite, or the steps span no volume.
    pub fn new(size: [usize; 3], origin: Point3, steps: [Vector3; 3]) -> Result<Self, FrameError> {
        size.iter()
            .try_fold(1_usize, |count, &n| count.checked_mul(n))
            .filter(|&count| count > 0)
            .ok_or(FrameError::Size(size))?;
        let matrix = Matrix3::from_columns(&steps);
        if !matrix.iter().chain(origin.iter()).all(|x| x.is_finite()) {
            return Err(FrameError::NotFinite);
        }
        // Relative to the lengths, so that a grid in micrometres is as good as one in metres.
        let lengths: f64 = steps.iter().map(|step| step.norm()).product();
        if lengths == 0.0 || matrix.determinant().abs() <= 1e-9 * lengths {
            return Err(FrameError::Singular);
        }
        let to_voxel = matrix.try_inverse().ok_or(FrameError::Singular)?;
        Ok(Self {
            size,
            origin,
            steps: matrix,
            to_voxel,
        })
    }

    /// The grid of an affine matrix whose world is RAS, as in NIfTI and NRRD: x and y change their sign.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn from_ras(size: [usize; 3], affine: &Matrix4<f64>) -> Result<Self, FrameError> {
        let lps = |column: usize| {
            Vector3::new(
                -affine[(0, column)],
                -affine[(1, column)],
                affine[(2, column)],
            )
        };
        Self::new(size, Point3::from(lps(3)), [lps(0), lps(1), lps(2)])
    }

    /// Voxels along i, j and k.
    pub fn size(&self) -> [usize; 3] {
        self.size
    }

    /// How many voxels there are.
    pub fn voxel_count(&self) -> usize {
        self.size.iter().product()
    }

    /// The centre of voxel (0, 0, 0), in millimetres.
    pub fn origin(&self) -> Point3 {
        self.origin
    }

    /// The steps from one voxel to the next along each axis, in millimetres.
    pub fn steps(&self) -> [Vector3; 3] {
        [0, 1, 2].map(|axis| self.steps.column(axis).into_owned())
    }

    /// The lengths of the steps, in millimetres.
    pub fn spacing(&self) -> [f64; 3] {
        self.steps().map(|step| step.norm())
    }

    /// The directions of the axes, of length 1.
    pub fn directions(&self) -> [Vector3; 3] {
        self.steps().map(|step| step.normalize())
    }

    /// The volume of one voxel, in cubic millimetres.
    pub fn voxel_mm3(&self) -> f64 {
        self.steps.determinant().abs()
    }

    /// The position of a place on the grid, whose whole numbers are the centres of voxels.
    pub fn position(&self, voxel: Point3) -> Point3 {
        self.origin + self.steps * voxel.coords
    }

    /// The place on the grid at a position of the world.
    pub fn voxel(&self, position: Point3) -> Point3 {
        Point3::from(self.to_voxel * (position - self.origin))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    #[test]
    fn a_place_on_the_grid_goes_to_the_world_and_back() {
        let frame = VolumeFrame::new(
            [4, 5, 6],
            Point3::new(10.0, -20.0, 30.0),
            [
                Vector3::new(0.0, 1.5, 0.1),
                Vector3::new(-1.5, 0.0, 0.0),
                Vector3::new(0.3, 0.0, 8.0),
            ],
        )
        .unwrap();
        let place = Point3::new(1.0, 2.5, -0.25);
        assert!((frame.voxel(frame.position(place)) - place).norm() < 1e-12);
        assert_eq!(frame.position(Point3::origin()), frame.origin());
        assert!((frame.spacing()[1] - 1.5).abs() < 1e-15);
        assert_eq!(frame.voxel_count(), 120);
    }

    #[test]
    fn numbers_that_place_no_grid_are_refused() {
        let step = |x, y, z| Vector3::new(x, y, z);
        let straight = [
            step(1.0, 0.0, 0.0),
            step(0.0, 1.0, 0.0),
            step(0.0, 0.0, 1.0),
        ];
        let new = VolumeFrame::new;
        assert_eq!(
            new([0, 1, 1], Point3::origin(), straight),
            Err(FrameError::Size([0, 1, 1]))
        );
        assert_eq!(
            new([usize::MAX, 2, 1], Point3::origin(), straight),
            Err(FrameError::Size([usize::MAX, 2, 1]))
        );
        assert_eq!(
            new([1; 3], Point3::new(f64::NAN, 0.0, 0.0), straight),
            Err(FrameError::NotFinite)
        );
        let flat = [straight[0], straight[0], straight[2]];
        assert_eq!(
            new([1; 3], Point3::origin(), flat),
            Err(FrameError::Singular)
        );
    }
}
