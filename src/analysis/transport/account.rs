//! How a motion was transported: which paths were found, and what was kept on the way.

use crate::analysis::geodesics::GeodesicPath;
use crate::mesh::Point3;

/// A deformation transported to another subject.
#[derive(Clone, Debug, PartialEq)]
pub struct TransportedPoses {
    /// As many poses as the source has, the first of which is the pose transported onto.
    pub poses: Vec<Vec<Point3>>,
    /// How they were made.
    pub account: TransportAccount,
}

/// How a deformation was transported.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TransportAccount {
    /// The geodesics along which it went: one, or one a displacement; none where the straight line was asked for.
    pub paths: Vec<FoundPath>,
    /// One for each displacement.
    pub steps: Vec<TransportedStep>,
}

/// A geodesic between two subjects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoundPath {
    /// Energy of the path, in units of the metric.
    pub energy: f64,
    /// Energy of the straight line with as many poses.
    pub energy_linear: f64,
    /// Iterations of the search.
    pub iterations: usize,
    /// Whether the search met its tolerance.
    pub converged: bool,
}

/// A displacement before and after its transport, in units of the metric: parallel transport keeps both.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransportedStep {
    /// ‖X‖ at the source and ‖X̄‖ at the pose transported onto.
    pub norms: [f64; 2],
    /// ⟨⟨X, γ'⟩⟩ with the unit direction γ' of the path, there and here; 0 where the metric sees no movement.
    pub products: [f64; 2],
}

impl FoundPath {
    pub(super) fn of(path: &GeodesicPath) -> Self {
        Self {
            energy: path.energy,
            energy_linear: path.energy_linear,
            iterations: path.iterations,
            converged: path.converged,
        }
    }

    /// Energy as a share of the straight line's; 1 where there is nothing to move.
    pub fn energy_share(&self) -> f64 {
        match self.energy_linear > 0.0 {
            true => self.energy / self.energy_linear,
            false => 1.0,
        }
    }
}

impl TransportAccount {
    /// `along a geodesic, 0.913 of the straight line's energy`.
    pub fn path_words(&self) -> String {
        let shares = self.paths.iter().map(FoundPath::energy_share);
        let words = match self.paths.len() {
            0 => return "along the straight line, as asked for".to_owned(),
            1 => "along a geodesic, ".to_owned(),
            count => format!("along {count} geodesics, on average "),
        };
        let mean = shares.sum::<f64>() / self.paths.len() as f64;
        let unfinished = match self.not_converged() {
            0 => String::new(),
            count => format!(" ({count} not converged)"),
        };
        format!("{words}{mean:.3} of the straight line's energy{unfinished}")
    }

    /// Paths whose search ended before its tolerance was met: they are no geodesics to that tolerance.
    pub fn not_converged(&self) -> usize {
        self.paths.iter().filter(|path| !path.converged).count()
    }

    /// The largest change of a norm, relative to that norm.
    pub fn norm_change(&self) -> f64 {
        self.largest_change(|step| step.norms)
    }

    /// The largest change of a product with the direction of the path, relative to the norm of its displacement.
    pub fn product_change(&self) -> f64 {
        self.largest_change(|step| step.products)
    }

    fn largest_change(&self, of: impl Fn(&TransportedStep) -> [f64; 2]) -> f64 {
        let changes = (self.steps.iter())
            .filter(|step| step.norms[0] > 0.0)
            .map(|step| (of(step)[1] - of(step)[0]).abs() / step.norms[0]);
        changes.fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_transport_says_what_its_paths_cost_and_whether_the_search_for_them_ended() {
        let path = |energy: f64, converged: bool| FoundPath {
            energy,
            energy_linear: 2.0,
            iterations: 9,
            converged,
        };
        let told = |paths: &[FoundPath]| {
            let account = TransportAccount {
                paths: paths.to_vec(),
                steps: Vec::new(),
            };
            (account.path_words(), account.not_converged())
        };
        let whole = told(&[path(1.8, true)]);
        assert_eq!(
            whole.0,
            "along a geodesic, 0.900 of the straight line's energy"
        );
        assert_eq!(whole.1, 0);
        let unfinished = told(&[path(1.8, true), path(1.6, false)]);
        assert_eq!(
            unfinished.0,
            "along 2 geodesics, on average 0.850 of the straight line's energy (1 not converged)"
        );
        assert_eq!(unfinished.1, 1);
        assert_eq!(told(&[]).0, "along the straight line, as asked for");
    }

    #[test]
    fn subjects_in_one_place_need_no_energy_to_move() {
        let still = FoundPath {
            energy: 0.0,
            energy_linear: 0.0,
            iterations: 0,
            converged: true,
        };
        assert_eq!(still.energy_share(), 1.0);
    }
}
