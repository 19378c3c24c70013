//! Four numbers side by side, and arithmetic for formulas that serve one number or four.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// How many numbers go side by side.
pub const LANES: usize = 4;

/// What formulas of the metrics ask of a number, be it one or [`Lanes`] of them.
pub trait Arithmetic:
    Copy
    + Default
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
{
    /// The same number everywhere.
    fn splat(value: f64) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// −1, 0 or 1: the subgradient of [`Self::abs`] that is 0 at 0.
    fn sign(self) -> Self;
    /// Square root.
    fn sqrt(self) -> Self;
    /// The quotient, or 0 where the denominator is not positive.
    fn over(self, denominator: Self) -> Self;
}

/// Both of two, written out: `map` on arrays is not always inlined where it must be.
#[inline(always)]
pub fn both<T>(of: impl Fn(usize) -> T) -> [T; 2] {
    [of(0), of(1)]
}

/// All of three, likewise.
#[inline(always)]
pub fn three<T>(of: impl Fn(usize) -> T) -> [T; 3] {
    [of(0), of(1), of(2)]
}

impl Arithmetic for f64 {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline(always)]
    fn sign(self) -> Self {
        if self > 0.0 {
            1.0
        } else if self < 0.0 {
            -1.0
        } else {
            0.0
        }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.sqrt()
    }

    #[inline(always)]
    fn over(self, denominator: Self) -> Self {
        let quotient = self / denominator;
        if denominator > 0.0 { quotient } else { 0.0 }
    }
}

/// Numbers that take the same steps together; never mixed but by the sum of all and by shifts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lanes(pub [f64; LANES]);

impl Lanes {
    /// A function of each number.
    #[inline(always)]
    pub fn map(self, function: impl Fn(f64) -> f64) -> Self {
        let [a, b, c, d] = self.0;
        Self([function(a), function(b), function(c), function(d)])
    }

    #[inline(always)]
    fn zip(self, other: Self, function: impl Fn(f64, f64) -> f64) -> Self {
        let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
        Self([
            function(a, e),
            function(b, f),
            function(c, g),
            function(d, h),
        ])
    }

    /// The numbers one place later, with `first` before them; the last one falls out.
    #[inline(always)]
    pub fn later(self, first: f64) -> Self {
        Self([first, self.0[0], self.0[1], self.0[2]])
    }

    /// The numbers one place earlier, with `last` behind them; the first one falls out.
    #[inline(always)]
    pub fn earlier(self, last: f64) -> Self {
        Self([self.0[1], self.0[2], self.0[3], last])
    }

    /// Angle in radians whose sine is to its cosine as `sine`, not negative, to `cosine`; 0 where both are 0.
    ///
    /// Within 5·10⁻¹⁶ of `sine.atan2(cosine + 0.0)`: the smaller of |sine| and |cosine| over the larger, taken
    /// to |z| ≤ tan π/8 by arctan t = π/4 + arctan((t − 1)/(t + 1)), then z + z³ P(z²) with P of degree
    /// 10 through the Chebyshev nodes of its interval, off by 5·10⁻¹⁸.
    #[inline(always)]
    pub fn angle_rad(sine: Self, cosine: Self) -> Self {
        sine.zip(cosine, angle_rad)
    }
}

/// tan π/8.
const EIGHTH: f64 = 0.414_213_562_373_095_03;

#[inline(always)]
fn angle_rad(sine: f64, cosine: f64) -> f64 {
    let length = cosine.abs();
    let steep = sine > length;
    let (small, large) = if steep {
        (length, sine)
    } else {
        (sine, length)
    };
    let wide = small > EIGHTH * large;
    let over = if wide { small + large } else { large };
    let under = if wide { small - large } else { small };
    let z = under / if over > 0.0 { over } else { 1.0 };
    let u = z * z;
    let (u2, u4) = (u * u, (u * u) * (u * u));
    let low = (-0.333_333_333_333_333_3 + u * 0.199_999_999_999_955_2)
        + u2 * (-0.142_857_142_846_665_42 + u * 0.111_111_110_152_563_61);
    let middle = (-0.090_909_045_781_239_01 + u * 0.076_921_831_908_260_87)
        + u2 * (-0.066_645_114_473_819_39 + u * 0.058_581_489_128_021_295);
    let high = (-0.050_854_497_379_398_41 + u * 0.039_231_658_295_575_09)
        + u2 * -0.019_176_887_119_047_435;
    let rest = low + u4 * (middle + u4 * high);
    let first = (if wide { FRAC_PI_4 } else { 0.0 }) + (z + z * u * rest);
    let second = if steep { FRAC_PI_2 - first } else { first };
    if cosine < 0.0 { PI - second } else { second }
}

impl Arithmetic for Lanes {
    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; LANES])
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.map(f64::abs)
    }

    #[inline(always)]
    fn sign(self) -> Self {
        self.map(Arithmetic::sign)
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.map(f64::sqrt)
    }

    #[inline(always)]
    fn over(self, denominator: Self) -> Self {
        self.zip(denominator, Arithmetic::over)
    }
}

impl Add for Lanes {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, |a, b| a + b)
    }
}

impl AddAssign for Lanes {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Lanes {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, |a, b| a - b)
    }
}

impl Mul for Lanes {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.zip(other, |a, b| a * b)
    }
}

impl Neg for Lanes {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        self.map(|a| -a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_agree_with_the_library_to_round_off() {
        let mut worst = 0.0_f64;
        for step in 0..200_000 {
            let turn = PI * f64::from(step) / 199_999.0;
            let size = 10.0_f64.powi(step % 41 - 20);
            let (sine, cosine) = (size * turn.sin().max(0.0), size * turn.cos());
            let found = Lanes::angle_rad(Lanes::splat(sine), Lanes::splat(cosine));
            worst = worst.max((found.0[step as usize % 4] - sine.atan2(cosine)).abs());
        }
        assert!(worst <= 5e-16, "{worst}");
    }

    #[test]
    fn angles_of_corners_without_area_are_those_of_the_library() {
        for (sine, cosine) in [(0.0, 0.0), (0.0, -0.0), (0.0, 2.0), (0.0, -2.0), (3.0, 0.0)] {
            let found = Lanes::angle_rad(Lanes::splat(sine), Lanes::splat(cosine)).0[1];
            assert_eq!(found, f64::atan2(sine, cosine + 0.0), "{sine} {cosine}");
        }
    }

    #[test]
    fn quotients_over_nothing_are_zero() {
        let found = Lanes([1.0, -2.0, 3.0, 0.0]).over(Lanes([2.0, 0.0, -1.0, 0.0]));
        assert_eq!(found, Lanes([0.5, 0.0, 0.0, 0.0]));
    }

    #[test]
    fn a_shift_there_and_back_loses_only_what_fell_out() {
        let lanes = Lanes([1.0, 2.0, 3.0, 4.0]);
        assert_eq!(lanes.later(9.0), Lanes([9.0, 1.0, 2.0, 3.0]));
        assert_eq!(lanes.later(9.0).earlier(4.0), lanes);
    }
}
