//! Hearts that are known, found in the counts of a synthetic study.
#![allow(clippy::unwrap_used, clippy::panic)] // A test that fails here says so.

mod damage;
mod known;
mod synthetic;

use std::sync::OnceLock;

use crate::image::{Border, Image, VolumeFrame, gaussian_blur};
use crate::mesh::{CappedSheet, Point3, ScanGrid, Vector3, scan_lines, sheets};
use crate::progress::Progress;
use crate::study::MeshSequence;
use crate::study::built_in::{BuiltInCohort, BuiltInParams, cohort};

use super::{CheckedSpectParams, SpectError, SpectSegmentation, segment_spect};
use synthetic::{Scene, Study, gated_spect};

use crate::analysis::walls_from_masks::{Masks, Tissue};
use crate::image::{MarkedPoints, Sampler, VolumeEdit};

fn built_in() -> &'static BuiltInCohort {
    static COHORT: OnceLock<BuiltInCohort> = OnceLock::new();
    COHORT.get_or_init(|| cohort(&BuiltInParams::default()).unwrap())
}

/// The study of a subject, and its true ejection fraction.
fn study(subject: usize, scene: &Scene) -> (Study, f64) {
    let cohort = built_in();
    let sequence = &cohort.study.subjects[subject].sequence;
    let truth = cohort.truths[subject].ejection_fraction;
    (gated_spect(sequence, scene), truth)
}

fn segmented(image: &Image, edits: &[VolumeEdit]) -> Result<SpectSegmentation, SpectError> {
    let (points, params) = (MarkedPoints::default(), CheckedSpectParams::default());
    segment_spect(image, &points, edits, &params, &Progress::default())
}

fn ejection_fraction(masks: &Masks) -> f64 {
    let volumes = (0..masks.instants().len()).map(|instant| masks.count(instant, Tissue::Cavity));
    let (least, most) = (volumes.clone().min().unwrap(), volumes.max().unwrap());
    1.0 - least as f64 / most as f64
}
