//! The walls of a series of images by settings: first what the tissues are, then the surfaces as a subject.

use std::sync::Arc;

use crate::analysis::measures::{SubjectMeasures, measure_subject};
use crate::analysis::preparation::{Preparation, Prepared, Segmented, segmented, walls};
use crate::engine::image_walls::prepared_subject;
use crate::engine::queries::image_series::{SeriesRef, interrupted};
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::study::{Study, Subject};

/// What is cavity and what is wall, at each instant.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageTissuesQuery {
    /// Of which images.
    pub series: SeriesRef,
    /// By which settings.
    pub settings: Arc<Preparation>,
}

/// The walls of images as a subject that is not yet in the study.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageWallsQuery {
    /// What the subject is called.
    pub id: String,
    /// From what.
    pub tissues: ImageTissuesQuery,
}

/// A subject made of images.
#[derive(Clone, Debug)]
pub struct MadeWalls {
    /// The subject, with its notes.
    pub subject: Arc<Subject>,
    /// Its volumes.
    pub measures: SubjectMeasures,
    /// What it was made of, and how it fits.
    pub prepared: Prepared,
}

/// Share of the work that finding the tissues takes.
const TISSUES_SHARE: f32 = 0.6;

impl Query for ImageTissuesQuery {
    type Answer = Segmented;
    const TITLE: &'static str = "Find the ventricle in images";

    fn parameters(&self) -> String {
        self.settings.road.words().to_owned()
    }

    fn depends_on(&self, _study: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, cx: &Context<'_>) -> Result<Segmented, Interrupted> {
        segmented(&self.series.0.image, &self.settings, cx.progress()).map_err(interrupted)
    }

    fn memory(segmented: &Segmented, memory: &mut Memory) {
        let instants = segmented.masks.instants().iter();
        let masks: usize = instants.map(|tissues| size_of_val(&**tissues)).sum();
        let contours = segmented.contours.iter();
        let contours: usize = contours.map(|contour| size_of_val(&*contour.points)).sum();
        memory.own(masks + contours);
    }

    fn replaces(&self, other: &Self) -> bool {
        self.series == other.series
    }
}

impl Query for ImageWallsQuery {
    type Answer = MadeWalls;
    const TITLE: &'static str = "Walls from images";

    fn parameters(&self) -> String {
        self.tissues.settings.road.words().to_owned()
    }

    fn depends_on(&self, _study: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, cx: &Context<'_>) -> Result<MadeWalls, Interrupted> {
        let settings = &self.tissues.settings;
        let part = cx.part("finding the ventricle", 0.0, TISSUES_SHARE);
        let segmented = part.get(&self.tissues)?;
        let part = cx.part("making surfaces", TISSUES_SHARE, 1.0);
        let walls = walls(&segmented, settings, part.progress()).map_err(interrupted)?;
        let prepared = Prepared {
            walls,
            instants: segmented.instants.clone(),
            points: segmented.points,
            contours: Arc::clone(&segmented.contours),
            notices: segmented.notices.clone(),
        };
        let series = &self.tissues.series.0;
        let subject = prepared_subject(&self.id, series, settings, prepared.clone());
        Ok(MadeWalls {
            measures: measure_subject(&subject),
            subject: Arc::new(subject),
            prepared,
        })
    }

    fn memory(made: &MadeWalls, memory: &mut Memory) {
        let sequence = &made.subject.sequence;
        let points = sequence.vertex_count() * sequence.frame_count();
        memory.own(points * size_of::<crate::mesh::Point3>());
    }

    fn replaces(&self, other: &Self) -> bool {
        self.id == other.id && self.tissues.series == other.tissues.series
    }
}
