//! The linear classifier on as many coordinates as do best, chosen without the case that is classified.

use super::linear_classifier::{LinearClassifier, Scratch};

/// Numbers of coordinates that are tried: multiples of this.
const STEP: usize = 5;
/// Parts of the cases; the number of coordinates for the cases of one is chosen by those of the others.
const FOLDS: usize = 5;
/// Cases of a choice that are left out in turn, at most: more would tell the same at a higher price.
const MAX_TESTED: usize = 200;

/// Leave-one-out with a choice inside. The number of coordinates for the cases of each fifth is the one by which most of
/// the other four fifths are right, each left out in turn; of equals the smallest. With it each case of the fifth is then
/// classified by the classifier trained on all others. So the label of a case has no say in how it is classified.
pub(super) struct NestedClassifier {
    /// One for each number of coordinates.
    whole: Vec<LinearClassifier>,
    folds: Vec<Fold>,
}

struct Fold {
    /// Cases that are left out and classified.
    left_out: Vec<usize>,
    /// Cases that choose.
    others: Vec<usize>,
    /// Of those that choose, one for each number of coordinates.
    choosers: Vec<LinearClassifier>,
}

impl NestedClassifier {
    /// Of `points`, rows of `width` numbers one after the other, the leading ones first.
    pub(super) fn new(points: &[f64], width: usize, shrinkage: f64) -> Self {
        let cases = points.len() / width.max(1);
        let widths: Vec<usize> = match width < STEP {
            true => vec![width],
            false => (STEP..=width).step_by(STEP).collect(),
        };
        let of = |cases: &[usize]| -> Vec<LinearClassifier> {
            let leading = |count: usize| -> Vec<f64> {
                (cases.iter())
                    .flat_map(|case| points[case * width..][..count].iter().copied())
                    .collect()
            };
            (widths.iter())
                .map(|&count| LinearClassifier::new(&leading(count), count, shrinkage))
                .collect()
        };
        let all: Vec<usize> = (0..cases).collect();
        Self {
            whole: of(&all),
            folds: if widths.len() < 2 {
                Vec::new()
            } else {
                (folds(points, width).into_iter())
                    .map(|(left_out, others)| Fold {
                        choosers: of(&others),
                        left_out,
                        others,
                    })
                    .collect()
            },
        }
    }

    /// Cases classified correctly by the classifier trained without them.
    pub(super) fn correct(&self, classes: &[usize], scratch: &mut Scratch) -> usize {
        let Some((only, [])) = self.whole.split_first() else {
            let right: Vec<Vec<bool>> = (self.whole.iter())
                .map(|classifier| classifier.right_cases(classes, 1, scratch))
                .collect();
            return (self.folds.iter())
                .map(|fold| {
                    let best = &right[fold.choice(classes, scratch)];
                    fold.left_out.iter().filter(|case| best[**case]).count()
                })
                .sum();
        };
        only.correct(classes, scratch)
    }
}

impl Fold {
    /// Which number of coordinates does best without the cases that are left out.
    fn choice(&self, classes: &[usize], scratch: &mut Scratch) -> usize {
        let own: Vec<usize> = self.others.iter().map(|case| classes[*case]).collect();
        let step = own.len().div_ceil(MAX_TESTED).max(1);
        let mut best = (0, 0);
        for (index, classifier) in self.choosers.iter().enumerate() {
            let right = classifier.right_cases(&own, step, scratch);
            let correct = right.iter().filter(|right| **right).count();
            // Strictly more: what does as well with fewer coordinates is less likely to be chance.
            if index == 0 || correct > best.1 {
                best = (index, correct);
            }
        }
        best.0
    }
}

/// Cases in folds, each with all others: every fifth along the first coordinate, so that the order of the study does not
/// matter and each fold holds cases of all kinds.
fn folds(points: &[f64], width: usize) -> Vec<(Vec<usize>, Vec<usize>)> {
    let mut along: Vec<usize> = (0..points.len() / width).collect();
    along.sort_by(|a, b| points[a * width].total_cmp(&points[b * width]));
    (0..FOLDS.min(along.len()))
        .map(|fold| {
            let (left_out, others): (Vec<_>, Vec<_>) = along
                .iter()
                .enumerate()
                .partition(|(rank, _)| rank % FOLDS == fold);
            let cases =
                |ranked: Vec<(usize, &usize)>| ranked.into_iter().map(|(_, case)| *case).collect();
            (cases(left_out), cases(others))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two classes that only the sixth to tenth coordinate tells apart, behind larger ones that tell nothing.
    fn told_late(cases: usize) -> (Vec<f64>, Vec<usize>) {
        let classes: Vec<usize> = (0..cases).map(|case| case % 2).collect();
        let points = (0..cases).flat_map(|case| {
            (0..10).map(move |axis| {
                // Irrational steps spread evenly and repeat nowhere.
                let noise = (((case * 13 + 1) as f64) * (axis as f64 + 2.0).sqrt()).fract() - 0.5;
                match axis {
                    0..5 => 2.0 * noise,
                    _ => noise + if case % 2 == 0 { 0.4 } else { -0.4 },
                }
            })
        });
        (points.collect(), classes)
    }

    #[test]
    fn as_many_coordinates_are_taken_as_tell_the_classes_apart() {
        let (points, classes) = told_late(60);
        let few: Vec<f64> = points
            .chunks(10)
            .flat_map(|row| row[..5].to_vec())
            .collect();
        let scratch = &mut Scratch::default();
        let by_few = LinearClassifier::new(&few, 5, 0.1).correct(&classes, scratch);
        let nested = NestedClassifier::new(&points, 10, 0.1).correct(&classes, scratch);
        let by_all = LinearClassifier::new(&points, 10, 0.1).correct(&classes, scratch);
        assert!(by_few < 45, "{by_few}");
        assert_eq!(nested, by_all);
        assert!(nested > 55, "{nested}");
    }

    #[test]
    fn every_case_is_told_once_and_has_no_say_in_the_choice() {
        let (points, _) = told_late(23);
        let folds = folds(&points, 10);
        let mut left_out: Vec<usize> = folds
            .iter()
            .flat_map(|(left_out, _)| left_out.clone())
            .collect();
        left_out.sort_unstable();
        assert_eq!(left_out, (0..23).collect::<Vec<_>>());
        for (left_out, others) in folds {
            assert!(left_out.iter().all(|case| !others.contains(case)));
            assert_eq!(left_out.len() + others.len(), 23);
        }
    }

    #[test]
    fn few_coordinates_leave_no_choice() {
        let (points, classes) = told_late(12);
        let three: Vec<f64> = points
            .chunks(10)
            .flat_map(|row| row[5..8].to_vec())
            .collect();
        let scratch = &mut Scratch::default();
        let fixed = LinearClassifier::new(&three, 3, 0.1).correct(&classes, scratch);
        assert_eq!(
            NestedClassifier::new(&three, 3, 0.1).correct(&classes, scratch),
            fixed
        );
        assert_eq!(NestedClassifier::new(&[], 0, 0.1).correct(&[], scratch), 0);
    }
}
