//! Minimises a smooth function of many unknowns by limited-memory BFGS, preconditioned.

use std::collections::VecDeque;

use super::line_search::{Found, Trial, search};
use super::{add_scaled, dot};

/// A function to minimise.
pub trait Objective {
    /// Value at `x`; writes the gradient. May be infinite or NaN where `x` went too far.
    fn evaluate(&mut self, x: &[f64], gradient: &mut [f64]) -> f64;

    /// Replaces a gradient by about the Newton step it stands for: multiplies by a fixed symmetric
    /// positive definite matrix close to the inverse Hessian. The identity if not told otherwise.
    fn precondition(&mut self, _gradient: &mut [f64]) {}
}

/// When to end, and how much to remember.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LbfgsParams {
    /// Steps remembered; each takes three vectors.
    pub memory: usize,
    /// End when the value is expected to fall by less than this share of itself.
    pub tolerance: f64,
    /// End after so many iterations.
    pub max_iterations: usize,
}

/// Why the search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ending {
    /// The tolerance is met.
    Converged,
    /// No step falls by more than rounding.
    Exhausted,
    /// As many iterations as allowed.
    MostIterations,
    /// Was told to stop.
    Stopped,
}

/// Where the search ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Minimum {
    /// Value at the final `x`.
    pub value: f64,
    /// Iterations done.
    pub iterations: usize,
    /// Values and gradients computed.
    pub evaluations: usize,
    /// Why it ended.
    pub ending: Ending,
}

/// Steps over which the fall of the value is summed for the test of convergence: long enough that one short step does not
/// end the search, short enough that a flat one ends soon. Not tuned.
const WINDOW: usize = 8;

/// An expected fall of this share of the value is lost in rounding.
const ROUNDING: f64 = 1e-15;

/// Minimises from `x`, which ends at the best point found.
///
/// Directions are −H g with H built from the last steps (two-loop recursion) on
/// γ P, P the preconditioner and γ = sᵀy / yᵀP y. P is applied once an iteration: P y is remembered
/// with s and y. Steps meet the strong Wolfe conditions, so that sᵀy > 0 and H stays positive.
///
/// It has converged when ½ gᵀH g, the fall that is expected of the next step, and the fall of the
/// last eight together are both at most `tolerance` of the value: a single short step does not end it.
/// `go_on` is asked after each evaluation.
///
/// Source: Nocedal and Wright (2006), *Numerical Optimization*, algorithm 7.4 and section 7.2.
pub fn lbfgs(
    objective: &mut impl Objective,
    x: &mut [f64],
    params: &LbfgsParams,
    mut go_on: impl FnMut() -> bool,
) -> Minimum {
    let mut search = Search::new(objective, x, params.memory);
    let mut values = VecDeque::from([search.value]);
    let mut ending = Ending::MostIterations;
    let mut iterations = 0;
    while iterations < params.max_iterations {
        if !go_on() {
            ending = Ending::Stopped;
            break;
        }
        let slope = search.turn();
        let bound = params.tolerance * search.value.abs();
        let stationary = slope == 0.0 || !search.value.is_finite();
        let fall = if values.len() > WINDOW {
            values[0] - search.value
        } else {
            f64::INFINITY
        };
        if stationary
            || (-0.5 * slope <= bound && fall <= bound)
            || -slope <= ROUNDING * search.value.abs()
        {
            ending = Ending::Converged;
            break;
        }
        match search.advance(objective, x, slope, &mut go_on) {
            Advance::Done => iterations += 1,
            Advance::Stopped => {
                ending = Ending::Stopped;
                break;
            }
            // Old steps may have made the direction a bad one: forget them once.
            Advance::Nothing if !search.history.is_empty() => search.history.clear(),
            Advance::Nothing => {
                ending = Ending::Exhausted;
                break;
            }
        }
        values.push_back(search.value);
        if values.len() > WINDOW + 1 {
            values.pop_front();
        }
    }
    Minimum {
        value: search.value,
        iterations,
        evaluations: search.evaluations,
        ending,
    }
}

/// One remembered step.
struct Pair {
    /// Change of x.
    s: Vec<f64>,
    /// Change of the gradient.
    y: Vec<f64>,
    /// P y.
    py: Vec<f64>,
    /// 1 / sᵀy.
    rho: f64,
}

struct Search {
    value: f64,
    gradient: Vec<f64>,
    /// P g.
    stepped: Vec<f64>,
    direction: Vec<f64>,
    trial_x: Vec<f64>,
    trial_gradient: Vec<f64>,
    history: VecDeque<Pair>,
    memory: usize,
    evaluations: usize,
}

enum Advance {
    Done,
    Nothing,
    Stopped,
}

impl Search {
    fn new(objective: &mut impl Objective, x: &[f64], memory: usize) -> Self {
        let mut gradient = vec![0.0; x.len()];
        let value = objective.evaluate(x, &mut gradient);
        let mut stepped = gradient.clone();
        objective.precondition(&mut stepped);
        Self {
            value,
            gradient,
            stepped,
            direction: vec![0.0; x.len()],
            trial_x: x.to_vec(),
            trial_gradient: vec![0.0; x.len()],
            history: VecDeque::with_capacity(memory),
            memory,
            evaluations: 1,
        }
    }

    /// Sets the direction to −H g and returns the slope along it.
    fn turn(&mut self) -> f64 {
        let mut weights = Vec::with_capacity(self.history.len());
        // −g and −P g, from which α y and α P y are taken side by side: P is linear.
        let mut q: Vec<f64> = self.gradient.iter().map(|g| -g).collect();
        for (d, p) in self.direction.iter_mut().zip(&self.stepped) {
            *d = -p;
        }
        for pair in self.history.iter().rev() {
            let alpha = pair.rho * dot(&pair.s, &q);
            add_scaled(&mut q, -alpha, &pair.y);
            add_scaled(&mut self.direction, -alpha, &pair.py);
            weights.push(alpha);
        }
        if let Some(last) = self.history.back() {
            let gamma = 1.0 / (last.rho * dot(&last.y, &last.py));
            for d in &mut self.direction {
                *d *= gamma;
            }
        }
        for (pair, alpha) in self.history.iter().zip(weights.into_iter().rev()) {
            let beta = pair.rho * dot(&pair.y, &self.direction);
            add_scaled(&mut self.direction, alpha - beta, &pair.s);
        }
        dot(&self.gradient, &self.direction)
    }

    fn advance(
        &mut self,
        objective: &mut impl Objective,
        x: &mut [f64],
        slope: f64,
        go_on: &mut impl FnMut() -> bool,
    ) -> Advance {
        if slope.is_nan() || slope >= 0.0 {
            return Advance::Nothing;
        }
        let at_zero = Trial {
            step: 0.0,
            value: self.value,
            slope,
        };
        let found = search(at_zero, 1.0, |step| {
            for ((trial, from), d) in self.trial_x.iter_mut().zip(&*x).zip(&self.direction) {
                *trial = from + step * d;
            }
            let value = objective.evaluate(&self.trial_x, &mut self.trial_gradient);
            self.evaluations += 1;
            go_on().then(|| Trial {
                step,
                value,
                slope: dot(&self.trial_gradient, &self.direction),
            })
        });
        match found {
            Found::Nothing => Advance::Nothing,
            Found::Stopped => Advance::Stopped,
            Found::Step(trial) => {
                self.accept(objective, x, trial);
                Advance::Done
            }
        }
    }

    fn accept(&mut self, objective: &mut impl Objective, x: &mut [f64], trial: Trial) {
        let recycled = if self.history.len() >= self.memory.max(1) {
            self.history.pop_front()
        } else {
            None
        };
        let mut pair = recycled.unwrap_or_else(|| Pair {
            s: vec![0.0; x.len()],
            y: vec![0.0; x.len()],
            py: vec![0.0; x.len()],
            rho: 0.0,
        });
        subtract(&mut pair.s, &self.trial_x, x);
        subtract(&mut pair.y, &self.trial_gradient, &self.gradient);
        x.copy_from_slice(&self.trial_x);
        self.gradient.copy_from_slice(&self.trial_gradient);
        self.value = trial.value;
        let before = std::mem::replace(&mut self.stepped, std::mem::take(&mut pair.py));
        self.stepped.copy_from_slice(&self.gradient);
        objective.precondition(&mut self.stepped);
        pair.py = before;
        for (py, now) in pair.py.iter_mut().zip(&self.stepped) {
            *py = now - *py;
        }
        let sy = dot(&pair.s, &pair.y);
        let ypy = dot(&pair.y, &pair.py);
        if sy > 0.0 && ypy > 0.0 && (1.0 / sy).is_finite() && self.memory > 0 {
            pair.rho = 1.0 / sy;
            self.history.push_back(pair);
        }
    }
}

fn subtract(out: &mut [f64], a: &[f64], b: &[f64]) {
    for ((out, a), b) in out.iter_mut().zip(a).zip(b) {
        *out = a - b;
    }
}

#[cfg(test)]
mod tests;
