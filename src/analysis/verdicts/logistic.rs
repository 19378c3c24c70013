//! A logistic classifier with a penalty on its weights, by Newton's method.

use crate::numeric::{factorise_positive, solve_lower, solve_positive};

/// Steps of Newton's method at most; a convex problem of this size takes about eight.
const MAX_STEPS: usize = 100;
/// Largest step of a coefficient after which it has converged: steps shrink by their square, so that the next
/// would be of the order of rounding.
const CONVERGED: f64 = 1e-7;
/// A step is halved at most so often; then rounding is all that is left.
const MAX_HALVINGS: usize = 40;

/// One case: its features and the probability that it should have (0 or 1, or in between), with its weight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Case<'a> {
    pub features: &'a [f64],
    pub target: f64,
    pub weight: f64,
}

/// 1 / (1 + e^(−s)).
pub(super) fn sigmoid(score: f64) -> f64 {
    sigmoid_and_softplus(score).0
}

/// 1 / (1 + e^(−s)) and ln(1 + e^s), without overflow.
fn sigmoid_and_softplus(score: f64) -> (f64, f64) {
    // Of a negative number, so that no score overflows.
    let e = (-score.abs()).exp();
    let upper = 1.0 / (1.0 + e);
    let sigmoid = if score >= 0.0 { upper } else { e * upper };
    (sigmoid, score.max(0.0) + e.ln_1p())
}

/// β₀ + β · x for coefficients [β₀, β₁ …].
pub(super) fn score(coefficients: &[f64], features: &[f64]) -> f64 {
    coefficients[0]
        + (coefficients[1..].iter().zip(features))
            .map(|(b, x)| b * x)
            .sum::<f64>()
}

/// Coefficients [β₀, β₁ …] that minimise −Σᵢ wᵢ (tᵢ ln pᵢ + (1 − tᵢ) ln(1 − pᵢ)) + λ/2 Σⱼ₌₁ βⱼ², where
/// pᵢ = 1 / (1 + exp(−β₀ − β · xᵢ)): logistic regression with a ridge penalty, β₀ free.
///
/// Newton's method from `start`, steps halved until the objective falls. Source: Hastie, Tibshirani and
/// Friedman, *The Elements of Statistical Learning*, 2nd ed., eqs. 4.20–4.26 and 4.31 with a squared penalty.
/// Needs cases with targets above and below one half, or targets in between, for β₀ to be finite.
pub(super) fn fit(cases: &[Case<'_>], ridge: f64, start: &[f64]) -> Vec<f64> {
    let size = start.len();
    let mut beta = start.to_vec();
    let mut tried = beta.clone();
    let mut step = vec![0.0; size];
    let mut hessian = vec![0.0; size * size];
    let mut probabilities = vec![0.0; cases.len()];
    let mut value = objective(cases, ridge, &beta, &mut probabilities);
    for _ in 0..MAX_STEPS {
        slopes(cases, ridge, &beta, &probabilities, &mut step, &mut hessian);
        factorise_positive(&mut hessian, size);
        solve_positive(&hessian, &mut step);
        // Far from the minimum a full Newton step may overshoot, and the loss must not rise.
        let mut share = 1.0;
        let fallen = (0..MAX_HALVINGS).find_map(|_| {
            for ((tried, beta), step) in tried.iter_mut().zip(&beta).zip(&step) {
                *tried = beta - share * step;
            }
            let now = objective(cases, ridge, &tried, &mut probabilities);
            if now <= value {
                return Some(now);
            }
            share *= 0.5;
            None
        });
        let Some(now) = fallen else { break };
        value = now;
        std::mem::swap(&mut beta, &mut tried);
        if step.iter().all(|step| share * step.abs() < CONVERGED) {
            break;
        }
    }
    beta
}

/// Largest leverage of a case in the formula of [`left_out_scores`]: at 1 the others would say nothing.
const MAX_LEVERAGE: f64 = 0.999;

/// Score of each case by a fit without it, one Newton step from the fit of all, `beta`:
/// sᵢ + hᵢ wᵢ (pᵢ − tᵢ) / (1 − hᵢ wᵢ pᵢ (1 − pᵢ)), with hᵢ = xᵢᵀ H⁻¹ xᵢ.
///
/// Exact to second order, at the price of one fit for all cases. Source: Pregibon (1981), Ann. Statist. 9(4), section 4;
/// Rad and Maleki (2020), J. R. Stat. Soc. B 82(4), eq. 8.
pub(super) fn left_out_scores(cases: &[Case<'_>], ridge: f64, beta: &[f64]) -> Vec<f64> {
    let size = beta.len();
    let mut probabilities = vec![0.0; cases.len()];
    objective(cases, ridge, beta, &mut probabilities);
    let (mut gradient, mut hessian) = (vec![0.0; size], vec![0.0; size * size]);
    slopes(
        cases,
        ridge,
        beta,
        &probabilities,
        &mut gradient,
        &mut hessian,
    );
    factorise_positive(&mut hessian, size);
    let mut entry = vec![1.0; size];
    (cases.iter().zip(probabilities))
        .map(|(case, p)| {
            entry[0] = 1.0;
            entry[1..].copy_from_slice(case.features);
            // H = L Lᵀ, so that h = |L⁻¹ x|².
            solve_lower(&hessian, &mut entry);
            let h: f64 = entry.iter().map(|x| x * x).sum();
            let leverage = (h * case.weight * p * (1.0 - p)).min(MAX_LEVERAGE);
            score(beta, case.features) + h * case.weight * (p - case.target) / (1.0 - leverage)
        })
        .collect()
}

/// Loss of scores without a penalty: −Σᵢ wᵢ (tᵢ ln pᵢ + (1 − tᵢ) ln(1 − pᵢ)).
pub(super) fn loss(cases: &[Case<'_>], scores: &[f64]) -> f64 {
    (cases.iter().zip(scores))
        .map(|(case, s)| case.weight * (sigmoid_and_softplus(*s).1 - case.target * s))
        .sum()
}

/// The objective; the probability of each case is laid into `probabilities`.
fn objective(cases: &[Case<'_>], ridge: f64, beta: &[f64], probabilities: &mut [f64]) -> f64 {
    let loss: f64 = (cases.iter().zip(probabilities))
        .map(|(case, probability)| {
            let s = score(beta, case.features);
            let (sigmoid, softplus) = sigmoid_and_softplus(s);
            *probability = sigmoid;
            case.weight * (softplus - case.target * s)
        })
        .sum();
    loss + 0.5 * ridge * beta[1..].iter().map(|b| b * b).sum::<f64>()
}

/// Gradient of the objective, and the lower triangle of its Hessian.
fn slopes(
    cases: &[Case<'_>],
    ridge: f64,
    beta: &[f64],
    probabilities: &[f64],
    gradient: &mut [f64],
    hessian: &mut [f64],
) {
    let size = beta.len();
    gradient.fill(0.0);
    hessian.fill(0.0);
    for (case, &p) in cases.iter().zip(probabilities) {
        let slope = case.weight * (p - case.target);
        // The second derivative, never negative: the loss is convex.
        let bend = case.weight * p * (1.0 - p);
        let entry = |i: usize| if i == 0 { 1.0 } else { case.features[i - 1] };
        for i in 0..size {
            gradient[i] += slope * entry(i);
            // The lower triangle: the factorisation reads no more.
            for j in 0..=i {
                hessian[i * size + j] += bend * entry(i) * entry(j);
            }
        }
    }
    // The intercept is free: penalised, it would pull probabilities towards one half.
    for j in 1..size {
        gradient[j] += ridge * beta[j];
        hessian[j * size + j] += ridge;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cases(rows: &[[f64; 2]], targets: &[f64]) -> Vec<(Vec<f64>, f64)> {
        rows.iter()
            .zip(targets)
            .map(|(row, &t)| (row.to_vec(), t))
            .collect()
    }

    fn fitted(cases: &[(Vec<f64>, f64)], ridge: f64) -> Vec<f64> {
        let cases: Vec<Case<'_>> = (cases.iter())
            .map(|(features, target)| Case {
                features,
                target: *target,
                weight: 1.0,
            })
            .collect();
        fit(&cases, ridge, &[0.0; 3])
    }

    #[test]
    fn without_features_the_intercept_is_the_log_odds() {
        let found = fitted(&cases(&[[0.0; 2]; 4], &[1.0, 0.0, 0.0, 0.0]), 1.0);
        assert!((found[0] - (1.0_f64 / 3.0).ln()).abs() < 1e-9);
        assert_eq!(found[1..], [0.0, 0.0]);
    }

    #[test]
    fn separable_cases_have_a_finite_solution_that_grows_as_the_penalty_falls() {
        let all = cases(
            &[[-1.0, 0.0], [-2.0, 0.0], [1.0, 0.0], [2.0, 0.0]],
            &[0.0, 0.0, 1.0, 1.0],
        );
        let weights: Vec<f64> = [10.0, 1.0, 0.1]
            .map(|ridge| fitted(&all, ridge)[1])
            .to_vec();
        assert!(weights[0] > 0.0 && weights[0] < weights[1] && weights[1] < weights[2]);
        // The slope of the objective vanishes: β = Σ |x| (1 − p) / λ, x = ±1, ±2.
        let b = weights[1];
        let expected = 2.0 * (1.0 - sigmoid(b)) + 4.0 * (1.0 - sigmoid(2.0 * b));
        assert!((b - expected).abs() < 1e-8, "{b} {expected}");
    }

    #[test]
    fn scores_left_out_by_a_formula_are_those_of_a_fit_without_the_case() {
        let rows: Vec<[f64; 2]> = (0..40)
            .map(|i| [(f64::from(i) * 0.7).sin(), (f64::from(i) * 1.3).cos()])
            .collect();
        let targets: Vec<f64> = (0..40)
            .map(|i| f64::from(u8::from((7 * i) % 11 < 5)))
            .collect();
        let all = cases(&rows, &targets);
        let as_cases = |all: &[(Vec<f64>, f64)], out: usize| -> Vec<f64> {
            let kept: Vec<_> = (all.iter().enumerate())
                .filter(|(i, _)| *i != out)
                .map(|(_, case)| case.clone())
                .collect();
            fitted(&kept, 1.0)
        };
        let whole: Vec<Case<'_>> = (all.iter())
            .map(|(features, target)| Case {
                features,
                target: *target,
                weight: 1.0,
            })
            .collect();
        let approximate = left_out_scores(&whole, 1.0, &fitted(&all, 1.0));
        let own = fitted(&all, 1.0);
        for (i, approximate) in approximate.into_iter().enumerate() {
            let exact = score(&as_cases(&all, i), &all[i].0);
            let moved = (score(&own, &all[i].0) - exact).abs();
            assert!(
                (approximate - exact).abs() < 0.1 * moved + 1e-3,
                "{approximate} {exact}"
            );
        }
    }

    proptest! {
        #[test]
        fn no_direction_lowers_the_objective(
            rows in prop::collection::vec(prop::array::uniform2(-3.0_f64..3.0), 12),
            ridge in 0.01_f64..10.0,
        ) {
            let targets: Vec<f64> = (0..12).map(|i| f64::from(i % 2)).collect();
            let all = cases(&rows, &targets);
            let found = fitted(&all, ridge);
            let cases: Vec<Case<'_>> = (all.iter())
                .map(|(features, target)| Case { features, target: *target, weight: 1.0 })
                .collect();
            let mut room = [0.0; 12];
            let best = objective(&cases, ridge, &found, &mut room);
            for j in 0..3 {
                for way in [-1e-3, 1e-3] {
                    let mut moved = found.clone();
                    moved[j] += way;
                    prop_assert!(objective(&cases, ridge, &moved, &mut room) >= best);
                }
            }
        }
    }
}
