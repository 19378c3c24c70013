//! A step along a direction that falls enough and flattens enough: the strong Wolfe conditions.

/// Share of the fall that the slope promises which must be had; as in Nocedal and Wright.
const SUFFICIENT_FALL: f64 = 1e-4;
/// Share of the slope that may remain; loose, as quasi-Newton directions are nearly of full length.
const REMAINING_SLOPE: f64 = 0.9;
/// Halving so often leaves steps of 1e-6 of the first.
const MAX_TRIALS: usize = 30;

/// Value and slope along the direction at a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Trial {
    pub step: f64,
    pub value: f64,
    pub slope: f64,
}

impl Trial {
    fn usable(&self) -> bool {
        self.value.is_finite() && self.slope.is_finite()
    }
}

/// How a search ended. The last point evaluated is the one named.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Found {
    /// A step that meets both conditions, or at least the first.
    Step(Trial),
    /// No step falls.
    Nothing,
    /// Was told to stop.
    Stopped,
}

/// Searches from step 0, where value and negative slope are given, beginning with `first`.
///
/// `evaluate` returns `None` to stop. A value that is not finite counts as too far.
///
/// Source: Nocedal and Wright (2006), *Numerical Optimization*, algorithms 3.5 and 3.6, with the
/// minimiser of the cubic (eq. 3.59) kept inside the middle 80 % of the bracket.
pub(super) fn search(
    at_zero: Trial,
    first: f64,
    mut evaluate: impl FnMut(f64) -> Option<Trial>,
) -> Found {
    let mut low = at_zero;
    let mut high: Option<Trial> = None;
    let mut step = first;
    for _ in 0..MAX_TRIALS {
        let Some(trial) = evaluate(step) else {
            return Found::Stopped;
        };
        let enough = at_zero.value + SUFFICIENT_FALL * step * at_zero.slope;
        if !trial.usable() || trial.value > enough || (low.step > 0.0 && trial.value >= low.value) {
            high = Some(trial);
        } else if trial.slope.abs() <= -REMAINING_SLOPE * at_zero.slope {
            return Found::Step(trial);
        } else {
            // It falls enough but is still steep: the minimum lies on the side it falls to.
            let towards = high.map_or(f64::INFINITY, |high| high.step);
            if trial.slope * (towards - trial.step) >= 0.0 {
                high = Some(low);
            }
            low = trial;
        }
        step = match high {
            Some(high) => between(low, high),
            None => 4.0 * step,
        };
        if !step.is_finite() || (step - low.step).abs() <= 1e-14 * step.abs() {
            break;
        }
    }
    if low.step > 0.0 {
        // Falls enough, though not as flat as wished; it has to be the last point evaluated.
        return match evaluate(low.step) {
            Some(trial) => Found::Step(trial),
            None => Found::Stopped,
        };
    }
    Found::Nothing
}

/// Minimiser of the cubic through both ends, or the middle where there is none.
fn between(low: Trial, high: Trial) -> f64 {
    let width = high.step - low.step;
    let middle = low.step + 0.5 * width;
    if !high.usable() {
        return low.step + 0.25 * width;
    }
    let d1 = low.slope + high.slope - 3.0 * (low.value - high.value) / (low.step - high.step);
    let d2 = (d1 * d1 - low.slope * high.slope).sqrt() * width.signum();
    let cubic = high.step - width * (high.slope + d2 - d1) / (high.slope - low.slope + 2.0 * d2);
    if !cubic.is_finite() {
        return middle;
    }
    let (from, to) = (low.step + 0.1 * width, high.step - 0.1 * width);
    cubic.clamp(from.min(to), from.max(to))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(value: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64, first: f64) -> (Found, usize) {
        let mut evaluations = 0;
        let at = |step: f64| Trial {
            step,
            value: value(step),
            slope: slope(step),
        };
        let found = search(at(0.0), first, |step| {
            evaluations += 1;
            Some(at(step))
        });
        (found, evaluations)
    }

    #[test]
    fn steps_far_too_long_and_too_short_are_mended() {
        for first in [1e-3, 1.0, 1e3] {
            let (found, evaluations) =
                found(|x| (x - 2.0).powi(4), |x| 4.0 * (x - 2.0).powi(3), first);
            let Found::Step(trial) = found else {
                panic!("{found:?}");
            };
            assert!(trial.value < 16.0 && trial.slope.abs() <= 0.9 * 32.0);
            assert!(evaluations < 20, "{evaluations}");
        }
    }

    #[test]
    fn a_wall_of_nan_is_backed_off_from() {
        let value = |x: f64| if x > 0.1 { f64::NAN } else { -x };
        let (found, _) = found(value, |_| -1.0, 1.0);
        assert!(matches!(found, Found::Step(trial) if trial.step <= 0.1 && trial.value < 0.0));
    }

    #[test]
    fn nothing_is_found_where_nothing_falls() {
        let (found, _) = found(|x| x, |_| -1.0, 1.0);
        assert_eq!(found, Found::Nothing);
    }
}
