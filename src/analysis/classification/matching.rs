//! Which cluster stands for which class? The one-to-one answer that agrees with most labels.

/// Clusters matched with classes.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Matching {
    /// Labelled rows by class and, within, by cluster.
    pub confusion: Vec<Vec<usize>>,
    /// The class that each cluster stands for; `None` where there are more clusters than classes.
    pub class_of_cluster: Vec<Option<usize>>,
    /// Labelled rows whose cluster stands for their class.
    pub correct: usize,
    /// Labelled rows.
    pub of: usize,
}

impl Matching {
    /// τ, the share of labelled rows whose cluster stands for their class; 0 where there are none.
    ///
    /// Source: eq. 3.6 of the text, which leaves open how clusters are named; here by the one-to-one
    /// match with the largest τ.
    pub fn tau(&self) -> f64 {
        self.correct as f64 / self.of.max(1) as f64
    }
}

/// Matches clusters with classes one to one, so that as many labels as possible agree.
///
/// `labels` holds a class for each row, or none; rows without are not counted.
pub fn tau(clusters: &[usize], labels: &[Option<usize>]) -> Matching {
    let labelled = || (clusters.iter().zip(labels)).filter_map(|(&c, l)| l.map(|l| (c, l)));
    // Of all rows: a cluster without labelled members still takes part in the matching.
    let cluster_count = clusters.iter().max().map_or(0, |most| most + 1);
    let class_count = labelled().map(|(_, label)| label + 1).max().unwrap_or(0);
    let mut confusion = vec![vec![0; cluster_count]; class_count];
    for (cluster, label) in labelled() {
        confusion[label][cluster] += 1;
    }
    let matched = best_match(&confusion, cluster_count);
    let mut class_of_cluster = vec![None; cluster_count];
    let mut correct = 0;
    for (class, &cluster) in matched.iter().enumerate() {
        if let Some(cluster) = cluster {
            class_of_cluster[cluster] = Some(class);
            correct += confusion[class][cluster];
        }
    }
    Matching {
        confusion,
        class_of_cluster,
        correct,
        of: labelled().count(),
    }
}

/// For each row of counts the column it takes, one to one, with the largest sum of counts.
///
/// Kuhn's Hungarian method with potentials, O(n³): rows are added one by one along the cheapest
/// alternating way.
///
/// Source: Kuhn (1955), Naval Res. Logist. Q. 2; in the form of Jonker and Volgenant (1987).
fn best_match(counts: &[Vec<usize>], columns: usize) -> Vec<Option<usize>> {
    // Square, so that clusters or classes that are left over are matched with nothing.
    let size = counts.len().max(columns);
    // Index 0 is the row being added; rows and columns count from 1. Missing ones cost nothing.
    let cost = |row: usize, column: usize| -> i64 {
        let count = counts.get(row - 1).and_then(|row| row.get(column - 1));
        // Most agreement is least cost.
        -(count.copied().unwrap_or(0) as i64)
    };
    let mut of_row = vec![0_i64; size + 1];
    let mut of_column = vec![0_i64; size + 1];
    let mut row_in = vec![0_usize; size + 1];
    for row in 1..=size {
        row_in[0] = row;
        let mut column = 0;
        let mut least = vec![i64::MAX; size + 1];
        let mut from = vec![0_usize; size + 1];
        let mut done = vec![false; size + 1];
        while row_in[column] != 0 {
            done[column] = true;
            let here = row_in[column];
            let (mut step, mut next) = (i64::MAX, 0);
            for other in (1..=size).filter(|&other| !done[other]) {
                let reduced = cost(here, other) - of_row[here] - of_column[other];
                if reduced < least[other] {
                    (least[other], from[other]) = (reduced, column);
                }
                if least[other] < step {
                    (step, next) = (least[other], other);
                }
            }
            for other in 0..=size {
                if done[other] {
                    of_row[row_in[other]] += step;
                    of_column[other] -= step;
                } else {
                    // A column not reached yet stays at infinity.
                    least[other] = least[other].saturating_sub(step);
                }
            }
            column = next;
        }
        while column != 0 {
            row_in[column] = row_in[from[column]];
            column = from[column];
        }
    }
    let mut matched = vec![None; counts.len()];
    for column in 1..=columns {
        if row_in[column] <= counts.len() {
            matched[row_in[column] - 1] = Some(column - 1);
        }
    }
    matched
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn labels(classes: &[usize]) -> Vec<Option<usize>> {
        classes.iter().copied().map(Some).collect()
    }

    #[test]
    fn clusters_are_named_so_that_most_labels_agree() {
        let matching = tau(&[2, 2, 0, 0, 1, 1], &labels(&[0, 0, 1, 1, 2, 1]));
        assert_eq!(matching.class_of_cluster, [Some(1), Some(2), Some(0)]);
        assert_eq!((matching.correct, matching.of), (5, 6));
        assert_eq!(matching.confusion, [[0, 0, 2], [2, 1, 0], [0, 1, 0]]);
    }

    #[test]
    fn a_greedy_choice_is_not_good_enough() {
        // Greedy: 0 takes column 0 (6), 1 is left with 0; best: 5 + 5.
        let mut clusters = vec![0; 6];
        clusters.extend([1; 5]);
        clusters.extend([0; 5]);
        let mut classes = vec![0; 11];
        classes.extend([1; 5]);
        assert_eq!(tau(&clusters, &labels(&classes)).correct, 10);
    }

    #[test]
    fn rows_without_a_label_and_clusters_without_a_class_are_not_counted() {
        let matching = tau(&[0, 1, 2, 2], &[Some(0), None, Some(0), Some(0)]);
        assert_eq!((matching.correct, matching.of), (2, 3));
        assert_eq!(matching.class_of_cluster, [None, None, Some(0)]);
        assert_eq!(tau(&[], &[]).tau(), 0.0);
        assert_eq!(tau(&[0, 0], &[None, None]).tau(), 0.0);
        // More classes than clusters.
        assert_eq!(tau(&[0, 0, 0], &labels(&[0, 1, 2])).correct, 1);
    }

    fn by_trying_all(counts: &[Vec<usize>], free: &mut Vec<usize>, row: usize) -> usize {
        if row == counts.len() {
            return 0;
        }
        // A row may also take none.
        let mut best = by_trying_all(counts, free, row + 1);
        for at in 0..free.len() {
            let column = free.remove(at);
            best = best.max(counts[row][column] + by_trying_all(counts, free, row + 1));
            free.insert(at, column);
        }
        best
    }

    proptest! {
        #[test]
        fn no_other_match_agrees_with_more_labels(
            rows in prop::collection::vec((0_usize..5, 0_usize..5), 0..40),
        ) {
            let clusters: Vec<usize> = rows.iter().map(|r| r.0).collect();
            let classes: Vec<usize> = rows.iter().map(|r| r.1).collect();
            let matching = tau(&clusters, &labels(&classes));
            let mut free = (0..matching.class_of_cluster.len()).collect();
            prop_assert_eq!(matching.correct, by_trying_all(&matching.confusion, &mut free, 0));
        }

        #[test]
        fn other_names_of_clusters_change_nothing(
            rows in prop::collection::vec((0_usize..4, 0_usize..4), 1..40),
            turn in 0_usize..4,
        ) {
            let clusters: Vec<usize> = rows.iter().map(|r| r.0).collect();
            let classes: Vec<usize> = rows.iter().map(|r| r.1).collect();
            let renamed: Vec<usize> = clusters.iter().map(|c| (c + turn) % 4 * 3 % 4).collect();
            let a = tau(&clusters, &labels(&classes));
            let b = tau(&renamed, &labels(&classes));
            prop_assert_eq!((a.correct, a.of), (b.correct, b.of));
        }
    }
}
