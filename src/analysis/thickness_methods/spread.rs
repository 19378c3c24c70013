//! What many thicknesses come to: their quantiles, and how two ways of measuring agree.

/// Quantiles of the thickness of one wall at one frame, in coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThicknessSpread {
    /// Vertices with a thickness.
    pub count: usize,
    /// 5 % are thinner.
    pub low: f64,
    /// 25 % are.
    pub quarter: f64,
    /// Half are.
    pub median: f64,
    /// 75 % are.
    pub three_quarters: f64,
    /// 95 % are.
    pub high: f64,
}

/// How a way of measuring differs from another, vertex by vertex, in coordinates.
///
/// Source: Bland and Altman (1986), Lancet 327(8476).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Vertices of which both tell the thickness.
    pub pairs: usize,
    /// Mean of the differences.
    pub bias: f64,
    /// Standard deviation of the differences, by n − 1; 0 of one pair. Some 95 % of them lie within bias ± 1.96 of it.
    pub deviation: f64,
}

impl ThicknessSpread {
    /// Of the thicknesses that are known; `None` without any, or where one is not a number.
    ///
    /// The quantile of p lies at place p (n − 1) of the n sorted values, counted from 0, between two
    /// of them in proportion.
    pub fn of(thickness: impl Iterator<Item = Option<f64>>) -> Option<Self> {
        let mut sorted: Vec<f64> = thickness.flatten().collect();
        if sorted.iter().any(|value| value.is_nan()) {
            return None;
        }
        sorted.sort_unstable_by(f64::total_cmp);
        let last = sorted.len().checked_sub(1)?;
        let quantile = |p: f64| {
            // Between order statistics, so that a quantile changes steadily with the values.
            let place = p * last as f64;
            let below = (place.floor() as usize).min(last);
            let above = (below + 1).min(last);
            sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
        };
        Some(Self {
            count: sorted.len(),
            low: quantile(0.05),
            quarter: quantile(0.25),
            median: quantile(0.5),
            three_quarters: quantile(0.75),
            high: quantile(0.95),
        })
    }
}

impl Agreement {
    /// Of `measured` less `reference`, where both tell a thickness; `None` where they never do.
    pub fn of(
        measured: impl Iterator<Item = Option<f64>>,
        reference: impl Iterator<Item = Option<f64>>,
    ) -> Option<Self> {
        let both = measured.zip(reference);
        let differences: Vec<f64> = both
            .filter_map(|(measured, reference)| Some(measured? - reference?))
            .collect();
        let pairs = differences.len();
        if pairs == 0 {
            return None;
        }
        let bias = differences.iter().sum::<f64>() / pairs as f64;
        let squares: f64 = differences.iter().map(|d| (d - bias) * (d - bias)).sum();
        Some(Self {
            pairs,
            bias,
            // Over n − 1, since the mean is estimated from the same pairs.
            deviation: (squares / pairs.saturating_sub(1).max(1) as f64).sqrt(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_evenly_spaced_values_are_evenly_spaced() {
        let values = (0..=100).rev().map(|i| Some(f64::from(i) / 10.0));
        let gaps = values.flat_map(|value| [value, None]);
        let found = ThicknessSpread::of(gaps).unwrap();
        let quantiles = [
            found.low,
            found.quarter,
            found.median,
            found.three_quarters,
            found.high,
        ];
        for (quantile, wanted) in quantiles.into_iter().zip([0.5, 2.5, 5.0, 7.5, 9.5]) {
            assert!((quantile - wanted).abs() < 1e-12, "{quantile} {wanted}");
        }
        assert_eq!(found.count, 101);
        let middle = ThicknessSpread::of([Some(1.0), Some(4.0)].into_iter()).unwrap();
        assert!((middle.median - 2.5).abs() < 1e-12 && (middle.low - 1.15).abs() < 1e-12);
    }

    #[test]
    fn nothing_told_has_no_spread_and_no_agreement() {
        assert_eq!(ThicknessSpread::of([None, None].into_iter()), None);
        assert_eq!(ThicknessSpread::of([Some(f64::NAN)].into_iter()), None);
        let apart = [Some(1.0), None].into_iter();
        assert_eq!(Agreement::of(apart, [None, Some(1.0)].into_iter()), None);
    }

    #[test]
    fn agreement_is_the_mean_and_the_deviation_of_differences_of_pairs() {
        let measured = [Some(3.0), Some(5.0), None, Some(9.0)];
        let reference = [Some(2.0), Some(2.0), Some(7.0), Some(4.0)];
        let found = Agreement::of(measured.into_iter(), reference.into_iter()).unwrap();
        // Differences 1, 3, 5.
        assert_eq!((found.pairs, found.bias, found.deviation), (3, 3.0, 2.0));
        let one = Agreement::of([Some(1.0)].into_iter(), [Some(3.0)].into_iter()).unwrap();
        assert_eq!((one.bias, one.deviation), (-2.0, 0.0));
    }
}
