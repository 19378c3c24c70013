//! How walls of images are made, and what comes of it.

use std::collections::BTreeMap;

use crate::analysis::preparation::{Asked, Overrides, Preparation, Road};
use crate::analysis::walls_from_masks::SurfaceFit;
use crate::io::Opened;

/// How the walls of a batch of images are made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImageWallSettings {
    /// The settings of all studies; `None`: of each those of the road that fits it.
    pub all: Option<Preparation>,
    /// Settings of single studies by their ids, in the place of those of all.
    pub each: BTreeMap<String, Preparation>,
    /// Single settings that win over those.
    pub over: Overrides,
}

impl ImageWallSettings {
    /// The road that somebody set for all studies.
    pub(super) fn road(&self) -> Option<Road> {
        let set = match (self.over.road, self.over.labels) {
            (Some(Road::Masks(_)) | None, Some(labels)) => Some(Road::Masks(labels)),
            (road, _) => road,
        };
        set.or(self.all.as_ref().map(|settings| settings.road))
    }

    /// Whether somebody said by which road a study goes.
    pub(super) fn is_set(&self, id: &str) -> bool {
        self.road().is_some() || self.each.contains_key(id)
    }

    /// The settings of a study, of which some are proposed.
    pub(super) fn of(&self, id: &str, proposed: Preparation) -> Preparation {
        let set = self.each.get(id).or(self.all.as_ref());
        self.over.over(set.cloned().unwrap_or(proposed))
    }
}

/// Walls of images, and what they were made with.
#[derive(Clone, Debug, Default)]
pub struct ImageWalls {
    /// Subjects, images and what went wrong.
    pub opened: Opened,
    /// How the surfaces lie on the tissues that were found, with the subject's id.
    pub fits: Vec<(String, SurfaceFit)>,
    /// The settings that each subject was made with, by its id.
    pub preparations: Vec<(String, Preparation)>,
    /// What somebody must say of images that gave no walls yet, by the id of the images.
    pub asked: Vec<(String, Vec<Asked>)>,
}
