//! Features as a classifier reads them: imputed, flagged, standardised, all by the training set alone.

use crate::numeric::median;

/// From features that may be unknown to numbers of a common scale.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Design {
    /// Median of each feature over the rows that know it, which stands in where it is not known; `None` where no row
    /// does: the feature then says nothing of anybody.
    pub medians: Vec<Option<f64>>,
    /// Features, known in some rows only, whose absence is a column of its own.
    pub flags: Vec<usize>,
    /// What the columns are measured from and by: features first, then flags.
    pub standard: Standard,
}

/// What columns are measured from and by.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Standard {
    pub means: Vec<f64>,
    pub deviations: Vec<f64>,
}

impl Design {
    /// Of training rows of equal length.
    pub fn new(rows: &[&[Option<f64>]]) -> Self {
        let width = rows.first().map_or(0, |row| row.len());
        let mut patterns: Vec<Vec<bool>> = Vec::new();
        let mut flags = Vec::new();
        let medians = (0..width)
            .map(|j| {
                let absent: Vec<bool> = rows.iter().map(|row| row[j].is_none()).collect();
                let some = absent.contains(&true) && absent.contains(&false);
                // What is unknown together, such as all of the wall, is one flag.
                if some && !patterns.contains(&absent) {
                    patterns.push(absent);
                    flags.push(j);
                }
                median(rows.iter().filter_map(|row| row[j]).collect())
            })
            .collect();
        let mut design = Self {
            medians,
            flags,
            standard: Standard::default(),
        };
        let columns: Vec<Vec<f64>> = rows.iter().map(|row| design.columns(row)).collect();
        design.standard = Standard::new(&columns);
        design
    }

    fn columns(&self, row: &[Option<f64>]) -> Vec<f64> {
        let values = (row.iter().zip(&self.medians))
            .map(|(value, median)| median.map_or(0.0, |median| value.unwrap_or(median)));
        let flags = (self.flags.iter()).map(|&j| f64::from(u8::from(row[j].is_none())));
        values.chain(flags).collect()
    }

    /// The columns of a row, in standard deviations.
    pub fn of(&self, row: &[Option<f64>]) -> Vec<f64> {
        let Standard { means, deviations } = &self.standard;
        (self.columns(row).into_iter().zip(means).zip(deviations))
            .map(|((x, mean), deviation)| (x - mean) / deviation)
            .collect()
    }
}

impl Standard {
    /// Mean and standard deviation of each column; 1 for a column that does not vary.
    fn new(rows: &[Vec<f64>]) -> Self {
        let width = rows.first().map_or(0, Vec::len);
        let count = rows.len().max(1) as f64;
        let mean = |f: &dyn Fn(&[f64]) -> f64| rows.iter().map(|row| f(row)).sum::<f64>() / count;
        let means: Vec<f64> = (0..width).map(|j| mean(&|row| row[j])).collect();
        let deviations = (0..width)
            .map(|j| mean(&|row| (row[j] - means[j]).powi(2)).sqrt())
            .zip(&means)
            // Less is round-off of equal numbers.
            .map(|(deviation, mean)| {
                if deviation > 1e-12 * mean.abs() {
                    deviation
                } else {
                    1.0
                }
            })
            .collect();
        Self { means, deviations }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_unknown_is_the_median_with_a_flag_and_what_nobody_knows_is_nothing() {
        let rows = [
            [Some(1.0), None, None, Some(5.0)],
            [Some(3.0), Some(8.0), None, Some(5.0)],
            [Some(5.0), Some(4.0), None, Some(5.0)],
            [None, Some(6.0), None, Some(5.0)],
        ];
        let slices: Vec<&[Option<f64>]> = rows.iter().map(|row| &row[..]).collect();
        let design = Design::new(&slices);
        assert_eq!(design.medians, [Some(3.0), Some(6.0), None, Some(5.0)]);
        assert_eq!(design.flags, [0, 1]);
        // Both stand in for the mean here, and only the flag says that they do.
        let own = design.of(&rows[3]);
        assert_eq!((own[0], own[3], own.len()), (0.0, 0.0, 6));
        assert!(own[4] > 1.0 && own[5] < 0.0);
        // A number that training never saw has no scale.
        assert_eq!(design.of(&[None, None, Some(1e9), None])[2], 0.0);
    }

    #[test]
    fn what_is_unknown_together_is_one_flag() {
        let rows = [[None, None], [Some(1.0), Some(2.0)], [Some(2.0), Some(1.0)]];
        let slices: Vec<&[Option<f64>]> = rows.iter().map(|row| &row[..]).collect();
        assert_eq!(Design::new(&slices).flags, [0]);
    }
}
