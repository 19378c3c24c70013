//! The search for the path of least energy on one mesh, at one number of interpolated poses or from few to many.
//!
//! Which of the two is decided in `solver.rs::search`: at once with all poses, and only for metrics with many minima, in
//! addition, from few poses on.

use crate::analysis::metrics::{MetricError, PathEnergy};
use crate::numeric::{Ending, LbfgsParams, Objective, lbfgs};

use super::stiffness::Stiffness;

/// Steps that the search remembers; each costs two vectors as long as the path.
const MEMORY: usize = 10;
/// What may be remembered at most, in bytes.
const MAX_BYTES: usize = 96 << 20;

/// Poses between two ends, flat: x, y, z of every vertex, pose after pose.
#[derive(Clone, Debug)]
pub(super) struct Inner {
    pub coordinates: Vec<f64>,
    pub iterations: usize,
    pub converged: bool,
    pub stopped: bool,
}

/// When the search ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Content {
    pub tolerance: f64,
    pub max_iterations: usize,
}

struct Path<'a> {
    energy: &'a mut PathEnergy,
    stiffness: Option<&'a Stiffness>,
}

impl Objective for Path<'_> {
    fn evaluate(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        self.energy.evaluate(x, gradient)
    }

    fn precondition(&mut self, gradient: &mut [f64]) {
        if let Some(stiffness) = self.stiffness {
            stiffness.solve(gradient);
        }
    }
}

/// Improves a path in place.
pub(super) fn improve(
    energy: &mut PathEnergy,
    stiffness: Option<&Stiffness>,
    inner: &mut Inner,
    content: &Content,
    go_on: impl FnMut() -> bool,
) {
    // s, y and P y for each remembered step; fewer steps for longer paths keep memory bounded.
    let bytes = 3 * size_of::<f64>() * inner.coordinates.len();
    let params = LbfgsParams {
        memory: (MAX_BYTES / bytes.max(1)).clamp(2, MEMORY),
        tolerance: content.tolerance,
        max_iterations: content.max_iterations,
    };
    let mut path = Path { energy, stiffness };
    let found = lbfgs(&mut path, &mut inner.coordinates, &params, go_on);
    inner.iterations += found.iterations;
    // Where no step lowers the energy by more than rounding, there is nothing left to gain either.
    inner.converged = matches!(found.ending, Ending::Converged | Ending::Exhausted);
    inner.stopped = found.ending == Ending::Stopped;
}

/// Interpolated poses of each level: 1, 3, 7, … and last what is asked for.
///
/// Bisecting does not pay where the preconditioner inverts the coupling in time: many poses then take
/// about as many iterations as few, and the levels before are lost time.
/// It pays where there are many minima, which are then found from few poses on.
pub(super) fn time_levels(interpolated_poses: usize) -> Vec<usize> {
    let mut levels = Vec::new();
    let mut next = 1;
    while next < interpolated_poses {
        levels.push(next);
        // Each interval is halved, so that poses that are there already stay where they are.
        next = 2 * next + 1;
    }
    levels.push(interpolated_poses);
    levels
}

/// The same way with another number of interpolated poses, evenly spread along its parameter.
pub(super) fn resampled(
    start: &[f64],
    inner: &[f64],
    end: &[f64],
    interpolated_poses: usize,
) -> Vec<f64> {
    let size = start.len();
    let old_steps = inner.len().checked_div(size).unwrap_or_default() + 1;
    let pose = |k: usize| {
        if k == 0 {
            start
        } else if k >= old_steps {
            end
        } else {
            &inner[(k - 1) * size..k * size]
        }
    };
    let mut out = Vec::with_capacity(size * interpolated_poses);
    for k in 1..=interpolated_poses {
        // Equal steps of time; poses in between lie on the straight line of their neighbours.
        let at = k as f64 * old_steps as f64 / (interpolated_poses + 1) as f64;
        let from = at.floor();
        let t = at - from;
        let (a, b) = (pose(from as usize), pose(from as usize + 1));
        out.extend(a.iter().zip(b).map(|(a, b)| a + t * (b - a)));
    }
    out
}

/// Finds a path of least energy, from the straight line: at each of the `levels`, which are numbers of interpolated poses,
/// it improves what the level before left. One level is a search with all poses at once.
pub(super) fn cheapest(
    energy_of: impl Fn(usize) -> Result<PathEnergy, MetricError>,
    stiffness: Option<&Stiffness>,
    ends: [&[f64]; 2],
    levels: &[usize],
    content: &Content,
    mut go_on: impl FnMut() -> bool,
) -> Result<Inner, MetricError> {
    let mut inner = Inner {
        coordinates: Vec::new(),
        iterations: 0,
        converged: false,
        stopped: false,
    };
    for (level, &count) in levels.iter().enumerate() {
        inner.coordinates = resampled(ends[0], &inner.coordinates, ends[1], count);
        // The remaining levels only bring what there is to the number of poses asked for.
        if inner.stopped {
            continue;
        }
        let last = level + 1 == levels.len();
        let content = Content {
            // Levels before the last only provide a start.
            tolerance: if last {
                content.tolerance
            } else {
                content.tolerance.max(COARSE_TOLERANCE)
            },
            ..*content
        };
        improve(
            &mut energy_of(count)?,
            stiffness,
            &mut inner,
            &content,
            &mut go_on,
        );
    }
    Ok(inner)
}

/// A level that only prepares the next need not be better than that.
const COARSE_TOLERANCE: f64 = 1e-4;
