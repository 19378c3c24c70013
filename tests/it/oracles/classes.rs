//! Clusters and their match with classes against scikit-learn and SciPy.

use super::*;
use cardiomorph::analysis::classification::{k_means, tau};

fn whole(numbers: &[f64]) -> Vec<usize> {
    numbers.iter().map(|x| *x as usize).collect()
}

fn flat(confusion: &[Vec<usize>]) -> Vec<f64> {
    confusion
        .concat()
        .iter()
        .map(|&count| count as f64)
        .collect()
}

#[test]
fn clusters_are_as_tight_as_those_of_scikit_learn_and_match_as_well() {
    for (name, count) in [("km4", 4), ("km3_overlap", 3)] {
        let case = Case::load("embed", name);
        let points = case.numbers("inputs", "points");
        let labels: Vec<Option<usize>> = whole(&case.numbers("inputs", "labels"))
            .into_iter()
            .map(Some)
            .collect();
        for seed in 0..3 {
            let found = k_means(&points, 2, count, 50, seed, &Progress::default()).unwrap();
            let best = case.number("inertia_best");
            assert!(found.inertia <= 1.0001 * best, "{name}: {}", found.inertia);
            assert!(
                found.inertia >= best * (1.0 - 1e-9),
                "{name}: {}",
                found.inertia
            );
            let matching = tau(&found.clusters, &labels);
            assert_eq!(matching.tau(), case.number("tau_best_kmeans"), "{name}");
        }
    }
}

#[test]
fn the_match_of_given_clusters_is_that_of_scipy() {
    for name in ["km4", "km3_overlap"] {
        let case = Case::load("embed", name);
        let labels: Vec<Option<usize>> = whole(&case.numbers("inputs", "labels"))
            .into_iter()
            .map(Some)
            .collect();
        let given = whole(&case.numbers("inputs", "cluster_labels_given"));
        let matching = tau(&given, &labels);
        assert!((matching.tau() - case.number("tau_given")).abs() <= 1e-15);
        let expected = case.numbers("expected", "confusion_given");
        assert_eq!(flat(&matching.confusion), expected);
    }
}
