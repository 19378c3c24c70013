//! Accuracy of a classification, with its permutation mean.

/// Accuracy of a classifier, with that of the same classifier for permuted labels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// Cases that are classified correctly.
    pub correct: usize,
    /// Cases with a label.
    pub of: usize,
    /// Mean accuracy for permuted labels, in `0.0..=1.0`.
    pub baseline: f64,
    /// Share of permutations at least as good, the labels as they are counted as one of them:
    /// (1 + number of them) / (1 + number of permutations).
    pub p_value: f64,
}

impl Accuracy {
    /// Share of cases classified correctly, in `0.0..=1.0`.
    pub fn share(&self) -> f64 {
        self.correct as f64 / self.of.max(1) as f64
    }
}

/// Rows put into groups, without a look at labels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clustering {
    /// The cluster of each row; they are numbered in the order of their first rows.
    pub clusters: Vec<usize>,
    /// Sum of the squared distances of rows to the centre of their cluster.
    pub inertia: f64,
}

/// How well classes are separated: by clusters, by neighbours, and by linear classifiers.
///
/// Accuracies are `None` where fewer than two classes have labels.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Classes {
    /// Names of the classes, in alphabetical order.
    pub names: Vec<String>,
    /// The class of each row, as an index into `names`.
    pub of_row: Vec<Option<usize>>,
    /// k-means in the plane of the map.
    pub clustering: Clustering,
    /// Labelled rows by class and, within, by cluster; empty where there is no class.
    pub confusion: Vec<Vec<usize>>,
    /// The class that each cluster stands for, by the match that agrees with most labels.
    pub class_of_cluster: Vec<Option<usize>>,
    /// Share of rows whose cluster stands for their class (eq. 3.6).
    pub tau: Option<Accuracy>,
    /// Nearest neighbour by the distances, each row left out in turn.
    pub nearest_neighbour: Option<Accuracy>,
    /// Linear classifier on the distances, each row left out in turn.
    pub linear_classifier: Option<Accuracy>,
    /// Linear classifier in the plane of the map, each row left out in turn.
    pub plane_classifier: Option<Accuracy>,
}
