//! The long axis of a ventricle in SPECT, and how a wall lies around it.

use nalgebra::{Matrix3, SVector};

use crate::mesh::{Point3, Vector3};

/// A line from the apex to the base, with directions across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct LongAxis {
    /// A point of it.
    pub origin: Point3,
    /// Columns: two directions across it, and the one towards the base; right-handed.
    pub directions: Matrix3<f64>,
}

impl LongAxis {
    /// Through a point towards the base; `None` without a direction.
    pub fn towards(origin: Point3, base: Vector3) -> Option<Self> {
        let up = base.try_normalize(1e-9)?;
        // The axis of the world that is the most across: across and up stay well apart.
        let across = Vector3::ith(up.iamin(), 1.0);
        let x = (across - up * up.dot(&across)).normalize();
        Some(Self {
            origin,
            directions: Matrix3::from_columns(&[x, up.cross(&x), up]),
        })
    }

    /// The direction towards the base.
    pub fn up(&self) -> Vector3 {
        self.directions.column(2).into_owned()
    }

    /// Coordinates across and along the axis to the world.
    pub fn position(&self, local: Vector3) -> Point3 {
        self.origin + self.directions * local
    }

    /// Coordinates of a position across and along the axis.
    pub fn local(&self, position: Point3) -> Vector3 {
        self.directions.tr_mul(&(position - self.origin))
    }
}

/// A wall of revolution about an axis: ρ² = a + b z + c z², with z towards the base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Conic {
    pub axis: LongAxis,
    coefficients: [f64; 3],
    /// Mean square of the differences of ρ, over the points.
    pub error: f64,
}

impl Conic {
    /// The squared radius at a height.
    fn square(&self, z: f64) -> f64 {
        let [a, b, c] = self.coefficients;
        a + z * (b + z * c)
    }

    /// The radius at a height, 0 below the apex.
    pub fn radius(&self, z: f64) -> f64 {
        self.square(z).max(0.0).sqrt()
    }

    /// The conic through points about an axis, by least squares of ρ²; `None` of too few points.
    pub fn about(axis: &LongAxis, points: &[Point3]) -> Option<Self> {
        let mut normal = Matrix3::<f64>::zeros();
        let mut right = Vector3::zeros();
        for &point in points {
            let local = axis.local(point);
            let row = Vector3::new(1.0, local.z, local.z * local.z);
            // A difference of ρ² is 2 ρ times one of ρ.
            let weight = 1.0 / (local.x.hypot(local.y).max(5.0)).powi(2);
            normal += row * row.transpose() * weight;
            right += row * (weight * (local.x * local.x + local.y * local.y));
        }
        let solution = normal.lu().solve(&right)?;
        let mut conic = Self {
            axis: *axis,
            coefficients: solution.into(),
            error: 0.0,
        };
        let differences = points.iter().map(|&point| {
            let local = axis.local(point);
            let (radius, square) = (local.x.hypot(local.y), conic.square(local.z));
            // Points below the tip of the conic are as far as its height says, roughly.
            let difference = radius - square.abs().sqrt().copysign(square);
            difference.powi(2).min(MAX_DIFFERENCE_MM.powi(2))
        });
        conic.error = differences.sum::<f64>() / points.len().max(1) as f64;
        conic.error.is_finite().then_some(conic)
    }

    /// The height of its tip and its greatest radius over the heights that a ventricle can have; `None` if it has no tip.
    pub fn tip_and_radius(&self) -> Option<(f64, f64)> {
        let heights = (0..2 * REACH_MM as usize).map(|mm| mm as f64 - REACH_MM);
        let inside = |z: &f64| self.square(*z) > 0.0;
        // From the middle down: where a ventricle opens above, the conic may be wider still.
        let tip = heights
            .clone()
            .rev()
            .skip_while(|z| *z > 0.0)
            .find(|z| !inside(z))?;
        let greatest = heights
            .filter(|z| *z > tip && *z <= tip + WIDEST_MM)
            .map(|z| self.radius(z));
        let radius = greatest.fold(0.0, f64::max);
        (radius > MIN_RADIUS_MM).then_some((tip, radius.min(MAX_RADIUS_MM)))
    }

    /// The axis near another one about which points lie most nearly on a surface of revolution.
    pub fn fitted(start: &LongAxis, points: &[Point3]) -> Option<Self> {
        let mut best = Self::about(start, points)?;
        let mut step: SVector<f64, 4> = SVector::from([6.0, 6.0, 0.2, 0.2]);
        while step[0] > 0.1 {
            let mut better = false;
            for number in 0..8 {
                let mut by = [0.0; 4];
                by[number / 2] = if number % 2 == 0 { 1.0 } else { -1.0 } * step[number / 2];
                let axis = moved(&best.axis, by);
                if let Some(conic) = axis.and_then(|axis| Self::about(&axis, points))
                    && conic.error < best.error
                {
                    best = conic;
                    better = true;
                }
            }
            if !better {
                step *= 0.5;
            }
        }
        Some(best)
    }
}

/// Heights on either side of the point that the axis goes through that are looked at.
const REACH_MM: f64 = 120.0;
/// Height above the tip at which a ventricle is widest, at most.
const WIDEST_MM: f64 = 60.0;
/// Radii of the middle of a wall.
const MIN_RADIUS_MM: f64 = 9.0;
const MAX_RADIUS_MM: f64 = 66.0;
/// Greatest difference of a point from the wall that counts for more: others are not of the wall.
const MAX_DIFFERENCE_MM: f64 = 8.0;

/// An axis moved across and turned about its origin.
fn moved(axis: &LongAxis, [x, y, turn_x, turn_y]: [f64; 4]) -> Option<LongAxis> {
    let across = axis.directions * Vector3::new(x, y, 0.0);
    let up = axis.directions * Vector3::new(turn_x, turn_y, 1.0);
    LongAxis::towards(axis.origin + across, up)
}
