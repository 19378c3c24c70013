//! The class whose mean is nearest as the spread within classes measures it, each case left out in turn.

use crate::numeric::{factorise_positive, solve_lower};

/// Cases as rows of coordinates, all of about the size 1.
pub(super) struct LinearClassifier {
    width: usize,
    points: Vec<f64>,
    shrinkage: f64,
}

/// Memory of the classifier, kept from one set of labels to the next.
#[derive(Default)]
pub(super) struct Scratch {
    means: Vec<f64>,
    members: Vec<usize>,
    scatter: Vec<f64>,
    factor: Vec<f64>,
    step: Vec<f64>,
}

impl LinearClassifier {
    /// Of `points`, rows of `width` numbers one after the other; the unit of length does not matter.
    pub(super) fn new(points: &[f64], width: usize, shrinkage: f64) -> Self {
        // The classes do not depend on the unit, but squares of very large or small numbers would.
        let largest = points.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let unit = if largest > 0.0 { largest } else { 1.0 };
        Self {
            width,
            points: points.iter().map(|x| x / unit).collect(),
            shrinkage,
        }
    }

    fn row(&self, case: usize) -> &[f64] {
        &self.points[case * self.width..][..self.width]
    }

    /// Cases classified correctly by the classifier trained without them.
    ///
    /// The scatter S and the mean of the case's own class, of m cases, without it are exact:
    /// S − m/(m−1) d dᵀ and m̄ − d/(m−1), d = x − m̄. So nothing is summed anew for each case.
    pub(super) fn correct(&self, classes: &[usize], scratch: &mut Scratch) -> usize {
        let right = self.right_cases(classes, 1, scratch);
        right.iter().filter(|right| **right).count()
    }

    /// Of every so many cases whether it is classified correctly, each left out in turn.
    pub(super) fn right_cases(
        &self,
        classes: &[usize],
        step: usize,
        scratch: &mut Scratch,
    ) -> Vec<bool> {
        self.gather(classes, scratch);
        (0..classes.len())
            .step_by(step)
            .map(|case| self.right(case, classes[case], scratch))
            .collect()
    }

    /// Means of classes, and the scatter of all cases around those of their own.
    fn gather(&self, classes: &[usize], scratch: &mut Scratch) {
        let width = self.width;
        let count = classes.iter().max().map_or(0, |most| most + 1);
        let Scratch {
            means,
            members,
            scatter,
            step,
            ..
        } = scratch;
        means.clear();
        means.resize(count * width, 0.0);
        members.clear();
        members.resize(count, 0);
        for (case, &class) in classes.iter().enumerate() {
            members[class] += 1;
            let mean = &mut means[class * width..][..width];
            mean.iter_mut()
                .zip(self.row(case))
                .for_each(|(m, x)| *m += x);
        }
        for (class, &members) in members.iter().enumerate() {
            let mean = &mut means[class * width..][..width];
            mean.iter_mut().for_each(|x| *x /= members.max(1) as f64);
        }
        scatter.clear();
        scatter.resize(width * width, 0.0);
        for (case, &class) in classes.iter().enumerate() {
            step.clear();
            step.extend(
                self.row(case)
                    .iter()
                    .zip(&means[class * width..])
                    .map(|(x, m)| x - m),
            );
            add_outer(scatter, step, 1.0);
        }
    }

    fn right(&self, case: usize, own: usize, scratch: &mut Scratch) -> bool {
        let width = self.width;
        let Scratch {
            means,
            members,
            scatter,
            factor,
            step,
        } = scratch;
        if members[own] < 2 {
            // Its class is gone with it.
            return false;
        }
        let (here, others) = (self.row(case), (members[own] - 1) as f64);
        step.clear();
        step.extend(here.iter().zip(&means[own * width..]).map(|(x, m)| x - m));
        // The scatter of all is known; leaving one case out is a change of rank one, not another pass.
        factor.clone_from(scatter);
        add_outer(factor, step, -(others + 1.0) / others);
        shrink(factor, width, self.shrinkage);
        // Positive definite by the shrinkage, but for round-off.
        factorise_positive(factor, width);
        // x − (m̄ − d/(m−1)) = d m/(m−1)
        step.iter_mut().for_each(|d| *d *= (others + 1.0) / others);
        let distance = solved_norm2(factor, step);
        (0..members.len())
            // A class whose last member was permuted away has no mean.
            .filter(|&class| class != own && members[class] > 0)
            .all(|class| {
                let mean = &means[class * width..][..width];
                step.clear();
                step.extend(here.iter().zip(mean).map(|(x, m)| x - m));
                // Strictly: a case between two classes belongs to neither.
                distance < solved_norm2(factor, step)
            })
    }
}

/// Adds `factor` · d dᵀ to the lower triangle.
fn add_outer(matrix: &mut [f64], d: &[f64], factor: f64) {
    for (i, x) in d.iter().enumerate() {
        let row = &mut matrix[i * d.len()..][..=i];
        row.iter_mut()
            .zip(d)
            .for_each(|(entry, y)| *entry += factor * x * y);
    }
}

/// (1 − γ) S + γ (tr S / p) 1; the unit matrix where the trace is nothing.
fn shrink(matrix: &mut [f64], width: usize, shrinkage: f64) {
    let trace: f64 = (0..width).map(|i| matrix[i * width + i]).sum();
    // Cases lie within 1 of the origin: less than this is round-off of their coordinates.
    let some = trace > 1e-24;
    let keep = if some { 1.0 - shrinkage } else { 0.0 };
    // In the mean of the diagonal, so that shrinking has no unit and changes no total scatter.
    let floor = if some {
        shrinkage * trace / width as f64
    } else {
        1.0
    };
    matrix.iter_mut().for_each(|entry| *entry *= keep);
    for i in 0..width {
        matrix[i * width + i] += floor;
    }
}

/// dᵀ (L Lᵀ)⁻¹ d; overwrites d.
fn solved_norm2(factor: &[f64], d: &mut [f64]) -> f64 {
    solve_lower(factor, d);
    d.iter().map(|x| x * x).sum()
}

/// Cases classified correctly by a linear classifier trained on all others with a label, and cases with a label.
///
/// `points` are rows of `width` numbers. It predicts the class with the least
/// (x − m̄)ᵀ Σ⁻¹ (x − m̄): linear discriminant analysis with classes that are equally likely beforehand, whatever
/// their number of cases. Σ = (1 − γ) S + γ (tr S / p) 1 with the pooled scatter S within classes and
/// the `shrinkage` γ, which makes it regular where there are few cases. A draw is a wrong answer, and
/// so is a class of one case, which is gone when that is left out.
///
/// Source: Hastie, Tibshirani and Friedman, *The Elements of Statistical Learning*, 2nd ed., sections 4.3 and
/// 4.3.1, eq. 4.14.
pub fn leave_one_out_linear(
    points: &[f64],
    width: usize,
    labels: &[Option<usize>],
    shrinkage: f64,
) -> (usize, usize) {
    let (cases, classes) = labelled_rows(points, width, labels);
    let classifier = LinearClassifier::new(&cases, width, shrinkage);
    (
        classifier.correct(&classes, &mut Scratch::default()),
        classes.len(),
    )
}

/// Rows that have a label, and these labels.
pub(super) fn labelled_rows(
    points: &[f64],
    width: usize,
    labels: &[Option<usize>],
) -> (Vec<f64>, Vec<usize>) {
    let mut cases = Vec::new();
    for (row, label) in labels.iter().enumerate() {
        // Without a label a case can neither train nor test.
        if label.is_some() {
            cases.extend_from_slice(&points[row * width..][..width]);
        }
    }
    (cases, labels.iter().copied().flatten().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn labels(classes: &[usize]) -> Vec<Option<usize>> {
        classes.iter().copied().map(Some).collect()
    }

    #[test]
    fn spread_along_one_axis_does_not_hide_a_difference_across_it() {
        let points: Vec<f64> = (0..12)
            .flat_map(|i| {
                [
                    f64::from(i % 6) * 10.0,
                    f64::from(i / 6) + 0.01 * f64::from(i % 2),
                ]
            })
            .collect();
        let classes: Vec<usize> = (0..12).map(|i| i / 6).collect();
        assert_eq!(
            leave_one_out_linear(&points, 2, &labels(&classes), 1e-3),
            (12, 12)
        );
        // With nothing but the shrinkage the far axis decides.
        let plain = leave_one_out_linear(&points, 2, &labels(&classes), 1.0);
        assert!(plain.0 < 12);
    }

    #[test]
    fn cases_that_coincide_are_all_wrong_and_a_lone_class_too() {
        let same = leave_one_out_linear(&[1.0; 8], 2, &labels(&[0, 0, 1, 1]), 0.1);
        assert_eq!(same, (0, 4));
        let lone = leave_one_out_linear(&[0.0, 0.1, 5.0], 1, &labels(&[0, 0, 1]), 0.1);
        assert_eq!(lone, (2, 3));
        assert_eq!(leave_one_out_linear(&[], 2, &[], 0.1), (0, 0));
        let unlabelled = leave_one_out_linear(&[0.0, 9.0, 0.2], 1, &[Some(0), None, Some(0)], 0.1);
        assert_eq!(unlabelled, (2, 2));
    }

    /// The classifier as it is defined, trained anew without each case, with a general solver.
    fn by_definition(points: &[f64], width: usize, classes: &[usize], shrinkage: f64) -> usize {
        use nalgebra::{DMatrix, DVector};
        let x = |i: usize| DVector::from_column_slice(&points[i * width..][..width]);
        (0..classes.len())
            .filter(|&out| {
                let rest =
                    |class| (0..classes.len()).filter(move |&i| i != out && classes[i] == class);
                let mean = |class| {
                    let sum = rest(class).fold(DVector::zeros(width), |sum, i| sum + x(i));
                    sum / rest(class).count() as f64
                };
                let mut s = DMatrix::zeros(width, width);
                for class in 0..3 {
                    for i in rest(class) {
                        let d = x(i) - mean(class);
                        s += &d * d.transpose();
                    }
                }
                let floor = shrinkage * s.trace() / width as f64;
                let sigma = s * (1.0 - shrinkage) + DMatrix::identity(width, width) * floor;
                let inverse = sigma.try_inverse().unwrap();
                let far = |class| {
                    let d = x(out) - mean(class);
                    (d.transpose() * &inverse * d)[(0, 0)]
                };
                let own = far(classes[out]);
                (0..3)
                    .filter(|&c| c != classes[out] && rest(c).count() > 0)
                    .all(|c| own < far(c))
            })
            .count()
    }

    proptest! {
        #[test]
        fn leaving_out_by_a_formula_is_leaving_out(
            points in prop::collection::vec(-1.0_f64..1.0, 48),
            shift in 0.0_f64..2.0,
        ) {
            let classes: Vec<usize> = (0..16).map(|i| i * i % 3 + usize::from(i % 5 == 0)).collect();
            prop_assume!((0..3).all(|c| classes.iter().filter(|&&k| k == c).count() > 1));
            let mut points = points;
            for (point, &class) in points.chunks_mut(3).zip(&classes) {
                point[1] += shift * class as f64;
            }
            let found = leave_one_out_linear(&points, 3, &labels(&classes), 0.1);
            prop_assert_eq!(found.0, by_definition(&points, 3, &classes, 0.1));
        }

        #[test]
        fn order_unit_and_origin_of_cases_change_nothing(
            points in prop::collection::vec(-1.0_f64..1.0, 40),
            turn in 1_usize..19,
            size in 0.01_f64..100.0,
        ) {
            let classes: Vec<usize> = (0..20).map(|i| i % 2).collect();
            let moved: Vec<f64> = (0..20)
                .flat_map(|i| points[2 * ((i + turn) % 20)..][..2].to_vec())
                .map(|x| size * x)
                .collect();
            let turned: Vec<usize> = (0..20).map(|i| classes[(i + turn) % 20]).collect();
            prop_assert_eq!(
                leave_one_out_linear(&points, 2, &labels(&classes), 0.1),
                leave_one_out_linear(&moved, 2, &labels(&turned), 0.1)
            );
        }
    }
}
