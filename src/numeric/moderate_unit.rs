//! A unit in which squares and fourth powers of sizes neither overflow nor vanish.

/// 1 for sizes up to `largest` of which fourth powers are ordinary numbers; else the power of two below `largest`.
///
/// Dividing by a power of two rounds nothing but what vanishes beside `largest`, so that an answer which
/// scales with its input is the same in this unit. 1 for zero, and for what is not finite.
pub fn moderate_unit(largest: f64) -> f64 {
    // 10⁶⁰ to the fourth power, summed over a million squared, is far inside the range of numbers.
    if largest == 0.0 || !largest.is_finite() || (1e-60..=1e60).contains(&largest) {
        return 1.0;
    }
    // No smaller than the least normal number, whose reciprocal is finite.
    largest.log2().floor().clamp(-1022.0, 1023.0).exp2()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ordinary_sizes_keep_their_unit_and_others_come_near_one() {
        for size in [0.0, 1e-60, 1.0, 87.3, 1e60, f64::INFINITY, f64::NAN] {
            assert_eq!(moderate_unit(size), 1.0);
        }
        for size in [1e-320, 1e-200, 1e-61, 1e61, 1e200, f64::MAX] {
            let scaled = size / moderate_unit(size);
            assert!((1e-16..4.0).contains(&scaled), "{size:e}: {scaled}");
            assert!((1.0 / moderate_unit(size)).is_finite());
        }
        // A power of two: nothing is rounded.
        assert_eq!(moderate_unit(3e200) * (3e200 / moderate_unit(3e200)), 3e200);
    }
}
