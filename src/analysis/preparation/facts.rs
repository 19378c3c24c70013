//! What is known of an image before anything is made of it.

use std::collections::BTreeSet;

use crate::image::{Image, Modality};

/// What is known of an image.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageFacts {
    /// The kind of machine, where the file says it.
    pub modality: Option<Modality>,
    /// Voxels along i, j and k.
    pub size: [usize; 3],
    /// Distances between them; 1 where the file says none.
    pub spacing_mm: [f64; 3],
    /// Whether the file says the distances.
    pub spacing_known: bool,
    /// Number of volumes.
    pub instants: usize,
    /// Whether the file says their times; one volume needs none.
    pub times_known: bool,
    /// The values that occur beside 0, ascending, if they are so few and whole that they are labels.
    pub labels: Option<Vec<i32>>,
    /// Outlines that were read beside the image.
    pub contours: usize,
}

/// Labels of an image at most, beside 0: the finest segmentations of a heart have fewer, and an image that is none has more
/// values than this.
const MAX_LABELS: usize = 32;
/// Greatest label: values beyond are measured, not given.
const MAX_LABEL: f32 = 1000.0;

/// What an image says of itself. What the image cannot say is taken to be known and absent: whoever read the file sets
/// `spacing_known` and `contours` where it is otherwise.
pub fn facts(image: &Image, modality: Option<Modality>) -> ImageFacts {
    let instants = image.volumes().len();
    ImageFacts {
        modality,
        size: image.frame().size(),
        spacing_mm: image.frame().spacing(),
        spacing_known: true,
        instants,
        times_known: instants == 1 || image.times_ms().is_some(),
        labels: labels(image),
        contours: 0,
    }
}

fn labels(image: &Image) -> Option<Vec<i32>> {
    let mut found = BTreeSet::new();
    // Neighbours are mostly of one label, so that the set is seldom asked.
    let mut last = 0.0;
    for &value in image.volumes().iter().flat_map(|volume| volume.iter()) {
        if value == last {
            continue;
        }
        if value.fract() != 0.0 || !(0.0..=MAX_LABEL).contains(&value) {
            return None;
        }
        last = value;
        if value != 0.0 && found.insert(value as i32) && found.len() > MAX_LABELS {
            return None;
        }
    }
    (!found.is_empty()).then(|| found.into_iter().collect())
}
