//! From an image to the tissues of the ventricle, by the road that is set.

use std::sync::Arc;

use super::tissue_edits::edited_tissues;
use super::{Asked, Preparation, PreparationError, Road, stated_image};
use crate::analysis::walls_from_masks::{MaskLabels, Masks};
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
        Road::Spect | Road::Cine | Road::Contours => {
            Err(PreparationError::Asked(vec![Asked::Labels]))
        }
    }
}

fn from_labels(
    image: &Image,
    labels: &MaskLabels,
    preparation: &Preparation,
) -> Result<Segmented, PreparationError> {
    let all = image.volumes().len();
    let masks = edited_tissues(Masks::from_labels(image, labels)?, &preparation.edits)?;
    let (masks, instants) = masks.drawn()?;
    let left_out = (instants.len() < all).then(|| {
        Notice::info(format!(
            "{} of {all} volumes have a mask: the others were left out",
            instants.len()
        ))
    });
    Ok(Segmented {
        masks,
        instants,
        points: preparation.points,
        contours: Arc::default(),
        notices: left_out.into_iter().collect(),
    })
}
