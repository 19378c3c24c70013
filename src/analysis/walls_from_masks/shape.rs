//! The smooth wall of one instant: an axis, and two surfaces around it as functions of height and angle.

use super::FrameWallError;
use super::planes::Place;
use super::radial::{SquaredRadius, WAVES, squared_radius};
use super::smooth_profile::{Nodes, Observation};

/// What one slice says about both surfaces.
#[derive(Clone, Debug)]
pub(super) struct RadialSlice {
    /// Of its middle.
    pub height: f64,
    /// The point that radii are measured from; `None` where the slice says nothing.
    pub centre: Option<Place>,
    /// The endocardium; of no area where there is no blood between slices with blood.
    pub cavity: Option<SquaredRadius>,
    /// The epicardium.
    pub heart: Option<SquaredRadius>,
}

/// The slices of one instant, from the apex to the base.
#[derive(Clone, Debug)]
pub(super) struct RadialFrame {
    pub slices: Vec<RadialSlice>,
    /// Distance of neighbouring slices.
    pub thickness: f64,
    /// Side of a pixel.
    pub pixel: f64,
}

/// Stiffness of profiles over the height, for slices as far apart as the unit of length. A wave from slice to slice
/// (of two slices) keeps 1 / (1 + 0.007 π⁴) = 0.6 of its height, one of four slices 0.96: what differs from slice to
/// slice is the hand of who drew the outlines, what spans four of them is the ventricle.
const STIFFNESS: f64 = 0.007;
/// Slices over the length of the ventricle for which that is meant; thinner ones are smoothed as these.
const USUAL_SLICES: f64 = 10.0;
/// Nodes of profiles for each slice.
const NODES_PER_SLICE: f64 = 6.0;
/// Depth of the tip below the upper side of its slice, in slices: that of half an ellipsoid on a cylinder of equal
/// volume (3/2) at most, and a little.
const TIP_DEPTH: [f64; 2] = [0.3, 1.5];
/// Thickness of the wall at the tip, as a share of its thickness in the lowest slices of the cavity. The apex is the
/// thinnest part of the wall, and slices across it do not show how thin.
const TIP_WALL: f64 = 0.5;
/// Least q in any direction, as a share of its mean around: outlines are rounder than that.
const ROUND: f64 = 0.15;

/// One surface: q(θ, z) = r², with r the distance from the axis.
#[derive(Clone, Debug)]
pub(super) struct Surface {
    /// Height of the tip.
    pub apex: f64,
    /// Volume of the mask up to the base.
    pub mask_volume: f64,
    nodes: Nodes,
    /// cos and sin coefficients of each wave at the nodes.
    waves: Vec<Vec<f64>>,
    /// Height over which the least radius grows from the tip, and that radius.
    least: [f64; 2],
}

/// Both surfaces and their axis.
#[derive(Clone, Debug)]
pub(super) struct WallShape {
    pub endo: Surface,
    pub epi: Surface,
    /// Height of the plane of the valve: the upper side of the highest slice.
    pub base: f64,
    axis_nodes: Nodes,
    axis: Vec<Vec<f64>>,
}

impl WallShape {
    /// The smooth wall through slices, of which at least two have a cavity and three a heart.
    ///
    /// # Errors
    /// If the slices do not determine a surface.
    pub fn of(frame: &RadialFrame) -> Result<Self, FrameWallError> {
        let h = frame.thickness;
        let top = frame.slices.last().map_or(0.0, |slice| slice.height);
        let base = top + 0.5 * h;
        let cavity = profile(frame, |slice| slice.cavity.as_ref());
        let heart = profile(frame, |slice| slice.heart.as_ref());
        let [endo_apex, epi_apex] = tips(frame, &cavity, &heart);
        let length = base - epi_apex;
        let stiffness = STIFFNESS * h.max(length / USUAL_SLICES).powi(4) / h;
        let surface = |apex: f64, profile: &Profile, name: &'static str| {
            Surface::through(apex, base, frame, profile, stiffness)
                .ok_or(FrameWallError::Undetermined { surface: name })
        };
        let axis_nodes = Nodes::new(epi_apex, base, h / NODES_PER_SLICE);
        let axis = axis(frame, &axis_nodes, stiffness)
            .ok_or(FrameWallError::Undetermined { surface: "axis" })?;
        Ok(Self {
            endo: surface(endo_apex, &cavity, "endocardium")?,
            epi: surface(epi_apex, &heart, "epicardium")?,
            base,
            axis_nodes,
            axis,
        })
    }

    /// The axis at a height.
    pub fn centre(&self, height: f64) -> Place {
        let at = |coordinate: &Vec<f64>| self.axis_nodes.value(coordinate, height);
        Place::from_iterator(self.axis.iter().map(at))
    }
}

impl Surface {
    fn through(
        apex: f64,
        base: f64,
        frame: &RadialFrame,
        profile: &Profile,
        stiffness: f64,
    ) -> Option<Self> {
        let h = frame.thickness;
        let nodes = Nodes::new(apex, base, h / NODES_PER_SLICE);
        let lowest = profile.first()?.0;
        // A tip below its slice holds a part of what that slice has.
        let bottom = |height: f64| {
            let side = height - 0.5 * h;
            if height == lowest {
                side.min(apex)
            } else {
                side
            }
        };
        let rows: Vec<Observation> = (profile.iter())
            .map(|&(height, _)| nodes.integral(bottom(height), height + 0.5 * h, h))
            .collect();
        let column = |wave: usize, part: usize| {
            let values = profile.iter().map(|(_, q)| q.0[wave][part]);
            values.collect::<Vec<f64>>()
        };
        let columns: Vec<Vec<f64>> = (0..=WAVES)
            .flat_map(|wave| [column(wave, 0), column(wave, 1)])
            .collect();
        let waves = nodes.smoothed(&rows, &columns, stiffness, true)?;
        let mut surface = Self {
            apex,
            mask_volume: 0.0,
            nodes,
            waves,
            least: [0.5 * h, 0.5 * frame.pixel],
        };
        // Slices that say nothing hold what lies between their neighbours.
        let inside = frame.slices.iter().filter(|slice| slice.height >= lowest);
        surface.mask_volume = inside
            .map(|slice| {
                let known = profile.iter().find(|(height, _)| *height == slice.height);
                let area = known.map_or_else(|| surface.area(slice.height), |(_, q)| q.area());
                area * h
            })
            .sum();
        Some(surface)
    }

    /// Area of the outline at a height.
    fn area(&self, height: f64) -> f64 {
        let mean = self
            .waves
            .first()
            .map_or(0.0, |q| self.nodes.value(q, height));
        std::f64::consts::PI * mean.max(0.0)
    }

    /// Distance from the axis in a direction at a height; 0 at the tip and below.
    pub fn radius(&self, angle: f64, height: f64) -> f64 {
        if height <= self.apex {
            return 0.0;
        }
        let mut coefficients = [[0.0; 2]; WAVES + 1];
        for (m, coefficient) in coefficients.iter_mut().enumerate() {
            for (part, value) in coefficient.iter_mut().enumerate() {
                if let Some(wave) = self.waves.get(2 * m + part) {
                    *value = self.nodes.value(wave, height);
                }
            }
        }
        let [rise, radius] = self.least;
        let least = radius * radius * ((height - self.apex) / rise).min(1.0);
        let mean = coefficients[0][0];
        let square = squared_radius(&coefficients, angle);
        square.max(ROUND * mean).max(least).sqrt()
    }
}

/// What slices say about one surface, with their heights, from its lowest slice up.
type Profile<'a> = Vec<(f64, &'a SquaredRadius)>;

fn profile<'a>(
    frame: &'a RadialFrame,
    of: impl Fn(&'a RadialSlice) -> Option<&'a SquaredRadius>,
) -> Profile<'a> {
    let said = frame.slices.iter();
    said.filter_map(|slice| Some((slice.height, of(slice)?)))
        .collect()
}

/// Heights of the tips of endocardium and epicardium.
fn tips(frame: &RadialFrame, cavity: &Profile, heart: &Profile) -> [f64; 2] {
    let h = frame.thickness;
    let depth = |profile: &Profile| match profile.as_slice() {
        [(_, lowest), (_, next), ..] => tip_depth(lowest.area(), next.area()) * h,
        _ => TIP_DEPTH[1] * h,
    };
    let upper_side = |profile: &Profile| profile.first().map_or(0.0, |(z, _)| z + 0.5 * h);
    let (endo_side, endo_depth) = (upper_side(cavity), depth(cavity));
    let mut epi = upper_side(heart) - depth(heart);
    // The tip of the cavity stays above that of the heart: first it moves up by at most half its depth, then the heart's down.
    let wall = TIP_WALL * lowest_thickness(cavity, heart);
    let endo = (endo_side - endo_depth).max((epi + wall).min(endo_side - 0.5 * endo_depth));
    epi = epi.min(endo - wall);
    [endo, epi]
}

/// Depth of a tip below the upper side of its slice, in slices, from the areas of that slice and of the next one up.
///
/// Near the tip of an ellipsoid the area grows as the height above the tip, A = g (z − zₐ). The tip's slice holds
/// A₀ h = g d² / 2 below its upper side, and the middle of the next one has A₁ = g (d + h/2); with ρ = A₀ / A₁ that is
/// d = h (ρ + √(ρ² + ρ)).
fn tip_depth(area: f64, next: f64) -> f64 {
    let [least, most] = TIP_DEPTH;
    if next <= 0.0 {
        return most;
    }
    let ratio = area / next;
    (ratio + (ratio * ratio + ratio).sqrt()).clamp(least, most)
}

/// Mean thickness of the wall in the two lowest slices that show both surfaces.
fn lowest_thickness(cavity: &Profile, heart: &Profile) -> f64 {
    let radius = |q: &SquaredRadius| q.0[0][0].max(0.0).sqrt();
    let both = cavity.iter().filter_map(|(height, endo)| {
        let (_, epi) = heart.iter().find(|(other, _)| other == height)?;
        Some(radius(epi) - radius(endo))
    });
    let lowest: Vec<f64> = both.take(2).collect();
    lowest.iter().sum::<f64>() / lowest.len().max(1) as f64
}

/// The axis through the centres of slices, x and y at the nodes.
fn axis(frame: &RadialFrame, nodes: &Nodes, stiffness: f64) -> Option<Vec<Vec<f64>>> {
    let known = frame
        .slices
        .iter()
        .filter_map(|slice| Some((slice.height, slice.centre?)));
    let (heights, centres): (Vec<f64>, Vec<Place>) = known.unzip();
    let rows: Vec<Observation> = heights.iter().map(|&z| nodes.point(z)).collect();
    let columns = [0, 1].map(|axis| centres.iter().map(|centre| centre[axis]).collect());
    nodes.smoothed(&rows, &columns, stiffness, false)
}
