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

/// Most changes of the value along the rows for each voxel that is not 0: labels lie in regions, while counts of few whole
/// numbers differ from nearly every neighbour.
const MAX_CHANGES: f64 = 0.75;

fn labels(image: &Image) -> Option<Vec<i32>> {
    let mut found = BTreeSet::new();
    let (mut last, mut changes, mut labelled) = (0.0, 0_usize, 0_usize);
    for &value in image.volumes().iter().flat_map(|volume| volume.iter()) {
        labelled += usize::from(value != 0.0);
        // Neighbours are mostly of one label, so that the set is seldom asked.
        if value == last {
            continue;
        }
        if value.fract() != 0.0 || !(0.0..=MAX_LABEL).contains(&value) {
            return None;
        }
        last = value;
        changes += 1;
        if value != 0.0 && found.insert(value as i32) && found.len() > MAX_LABELS {
            return None;
        }
    }
    let in_regions = changes as f64 <= MAX_CHANGES * labelled as f64;
    (in_regions && !found.is_empty()).then(|| found.into_iter().collect())
}
