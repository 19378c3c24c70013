//! The classifier of a cohort: logistic, calibrated, each labelled subject left out in turn.

use crate::progress::{Progress, Stopped};

use super::design::Design;
use super::logistic::{Case, fit, left_out_scores, loss, score, sigmoid};

/// Penalties on squared weights from which one is chosen, from strong to weak, against a log-likelihood of one unit per
/// case: the first leaves hardly more than the mean, the last hardly touches a weight that one case speaks for.
const PENALTIES: [f64; 5] = [36.0, 6.0, 1.0, 0.18, 0.03];
/// Penalty on the slope of the calibration: a trace, so that scores that tell nothing have a finite one.
const CALIBRATION_RIDGE: f64 = 1e-6;

/// What is known of one subject, per feature.
pub(super) type Row = [Option<f64>];

/// A design and a logistic classifier on it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Classifier {
    pub design: Design,
    /// The intercept, then one per column of the design.
    pub coefficients: Vec<f64>,
    /// The penalty that was chosen.
    pub ridge: f64,
}

/// Coefficients by each penalty, from which others start.
type Path = Vec<Vec<f64>>;

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
    /// Of labelled subjects. The penalty is the one whose scores, each by a fit without the case, have the least loss.
    pub fn new(rows: &[&Row], positive: &[bool]) -> Self {
        Self::from(rows, positive, None).0
    }

    /// The same; Newton's method starts from the path of a similar problem if there is one.
    fn from(rows: &[&Row], positive: &[bool], start: Option<&Path>) -> (Self, Path) {
        // Of the training rows alone, or the case left out would have told its own scale.
        let design = Design::new(rows);
        let columns: Vec<Vec<f64>> = rows.iter().map(|row| design.of(row)).collect();
        // Otherwise the more frequent class would be the safer answer, whatever the features say.
        let weights = balanced(positive);
        let cases: Vec<Case<'_>> = (columns.iter().zip(positive))
            .map(|(features, &up)| Case {
                features,
                target: f64::from(u8::from(up)),
                weight: weights[usize::from(up)],
            })
            .collect();
        let size = design.standard.means.len() + 1;
        let mut path: Path = Vec::with_capacity(PENALTIES.len());
        let mut best = (f64::INFINITY, 0);
        for (index, &ridge) in PENALTIES.iter().enumerate() {
            let zeros = vec![0.0; size];
            let begin = (start.map(|path| &path[index]))
                // One subject may decide whether a column exists.
                .filter(|known| known.len() == size)
                .or(path.last())
                .unwrap_or(&zeros);
            let found = fit(&cases, ridge, begin);
            let lost = loss(&cases, &left_out_scores(&cases, ridge, &found));
            // Of equals the stronger penalty: it comes first.
            if lost < best.0 {
                best = (lost, index);
            }
            path.push(found);
        }
        let classifier = Self {
            coefficients: path[best.1].clone(),
            ridge: PENALTIES[best.1],
            design,
        };
        (classifier, path)
    }

    /// Log odds before calibration.
    pub fn score(&self, row: &Row) -> f64 {
        score(&self.coefficients, &self.design.of(row))
    }

    /// What each feature adds to the score of a row beside the mean of the training set, its flag included.
    pub fn contributions(&self, row: &Row) -> Vec<f64> {
        let columns = self.design.of(row);
        let mut parts: Vec<f64> = (self.coefficients[1..].iter().zip(&columns))
            .map(|(weight, x)| weight * x)
            .collect();
        let flags = parts.split_off(row.len().min(parts.len()));
        for (&feature, part) in self.design.flags.iter().zip(flags) {
            parts[feature] += part;
        }
        parts
    }
}

/// From scores to probabilities: p = 1 / (1 + exp(−a s − b)), a ≥ 0.
///
/// Targets are (n₊ + 1) / (n₊ + 2) and 1 / (n₋ + 2) in the place of 1 and 0, so that few subjects that are
/// separated by far do not get a probability of 0 or 1 (Platt's calibration); here both classes weigh alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Calibration {
    pub slope: f64,
    pub shift: f64,
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
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LeftOut {
    /// Log odds by the classifier of the others.
    pub scores: Vec<f64>,
    /// Calibrated by the scores of the others.
    pub probabilities: Vec<f64>,
    /// The classifiers of the others.
    pub classifiers: Vec<Classifier>,
}

/// Each case left out in turn, the choice of the penalty included. Both classes must have three cases at least.
///
/// # Errors
/// [`Stopped`] if asked to stop.
pub(super) fn leave_one_out(
    rows: &[&Row],
    positive: &[bool],
    progress: &Progress,
) -> Result<LeftOut, Stopped> {
    // Leaving one out moves the minimum little: started from that of all, Newton's method takes few steps. The
    // problem is convex, so that the start changes no result but for rounding.
    let (_, whole) = Classifier::from(rows, positive, None);
    let classifiers = (0..rows.len())
        .map(|out| {
            progress.check()?;
            let (others, labels) = (without(rows, out), without(positive, out));
            Ok(Classifier::from(&others, &labels, Some(&whole)).0)
        })
        .collect::<Result<Vec<Classifier>, Stopped>>()?;
    let scores: Vec<f64> = (classifiers.iter().zip(rows))
        .map(|(classifier, row)| classifier.score(row))
        .collect();
    // Likewise for the calibration. Its scores are leave-one-out scores: those of a fit to itself would be too sure.
    let all = calibrated(&scores, positive, &UNCALIBRATED);
    let probabilities = (0..rows.len())
        .map(|out| {
            progress.check()?;
            let fitted = calibrated(&without(&scores, out), &without(positive, out), &all);
            Ok(Calibration::of(&fitted).probability(scores[out]))
        })
        .collect::<Result<_, Stopped>>()?;
    Ok(LeftOut {
        scores,
        probabilities,
        classifiers,
    })
}

/// A classifier of all labelled subjects, its calibration, and what it says of each of them left out.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Model {
    pub classifier: Classifier,
    pub calibration: Calibration,
    pub left_out: LeftOut,
}

impl Model {
    /// # Errors
    /// [`Stopped`] if asked to stop.
    pub fn new(rows: &[&Row], positive: &[bool], progress: &Progress) -> Result<Self, Stopped> {
        let left_out = leave_one_out(rows, positive, progress)?;
        Ok(Self {
            classifier: Classifier::new(rows, positive),
            calibration: Calibration::new(&left_out.scores, positive),
            left_out,
        })
    }
}

fn without<T: Copy>(values: &[T], out: usize) -> Vec<T> {
    [&values[..out], &values[out + 1..]].concat()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn left_out(rows: &[[f64; 2]], labels: &[bool]) -> LeftOut {
        let rows: Vec<[Option<f64>; 2]> = rows.iter().map(|row| row.map(Some)).collect();
        let rows: Vec<&Row> = rows.iter().map(|row| &row[..]).collect();
        leave_one_out(&rows, labels, &Progress::default()).unwrap()
    }

    #[test]
    fn contributions_add_up_to_the_score_and_hold_the_flags() {
        let rows: Vec<[Option<f64>; 2]> = (0..20_i32)
            .map(|i| [Some(f64::from(i % 7)), (i % 3 != 0).then(|| f64::from(i))])
            .collect();
        let slices: Vec<&Row> = rows.iter().map(|row| &row[..]).collect();
        let labels: Vec<bool> = (0..20).map(|i| i % 3 == 0).collect();
        let classifier = Classifier::new(&slices, &labels);
        for row in slices {
            let parts = classifier.contributions(row);
            assert_eq!(parts.len(), 2);
            let sum = classifier.coefficients[0] + parts.iter().sum::<f64>();
            assert!((sum - classifier.score(row)).abs() < 1e-9);
        }
        // Absence alone tells the classes here.
        assert!(classifier.score(&[Some(3.0), None]) > 0.0);
        assert!(classifier.score(&[Some(3.0), Some(9.0)]) < 0.0);
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
