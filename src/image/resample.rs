//! Values of a volume between its voxels, and on another grid.

use nalgebra::Vector3;
use rayon::prelude::*;

use super::VolumeFrame;
use crate::mesh::Point3;
use crate::progress::{Progress, Stopped};

/// How far beyond the outermost voxels, in voxels, a place still counts as on them: rounding of positions.
const ON_BORDER: f64 = 1e-9;

/// Voxels that a volume may be resampled to: 1 GiB.
const MAX_VOXELS: usize = 1 << 28;

/// How values between voxels are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interpolation {
    /// Trilinear, for images.
    Linear,
    /// That of the nearest voxel, for labels.
    Nearest,
}

/// Why a volume is not resampled.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ResampleError {
    /// Values and a grid do not belong together.
    #[error("{values} values for {voxels} voxels")]
    Count {
        /// How many values there are.
        values: usize,
        /// How many there should be.
        voxels: usize,
    },
    /// The grid asked for is too fine.
    #[error("a grid of {voxels} voxels is more than the limit of {MAX_VOXELS}")]
    TooLarge {
        /// How many voxels it would have.
        voxels: usize,
    },
    /// Stopped.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

/// A volume that is read at positions of the world.
#[derive(Clone, Copy, Debug)]
pub struct Sampler<'a> {
    frame: &'a VolumeFrame,
    values: &'a [f32],
}

impl<'a> Sampler<'a> {
    /// Of values on a grid, i fastest.
    ///
    /// # Errors
    /// If counts differ.
    pub fn new(frame: &'a VolumeFrame, values: &'a [f32]) -> Result<Self, ResampleError> {
        if values.len() != frame.voxel_count() {
            return Err(ResampleError::Count {
                values: values.len(),
                voxels: frame.voxel_count(),
            });
        }
        Ok(Self { frame, values })
    }

    /// The value at a position in millimetres, trilinear between the eight voxels around it; `None` beyond the outermost
    /// voxels. Voxels that have no part in it do not matter; with one that is NaN (padding) and has, it is NaN: what is
    /// unknown is not mixed in.
    pub fn at(&self, position: Point3) -> Option<f64> {
        self.linear(self.frame.voxel(position))
    }

    /// The volume on another grid, i fastest. Beyond its outermost voxels it is `outside`; where padding would have a part,
    /// NaN. In `Nearest` a voxel reaches half way to its neighbours, and half a voxel beyond the outermost.
    ///
    /// # Errors
    /// If the grid has more than 268 million voxels, or it is stopped; that is heard once a row.
    pub fn resampled(
        &self,
        onto: &VolumeFrame,
        interpolation: Interpolation,
        outside: f32,
        progress: &Progress,
    ) -> Result<Vec<f32>, ResampleError> {
        let voxels = onto.voxel_count();
        if voxels > MAX_VOXELS {
            return Err(ResampleError::TooLarge { voxels });
        }
        let [nx, ny, nz] = onto.size();
        let mut values = vec![outside; voxels];
        progress.expect_steps(ny * nz);
        (values.par_chunks_mut(nx).enumerate()).try_for_each(|(number, row)| {
            progress.step()?;
            let (j, k) = ((number % ny) as f64, (number / ny) as f64);
            let [first, second] =
                [0.0, 1.0].map(|i| self.frame.voxel(onto.position(Point3::new(i, j, k))));
            // Places on a line are mapped to places on a line.
            let step: Vector3<f64> = second - first;
            for (i, value) in row.iter_mut().enumerate() {
                let place = first + step * i as f64;
                let found = match interpolation {
                    Interpolation::Linear => self.linear(place).map(|value| value as f32),
                    Interpolation::Nearest => self.nearest(place),
                };
                *value = found.unwrap_or(outside);
            }
            Ok::<(), Stopped>(())
        })?;
        Ok(values)
    }

    fn nearest(&self, place: Point3) -> Option<f32> {
        let size = self.frame.size();
        let mut voxel = [0; 3];
        for axis in 0..3 {
            let last = (size[axis] - 1) as f64;
            if !(-0.5 - ON_BORDER..=last + 0.5 + ON_BORDER).contains(&place[axis]) {
                return None;
            }
            voxel[axis] = place[axis].round().clamp(0.0, last) as usize;
        }
        self.values
            .get(voxel[0] + size[0] * (voxel[1] + size[1] * voxel[2]))
            .copied()
    }

    fn linear(&self, place: Point3) -> Option<f64> {
        let size = self.frame.size();
        let (mut lower, mut share) = ([0; 3], [0.0; 3]);
        for axis in 0..3 {
            let last = (size[axis] - 1) as f64;
            // False for NaN too.
            if !(-ON_BORDER..=last + ON_BORDER).contains(&place[axis]) {
                return None;
            }
            let within = place[axis].clamp(0.0, last);
            lower[axis] = within as usize;
            share[axis] = within - within.floor();
        }
        let strides = [1, size[0], size[0] * size[1]];
        let base = lower[0] + strides[1] * lower[1] + strides[2] * lower[2];
        let mut sum = 0.0;
        for corner in 0..8 {
            let (mut at, mut weight) = (base, 1.0);
            for axis in 0..3 {
                if corner >> axis & 1 == 1 {
                    at += strides[axis];
                    weight *= share[axis];
                } else {
                    weight *= 1.0 - share[axis];
                }
            }
            // What has no part is not looked at: it may be padding, or beyond the grid.
            if weight > 0.0 {
                sum += weight * f64::from(*self.values.get(at)?);
            }
        }
        Some(sum)
    }
}

#[cfg(test)]
mod tests;
