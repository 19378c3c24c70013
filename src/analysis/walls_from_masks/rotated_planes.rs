//! Masks drawn in planes through the long axis, each turned a little further, as programs for gated SPECT keep them.

use std::f64::consts::{PI, TAU};

use crate::image::VolumeFrame;
use crate::mesh::Point3;

use super::planes::{Place, Planes};
use super::radial::SquaredRadius;
use super::shape::{RadialFrame, RadialSlice};
use super::{FrameWallError, Masks, Tissue};

/// Share of the planes that show a place of the middle line, over places that any of them shows: it is the same line in
/// each. Real gated SPECT has 0.89 and more, stacks of slices 0.85 and less.
const SAME_LINE: f64 = 0.8;
/// Overlap (Dice) of the first plane with the last one seen from behind, which stands one step of the turn beside it. Real
/// gated SPECT has 0.91 and more, stacks of slices 0.69 and less.
const SAME_PLANE: f64 = 0.8;
/// By how much that may be less than the overlap of the first two planes: they are as far apart.
const LESS_THAN_NEIGHBOURS: f64 = 0.08;
/// Longest step across planes, in pixels: slices that are farther apart are a stack.
const MAX_PIXELS: f64 = 1.5;
/// Fewest planes that make a turn.
const MIN_PLANES: usize = 8;

/// Planes turned about the middle line of their columns by half a turn in all.
#[derive(Clone, Debug)]
pub(super) struct RotatedPlanes<'a> {
    masks: &'a Masks,
    /// Axes of the volume: along the long axis, across it within a plane.
    along: usize,
    across: usize,
    /// Whether the first row is nearer to the base.
    first_is_base: bool,
}

/// One instant with the points that its surfaces should pass through: of the endocardium, and of the epicardium.
pub(super) type RadialAndOutlines = (RadialFrame, [Vec<(Place, f64)>; 2]);

impl<'a> RotatedPlanes<'a> {
    /// Recognises such masks; `None` for slices.
    ///
    /// The middle line is the same in all planes, and the last plane, seen from behind, is nearly the first. A stack of
    /// slices has neither: the ventricle ends within it.
    pub fn of(masks: &'a Masks) -> Option<Self> {
        if masks.frame().size()[2] < MIN_PLANES {
            return None;
        }
        [[0, 1], [1, 0]].into_iter().find_map(|[along, across]| {
            let mut planes = Self {
                masks,
                along,
                across,
                first_is_base: false,
            };
            planes.first_is_base = planes.cavity_precedes_wall();
            planes.are_a_turn().then_some(planes)
        })
    }

    fn size(&self) -> [usize; 3] {
        let size = self.masks.frame().size();
        [size[self.along], size[self.across], size[2]]
    }

    fn tissue(&self, voxels: &[Tissue], [row, column, plane]: [usize; 3]) -> Tissue {
        let size = self.masks.frame().size();
        let place = match self.along {
            0 => row + size[0] * column,
            _ => column + size[0] * row,
        };
        let voxel = voxels.get(place + size[0] * size[1] * plane);
        voxel.copied().unwrap_or_default()
    }

    fn inside(&self, voxels: &[Tissue], place: [usize; 3]) -> bool {
        matches!(self.tissue(voxels, place), Tissue::Cavity | Tissue::Wall)
    }

    fn are_a_turn(&self) -> bool {
        let [rows, columns, planes] = self.size();
        let spacing = self.masks.frame().spacing();
        let middle = columns / 2;
        if spacing[2] > MAX_PIXELS * spacing[0].min(spacing[1]) {
            return false;
        }
        let (mut on_line, mut places) = (0, 0);
        let (mut behind, mut beside) = (Overlap::default(), Overlap::default());
        for voxels in self.masks.instants() {
            for row in 0..rows {
                let shown = (0..planes)
                    .filter(|&plane| self.inside(voxels, [row, middle, plane]))
                    .count();
                on_line += shown;
                places += if shown > 0 { planes } else { 0 };
                for column in 0..columns {
                    let first = self.inside(voxels, [row, column, 0]);
                    beside.add(first, self.inside(voxels, [row, column, 1]));
                    // The first column has no mirror image where their number is even.
                    if let Some(mirror) = (2 * middle).checked_sub(column).filter(|&c| c < columns)
                    {
                        behind.add(first, self.inside(voxels, [row, mirror, planes - 1]));
                    }
                }
            }
        }
        let same_plane = behind.dice();
        places > 0
            && on_line as f64 >= SAME_LINE * places as f64
            && same_plane >= SAME_PLANE
            && same_plane >= beside.dice() - LESS_THAN_NEIGHBOURS
    }

    /// Whether the mean row of the cavity is nearer to the first row than that of the wall: the apex has no cavity.
    fn cavity_precedes_wall(&self) -> bool {
        let [rows, columns, planes] = self.size();
        let mut sums = [[0.0_f64; 2]; 2];
        for voxels in self.masks.instants() {
            for place in (0..rows * columns * planes)
                .map(|n| [n / columns % rows, n % columns, n / columns / rows])
            {
                let kind = match self.tissue(voxels, place) {
                    Tissue::Cavity => 0,
                    Tissue::Wall => 1,
                    _ => continue,
                };
                sums[kind][0] += place[0] as f64;
                sums[kind][1] += 1.0;
            }
        }
        let [cavity, wall] = sums.map(|[sum, count]| sum / count.max(1.0));
        cavity < wall
    }

    /// The axis with the directions that radii are measured in: the first plane, and a quarter of a turn from it.
    pub fn planes(&self) -> Planes {
        let frame: &VolumeFrame = self.masks.frame();
        let [rows, columns, _] = self.size();
        let directions = frame.directions();
        let up = directions[self.along];
        let mut voxel = [0.0; 3];
        voxel[self.across] = (columns / 2) as f64;
        if self.first_is_base {
            voxel[self.along] = rows.saturating_sub(1) as f64;
        }
        let z = if self.first_is_base { -up } else { up };
        let x = directions[self.across];
        // In a sheared grid the two are not perpendicular; heights stay along the axis.
        let x = (x - z * z.dot(&x)).normalize();
        let spacing = frame.spacing();
        Planes::without_pixels(
            frame.position(Point3::from(voxel)),
            [x, z],
            spacing[self.along],
            spacing[self.across],
        )
    }

    /// Radii of an instant.
    ///
    /// # Errors
    /// If there is no cavity, no wall around it, or too few rows.
    pub fn radial(&self, instant: usize) -> Result<RadialAndOutlines, FrameWallError> {
        let voxels: &[Tissue] = self
            .masks
            .instants()
            .get(instant)
            .map_or(&[], |voxels| voxels);
        let [rows, ..] = self.size();
        let spacing = self.masks.frame().spacing();
        let (height, pixel) = (spacing[self.along], spacing[self.across]);
        let mut outlines = [Vec::new(), Vec::new()];
        let mut slices = Vec::new();
        for up in 0..rows {
            let row = if self.first_is_base {
                rows - 1 - up
            } else {
                up
            };
            let z = height * up as f64;
            let samples =
                [false, true].map(|with_wall| self.squares(voxels, row, with_wall, pixel));
            let area = samples
                .each_ref()
                .map(|s| s.iter().map(|(_, q)| q).sum::<f64>());
            let [cavity, heart] = samples.each_ref().map(|samples| {
                let count = samples.len().max(1) as f64;
                let mean = samples.iter().map(|(_, q)| q).sum::<f64>() / count;
                let sigma = 0.5 * pixel / mean.sqrt().max(0.5 * pixel);
                SquaredRadius::of_samples(samples.iter().copied(), sigma)
            });
            for ((outline, samples), area) in outlines.iter_mut().zip(&samples).zip(area) {
                let points = samples.iter().filter(|_| area > 0.0);
                outline.extend(points.map(|(angle, square)| {
                    (Place::new(angle.cos(), angle.sin()) * square.sqrt(), z)
                }));
            }
            slices.push(RadialSlice {
                height: z,
                centre: (area[1] > 0.0).then(Place::zeros),
                cavity: (area[0] > 0.0).then_some(cavity),
                heart: (area[1] > 0.0).then_some(heart),
            });
        }
        let slices = up_to_the_base(slices)?;
        let top = slices.last().map_or(0.0, |slice| slice.height);
        for outline in &mut outlines {
            outline.retain(|(_, z)| *z <= top);
        }
        Ok((
            RadialFrame {
                slices,
                thickness: height,
                pixel,
            },
            outlines,
        ))
    }

    /// q = 2 ∫ r dr over the mask in each direction of a row: each plane has two.
    fn squares(
        &self,
        voxels: &[Tissue],
        row: usize,
        with_wall: bool,
        pixel: f64,
    ) -> Vec<(f64, f64)> {
        let [_, columns, planes] = self.size();
        let middle = columns / 2;
        let mut squares = Vec::with_capacity(2 * planes);
        for side in 0..2 {
            for plane in 0..planes {
                let angle = PI * plane as f64 / planes as f64 + PI * f64::from(side);
                let in_mask = |column: usize| match self.tissue(voxels, [row, column, plane]) {
                    Tissue::Cavity => true,
                    Tissue::Wall => with_wall,
                    _ => false,
                };
                let reach = if side == 0 {
                    columns - 1 - middle
                } else {
                    middle
                };
                let sum: f64 = (0..=reach)
                    .filter(|away| {
                        in_mask(if side == 0 {
                            middle + away
                        } else {
                            middle - away
                        })
                    })
                    // A voxel on the middle line lies half on this side; 2 ∫ r dr over the others is 2 r.
                    .map(|away| if away == 0 { 0.25 } else { 2.0 * away as f64 })
                    .sum();
                squares.push((angle.rem_euclid(TAU), sum * pixel * pixel));
            }
        }
        squares
    }
}

/// How far two sets of voxels overlap.
#[derive(Default)]
struct Overlap {
    both: usize,
    either: usize,
}

impl Overlap {
    fn add(&mut self, a: bool, b: bool) {
        self.both += 2 * usize::from(a && b);
        self.either += usize::from(a) + usize::from(b);
    }

    /// 2 |A ∩ B| / (|A| + |B|).
    fn dice(&self) -> f64 {
        self.both as f64 / self.either.max(1) as f64
    }
}

/// The rows from the lowest with wall to the highest with cavity and wall.
fn up_to_the_base(slices: Vec<RadialSlice>) -> Result<Vec<RadialSlice>, FrameWallError> {
    let area = |q: &Option<SquaredRadius>| q.as_ref().map_or(0.0, SquaredRadius::area);
    if slices.iter().all(|slice| slice.cavity.is_none()) {
        return Err(FrameWallError::NoCavity);
    }
    let walled =
        |slice: &RadialSlice| slice.cavity.is_some() && area(&slice.heart) > area(&slice.cavity);
    let base = slices
        .iter()
        .rposition(walled)
        .ok_or(FrameWallError::NoWall)?;
    let mut kept: Vec<RadialSlice> = slices.into_iter().take(base + 1).collect();
    let lowest = kept
        .iter()
        .position(|slice| slice.heart.is_some())
        .unwrap_or(0);
    kept.drain(..lowest);
    for (tissue, slices, needed) in [
        (
            "wall",
            kept.iter().filter(|slice| slice.heart.is_some()).count(),
            3,
        ),
        (
            "cavity",
            kept.iter().filter(|slice| slice.cavity.is_some()).count(),
            2,
        ),
    ] {
        if slices < needed {
            return Err(FrameWallError::FewSlices {
                tissue,
                slices,
                needed,
            });
        }
    }
    Ok(kept)
}
