//! Which subjects are alike, and how far one lies from the training set.

use super::result::Familiarity;

/// Rows that are nearest to one of them among some, nearest first; itself is left out.
pub(super) fn alike(rows: &[Vec<f64>], of: usize, among: &[usize], count: usize) -> Vec<usize> {
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
pub(super) fn usual_distances(rows: &[Vec<f64>], seen: &[usize]) -> Vec<f64> {
    let mut distances: Vec<f64> = seen
        .iter()
        .filter_map(|&row| nearest(rows, row, seen))
        .collect();
    distances.sort_by(f64::total_cmp);
    distances
}

/// How near a row lies to the training set; `None` where there are no others.
pub(super) fn familiarity(
    rows: &[Vec<f64>],
    of: usize,
    seen: &[usize],
    usual: &[f64],
) -> Option<Familiarity> {
    let distance = nearest(rows, of, seen)?;
    let as_far = usual.iter().filter(|&&other| other >= distance).count();
    Some(Familiarity {
        distance,
        usual: *usual.get(usual.len() / 2)?,
        as_far: as_far as f64 / usual.len() as f64,
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
