//! Round numbers for axes, colour bars and scale bars.

/// Steps that people count in, within one power of ten.
const NICE: [f64; 4] = [1.0, 2.0, 5.0, 10.0];

/// The smallest of …, 0.1, 0.2, 0.5, 1, 2, 5, 10, … that is at least `value`; 1 if `value` is
/// not a positive number.
pub fn nice_ceiling(value: f64) -> f64 {
    if !(value > 0.0 && value.is_finite()) {
        return 1.0;
    }
    let decade = 10_f64.powf(value.log10().floor());
    // A millionth of slack, so that 0.2 computed as 0.2000000001 stays 0.2.
    let nice = NICE
        .iter()
        .find(|&&step| step * decade >= value * (1.0 - 1e-6));
    nice.copied().unwrap_or(10.0) * decade
}

/// The greatest of …, 0.1, 0.2, 0.5, 1, 2, 5, 10, … that is not above `most`; 0 if `most` is not
/// a positive number.
pub fn nice_floor(most: f64) -> f64 {
    if !(most > 0.0 && most.is_finite()) {
        return 0.0;
    }
    let decade = 10_f64.powf(most.log10().floor());
    // A whole power may come out a hair above `most` by rounding.
    let share = most / decade * (1.0 + 1e-9);
    let nice = NICE.iter().rev().find(|&&step| step <= share);
    nice.copied().unwrap_or(0.5) * decade
}

/// Round values from `low` to `high`, both inside the range, about `wanted` of them.
pub fn nice_ticks(low: f64, high: f64, wanted: usize) -> Vec<f64> {
    if low.is_nan() || high.is_nan() || high <= low || (high - low).is_infinite() {
        return Vec::new();
    }
    let step = nice_ceiling((high - low) / wanted.max(1) as f64);
    // A millionth of a step of slack keeps ends that rounding pushed out.
    let first = (low / step - 1e-6).ceil() as i64;
    let last = (high / step + 1e-6).floor() as i64;
    (first..=last).map(|i| i as f64 * step).collect()
}

/// Ratios from `low` to `high` that halve and double evenly: …, 0.5, 0.71, 1, 1.41, 2, …
///
/// √2 apart where that gives at most `wanted` values, else factors of 2, 4, 16, … apart.
pub fn logarithmic_ticks(low: f64, high: f64, wanted: usize) -> Vec<f64> {
    if !(low > 0.0 && high > low && high.is_finite()) {
        return Vec::new();
    }
    let mut octaves = 0.5;
    while (high / low).log2() / octaves > wanted.max(2) as f64 {
        octaves *= 2.0;
    }
    let first = (low.log2() / octaves - 1e-6).ceil() as i64;
    let last = (high.log2() / octaves + 1e-6).floor() as i64;
    (first..=last)
        .map(|i| (i as f64 * octaves).exp2())
        .collect()
}

/// A number with as many decimals as the step between ticks needs.
pub fn tick_text(value: f64, step: f64) -> String {
    let decimals = if step > 0.0 && step < 1.0 {
        (-step.log10() - 1e-6).ceil().clamp(0.0, 6.0) as usize
    } else {
        0
    };
    let text = format!("{value:.decimals$}");
    if text
        .trim_start_matches('-')
        .chars()
        .all(|c| "0.".contains(c))
    {
        text.trim_start_matches('-').to_owned()
    } else {
        text.replace('-', "−")
    }
}

/// A ratio to two decimals, without zeros at the end: 0.5, 0.71, 1, 1.41.
pub(crate) fn ratio_text(value: f64) -> String {
    format!("{value:.2}")
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_greatest_round_number_below_is_one_two_or_five() {
        for (most, nice) in [
            (1.0, 1.0),
            (37.0, 20.0),
            (0.07, 0.05),
            (1000.0, 1000.0),
            (0.9, 0.5),
        ] {
            assert!((nice_floor(most) - nice).abs() < 1e-12, "{most}");
        }
        assert!(nice_floor(f64::NAN).abs() < 1e-12);
    }

    #[test]
    fn ceilings_are_one_two_or_five_times_a_power_of_ten() {
        for (value, expected) in [
            (0.13, 0.2),
            (2.0, 2.0),
            (2.01, 5.0),
            (7.0, 10.0),
            (61.0, 100.0),
        ] {
            assert!((nice_ceiling(value) - expected).abs() < 1e-12, "{value}");
        }
        assert_eq!(nice_ceiling(0.0), 1.0);
        assert_eq!(nice_ceiling(f64::NAN), 1.0);
    }

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(nice_ticks(0.0, 10.0, 5), [0.0, 2.0, 4.0, 6.0, 8.0, 10.0]);
        assert_eq!(nice_ticks(-0.3, 0.3, 3), [-0.2, 0.0, 0.2]);
        assert!(nice_ticks(1.0, 1.0, 5).is_empty());
    }

    #[test]
    fn ratios_are_divided_by_factors() {
        let texts: Vec<_> = logarithmic_ticks(0.5, 2.0, 5)
            .into_iter()
            .map(ratio_text)
            .collect();
        assert_eq!(texts, ["0.5", "0.71", "1", "1.41", "2"]);
        assert_eq!(logarithmic_ticks(0.125, 8.0, 5), [0.25, 1.0, 4.0]);
    }

    #[test]
    fn zero_has_no_sign_and_minus_is_a_minus() {
        assert_eq!(tick_text(-0.0, 0.5), "0.0");
        assert_eq!(tick_text(-1.5, 0.5), "−1.5");
        assert_eq!(tick_text(20.0, 10.0), "20");
    }
}
