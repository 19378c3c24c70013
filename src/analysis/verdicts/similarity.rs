//! Which subjects are similar, and how far one lies from the training set.

use super::result::TrainingSetDistance;

/// Rows that are nearest to one of them among some, nearest first; itself is left out.
pub(super) fn nearest_rows(
    rows: &[Vec<f64>],
    of: usize,
    among: &[usize],
    count: usize,
) -> Vec<usize> {
    let mut others: Vec<(f64, usize)> = (among.iter())
        .filter(|&&other| other != of)
        .map(|&other| (distance(&rows[of], &rows[other]), other))
        .collect();
    // Ties by the order of the study, so that the list is the same on every run.
    others.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    others
        .into_iter()
        .take(count)
        .map(|(_, other)| other)
        .collect()
}

/// Distance of each row of the training set to the nearest other one, in rising order.
pub(super) fn nearest_distances(rows: &[Vec<f64>], training_set: &[usize]) -> Vec<f64> {
    let mut distances: Vec<f64> = training_set
        .iter()
        .filter_map(|&row| nearest(rows, row, training_set))
        .collect();
    // Ascending, for the median.
    distances.sort_by(f64::total_cmp);
    distances
}

/// How near a row lies to the training set; `None` where there are no others.
pub(super) fn training_set_distance(
    rows: &[Vec<f64>],
    of: usize,
    training_set: &[usize],
    nearest_distances: &[f64],
) -> Option<TrainingSetDistance> {
    let distance = nearest(rows, of, training_set)?;
    let as_far = nearest_distances
        .iter()
        .filter(|&&other| other >= distance)
        .count();
    Some(TrainingSetDistance {
        distance,
        median: *nearest_distances.get(nearest_distances.len() / 2)?,
        as_far: as_far as f64 / nearest_distances.len() as f64,
    })
}

fn nearest(rows: &[Vec<f64>], of: usize, among: &[usize]) -> Option<f64> {
    (among.iter())
        .filter(|&&other| other != of)
        .map(|&other| distance(&rows[of], &rows[other]))
        .min_by(f64::total_cmp)
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).powi(2))
        .sum::<f64>()
        .sqrt()
}
