//! Rows put into groups around their means.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::progress::{Progress, Stopped};

use super::Clustering;

/// Steps after which a start is given up as it is; seldom more than 30 are needed.
const MAX_STEPS: usize = 300;

/// Clusters of `points`, rows of `width` numbers one after the other, with the least inertia found.
///
/// From each of `restarts` starts, rows join their nearest centre and centres move to the mean of their
/// rows until no row changes; the inertia Σ |x − centre|² never rises. Starts are drawn as k-means++: each
/// next centre is a row, chosen with a probability that grows with its squared distance from the centres so
/// far. A centre that loses all rows moves to the row farthest from its own. Of starts that end
/// with the same inertia the first counts. There are not more clusters than rows.
///
/// Every start has a stream of `seed` of its own: the answer does not depend on the number of threads, and
/// more starts never make it worse.
///
/// Source: Lloyd (1982), IEEE Trans. Inf. Theory 28(2); Arthur and Vassilvitskii (2007), SODA.
///
/// # Errors
/// If stopped. Coordinates must be finite, with squares that are.
pub fn k_means(
    points: &[f64],
    width: usize,
    clusters: usize,
    restarts: usize,
    seed: u64,
    progress: &Progress,
) -> Result<Clustering, Stopped> {
    let rows = Rows { points, width };
    progress.check()?;
    // More clusters than rows would stay empty.
    let clusters = clusters.min(rows.count());
    if clusters == 0 {
        return Ok(Clustering::default());
    }
    progress.expect_steps(restarts);
    let found = (0..restarts.max(1))
        .into_par_iter()
        .map(|start| {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            // A stream per start, so that threads may take the starts in any order.
            random.set_stream(start as u64);
            let centres = rows.drawn_centres(clusters, &mut random);
            let found = rows.descend(centres, progress)?;
            progress.step()?;
            Ok(found)
        })
        .collect::<Result<Vec<_>, Stopped>>()?;
    let best = (found.into_iter()).reduce(|best, next| {
        // Strictly less: of equals the first start, whichever thread ends first.
        if next.inertia < best.inertia {
            next
        } else {
            best
        }
    });
    // Numbers of clusters carry no meaning; these are the same for the same partition.
    Ok(best.map(numbered_by_first_rows).unwrap_or_default())
}

fn numbered_by_first_rows(mut clustering: Clustering) -> Clustering {
    let mut numbers = Vec::new();
    clustering.clusters = (clustering.clusters.iter())
        .map(|cluster| {
            let known = numbers.iter().position(|known| known == cluster);
            known.unwrap_or_else(|| {
                numbers.push(*cluster);
                numbers.len() - 1
            })
        })
        .collect();
    clustering
}

#[derive(Clone, Copy)]
struct Rows<'a> {
    points: &'a [f64],
    width: usize,
}

impl Rows<'_> {
    fn count(&self) -> usize {
        self.points.len().checked_div(self.width).unwrap_or(0)
    }

    fn row(&self, row: usize) -> &[f64] {
        &self.points[row * self.width..][..self.width]
    }

    fn drawn_centres(&self, clusters: usize, random: &mut ChaCha8Rng) -> Vec<f64> {
        let mut centres = self.row(random.random_range(0..self.count())).to_vec();
        let mut nearest: Vec<f64> = (0..self.count())
            .map(|row| square(self.row(row), &centres))
            .collect();
        while centres.len() < clusters * self.width {
            let sum: f64 = nearest.iter().sum();
            // In proportion to squared distance (k-means++): far rows begin clusters, outliers not always.
            let mut left = random.random::<f64>() * sum;
            let drawn = nearest.iter().position(|square| {
                left -= square;
                left < 0.0
            });
            // Where all rows lie on centres, or round-off eats the end, any row will do.
            let row = drawn.unwrap_or_else(|| random.random_range(0..self.count()));
            centres.extend_from_slice(self.row(row));
            for (other, nearest) in nearest.iter_mut().enumerate() {
                *nearest = nearest.min(square(self.row(other), self.row(row)));
            }
        }
        centres
    }

    fn descend(&self, mut centres: Vec<f64>, progress: &Progress) -> Result<Clustering, Stopped> {
        let mut now = self.joined(&centres);
        for _ in 0..MAX_STEPS {
            progress.check()?;
            centres = self.means(&now, &centres);
            let next = self.joined(&centres);
            // The same members have the same means, so nothing changes from here on.
            let settled = next.clusters == now.clusters;
            now = next;
            if settled {
                break;
            }
        }
        Ok(now)
    }

    /// Each row with its nearest centre, the first of equally near ones.
    fn joined(&self, centres: &[f64]) -> Clustering {
        let mut inertia = 0.0;
        let clusters = (0..self.count())
            .map(|row| {
                let (mut nearest, mut least) = (0, f64::INFINITY);
                for (cluster, centre) in centres.chunks_exact(self.width).enumerate() {
                    let square = square(self.row(row), centre);
                    if square < least {
                        (nearest, least) = (cluster, square);
                    }
                }
                inertia += least;
                nearest
            })
            .collect();
        Clustering { clusters, inertia }
    }

    /// Means of the rows of each cluster; one without rows takes the row farthest from its centre.
    fn means(&self, joined: &Clustering, centres: &[f64]) -> Vec<f64> {
        let mut means = vec![0.0; centres.len()];
        let mut members = vec![0_usize; centres.len() / self.width];
        for (row, &cluster) in joined.clusters.iter().enumerate() {
            members[cluster] += 1;
            let mean = &mut means[cluster * self.width..][..self.width];
            mean.iter_mut()
                .zip(self.row(row))
                .for_each(|(mean, x)| *mean += x);
        }
        let mut far: Vec<(f64, usize)> = Vec::new();
        for (cluster, mean) in means.chunks_exact_mut(self.width).enumerate() {
            if members[cluster] > 0 {
                mean.iter_mut().for_each(|x| *x /= members[cluster] as f64);
                continue;
            }
            // Only where a cluster is empty: most sweeps never need the order.
            if far.is_empty() {
                far = (joined.clusters.iter().enumerate())
                    .map(|(row, &own)| {
                        (
                            square(self.row(row), &centres[own * self.width..][..self.width]),
                            row,
                        )
                    })
                    .collect();
                // Ascending, so that the farthest is taken from the end; of equals the first row.
                far.sort_by(|a, b| a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)));
            }
            if let Some((_, row)) = far.pop() {
                mean.copy_from_slice(self.row(row));
            }
        }
        means
    }
}

fn square(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn found(points: &[f64], clusters: usize) -> Clustering {
        k_means(points, 2, clusters, 20, 3, &Progress::default()).unwrap()
    }

    #[test]
    fn groups_far_apart_are_found_and_numbered_by_their_first_rows() {
        let points = [9.0, 9.0, 0.0, 0.0, 9.0, 8.0, 1.0, 0.0, 0.0, 1.0, 8.0, 9.0];
        let clustering = found(&points, 2);
        assert_eq!(clustering.clusters, [0, 1, 0, 1, 1, 0]);
        assert!((clustering.inertia - 8.0 / 3.0).abs() < 1e-12);
    }

    #[test]
    fn as_many_clusters_as_rows_leave_no_inertia() {
        let points = [0.0, 0.0, 1.0, 0.0, 5.0, 5.0];
        for clusters in [3, 4, 100] {
            let clustering = found(&points, clusters);
            assert_eq!(clustering.clusters, [0, 1, 2]);
            assert_eq!(clustering.inertia, 0.0);
        }
        assert_eq!(found(&[], 3), Clustering::default());
        assert_eq!(found(&points, 0), Clustering::default());
    }

    #[test]
    fn rows_that_coincide_share_a_cluster() {
        let clustering = found(&[2.0; 12], 3);
        assert_eq!(clustering.clusters, [0; 6]);
        assert_eq!(clustering.inertia, 0.0);
    }

    #[test]
    fn a_centre_without_rows_moves_to_the_farthest_row() {
        let rows = Rows {
            points: &[0.0, 1.0, 10.0],
            width: 1,
        };
        let centres = [1.0, 99.0];
        let joined = rows.joined(&centres);
        assert_eq!(joined.clusters, [0, 0, 0]);
        assert_eq!(rows.means(&joined, &centres)[1], 10.0);
    }

    #[test]
    fn a_search_that_is_stopped_says_so() {
        let progress = Progress::default();
        progress.stop();
        assert_eq!(k_means(&[0.0; 8], 2, 2, 5, 0, &progress), Err(Stopped));
    }

    proptest! {
        #[test]
        fn inertia_never_rises_from_step_to_step(
            points in prop::collection::vec(-1.0_f64..1.0, 20..80),
            clusters in 1_usize..9,
            seed in 0_u64..1000,
        ) {
            let rows = Rows { points: &points[..points.len() / 2 * 2], width: 2 };
            let mut centres = rows.drawn_centres(clusters, &mut ChaCha8Rng::seed_from_u64(seed));
            let mut last = f64::INFINITY;
            for _ in 0..20 {
                let joined = rows.joined(&centres);
                prop_assert!(joined.inertia <= last * (1.0 + 1e-12));
                last = joined.inertia;
                centres = rows.means(&joined, &centres);
            }
        }

        #[test]
        fn more_starts_never_make_it_worse(
            points in prop::collection::vec(-1.0_f64..1.0, 40..60),
            seed in 0_u64..100,
        ) {
            let points = &points[..points.len() / 2 * 2];
            let with = |restarts| k_means(points, 2, 4, restarts, seed, &Progress::default()).unwrap();
            prop_assert!(with(8).inertia <= with(2).inertia);
            prop_assert_eq!(with(8), with(8));
        }
    }
}
