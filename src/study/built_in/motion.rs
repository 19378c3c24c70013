//! A motion of the whole wall that keeps the volume of every piece of it.
//!
//! A particle at (R, Θ, Z) moves to (r, θ, z) with
//!   z = f(Θ, Z),  θ = Θ + ψ(Z),  r² = (R² − κ Rₑ²) / g,  g = f_Z − ψ′ f_Θ,
//! where Rₑ(Θ, Z) is the inner radius at end-diastole. Its Jacobian determinant is
//! (r/R) (∂r/∂R) (θ_Θ z_Z − θ_Z z_Θ) = (1/g) · g = 1, for any f, ψ and κ: the wall thickens because
//! it is incompressible, and the cavity keeps the share 1 − κ of its volume where κ is constant,
//! however much it shortens. f, ψ and κ hold the base's descent, the twist and the contraction;
//! patches take their part out of f and κ. Final shears, which keep volumes too, curve the long
//! axis and tilt the base.

use super::grid::GridPoint;
use super::shape::Shape;
use super::timing::{BeatState, ramp};
use crate::mesh::Point3;

/// Strength of the motion at end-systole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct MotionDesign {
    /// Share κ of the cross-section that leaves the cavity where the wall is well.
    pub squeeze: f64,
    /// Share by which normal myocardium shortens along the axis, from the lower third up.
    pub shortening: f64,
    /// Share by which the wall under the cavity's tip lengthens along the axis.
    pub tip_lengthening: f64,
    /// Rotation about the axis towards the base (counter-clockwise seen from the base) at the apex.
    pub apex_turn_rad: f64,
    /// The same at the base.
    pub base_turn_rad: f64,
    /// Sideways offset of the long axis at the base, by the square of the height.
    pub bend_mm: [f64; 2],
    /// Tilt of the base plane towards septum and anterior wall.
    pub tilt: [f64; 2],
}

/// Share of the height over which the wall goes from lengthening (tip) to shortening.
const SHORTENING_FROM: f64 = 0.45;

/// Share of the shortening that myocardium which does not work goes without; the rest it is made
/// to follow by the sheets that it is woven into. With it an ill column of the wall holds the
/// base up by some millimetres, and an ill place thickens by a few percent.
const TETHERED: f64 = 0.4;

/// A particle with all that its path needs; times enter only in [`Motion::at`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Material {
    radius2: f64,
    around: [f64; 2],
    z: f64,
    /// Z − f at end-systole.
    descent: f64,
    /// 1 − f_Z at end-systole.
    shortening: f64,
    /// f_Θ at end-systole.
    slope_around: f64,
    /// κ Rₑ² at end-systole.
    squeezed: f64,
    turn: f64,
    turn_slope: f64,
}

/// The motion of one subject.
#[derive(Clone, Debug)]
pub(super) struct Motion<'a> {
    shape: &'a Shape,
    design: MotionDesign,
}

impl<'a> Motion<'a> {
    pub fn new(shape: &'a Shape, design: MotionDesign) -> Self {
        Self { shape, design }
    }

    /// The inner surface's particle at a grid point.
    pub fn endo(&self, point: GridPoint) -> Material {
        let z = self.shape.endo_height_mm(point.eccentric_share);
        let radius2 = self.shape.endo_radius2_mm2(z, point.around_rad);
        self.material(radius2, point.around_rad, z)
    }

    /// The outer surface's particle at a grid point.
    pub fn epi(&self, point: GridPoint) -> Material {
        let z = self.shape.epi_height_mm(point.eccentric_share);
        let radius2 = self.shape.epi_radius2_mm2(z, point.around_rad);
        self.material(radius2, point.around_rad, z)
    }

    /// A particle anywhere in the wall.
    pub fn material(&self, radius2: f64, around_rad: f64, z: f64) -> Material {
        let design = &self.design;
        let apex = self.shape.apex_mm();
        let height = (z - apex) / -apex;
        let ill = self.shape.illness(z, around_rad);
        let [tethered, tethered_slope] = self.tethered(around_rad, z);
        let squeeze = design.squeeze
            * (1.0 - ill.severity)
            * Shape::contraction_share(self.shape.height_share(z));
        let turn_range = design.base_turn_rad - design.apex_turn_rad;
        Material {
            radius2,
            around: [around_rad.cos(), around_rad.sin()],
            z,
            descent: -apex * self.free_descent(height) - tethered,
            shortening: self.free_shortening(height)
                * (1.0 - TETHERED * self.shape.tether(z, around_rad).severity),
            slope_around: tethered_slope,
            squeezed: squeeze * self.shape.endo_radius2_mm2(z, around_rad),
            turn: design.apex_turn_rad + turn_range * ramp(height, 0.0, 1.0),
            turn_slope: turn_range * 6.0 * height * (1.0 - height) / -apex,
        }
    }

    /// Where a particle is at a moment of the beat.
    pub fn at(&self, particle: &Material, state: BeatState) -> Point3 {
        let BeatState {
            contraction,
            rotation,
        } = state;
        let apex = self.shape.apex_mm();
        let z = particle.z - contraction * particle.descent;
        let surface_stretch = 1.0
            - contraction * particle.shortening
            - rotation * particle.turn_slope * contraction * particle.slope_around;
        let radius2 = (particle.radius2 - contraction * particle.squeezed) / surface_stretch;
        let radius = radius2.max(0.0).sqrt();
        let (sin, cos) = (rotation * particle.turn).sin_cos();
        let [cos_0, sin_0] = particle.around;
        let height = (z - apex) / -apex;
        let [bend_x, bend_y] = self.design.bend_mm.map(|bend| bend * height * height);
        let x = radius * (cos_0 * cos - sin_0 * sin) + bend_x;
        let y = radius * (sin_0 * cos + cos_0 * sin) + bend_y;
        let [tilt_x, tilt_y] = self.design.tilt;
        Point3::new(x, y, z + tilt_x * x + tilt_y * y)
    }

    /// 1 − f_Z of normal myocardium at a height counted from the apex (0) to the base (1).
    fn free_shortening(&self, height: f64) -> f64 {
        let above = ramp(height, 0.0, SHORTENING_FROM);
        self.design.shortening * above - self.design.tip_lengthening * (1.0 - above)
    }

    /// Its integral from the apex, in shares of the wall's length.
    fn free_descent(&self, height: f64) -> f64 {
        let x = (height / SHORTENING_FROM).clamp(0.0, 1.0);
        let above =
            SHORTENING_FROM * x * x * x * (1.0 - 0.5 * x) + (height - SHORTENING_FROM).max(0.0);
        self.design.shortening * above - self.design.tip_lengthening * (height - above)
    }

    /// Descent that patches below this place take away, ∫ (1 − f_Z) s dZ over their tether s, and
    /// its derivative around the axis; by three Gauss panels of eight points, an error under
    /// 0.01 mm for the narrowest border.
    fn tethered(&self, around_rad: f64, z: f64) -> [f64; 2] {
        const PANELS: usize = 3;
        if self.shape.patches().is_empty() {
            return [0.0; 2];
        }
        let apex = self.shape.apex_mm();
        let half = 0.5 * (z - apex) / PANELS as f64;
        let mut sums = [0.0; 2];
        for panel in 0..PANELS {
            let middle = apex + half * (2 * panel + 1) as f64;
            for (node, weight) in GAUSS_8 {
                for z in [middle - half * node, middle + half * node] {
                    let ill = self.shape.tether(z, around_rad);
                    let weight =
                        TETHERED * weight * half * self.free_shortening((z - apex) / -apex);
                    sums[0] += weight * ill.severity;
                    sums[1] += weight * ill.around_derivative;
                }
            }
        }
        sums
    }
}

/// Positive nodes and weights of the eight-point Gauss–Legendre rule on −1..1.
const GAUSS_8: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_2, 0.101_228_536_290_376_3),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::built_in::design::{SubjectDesign, designs};
    use nalgebra::Matrix3;

    /// Where a particle at Cartesian model coordinates goes.
    fn moved(motion: &Motion<'_>, point: Point3, state: BeatState) -> Point3 {
        let particle = motion.material(
            point.x * point.x + point.y * point.y,
            point.y.atan2(point.x),
            point.z,
        );
        motion.at(&particle, state)
    }

    /// Determinant of the motion's derivative, by central differences.
    fn volume_change(motion: &Motion<'_>, point: Point3, state: BeatState) -> f64 {
        const STEP_MM: f64 = 1e-3;
        let columns = [0, 1, 2].map(|axis| {
            let mut step = nalgebra::Vector3::zeros();
            step[axis] = STEP_MM;
            (moved(motion, point + step, state) - moved(motion, point - step, state))
                / (2.0 * STEP_MM)
        });
        Matrix3::from_columns(&columns).determinant()
    }

    /// Greatest departure of the volume change from 1 over the wall of a subject.
    fn worst_change(design: &SubjectDesign) -> f64 {
        let shape = Shape::new(design.form.clone(), design.edv_ml);
        let motion = Motion::new(&shape, design.motion(0.6));
        let mut worst = 0.0_f64;
        for height in [0.1, 0.25, 0.4, 0.6, 0.8, 0.95] {
            let z = shape.cavity_tip_mm() * (1.0 - height);
            for step in 0..24 {
                let around = std::f64::consts::TAU * (f64::from(step) + 0.3) / 24.0;
                let inner = shape.endo_radius2_mm2(z, around).sqrt();
                let outer = shape.epi_radius2_mm2(z, around).sqrt();
                for depth in [0.05, 0.5, 0.95] {
                    let radius = inner + depth * (outer - inner);
                    let point = Point3::new(radius * around.cos(), radius * around.sin(), z);
                    for (contraction, rotation) in [(1.0, 1.0), (0.4, 0.9)] {
                        let state = BeatState {
                            contraction,
                            rotation,
                        };
                        worst = worst.max((volume_change(&motion, point, state) - 1.0).abs());
                    }
                }
            }
        }
        worst
    }

    #[test]
    fn every_piece_of_the_wall_keeps_its_volume() {
        for design in designs(3) {
            let worst = worst_change(&design);
            // Without patches all is in closed form; with them the quadrature of the tether
            // leaves some 1e-4.
            let most = if design.form.patches.is_empty() {
                1e-6
            } else {
                2e-3
            };
            assert!(worst < most, "{}: {worst}", design.id);
        }
    }

    #[test]
    fn the_free_descent_is_the_integral_of_the_free_shortening() {
        let design = &designs(3)[0];
        let shape = Shape::new(design.form.clone(), design.edv_ml);
        let motion = Motion::new(&shape, design.motion(0.6));
        for height in [0.1, 0.3, 0.45, 0.7, 1.0] {
            let step = 1e-6;
            let slope = (motion.free_descent(height + step) - motion.free_descent(height - step))
                / (2.0 * step);
            assert!((slope - motion.free_shortening(height)).abs() < 1e-8);
        }
    }
}
