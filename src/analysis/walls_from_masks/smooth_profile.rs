//! Smooth functions of the height that have given means over slices.

use nalgebra::{DMatrix, DVector};

/// Most nodes of a function: dense equations of this size take some ten milliseconds, and more nodes than this
/// make no difference to a ventricle.
const MAX_NODES: usize = 240;

/// Heights at equal distances; functions are linear between them.
#[derive(Clone, Debug)]
pub(super) struct Nodes {
    from: f64,
    step: f64,
    count: usize,
}

/// What is known: Σ weight · f(node) has a value.
pub(super) type Observation = Vec<(usize, f64)>;

impl Nodes {
    /// From one height to a greater one, at most `step` apart where that is not too many.
    pub fn new(from: f64, to: f64, step: f64) -> Self {
        let pieces = ((to - from) / step)
            .ceil()
            .clamp(8.0, (MAX_NODES - 1) as f64);
        Self {
            from,
            step: (to - from) / pieces,
            count: pieces as usize + 1,
        }
    }

    /// Place on the nodes of a height, held within them: the node below and the share of the way to the next.
    fn place(&self, height: f64) -> (usize, f64) {
        let last = (self.count - 1) as f64;
        let place = ((height - self.from) / self.step).clamp(0.0, last);
        let below = (place.floor() as usize).min(self.count - 2);
        (below, place - below as f64)
    }

    /// f at a height.
    pub fn point(&self, height: f64) -> Observation {
        let (below, share) = self.place(height);
        vec![(below, 1.0 - share), (below + 1, share)]
    }

    /// ∫ f dz / `over` from one height to another, with f = 0 beyond the nodes.
    pub fn integral(&self, from: f64, to: f64, over: f64) -> Observation {
        let mut row = vec![0.0; self.count];
        for below in 0..self.count - 1 {
            let [low, high] = [below, below + 1].map(|n| self.from + self.step * n as f64);
            let (a, b) = (low.max(from), high.min(to));
            if b > a {
                // The integral of a linear piece is its length times its value in the middle.
                let share = (0.5 * (a + b) - low) / self.step;
                row[below] += (b - a) * (1.0 - share) / over;
                row[below + 1] += (b - a) * share / over;
            }
        }
        let weights = row.into_iter().enumerate();
        weights.filter(|(_, weight)| *weight != 0.0).collect()
    }

    /// A function's value at a height; beyond the ends that of the end.
    pub fn value(&self, function: &[f64], height: f64) -> f64 {
        let (below, share) = self.place(height);
        let at = |node: usize| function.get(node).copied().unwrap_or(0.0);
        at(below) * (1.0 - share) + at(below + 1) * share
    }

    /// Functions f minimising Σ (observation − value)² + stiffness ∫ f″² dz, one for each column of `values`, with f = 0 at
    /// the first node if `pinned`; `None` where the observations do not determine them.
    ///
    /// The integral is Σ step · ((f₊ − 2 f + f₋) / step²)² over inner nodes; the ends are free.
    pub fn smoothed(
        &self,
        observations: &[Observation],
        values: &[Vec<f64>],
        stiffness: f64,
        pinned: bool,
    ) -> Option<Vec<Vec<f64>>> {
        let n = self.count;
        let mut normal = DMatrix::<f64>::zeros(n, n);
        for row in observations {
            for &(i, a) in row {
                for &(j, b) in row {
                    normal[(i, j)] += a * b;
                }
            }
        }
        let bending = stiffness * self.step.powi(-3);
        for middle in 1..n - 1 {
            let row = [(middle - 1, 1.0), (middle, -2.0), (middle + 1, 1.0)];
            for (i, a) in row {
                for (j, b) in row {
                    normal[(i, j)] += bending * a * b;
                }
            }
        }
        if pinned {
            for i in 0..n {
                normal[(0, i)] = 0.0;
                normal[(i, 0)] = 0.0;
            }
            normal[(0, 0)] = 1.0;
        }
        let factor = normal.cholesky()?;
        let solve = |column: &Vec<f64>| {
            let mut right = DVector::zeros(n);
            for (row, value) in observations.iter().zip(column) {
                for &(i, a) in row {
                    right[i] += a * value;
                }
            }
            if pinned {
                right[0] = 0.0;
            }
            let function: Vec<f64> = factor.solve(&right).iter().copied().collect();
            function.iter().all(|x| x.is_finite()).then_some(function)
        };
        values.iter().map(solve).collect()
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    #[test]
    fn a_line_is_kept_exactly_and_a_jump_is_smoothed() {
        let nodes = Nodes::new(0.0, 60.0, 2.0);
        let heights: Vec<f64> = (0..6).map(|k| 5.0 + 10.0 * f64::from(k)).collect();
        let rows: Vec<Observation> = heights
            .iter()
            .map(|z| nodes.integral(z - 5.0, z + 5.0, 10.0))
            .collect();
        let line: Vec<f64> = heights.iter().map(|z| 3.0 * z).collect();
        let zigzag: Vec<f64> = (0..6).map(|k| f64::from(k % 2)).collect();
        let found = nodes.smoothed(&rows, &[line, zigzag], 7.0, false).unwrap();
        for z in [0.0, 13.0, 60.0] {
            assert!((nodes.value(&found[0], z) - 3.0 * z).abs() < 1e-6);
        }
        let swing = nodes.value(&found[1], 35.0) - nodes.value(&found[1], 25.0);
        assert!(swing.abs() < 1.0 && swing.abs() > 0.3, "{swing}");
    }

    #[test]
    fn what_is_observed_once_is_not_determined_unless_pinned() {
        let nodes = Nodes::new(0.0, 60.0, 2.0);
        let rows = [nodes.integral(20.0, 30.0, 10.0)];
        assert!(nodes.smoothed(&[], &[vec![]], 1.0, false).is_none());
        let found = nodes.smoothed(&rows, &[vec![50.0]], 1.0, true).unwrap();
        assert!((nodes.value(&found[0], 25.0) - 50.0).abs() < 1e-3);
        assert_eq!(nodes.value(&found[0], 0.0), 0.0);
    }
}
