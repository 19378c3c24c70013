//! Round numbers for ticks and scale bars.

/// The greatest of 1, 2 or 5 times a power of ten that is not above `most`; 0 where there is none.
pub fn nice_below(most: f64) -> f64 {
    if !(most.is_finite() && most > 0.0) {
        return 0.0;
    }
    let power = 10f64.powf(most.log10().floor());
    // A whole power may come out a hair above `most` by rounding.
    let share = most / power * (1.0 + 1e-9);
    let step = [5.0, 2.0, 1.0].into_iter().find(|step| *step <= share);
    step.unwrap_or(0.5) * power
}

/// Round values within `low..=high`, about `count` of them.
pub fn linear_ticks(low: f64, high: f64, count: usize) -> Vec<f64> {
    if !(low.is_finite() && high.is_finite() && high > low) {
        return Vec::new();
    }
    let wanted = (high - low) / count.max(1) as f64;
    let power = 10f64.powf(wanted.log10().floor());
    // Rather a few more ticks than asked for than far fewer.
    let enough = |step: &f64| *step >= 0.6 * wanted;
    let steps = [1.0, 2.0, 5.0, 10.0].map(|share| share * power);
    let step = steps.into_iter().find(enough).unwrap_or(10.0 * power);
    let first = (low / step - 1e-9).ceil() as i64;
    let last = (high / step + 1e-9).floor() as i64;
    (first..=last).map(|i| i as f64 * step).collect()
}

/// Enough digits to tell `step` apart, and no more.
pub fn digits_for(step: f64) -> usize {
    if step <= 0.0 {
        return 0;
    }
    (-step.log10() - 1e-9).ceil().clamp(0.0, 6.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_numbers_are_one_two_or_five() {
        for (most, nice) in [
            (1.0, 1.0),
            (37.0, 20.0),
            (0.07, 0.05),
            (1000.0, 1000.0),
            (0.9, 0.5),
        ] {
            assert!((nice_below(most) - nice).abs() < 1e-12, "{most}");
        }
        assert!(nice_below(f64::NAN).abs() < 1e-12);
    }

    #[test]
    fn ticks_lie_inside_and_are_about_as_many_as_asked_for() {
        for (low, high) in [(58.0, 131.0), (0.0, 1.0), (-3.0, 0.002)] {
            let ticks = linear_ticks(low, high, 5);
            assert!(ticks.len() >= 2 && ticks.len() <= 9, "{ticks:?}");
            assert!(
                ticks
                    .iter()
                    .all(|tick| *tick >= low - 1e-9 && *tick <= high + 1e-9)
            );
        }
        assert_eq!(linear_ticks(58.0, 131.0, 4), [60.0, 80.0, 100.0, 120.0]);
    }
}
