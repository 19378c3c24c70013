//! Places of the wall that do not work: round patches with a soft border, in a chart that has no seam at the apex.

use super::timing::ramp;

/// Polar angle of the base in the patch chart, with the apex at 0.
pub(super) const BASE_POLAR_RAD: f64 = 1.9;

/// A place of the wall as seen by patches: the direction (sin α cos Θ, sin α sin Θ, cos α).
#[derive(Clone, Copy, Debug)]
pub(super) struct ChartPoint {
    sin_polar: f64,
    cos_polar: f64,
    around_rad: f64,
}

impl ChartPoint {
    /// `height_share` counts from the tip of the cavity (0, and below) to the base (1).
    ///
    /// α = α_base h² / (h + ε) grows from zero without a kink, so that patches over the tip of
    /// the cavity leave no crease; ε = 0.06 is the height of the tip's rounding.
    pub fn new(height_share: f64, around_rad: f64) -> Self {
        const ROUNDING: f64 = 0.06;
        let height = height_share.max(0.0);
        let polar = BASE_POLAR_RAD * height * height / (height + ROUNDING) * (1.0 + ROUNDING);
        let (sin_polar, cos_polar) = polar.sin_cos();
        Self {
            sin_polar,
            cos_polar,
            around_rad,
        }
    }
}

/// One patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Patch {
    /// Around the axis, from the middle of the septum towards the anterior wall.
    pub around_rad: f64,
    /// From the apex, in the chart.
    pub polar_rad: f64,
    /// To the middle of the border, in the chart.
    pub radius_rad: f64,
    /// Half the width of the border.
    pub half_border_rad: f64,
    /// 1 does not move at all, 0 moves as its neighbours.
    pub severity: f64,
}

/// How ill a place is, in 0..=1, and how this changes around the axis (per radian).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Illness {
    pub severity: f64,
    pub around_derivative: f64,
}

impl Patch {
    /// The same patch with a border so wide that neighbours that shorten by a fifth do not shear
    /// it off: 28° on either side. Its middle lies a little farther out, so that the place of the patch is still in it. Neither is tuned.
    pub fn softened(&self) -> Self {
        const WIDE_HALF_BORDER_RAD: f64 = 0.49;
        const FARTHER_RAD: f64 = 0.1;
        Self {
            radius_rad: self.radius_rad + FARTHER_RAD,
            half_border_rad: WIDE_HALF_BORDER_RAD,
            ..*self
        }
    }

    /// Membership in 0..=1, about 0.6 at the radius, and its derivative around the axis.
    pub fn membership(&self, point: ChartPoint) -> (f64, f64) {
        let (sin_centre, cos_centre) = self.polar_rad.sin_cos();
        let (sin_between, cos_between) = (point.around_rad - self.around_rad).sin_cos();
        let across = point.sin_polar * sin_centre;
        let cos_distance = point.cos_polar * cos_centre + across * cos_between;
        let outer = (self.radius_rad + self.half_border_rad).cos();
        let inner = (self.radius_rad - self.half_border_rad).max(0.0).cos();
        let x = ((cos_distance - outer) / (inner - outer)).clamp(0.0, 1.0);
        let slope = 6.0 * x * (1.0 - x) / (inner - outer);
        (
            ramp(cos_distance, outer, inner),
            -slope * across * sin_between,
        )
    }
}

/// Illness of a place under all patches: 1 − Π (1 − sₖ mₖ).
pub(super) fn illness(patches: &[Patch], point: ChartPoint) -> Illness {
    let mut health = 1.0;
    let mut derivative = 0.0;
    for patch in patches {
        let (member, member_derivative) = patch.membership(point);
        let factor = 1.0 - patch.severity * member;
        derivative = derivative * factor - health * patch.severity * member_derivative;
        health *= factor;
    }
    Illness {
        severity: 1.0 - health,
        around_derivative: -derivative,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PATCH: Patch = Patch {
        around_rad: 1.0,
        polar_rad: 0.9,
        radius_rad: 0.5,
        half_border_rad: 0.15,
        severity: 0.8,
    };

    #[test]
    fn a_patch_is_whole_inside_and_absent_outside() {
        let share_of = |polar: f64| {
            // Inverse of the chart by bisection.
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let point = ChartPoint::new(middle, 0.0);
                if point.cos_polar.acos() < polar {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            low
        };
        let at = |polar: f64| PATCH.membership(ChartPoint::new(share_of(polar), 1.0)).0;
        assert!((at(0.9) - 1.0).abs() < 1e-12);
        assert!((at(1.2) - 1.0).abs() < 1e-9);
        assert!((0.4..0.65).contains(&at(1.4)));
        assert_eq!(at(1.6), 0.0);
    }

    #[test]
    fn the_derivative_is_that_of_the_illness() {
        let other = Patch {
            around_rad: 1.6,
            severity: 1.0,
            ..PATCH
        };
        let ill = |around: f64| illness(&[PATCH, other], ChartPoint::new(0.75, around));
        for around in [0.4, 0.9, 1.3, 1.9, 2.4] {
            let step = 1e-6;
            let slope = (ill(around + step).severity - ill(around - step).severity) / (2.0 * step);
            assert!((slope - ill(around).around_derivative).abs() < 1e-6);
        }
    }

    #[test]
    fn all_directions_agree_at_the_apex() {
        let here = illness(&[PATCH], ChartPoint::new(0.0, 0.3));
        let there = illness(&[PATCH], ChartPoint::new(-0.1, 2.9));
        assert_eq!(here.severity, there.severity);
    }
}
