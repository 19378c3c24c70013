//! Known minima, laws of convergence, damage and stopping.

use super::*;

const PARAMS: LbfgsParams = LbfgsParams {
    memory: 10,
    tolerance: 1e-14,
    max_iterations: 2_000,
};

/// Rosenbrock's valley in many dimensions; least at (1, …, 1), where it is 0.
struct Valley;

impl Objective for Valley {
    fn evaluate(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        gradient.fill(0.0);
        let mut value = 0.0;
        for i in 0..x.len() - 1 {
            let (rise, run) = (x[i + 1] - x[i] * x[i], 1.0 - x[i]);
            value += 100.0 * rise * rise + run * run;
            gradient[i] -= 400.0 * rise * x[i] + 2.0 * run;
            gradient[i + 1] += 200.0 * rise;
        }
        value
    }
}

/// 1 + ½ Σ d_i x_i², preconditioned by the inverse of its own Hessian if asked.
struct Bowl {
    curvatures: Vec<f64>,
    preconditioned: bool,
}

impl Objective for Bowl {
    fn evaluate(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
        let mut value = 1.0;
        for ((g, x), d) in gradient.iter_mut().zip(x).zip(&self.curvatures) {
            *g = d * x;
            value += 0.5 * d * x * x;
        }
        value
    }

    fn precondition(&mut self, gradient: &mut [f64]) {
        if self.preconditioned {
            for (g, d) in gradient.iter_mut().zip(&self.curvatures) {
                *g /= d;
            }
        }
    }
}

fn bowl(preconditioned: bool) -> Bowl {
    Bowl {
        curvatures: (0..200)
            .map(|i| 10.0_f64.powf(f64::from(i) / 60.0))
            .collect(),
        preconditioned,
    }
}

#[test]
fn the_floor_of_a_curved_valley_is_found() {
    for dimensions in [2, 10, 101] {
        let mut x: Vec<f64> = (0..dimensions).map(|i| -1.2 + 0.01 * i as f64).collect();
        let found = lbfgs(&mut Valley, &mut x, &PARAMS, || true);
        // There is a second, local minimum near x₀ = −1 from 4 dimensions on.
        assert!(
            found.value < 1e-12 || (found.value - 3.98).abs() < 0.01,
            "{found:?}"
        );
        let mut gradient = vec![0.0; dimensions];
        Valley.evaluate(&x, &mut gradient);
        assert!(gradient.iter().all(|g| g.abs() < 1e-5), "{found:?}");
    }
}

#[test]
fn with_the_inverse_hessian_as_preconditioner_one_step_is_enough() {
    let mut x = vec![1.0; 200];
    let found = lbfgs(&mut bowl(true), &mut x, &PARAMS, || true);
    assert!(found.iterations <= 2, "{found:?}");
    assert!(x.iter().all(|x| x.abs() < 1e-12));
    let mut x = vec![1.0; 200];
    let plain = lbfgs(&mut bowl(false), &mut x, &PARAMS, || true);
    assert!(
        plain.iterations > 20 && (plain.value - 1.0).abs() < 1e-9,
        "{plain:?}"
    );
}

#[test]
fn at_the_minimum_nothing_is_done() {
    let mut x = vec![0.0; 200];
    let found = lbfgs(&mut bowl(false), &mut x, &PARAMS, || true);
    assert_eq!((found.iterations, found.ending), (0, Ending::Converged));
    let nothing = lbfgs(&mut bowl(false), &mut [], &PARAMS, || true);
    assert_eq!((nothing.iterations, nothing.ending), (0, Ending::Converged));
}

#[test]
fn a_stopped_search_keeps_the_best_point() {
    let mut x = vec![-1.2; 20];
    let mut gradient = vec![0.0; 20];
    let begun = Valley.evaluate(&x, &mut gradient);
    let mut asked = 0;
    let found = lbfgs(&mut Valley, &mut x, &PARAMS, || {
        asked += 1;
        asked < 12
    });
    assert_eq!(found.ending, Ending::Stopped);
    assert!(found.value < begun);
    assert_eq!(Valley.evaluate(&x, &mut gradient), found.value);
}

#[test]
fn values_never_rise() {
    struct Watched(Vec<f64>);
    impl Objective for Watched {
        fn evaluate(&mut self, x: &[f64], gradient: &mut [f64]) -> f64 {
            Valley.evaluate(x, gradient)
        }
        fn precondition(&mut self, gradient: &mut [f64]) {
            self.0.push(gradient.iter().map(|g| g * g).sum());
        }
    }
    let mut last = f64::INFINITY;
    for max_iterations in 0..60 {
        let mut x = vec![-1.2; 8];
        let params = LbfgsParams {
            max_iterations,
            ..PARAMS
        };
        let found = lbfgs(&mut Watched(Vec::new()), &mut x, &params, || true);
        assert!(found.value <= last, "{} > {last}", found.value);
        last = found.value;
    }
}

#[test]
fn a_function_that_is_nowhere_finite_ends_at_once() {
    struct Broken;
    impl Objective for Broken {
        fn evaluate(&mut self, _x: &[f64], gradient: &mut [f64]) -> f64 {
            gradient.fill(f64::NAN);
            f64::NAN
        }
    }
    let mut x = vec![1.0; 3];
    let found = lbfgs(&mut Broken, &mut x, &PARAMS, || true);
    assert_eq!(found.iterations, 0);
    assert_eq!(x, [1.0; 3]);
}
