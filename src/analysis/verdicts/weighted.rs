//! Quantiles and deviations of a quantity over a surface, by area.

/// Values with areas, in rising order.
pub(super) struct Weighted {
    sorted: Vec<[f64; 2]>,
    whole: f64,
}

impl Weighted {
    /// Of values and their areas.
    pub fn new(values: &[f64], areas: &[f64]) -> Self {
        let mut sorted: Vec<[f64; 2]> = (values.iter().zip(areas))
            // Atoms without area are those that take no part.
            .filter(|(_, area)| **area > 0.0)
            .map(|(&value, &area)| [value, area])
            .collect();
        sorted.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let whole = sorted.iter().map(|[_, area]| area).sum();
        Self { sorted, whole }
    }

    /// Area of all of them.
    pub fn whole(&self) -> f64 {
        self.whole
    }

    /// Share of the area with values below a limit; 0 of no area.
    pub fn share_below(&self, limit: f64) -> f64 {
        let below: f64 = (self.sorted.iter())
            .take_while(|[value, _]| *value < limit)
            .map(|[_, area]| area)
            .sum();
        // A sum of nothing is −0.
        (below + 0.0) / self.whole.max(f64::MIN_POSITIVE)
    }

    /// Value below which a share of the area lies.
    pub fn quantile(&self, share: f64) -> f64 {
        let mut below = 0.0;
        for [value, area] in &self.sorted {
            below += area;
            if below >= share * self.whole {
                return *value;
            }
        }
        self.sorted.last().map_or(f64::NAN, |[value, _]| *value)
    }

    /// Standard deviation.
    pub fn deviation(&self) -> f64 {
        let mean = |f: &dyn Fn(f64) -> f64| -> f64 {
            self.sorted
                .iter()
                .map(|[value, area]| area * f(*value))
                .sum::<f64>()
                / self.whole
        };
        let middle = mean(&|value| value);
        mean(&|value| (value - middle).powi(2)).sqrt()
    }
}
