//! The classifier of a cohort: logistic, calibrated, each labelled subject left out in turn.

use crate::progress::{Progress, Stopped};

use super::logistic::{Case, fit, score, sigmoid};

/// Penalty on the slope of the calibration: a trace, so that scores without information have a finite one.
const CALIBRATION_RIDGE: f64 = 1e-6;

/// Standardised features and a logistic classifier on them.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Classifier {
    pub standard: Standard,
    coefficients: Vec<f64>,
}

/// What features are measured from and by.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Standard {
    means: Vec<f64>,
    deviations: Vec<f64>,
}

impl Standard {
    /// Mean and standard deviation of each column; 1 for a column that does not vary.
    pub fn new(rows: &[&[f64]]) -> Self {
        let width = rows.first().map_or(0, |row| row.len());
        let count = rows.len().max(1) as f64;
        let mean = |f: &dyn Fn(&[f64]) -> f64| rows.iter().map(|row| f(row)).sum::<f64>() / count;
        let means: Vec<f64> = (0..width).map(|j| mean(&|row| row[j])).collect();
        let deviations = (0..width)
            .map(|j| mean(&|row| (row[j] - means[j]).powi(2)).sqrt())
            .zip(&means)
            // Less is round-off of equal numbers.
            .map(|(deviation, mean)| {
                if deviation > 1e-12 * mean.abs() {
                    deviation
                } else {
                    1.0
                }
            })
            .collect();
        Self { means, deviations }
    }

    pub fn of(&self, row: &[f64]) -> Vec<f64> {
        (row.iter().zip(&self.means).zip(&self.deviations))
            .map(|((x, mean), deviation)| (x - mean) / deviation)
            .collect()
    }
}

/// Weights that make both classes count alike, n / (2 n of the class).
fn balanced(abnormal: &[bool]) -> [f64; 2] {
    let ups = abnormal.iter().filter(|&&up| up).count();
    let half = 0.5 * abnormal.len() as f64;
    [
        half / (abnormal.len() - ups).max(1) as f64,
        half / ups.max(1) as f64,
    ]
}

impl Classifier {
    /// Of labelled subjects; Newton's method starts from `start` if there is one.
    pub fn new(rows: &[&[f64]], abnormal: &[bool], ridge: f64, start: Option<&Self>) -> Self {
        // Of the training rows alone, or the case left out would take part in its own scale.
        let standard = Standard::new(rows);
        let standardised: Vec<Vec<f64>> = rows.iter().map(|row| standard.of(row)).collect();
        // Otherwise the more frequent class would be the safer answer, whatever the features say.
        let weights = balanced(abnormal);
        let cases: Vec<Case<'_>> = (standardised.iter().zip(abnormal))
            .map(|(features, &up)| Case {
                features,
                target: f64::from(u8::from(up)),
                weight: weights[usize::from(up)],
            })
            .collect();
        let zeros = vec![0.0; standard.means.len() + 1];
        let start = start.map_or(zeros.as_slice(), |classifier| {
            classifier.coefficients.as_slice()
        });
        Self {
            coefficients: fit(&cases, ridge, start),
            standard,
        }
    }

    /// Log odds before calibration.
    pub fn score(&self, row: &[f64]) -> f64 {
        score(&self.coefficients, &self.standard.of(row))
    }
}

/// From scores to probabilities: p = 1 / (1 + exp(−a s − b)), a ≥ 0.
///
/// Targets are (n₊ + 1) / (n₊ + 2) and 1 / (n₋ + 2) in the place of 1 and 0, so that few subjects that are
/// separated by far do not get a probability of 0 or 1 (Platt's calibration); here both classes weigh alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Calibration {
    slope: f64,
    shift: f64,
}

/// Shift and slope with which the search for those of a calibration begins: scores are log odds already.
const UNCALIBRATED: [f64; 2] = [0.0, 1.0];

/// Shift and slope that fit best, of either sign.
fn calibrated(scores: &[f64], abnormal: &[bool], start: &[f64]) -> Vec<f64> {
    let ups = abnormal.iter().filter(|&&up| up).count() as f64;
    let downs = abnormal.len() as f64 - ups;
    let weights = balanced(abnormal);
    let cases: Vec<Case<'_>> = (scores.chunks_exact(1).zip(abnormal))
        .map(|(features, &up)| Case {
            features,
            // Targets short of 0 and 1 (Platt 1999): certain ones would drive the slope to infinity.
            target: if up {
                (ups + 1.0) / (ups + 2.0)
            } else {
                1.0 / (downs + 2.0)
            },
            weight: weights[usize::from(up)],
        })
        .collect();
    fit(&cases, CALIBRATION_RIDGE, start)
}

impl Calibration {
    pub fn new(scores: &[f64], abnormal: &[bool]) -> Self {
        Self::of(&calibrated(scores, abnormal, &UNCALIBRATED))
    }

    fn of(fitted: &[f64]) -> Self {
        match *fitted {
            [shift, slope] if slope > 0.0 => Self { slope, shift },
            // Scores that order the subjects the wrong way round say nothing.
            _ => Self {
                slope: 0.0,
                shift: 0.0,
            },
        }
    }

    pub fn probability(&self, score: f64) -> f64 {
        sigmoid(self.slope * score + self.shift)
    }
}

/// Scores and probabilities of each labelled subject from a classifier and a calibration without it (leave-one-out).
#[derive(Clone, Debug, PartialEq)]
pub(super) struct LeftOut {
    /// Log odds by the classifier of the others.
    pub scores: Vec<f64>,
    /// Calibrated by the scores of the others.
    pub probabilities: Vec<f64>,
}

/// Each case left out in turn. Both classes must have three cases at least.
///
/// # Errors
/// [`Stopped`] if asked to stop.
pub(super) fn leave_one_out(
    rows: &[&[f64]],
    abnormal: &[bool],
    ridge: f64,
    progress: &Progress,
) -> Result<LeftOut, Stopped> {
    // Leaving one out moves the minimum little: started from that of all, Newton's method takes few steps. The
    // problem is convex, so that the start changes no result but for rounding.
    let whole = Classifier::new(rows, abnormal, ridge, None);
    let scores = (0..rows.len())
        .map(|out| {
            progress.check()?;
            let (others, labels) = (without(rows, out), without(abnormal, out));
            Ok(Classifier::new(&others, &labels, ridge, Some(&whole)).score(rows[out]))
        })
        .collect::<Result<Vec<f64>, Stopped>>()?;
    // Likewise for the calibration. Its scores are leave-one-out scores: those of a fit to itself would be too sure.
    let all = calibrated(&scores, abnormal, &UNCALIBRATED);
    let probabilities = (0..rows.len())
        .map(|out| {
            progress.check()?;
            let fitted = calibrated(&without(&scores, out), &without(abnormal, out), &all);
            Ok(Calibration::of(&fitted).probability(scores[out]))
        })
        .collect::<Result<_, Stopped>>()?;
    Ok(LeftOut {
        scores,
        probabilities,
    })
}

fn without<T: Copy>(values: &[T], out: usize) -> Vec<T> {
    [&values[..out], &values[out + 1..]].concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn slices(rows: &[[f64; 2]]) -> Vec<&[f64]> {
        rows.iter().map(<[f64; 2]>::as_slice).collect()
    }

    fn left_out(rows: &[[f64; 2]], labels: &[bool]) -> LeftOut {
        leave_one_out(&slices(rows), labels, 1.0, &Progress::default()).unwrap()
    }

    proptest! {
        #[test]
        fn the_own_label_has_no_say_in_the_own_score(
            rows in prop::collection::vec(prop::array::uniform2(-2.0_f64..2.0), 12),
            out in 0_usize..12,
        ) {
            let labels: Vec<bool> = (0..12).map(|i| i % 2 == 0).collect();
            let mut flipped = labels.clone();
            flipped[out] = !flipped[out];
            let [a, b] = [labels, flipped].map(|labels| left_out(&rows, &labels).scores[out]);
            prop_assert!((a - b).abs() < 1e-6, "{} {}", a, b);
        }

        #[test]
        fn units_of_features_change_no_score(
            rows in prop::collection::vec(prop::array::uniform2(-2.0_f64..2.0), 10),
            unit in 0.01_f64..100.0, shift in -5.0_f64..5.0,
        ) {
            let labels: Vec<bool> = (0..10).map(|i| i % 3 == 0).collect();
            let moved: Vec<[f64; 2]> = rows.iter().map(|[x, y]| [unit * x + shift, *y]).collect();
            let a = left_out(&rows, &labels);
            let b = left_out(&moved, &labels);
            for (a, b) in a.probabilities.iter().zip(&b.probabilities) {
                prop_assert!((a - b).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn calibration_says_how_often_a_score_is_right() {
        // At +1 three of four are abnormal, at −1 one of four, a hundred times over.
        let scores: Vec<f64> = (0..800)
            .map(|i| if i % 8 < 4 { 1.0 } else { -1.0 })
            .collect();
        let labels: Vec<bool> = (0..800).map(|i| [0, 1, 2, 4].contains(&(i % 8))).collect();
        let calibration = Calibration::new(&scores, &labels);
        assert!((calibration.probability(1.0) - 0.75).abs() < 0.01);
        assert!((calibration.probability(-1.0) - 0.25).abs() < 0.01);
    }

    #[test]
    fn scores_the_wrong_way_round_say_nothing() {
        let calibration = Calibration::new(&[1.0, 2.0, 3.0, 4.0], &[true, true, false, false]);
        assert_eq!(calibration.probability(9.0), 0.5);
    }
}
