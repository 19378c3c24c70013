//! From an image to walls.

use std::sync::Arc;

use super::lids::with_lids;
use super::{BaseEnd, Preparation, PreparationError, Segmented, segmented};
use crate::analysis::walls_from_masks::{Walls, walls_from_masks};
use crate::image::{Contour, Image, MarkedPoints};
use crate::progress::Progress;
use crate::study::Notice;

/// The walls of an image, and what they were made of.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// Endocardium and epicardium at each instant, in the world of the image.
    pub walls: Walls,
    /// The volume of the image that each frame of the walls is of, ascending: volumes without outlines have no frame.
    pub instants: Vec<usize>,
    /// Points that were marked, or found where none were.
    pub points: MarkedPoints,
    /// Outlines of the tissues, where the road has some: found ones with those that were drawn in their place.
    pub contours: Arc<Vec<Contour>>,
    /// What was found, assumed and left out on the way to the tissues; `walls` has its own.
    pub notices: Vec<Notice>,
}

/// The walls of an image by the settings: [`segmented()`](super::segmented()), then [`walls()`].
///
/// # Errors
/// If the settings are out of range, somebody must say more, the road finds no ventricle, or it is stopped.
pub fn prepared(
    image: &Image,
    preparation: &Preparation,
    progress: &Progress,
) -> Result<Prepared, PreparationError> {
    let part = progress.part("finding the ventricle", 0.0, 0.6);
    let segmented = segmented(image, preparation, &part)?;
    let part = progress.part("walls from masks", 0.6, 1.0);
    let walls = walls(&segmented, preparation, &part)?;
    Ok(Prepared {
        walls,
        instants: segmented.instants,
        points: segmented.points,
        contours: segmented.contours,
        notices: segmented.notices,
    })
}

/// The surfaces of tissues, open or closed at the base as is set. Vertices correspond over instants and subjects either way.
///
/// # Errors
/// If the tissues give no walls, or it is stopped.
pub fn walls(
    segmented: &Segmented,
    preparation: &Preparation,
    progress: &Progress,
) -> Result<Walls, PreparationError> {
    let mut params = preparation.wall_params();
    params.septum = segmented.points.septum;
    let params = params.check().map_err(super::SettingsError::from)?;
    let walls = walls_from_masks(&segmented.masks, &params, progress)?;
    match preparation.base {
        BaseEnd::Open => Ok(walls),
        BaseEnd::Closed => Ok(Walls {
            sequence: with_lids(&walls.sequence)?,
            ..walls
        }),
    }
}
