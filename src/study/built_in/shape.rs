//! The wall at end-diastole: radii of its inner and outer surface around the long axis.
//!
//! Model coordinates: z along the long axis, the base at 0 and the tips below; angles around it
//! from the middle of the septum towards the anterior wall, so that septum, anterior wall and
//! base make a right-handed frame as in the body. Lengths in millimetres.

use std::f64::consts::TAU;

use super::patch::{ChartPoint, Illness, Patch, illness};
use super::timing::ramp;

/// Share of the cavity's length over which contraction fades out towards its tip, so that the
/// outer surface over the tip stays free of creases.
const TIP_FADE: f64 = 0.06;
/// Share of the contraction that the ring of the mitral valve, which is stiffer, does without.
const STIFF_BASE: f64 = 0.15;

/// A gentle wave of the wall's radius around the axis: amplitude · cos(order · Θ − phase − spiral · h).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wave {
    pub order: f64,
    pub amplitude: f64,
    pub phase_rad: f64,
    pub spiral_rad: f64,
}

/// Form of one subject, apart from its width.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Form {
    /// From the base to the tip of the cavity.
    pub cavity_length_mm: f64,
    /// Place of the widest ring, as a share of the cavity's length from its tip.
    pub widest_share: f64,
    /// 0 for an ellipsoid; larger is more pointed.
    pub pointedness: f64,
    /// Share by which the septal side lies nearer to the axis.
    pub septal_flattening: f64,
    /// Three waves that make the subject its own.
    pub waves: [Wave; 3],
    /// Thickness at mid-height.
    pub wall_mm: f64,
    /// Share by which the septum is thicker.
    pub septal_thickening: f64,
    /// Thickness at the tip, as a share of the wall's.
    pub tip_share: f64,
    /// Share by which a wholly ill wall is thinner.
    pub scar_thinning: f64,
    /// What does not work.
    pub patches: Vec<Patch>,
}

/// A form with its width: everything about the wall at end-diastole.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    form: Form,
    soft_patches: Vec<Patch>,
    half_width_mm: f64,
    tip_wall_mm: f64,
}

impl Shape {
    /// The form made as wide as its cavity needs to hold `volume_ml`.
    pub fn new(form: Form, volume_ml: f64) -> Self {
        let tip_illness = illness(&form.patches, ChartPoint::new(0.0, 0.0)).severity;
        let tip_wall_mm = form.wall_mm * form.tip_share * (1.0 - form.scar_thinning * tip_illness);
        let soft_patches = form.patches.iter().map(Patch::softened).collect();
        let mut shape = Self {
            form,
            soft_patches,
            half_width_mm: 1.0,
            tip_wall_mm,
        };
        let [unit_volume_mm3, _] = shape.cavity_integrals(|_| 1.0);
        shape.half_width_mm = (1e3 * volume_ml / unit_volume_mm3).sqrt();
        shape
    }

    /// Height of the cavity's tip (negative).
    pub fn cavity_tip_mm(&self) -> f64 {
        -self.form.cavity_length_mm
    }

    /// Height of the outer tip, the apex of the subject (negative).
    pub fn apex_mm(&self) -> f64 {
        -self.form.cavity_length_mm - self.tip_wall_mm
    }

    /// Height of a ring of the inner surface, by its share of the eccentric angle.
    pub fn endo_height_mm(&self, eccentric_share: f64) -> f64 {
        height(
            eccentric_share,
            self.cavity_tip_mm(),
            self.form.widest_share,
        )
    }

    /// Height of a ring of the outer surface.
    pub fn epi_height_mm(&self, eccentric_share: f64) -> f64 {
        height(eccentric_share, self.apex_mm(), self.epi_widest_share())
    }

    /// Squared distance of the inner surface from the axis; zero below its tip.
    pub fn endo_radius2_mm2(&self, z_mm: f64, around_rad: f64) -> f64 {
        let share = self.height_share(z_mm);
        if share <= 0.0 {
            return 0.0;
        }
        let width = self.half_width_mm * self.modulation(share, around_rad);
        width * width * self.profile2(share, self.form.widest_share)
    }

    /// Squared distance of the outer surface from the axis.
    pub fn epi_radius2_mm2(&self, z_mm: f64, around_rad: f64) -> f64 {
        let cavity_share = self.height_share(z_mm);
        let share = (z_mm - self.apex_mm()) / -self.apex_mm();
        let width = self.half_width_mm * self.modulation(cavity_share, around_rad)
            + self.wall_mm(cavity_share, around_rad);
        width * width * self.profile2(share.max(0.0), self.epi_widest_share())
    }

    /// Illness of a place.
    pub fn illness(&self, z_mm: f64, around_rad: f64) -> Illness {
        if self.form.patches.is_empty() {
            return Illness::default();
        }
        illness(
            &self.form.patches,
            ChartPoint::new(self.height_share(z_mm), around_rad),
        )
    }

    /// How much of the shortening along the axis a place does without: illness with a wide
    /// border, because the sheets of the wall are tied to one another.
    pub fn tether(&self, z_mm: f64, around_rad: f64) -> Illness {
        if self.soft_patches.is_empty() {
            return Illness::default();
        }
        illness(
            &self.soft_patches,
            ChartPoint::new(self.height_share(z_mm), around_rad),
        )
    }

    /// What does not work.
    pub fn patches(&self) -> &[Patch] {
        &self.form.patches
    }

    /// Share of the cavity's height, 0 at its tip (negative below) and 1 at the base.
    pub fn height_share(&self, z_mm: f64) -> f64 {
        1.0 - z_mm / self.cavity_tip_mm()
    }

    /// How much of the contraction reaches a height: 0 at the cavity's tip, at most 1.
    ///
    /// h (1 + δ) / (h + δ): with it R² (1 − κ w) grows with h for every κ < 1, so that the
    /// contracted cavity has no waist above its tip, as it would with a fade of finite length.
    pub fn contraction_share(height_share: f64) -> f64 {
        let height = height_share.max(0.0);
        height * (1.0 + TIP_FADE) / (height + TIP_FADE)
            * (1.0 - STIFF_BASE * ramp(height, 0.55, 1.0))
    }

    /// Volume of the cavity in mm³, and the part of it that `weight` counts: midpoint sums of
    /// ½ R² dΘ dz. Weight takes height share and angle.
    ///
    /// 96 heights and 48 angles: the error against twice as many is below 1e-4 of the volume.
    pub fn cavity_integrals(&self, weight: impl Fn([f64; 2]) -> f64) -> [f64; 2] {
        const HEIGHTS: usize = 96;
        const ANGLES: usize = 48;
        let cell = 0.5 * self.form.cavity_length_mm / HEIGHTS as f64 * TAU / ANGLES as f64;
        let [mut whole, mut part] = [0.0, 0.0];
        for level in 0..HEIGHTS {
            let share = (level as f64 + 0.5) / HEIGHTS as f64;
            let z_mm = self.cavity_tip_mm() * (1.0 - share);
            for step in 0..ANGLES {
                let around = TAU * step as f64 / ANGLES as f64;
                let volume = cell * self.endo_radius2_mm2(z_mm, around);
                whole += volume;
                part += volume * weight([share, around]);
            }
        }
        [whole, part]
    }

    /// Thickness across the axis.
    fn wall_mm(&self, cavity_share: f64, around_rad: f64) -> f64 {
        let form = &self.form;
        let septal = form.septal_thickening * septal_bump(around_rad) * window(cavity_share);
        let scar = if form.patches.is_empty() || form.scar_thinning == 0.0 {
            0.0
        } else {
            form.scar_thinning
                * illness(&form.patches, ChartPoint::new(cavity_share, around_rad)).severity
        };
        form.wall_mm * (1.0 + septal) * (1.0 - scar)
    }

    /// Squared half-width at a height over that of the widest ring: a truncated ellipsoid,
    /// 1 − x² with x = (w − h) / w, drawn in towards the tip by (1 − k (1 − h)²).
    fn profile2(&self, share: f64, widest_share: f64) -> f64 {
        let x = (widest_share - share) / widest_share;
        let from_base = 1.0 - share;
        (1.0 - x * x) * (1.0 - self.form.pointedness * from_base * from_base)
    }

    /// Departure from roundness; none at the tip, where directions meet.
    fn modulation(&self, cavity_share: f64, around_rad: f64) -> f64 {
        let form = &self.form;
        let waves: f64 = form
            .waves
            .iter()
            .map(|wave| {
                let angle =
                    wave.order * around_rad - wave.phase_rad - wave.spiral_rad * cavity_share;
                wave.amplitude * angle.cos()
            })
            .sum();
        1.0 + window(cavity_share) * (waves - form.septal_flattening * septal_bump(around_rad))
    }

    fn epi_widest_share(&self) -> f64 {
        let length = self.form.cavity_length_mm;
        (self.form.widest_share * length + self.tip_wall_mm) / (length + self.tip_wall_mm)
    }
}

/// −tip · w (1 − cos β) above the tip, where β runs to the base: 1 = w (1 − cos β_base).
fn height(eccentric_share: f64, tip_mm: f64, widest_share: f64) -> f64 {
    let base_angle = (1.0 - 1.0 / widest_share).acos();
    if eccentric_share >= 1.0 {
        return 0.0;
    }
    let share = widest_share * (1.0 - (eccentric_share * base_angle).cos());
    tip_mm * (1.0 - share)
}

/// 1 in the middle of the septum; half of that 43° away; under 0.01 on the free wall.
fn septal_bump(around_rad: f64) -> f64 {
    (2.6 * (around_rad.cos() - 1.0)).exp()
}

/// Lets departures from roundness grow from the tip: C² at 0 and whole from the middle up.
fn window(cavity_share: f64) -> f64 {
    let x = (cavity_share / 0.55).clamp(0.0, 1.0);
    x * x * x * (x * (6.0 * x - 15.0) + 10.0)
}
