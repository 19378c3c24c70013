//! Values on a grid, at one or several instants.

use std::sync::Arc;

use super::{FrameError, VolumeFrame};

/// A volume over time: one grid, and its values at each of at least one instant.
///
/// Values are those that the file means (rescaled), i fastest, then j, then k. Padding that the file names is NaN.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    frame: VolumeFrame,
    volumes: Vec<Arc<[f32]>>,
    times_ms: Option<Vec<f64>>,
}

/// Why values and a grid do not belong together.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ImageError {
    /// The grid itself is none.
    #[error(transparent)]
    Frame(#[from] FrameError),
    /// No instant, or an instant with more or fewer values than the grid has voxels.
    #[error("{values} values for {voxels} voxels")]
    Count {
        /// How many values there are.
        values: usize,
        /// How many there should be.
        voxels: usize,
    },
    /// There are times, but not one for each instant, or not finite and increasing ones.
    #[error("the times of the {instants} volumes are not {instants} increasing numbers")]
    Times {
        /// How many volumes there are.
        instants: usize,
    },
}

impl Image {
    /// Joins a grid, the values of each instant, and their times after the R wave in milliseconds where they are known.
    ///
    /// # Errors
    /// If counts differ, there is no volume, or times are not finite and increasing.
    pub fn new(
        frame: VolumeFrame,
        volumes: Vec<Arc<[f32]>>,
        times_ms: Option<Vec<f64>>,
    ) -> Result<Self, ImageError> {
        let voxels = frame.voxel_count();
        let wrong = volumes.iter().map(|v| v.len()).find(|&n| n != voxels);
        if let Some(values) = wrong.or(volumes.is_empty().then_some(0)) {
            return Err(ImageError::Count { values, voxels });
        }
        if let Some(times) = &times_ms {
            let increasing = times.windows(2).all(|pair| pair[0] < pair[1]);
            if times.len() != volumes.len() || !increasing || !times.iter().all(|t| t.is_finite()) {
                return Err(ImageError::Times {
                    instants: volumes.len(),
                });
            }
        }
        Ok(Self {
            frame,
            volumes,
            times_ms,
        })
    }

    /// Where the voxels stand.
    pub fn frame(&self) -> &VolumeFrame {
        &self.frame
    }

    /// The values of each instant, i fastest, then j, then k.
    pub fn volumes(&self) -> &[Arc<[f32]>] {
        &self.volumes
    }

    /// Milliseconds after the R wave of each instant, where the file says so.
    pub fn times_ms(&self) -> Option<&[f64]> {
        self.times_ms.as_deref()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;
    use crate::mesh::{Point3, Vector3};

    #[test]
    fn values_must_fit_the_grid_and_times_the_volumes() {
        let frame = VolumeFrame::new(
            [2, 1, 1],
            Point3::origin(),
            [Vector3::x(), Vector3::y(), Vector3::z()],
        )
        .unwrap();
        let two: Arc<[f32]> = vec![1.0, 2.0].into();
        assert!(Image::new(frame, vec![two.clone()], None).is_ok());
        assert_eq!(
            Image::new(frame, vec![], None),
            Err(ImageError::Count {
                values: 0,
                voxels: 2
            })
        );
        assert_eq!(
            Image::new(frame, vec![vec![1.0].into()], None),
            Err(ImageError::Count {
                values: 1,
                voxels: 2
            })
        );
        let backwards = Some(vec![10.0, 0.0]);
        assert_eq!(
            Image::new(frame, vec![two.clone(), two], backwards),
            Err(ImageError::Times { instants: 2 })
        );
    }
}
