//! How the slices of a stack lie in the world: planes from the apex to the base, with coordinates of their own.

use nalgebra::Vector2;

use crate::image::VolumeFrame;
use crate::mesh::{Point3, Vector3};

use super::region::Region;
use super::{Masks, Tissue};

/// A place within a slice, in millimetres.
pub(super) type Place = Vector2<f64>;

/// Slices of one thickness, numbered from the apex to the base, with coordinates x, y within them and the height z.
#[derive(Clone, Debug)]
pub(super) struct Planes {
    /// World position of x = y = z = 0, which is the centre of the first voxel of the lowest slice.
    origin: Point3,
    /// World directions of x, y and z, orthonormal and right-handed; z points to the base.
    axes: [Vector3; 3],
    /// Axes of the volume along x, beside it, and across the slices.
    order: [usize; 3],
    /// Voxels along each axis of the volume.
    size: [usize; 3],
    /// Step from one voxel to the next along the rows and along the columns of a slice.
    steps: [Place; 2],
    /// Step of the first voxel from one slice to the next up, which is not 0 in a sheared grid.
    drift: Place,
    /// Whether the first slice of the volume is the highest.
    first_is_base: bool,
    /// Thickness of a slice: distance between neighbours.
    pub thickness: f64,
}

impl Planes {
    /// Planes across the axis of the volume with the longest step, from the apex to the base by what the masks show.
    pub fn of(masks: &Masks) -> Self {
        let frame = masks.frame();
        let spacing = frame.spacing();
        let across = (0..3).rev().fold(2, |best, axis| {
            if spacing[axis] > spacing[best] {
                axis
            } else {
                best
            }
        });
        Self::across(frame, across, first_is_base(masks, across))
    }

    /// Planes of which only directions, thickness and the size of a pixel count, for masks that are no stack of slices.
    pub fn without_pixels(
        origin: Point3,
        [x, z]: [Vector3; 2],
        thickness: f64,
        pixel: f64,
    ) -> Self {
        Self {
            origin,
            axes: [x, z.cross(&x), z],
            order: [0, 1, 2],
            size: [0; 3],
            steps: [Place::new(pixel, 0.0), Place::new(0.0, pixel)],
            drift: Place::zeros(),
            first_is_base: false,
            thickness,
        }
    }

    /// Planes across an axis of a volume.
    fn across(frame: &VolumeFrame, across: usize, first_is_base: bool) -> Self {
        // The other two in cyclic order: a right-handed grid keeps its hand.
        let order = [(across + 1) % 3, (across + 2) % 3, across];
        let size = frame.size();
        let [along, beside, up_step] = order.map(|axis| frame.steps()[axis]);
        let normal = along.cross(&beside).normalize();
        let towards_last = if normal.dot(&up_step) < 0.0 {
            -normal
        } else {
            normal
        };
        let z = if first_is_base {
            -towards_last
        } else {
            towards_last
        };
        let x = along.normalize();
        let y = z.cross(&x);
        let within = |step: Vector3| Place::new(step.dot(&x), step.dot(&y));
        let up = if first_is_base { -up_step } else { up_step };
        let lowest = if first_is_base { size[across] - 1 } else { 0 };
        Self {
            origin: frame.origin() + up_step * lowest as f64,
            axes: [x, y, z],
            order,
            size,
            steps: [within(along), within(beside)],
            drift: within(up),
            first_is_base,
            thickness: up.dot(&z),
        }
    }

    /// Number of slices.
    pub fn count(&self) -> usize {
        self.size[self.order[2]]
    }

    /// Height of the middle of a slice.
    pub fn height(&self, slice: usize) -> f64 {
        self.thickness * slice as f64
    }

    /// The number that a slice has in the volume, from 0.
    pub fn number_in_volume(&self, slice: usize) -> usize {
        if self.first_is_base {
            self.count() - 1 - slice
        } else {
            slice
        }
    }

    /// The place of a column and row of a slice.
    pub fn place(&self, slice: usize, [i, j]: [f64; 2]) -> Place {
        self.drift * slice as f64 + self.steps[0] * i + self.steps[1] * j
    }

    /// The direction from one pixel to the next along the rows, and along the columns.
    pub fn pixel_steps(&self) -> [Place; 2] {
        self.steps
    }

    /// Area of a pixel.
    pub fn pixel_mm2(&self) -> f64 {
        self.steps[0].perp(&self.steps[1]).abs()
    }

    /// Side of a square as large as a pixel.
    pub fn pixel_mm(&self) -> f64 {
        self.pixel_mm2().sqrt()
    }

    /// The position of a place at a height.
    pub fn position(&self, place: Place, height: f64) -> Point3 {
        let [x, y, z] = self.axes;
        self.origin + x * place.x + y * place.y + z * height
    }

    /// The place of a position within its slice.
    pub fn place_of(&self, position: Point3) -> Place {
        let away = position - self.origin;
        Place::new(away.dot(&self.axes[0]), away.dot(&self.axes[1]))
    }

    /// The height of a position.
    pub fn height_of(&self, position: Point3) -> f64 {
        (position - self.origin).dot(&self.axes[2])
    }

    /// Whether slices, stored with rows to the right and columns down, are seen in the world as they are from the apex: the
    /// third direction of the right-handed frame of rows, columns and the line of sight then points to the base.
    pub fn seen_from_apex(&self) -> bool {
        self.steps[0].perp(&self.steps[1]) > 0.0
    }

    /// A direction within slices in the world.
    pub fn direction(&self, within: Place) -> Vector3 {
        self.axes[0] * within.x + self.axes[1] * within.y
    }

    /// Voxels of a tissue in a slice of an instant.
    pub fn region(&self, voxels: &[Tissue], slice: usize, tissue: Tissue) -> Region {
        let [along, beside, across] = self.order;
        let strides = [1, self.size[0], self.size[0] * self.size[1]];
        let first = self.number_in_volume(slice) * strides[across];
        let rows = 0..self.size[beside];
        let inside = rows.flat_map(|j| {
            let row = first + j * strides[beside];
            (0..self.size[along]).map(move |i| row + i * strides[along])
        });
        let is = |place: usize| voxels.get(place) == Some(&tissue);
        Region::new(self.size[along], inside.map(is).collect())
    }
}

/// Whether the first slice across an axis lies nearer to the base than the last one.
///
/// Both ventricles are narrow at the apex, so that the mean height of their voxels lies above the middle of their slices; and
/// slices of wall without cavity lie at the apex. The three are added as shares of the ventricles' lengths.
fn first_is_base(masks: &Masks, across: usize) -> bool {
    let size = masks.frame().size();
    let stride: usize = size[..across].iter().product();
    // Voxels of each slice at all instants: cavity, wall, right cavity.
    let mut counts = vec![[0_usize; 3]; size[across]];
    for voxels in masks.instants() {
        for (place, tissue) in voxels.iter().enumerate() {
            let kind = match tissue {
                Tissue::Other => continue,
                Tissue::Cavity => 0,
                Tissue::Wall => 1,
                Tissue::RightCavity => 2,
            };
            counts[(place / stride) % size[across]][kind] += 1;
        }
    }
    let [cavity, heart, right] = [
        shown(&counts, |slice| slice[0]),
        shown(&counts, |slice| slice[0] + slice[1]),
        shown(&counts, |slice| slice[2]),
    ];
    // Positive where the first slice is nearer to the base.
    let tapering = |shown: &Option<Shown>| {
        let Shown { first, last, mean } = shown.as_ref()?;
        (last > first).then(|| 0.5 - (mean - *first as f64) / (last - first) as f64)
    };
    let without_cavity = cavity.as_ref().zip(heart.as_ref()).map(|(cavity, heart)| {
        let [before, after] = [cavity.first - heart.first, heart.last - cavity.last];
        (after as f64 - before as f64) / (heart.last - heart.first + 1) as f64
    });
    let signs = [tapering(&heart), tapering(&right), without_cavity];
    signs.into_iter().flatten().sum::<f64>() > 0.0
}

/// In which slices a tissue is, and their mean, each counted as often as it has voxels.
struct Shown {
    first: usize,
    last: usize,
    mean: f64,
}

fn shown(counts: &[[usize; 3]], of: impl Fn(&[usize; 3]) -> usize) -> Option<Shown> {
    let sum: usize = counts.iter().map(&of).sum();
    let weighted = counts
        .iter()
        .enumerate()
        .map(|(n, slice)| n as f64 * of(slice) as f64);
    Some(Shown {
        first: counts.iter().position(|slice| of(slice) > 0)?,
        last: counts.iter().rposition(|slice| of(slice) > 0)?,
        mean: weighted.sum::<f64>() / sum as f64,
    })
}
