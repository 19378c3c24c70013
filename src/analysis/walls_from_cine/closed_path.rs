//! The closed path of least cost around a middle, by dynamic programming.

use super::polar::{RAYS, STEP_MM};

/// Greatest change from a ray to the next, in samples.
const MAX_STEP: usize = 3;

/// Costs of passing each sample of each ray.
#[derive(Clone, Debug)]
pub(super) struct Costs {
    samples: usize,
    values: Vec<f64>,
}

impl Costs {
    /// Costs by ray and sample.
    pub(super) fn of(samples: usize, cost: impl FnMut(usize) -> Vec<f64>) -> Self {
        let values: Vec<f64> = (0..RAYS).flat_map(cost).collect();
        Self { samples, values }
    }

    fn ray(&self, ray: usize) -> &[f64] {
        let ray = ray % RAYS;
        &self.values[ray * self.samples..(ray + 1) * self.samples]
    }

    /// The closed path of which Σ cost + bending Σ (Δr)² is least, as radii in millimetres. `bending` is per mm²; radii change
    /// by at most 1.5 mm from a ray to the next.
    ///
    /// Two turns without a bound give the sample where the path passes the first ray in the middle of them; a third turn
    /// begins and ends there. It is the least closed path through that sample.
    pub(super) fn min_closed(&self, bending: f64) -> Vec<f64> {
        if self.samples == 0 {
            return vec![0.0; RAYS];
        }
        let free = self.walk(2 * RAYS + 1, None, bending);
        let through = free[RAYS];
        let closed = self.walk(RAYS + 1, Some(through), bending);
        (closed.iter().take(RAYS))
            .map(|&n| (n as f64 + 0.5) * STEP_MM)
            .collect()
    }

    /// The path over so many rays, from one sample back to itself if it is bound.
    fn walk(&self, rays: usize, bound: Option<usize>, bending: f64) -> Vec<usize> {
        let bends: Vec<f64> = (0..=MAX_STEP)
            .map(|n| bending * (n as f64 * STEP_MM).powi(2))
            .collect();
        let mut best: Vec<f64> = self.ray(0).to_vec();
        if let Some(bound) = bound {
            (best.iter_mut().enumerate())
                .filter(|(n, _)| *n != bound)
                .for_each(|(_, cost)| *cost = f64::INFINITY);
        }
        let mut came_from = vec![0_u16; rays * self.samples];
        let mut next = vec![0.0; self.samples];
        for ray in 1..rays {
            let own = self.ray(ray);
            for n in 0..self.samples {
                let low = n.saturating_sub(MAX_STEP);
                let high = (n + MAX_STEP).min(self.samples - 1);
                let mut least = (f64::INFINITY, n);
                for from in low..=high {
                    let cost = best[from] + bends[n.abs_diff(from)];
                    if cost < least.0 {
                        least = (cost, from);
                    }
                }
                next[n] = least.0 + own[n];
                came_from[ray * self.samples + n] = least.1 as u16;
            }
            std::mem::swap(&mut best, &mut next);
        }
        let end = bound.unwrap_or_else(|| {
            let ends = best.iter().enumerate().min_by(|a, b| a.1.total_cmp(b.1));
            ends.map_or(0, |(n, _)| n)
        });
        let mut path = vec![end; rays];
        for ray in (1..rays).rev() {
            path[ray - 1] = usize::from(came_from[ray * self.samples + path[ray]]);
        }
        path
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_path_follows_a_valley_and_closes() {
        let valley =
            |ray: usize| 30.0 + 8.0 * (std::f64::consts::TAU * ray as f64 / RAYS as f64).sin();
        let costs = Costs::of(80, |ray| {
            (0..80).map(|n| (n as f64 - valley(ray)).abs()).collect()
        });
        let path = costs.min_closed(0.0);
        for (ray, radius) in path.iter().enumerate() {
            assert!((radius / STEP_MM - 0.5 - valley(ray)).abs() <= 0.5 + 1e-9);
        }
    }

    #[test]
    fn a_short_gap_in_the_valley_is_bridged_and_ends_meet() {
        // At the first ray the cheapest sample lies far off: a path that begins there has to come back.
        let costs = Costs::of(60, |ray| {
            let lure = if ray == 0 { 50 } else { 20 };
            (0..60)
                .map(|n| if n == lure { -1.0 } else { 0.0 })
                .collect()
        });
        let path = costs.min_closed(0.05);
        assert!(
            path.iter()
                .all(|radius| (radius - 20.5 * STEP_MM).abs() < 1e-12),
            "{path:?}"
        );
    }
}
