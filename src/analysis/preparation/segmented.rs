//! From an image to the tissues of the ventricle, by the road that is set.

use std::sync::Arc;

use super::tissue_edits::edited_tissues;
use super::{Asked, Preparation, PreparationError, Road, SettingsError, stated_image};
use crate::analysis::walls_from_cine::{CheckedCineParams, segment_cine};
use crate::analysis::walls_from_contours::{masks_of_contours, with_epicardium};
use crate::analysis::walls_from_masks::{MaskLabels, Masks};
use crate::analysis::walls_from_spect::segment_spect;
use crate::image::{Contour, Image, MarkedPoints};
use crate::progress::Progress;
use crate::study::Notice;

/// The tissues of a ventricle in an image.
#[derive(Clone, Debug)]
pub struct Segmented {
    /// Cavity and wall at each instant.
    pub masks: Masks,
    /// The volume of the image that each instant of the masks is of, ascending.
    pub instants: Vec<usize>,
    /// Points that were marked, or found where none were.
    pub points: MarkedPoints,
    /// Outlines of the tissues, where the road has some.
    pub contours: Arc<Vec<Contour>>,
    /// What was found, assumed and left out.
    pub notices: Vec<Notice>,
}

/// The tissues of an image by the road of the settings.
///
/// # Errors
/// If settings are out of range, points or outlines that the road needs are missing, it finds no ventricle, or it is stopped.
pub fn segmented(
    image: &Image,
    preparation: &Preparation,
    progress: &Progress,
) -> Result<Segmented, PreparationError> {
    let image = stated_image(image, preparation)?;
    progress.check()?;
    match preparation.road {
        Road::Masks(labels) => from_labels(&image, &labels, preparation),
        Road::Contours if preparation.contours.is_empty() => {
            Err(PreparationError::Asked(vec![Asked::Outlines]))
        }
        Road::Contours => from_contours(&image, &preparation.contours, preparation),
        Road::Spect => from_counts(&image, preparation, progress),
        Road::Cine => from_edges(&image, preparation, progress),
    }
}

/// The tissues of masks after the edits of the settings, at the instants at which anything is drawn.
///
/// # Errors
/// If an edit says no place, or nothing of the ventricle is drawn at any instant.
pub fn segmented_masks(
    masks: Masks,
    preparation: &Preparation,
) -> Result<Segmented, PreparationError> {
    let (masks, instants) = edited_tissues(masks, &preparation.edits)?.drawn()?;
    Ok(Segmented {
        masks,
        instants,
        points: preparation.points,
        contours: Arc::default(),
        notices: Vec::new(),
    })
}

fn from_labels(
    image: &Image,
    labels: &MaskLabels,
    preparation: &Preparation,
) -> Result<Segmented, PreparationError> {
    let mut found = segmented_masks(Masks::from_labels(image, labels)?, preparation)?;
    found.notices.extend(left_out(&found, image, "have a mask"));
    Ok(found)
}

/// The wall where counts are greatest.
fn from_counts(
    image: &Image,
    preparation: &Preparation,
    progress: &Progress,
) -> Result<Segmented, PreparationError> {
    let params = preparation
        .spect_params()
        .check()
        .map_err(SettingsError::from)?;
    let (points, edits) = (&preparation.points, &preparation.edits);
    let found = segment_spect(image, points, edits, &params, progress)?;
    Ok(Segmented {
        instants: (0..found.masks.instants().len()).collect(),
        masks: found.masks,
        points: found.points,
        contours: Arc::default(),
        notices: found.notices,
    })
}

/// Outlines along the edges of bright blood from three marked points on; those that were drawn are kept as they are.
fn from_edges(
    image: &Image,
    preparation: &Preparation,
    progress: &Progress,
) -> Result<Segmented, PreparationError> {
    let points = preparation.points;
    let needed = [
        (Asked::Apex, points.apex),
        (Asked::Base, points.base),
        (Asked::Blood, points.blood),
    ];
    let missing = needed.iter().filter(|(_, point)| point.is_none());
    let missing: Vec<Asked> = missing.map(|&(asked, _)| asked).collect();
    if !missing.is_empty() {
        return Err(PreparationError::Asked(missing));
    }
    let params = CheckedCineParams::default();
    let found = segment_cine(image, &points, &preparation.contours, &params, progress)?;
    let mut segmented = from_contours(image, &found.contours, preparation)?;
    segmented.notices.splice(0..0, found.notices);
    Ok(segmented)
}

/// Outlines as they were drawn, and of the epicardium those that follow where it was drawn at few instants.
fn from_contours(
    image: &Image,
    contours: &[Contour],
    preparation: &Preparation,
) -> Result<Segmented, PreparationError> {
    let (frame, instants) = (image.frame(), image.volumes().len());
    let whole = with_epicardium(frame, instants, contours)?;
    let masks = masks_of_contours(frame, instants, &whole.contours)?;
    let mut found = segmented_masks(masks, preparation)?;
    found.contours = Arc::new(whole.contours);
    found.notices.extend(whole.notices);
    found
        .notices
        .extend(left_out(&found, image, "have outlines"));
    Ok(found)
}

/// That volumes have no frame.
fn left_out(found: &Segmented, image: &Image, have: &str) -> Option<Notice> {
    let (kept, all) = (found.instants.len(), image.volumes().len());
    (kept < all).then(|| {
        Notice::info(format!(
            "{kept} of {all} volumes {have}: the others were left out"
        ))
    })
}
