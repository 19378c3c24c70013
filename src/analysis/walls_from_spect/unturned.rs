//! Images in planes through the long axis, each turned a little further, laid out as a volume.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use crate::image::{Image, VolumeFrame};
use crate::mesh::Point3;
use crate::progress::Progress;

use super::SpectError;

/// Fewest planes that make a turn.
const MIN_PLANES: usize = 8;
/// Longest step across planes, in pixels: slices that are farther apart are a stack.
const MAX_PIXELS: f64 = 1.5;
/// Spread of the middle line over planes as a share of its mean: the line is the same in each. Not tuned.
const SAME_LINE: f64 = 0.05;
/// Difference of the first plane from the last one seen from behind, as a share of the difference from its own mirror image:
/// both stand one step of the turn apart. Below 1 wherever a heart is not the same on both sides.
const SAME_PLANE: f64 = 0.7;

/// Planes turned about the middle line of their rows or columns.
struct TurnedPlanes<'a> {
    image: &'a Image,
    /// Axes of the volume: along the long axis, across it within a plane.
    along: usize,
    across: usize,
}

/// The volume that turned planes show, on a grid along the long axis; `None` if the image is no such planes.
///
/// Plane n of N stands at the angle π n / N to the first one. The first plane stays where the frame of the file says, and
/// so do heights; voxels have the spacing across the axis, and the height along it. Values are linear in height, radius and
/// angle. Beyond the planes there is nothing (NaN).
///
/// # Errors
/// If it was asked to stop.
pub(super) fn unturned(
    image: &Image,
    certain: bool,
    progress: &Progress,
) -> Result<Option<Image>, SpectError> {
    let found = [[0, 1], [1, 0]].into_iter().find_map(|[along, across]| {
        let planes = TurnedPlanes {
            image,
            along,
            across,
        };
        planes.are_a_turn().then_some(planes)
    });
    let assumed = TurnedPlanes {
        image,
        along: 0,
        across: 1,
    };
    match found.or(certain.then_some(assumed)) {
        Some(planes) => planes.volume(progress).map(Some),
        None => Ok(None),
    }
}

impl TurnedPlanes<'_> {
    /// Rows along the axis, columns across it, planes.
    fn size(&self) -> [usize; 3] {
        let size = self.image.frame().size();
        [size[self.along], size[self.across], size[2]]
    }

    fn at(&self, values: &[f32], [row, column, plane]: [usize; 3]) -> f64 {
        let size = self.image.frame().size();
        let place = match self.along {
            0 => row + size[0] * column,
            _ => column + size[0] * row,
        };
        let value = values.get(place + size[0] * size[1] * plane);
        value.map_or(f64::NAN, |&value| f64::from(value))
    }

    fn are_a_turn(&self) -> bool {
        let [rows, columns, planes] = self.size();
        let spacing = self.image.frame().spacing();
        if planes < MIN_PLANES
            || columns < MIN_PLANES
            || spacing[2] > MAX_PIXELS * spacing[0].min(spacing[1])
        {
            return false;
        }
        let middle = columns / 2;
        let (mut spread, mut mean) = (0.0, 0.0);
        let (mut behind, mut mirrored) = (0.0, 0.0);
        for values in self.image.volumes() {
            for row in 0..rows {
                let line = (0..planes).map(|plane| self.at(values, [row, middle, plane]));
                let average = line.clone().sum::<f64>() / planes as f64;
                spread += line.map(|value| (value - average).abs()).sum::<f64>() / planes as f64;
                mean += average.abs();
                // The first column has no mirror image where their number is even.
                for column in (2 * middle).saturating_sub(columns - 1)..columns {
                    let mirror = 2 * middle - column;
                    let first = self.at(values, [row, column, 0]);
                    behind += (first - self.at(values, [row, mirror, planes - 1])).abs();
                    mirrored += (first - self.at(values, [row, mirror, 0])).abs();
                }
            }
        }
        // False where a value is NaN, and for a constant image.
        spread <= SAME_LINE * mean && mirrored > 0.0 && behind <= SAME_PLANE * mirrored
    }

    fn volume(&self, progress: &Progress) -> Result<Image, SpectError> {
        let [rows, columns, _] = self.size();
        let frame = self.image.frame();
        let (steps, spacing) = (frame.steps(), frame.spacing());
        let up = steps[self.along];
        let sideways = steps[self.across];
        let third = up.cross(&sideways).normalize() * spacing[self.across];
        let middle = columns / 2;
        let mut on_axis = [0.0; 3];
        on_axis[self.across] = middle as f64;
        let reach = middle as f64;
        let origin = frame.position(Point3::from(on_axis)) - (sideways + third) * reach;
        let side = 2 * middle + 1;
        let frame = VolumeFrame::new([side, side, rows], origin, [sideways, third, up])?;
        let mut volumes = Vec::with_capacity(self.image.volumes().len());
        for values in self.image.volumes() {
            let mut volume = Vec::with_capacity(frame.voxel_count());
            for row in 0..rows {
                progress.check()?;
                for place in 0..side * side {
                    let [x, y] = [place % side, place / side].map(|n| n as f64 - reach);
                    volume.push(self.between(values, row, x, y) as f32);
                }
            }
            volumes.push(Arc::from(volume));
        }
        let times = self.image.times_ms().map(<[f64]>::to_vec);
        Ok(Image::new(frame, volumes, times)?)
    }

    /// The value at a place beside the axis, in columns.
    fn between(&self, values: &[f32], row: usize, x: f64, y: f64) -> f64 {
        let [_, columns, planes] = self.size();
        let (radius, angle) = (x.hypot(y), y.atan2(x).rem_euclid(TAU));
        let turn = angle / PI * planes as f64;
        let (lower, share) = (turn.floor(), turn - turn.floor());
        let ring = |step: usize| {
            // Each plane has two sides, half a turn apart.
            let (plane, behind) = (step % planes, step / planes % 2 == 1);
            let middle = (columns / 2) as f64;
            let column = if behind {
                middle - radius
            } else {
                middle + radius
            };
            let (low, part) = (column.floor(), column - column.floor());
            let at = |column: f64| match column >= 0.0 && column < columns as f64 {
                true => self.at(values, [row, column as usize, plane]),
                false => f64::NAN,
            };
            match part > 0.0 {
                true => at(low) * (1.0 - part) + at(low + 1.0) * part,
                false => at(low),
            }
        };
        ring(lower as usize) * (1.0 - share) + ring(lower as usize + 1) * share
    }
}
