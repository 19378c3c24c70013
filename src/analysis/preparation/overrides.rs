//! Single settings that win over those of a road or of a file.

use super::{BaseEnd, Preparation, Road, TypedTimes};
use crate::analysis::walls_from_masks::MaskLabels;
use crate::image::MarkedPoints;

/// What somebody set of a batch of images, as the options of `mesh` say it: what is `None` stays as it was.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Overrides {
    /// How walls are found.
    pub road: Option<Road>,
    /// Labels of tissues; without a road they mean the road of masks.
    pub labels: Option<MaskLabels>,
    /// Distances between voxels along i, j and k in millimetres.
    pub spacing_mm: Option<[f64; 3]>,
    /// Times of the volumes.
    pub times: Option<TypedTimes>,
    /// Standard deviation of the blur in millimetres.
    pub blur_mm: Option<f64>,
    /// What is bright, as a share of the maximum.
    pub threshold: Option<f64>,
    /// Marked points.
    pub points: MarkedPoints,
    /// Vertices of each surface at most.
    pub vertices: Option<usize>,
    /// What becomes of the base.
    pub base: Option<BaseEnd>,
    /// Whether slices are put back.
    pub correct_shifts: Option<bool>,
}

impl Overrides {
    /// The settings with what is set here in the place of theirs.
    #[must_use]
    pub fn over(&self, settings: Preparation) -> Preparation {
        let points = settings.points;
        let set = self.points;
        Preparation {
            road: self.road_over(settings.road),
            spacing_mm: self.spacing_mm.or(settings.spacing_mm),
            times: self.times.clone().or(settings.times),
            blur_mm: self.blur_mm.unwrap_or(settings.blur_mm),
            threshold: self.threshold.or(settings.threshold),
            edits: settings.edits,
            points: MarkedPoints {
                apex: set.apex.or(points.apex),
                base: set.base.or(points.base),
                septum: set.septum.or(points.septum),
                blood: set.blood.or(points.blood),
            },
            contours: settings.contours,
            vertices: self.vertices.unwrap_or(settings.vertices),
            base: self.base.unwrap_or(settings.base),
            correct_shifts: self.correct_shifts.unwrap_or(settings.correct_shifts),
        }
    }

    fn road_over(&self, road: Road) -> Road {
        match (self.road, self.labels, road) {
            (Some(Road::Masks(_)) | None, Some(labels), _) => Road::Masks(labels),
            // The labels of the settings stay where the road is theirs.
            (Some(Road::Masks(_)), None, Road::Masks(labels)) => Road::Masks(labels),
            (Some(set), _, _) => set,
            (None, None, road) => road,
        }
    }
}
