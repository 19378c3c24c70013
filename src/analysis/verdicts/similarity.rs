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
        // The upper one of an even number: a distance that occurs.
        median: *nearest_distances.get(nearest_distances.len() / 2)?,
        as_far: as_far as f64 / nearest_distances.len() as f64,
    })
}

/// Root mean square over the columns of a standardised row that are not always 0, of which there are `count`: how many
/// standard deviations it lies from the mean, per column.
pub(super) fn distance_from_mean(row: &[f64], count: usize) -> f64 {
    (row.iter().map(|x| x * x).sum::<f64>() / count.max(1) as f64).sqrt()
}

/// Steps between the quantiles of a rule.
const STEPS: usize = 20;

/// The quantiles 0, 5 … 100 %.
pub(super) fn quantiles(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    let last = values.len().saturating_sub(1);
    (0..=STEPS)
        .filter_map(|step| values.get((step * last + STEPS / 2) / STEPS).copied())
        .collect()
}

/// A distance beside ascending quantiles of those of a training set, which a rule has in the place of subjects.
pub(super) fn distance_among(quantiles: &[f64], distance: f64) -> Option<TrainingSetDistance> {
    let above = quantiles.partition_point(|&other| other < distance);
    let as_far = match above {
        0 => 1.0,
        above if above == quantiles.len() => 0.0,
        above => {
            let [low, high] = [quantiles[above - 1], quantiles[above]];
            let below = (above - 1) as f64 + (distance - low) / (high - low);
            1.0 - below / (quantiles.len() - 1) as f64
        }
    };
    Some(TrainingSetDistance {
        distance,
        median: *quantiles.get(quantiles.len() / 2)?,
        as_far,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_distance_lies_among_quantiles_where_it_lies_among_the_values() {
        let quantiles = quantiles((0..201).map(f64::from).rev().collect());
        assert_eq!(
            (quantiles.len(), quantiles[1], quantiles[20]),
            (21, 10.0, 200.0)
        );
        for (distance, as_far) in [
            (0.0, 1.0),
            (50.0, 0.75),
            (105.0, 0.475),
            (200.0, 0.0),
            (900.0, 0.0),
        ] {
            let found = distance_among(&quantiles, distance).unwrap();
            assert!(
                (found.as_far - as_far).abs() < 1e-12,
                "{distance}: {found:?}"
            );
            assert_eq!((found.median, found.distance), (100.0, distance));
        }
        assert_eq!(distance_from_mean(&[3.0, 0.0, -3.0], 2), 3.0);
        assert_eq!(distance_among(&[], 1.0), None);
    }
}
