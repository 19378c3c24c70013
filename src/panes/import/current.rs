//! Whose images are imported and by which settings, and how far that is.

use std::sync::Arc;

use crate::analysis::preparation::{Asked, Preparation, Road, asked};
use crate::document::{Document, ImportStep};
use crate::engine::{
    ImagePreviewQuery, ImageProposal, ImageProposalQuery, ImageTissuesQuery, ImageWallsQuery,
    MadeWalls, SeriesRef, Showing,
};
use crate::io::ImageSeries;
use crate::panes::commands::{Command, ImportCommand};
use crate::panes::pane_context::PaneContext;

/// Images with the settings of their import.
#[derive(Clone)]
pub struct Current {
    /// Index of the images.
    pub images: usize,
    /// Whose they are.
    pub id: String,
    /// The series that walls are made of.
    pub series: Arc<ImageSeries>,
    /// What is known of it.
    pub found: Arc<ImageProposal>,
    /// What somebody set, else what is proposed.
    pub settings: Arc<Preparation>,
}

impl Current {
    /// The images on screen; `None` where there are none, or they are not looked at yet.
    pub fn shown(cx: &PaneContext<'_>) -> Option<Self> {
        let document = &cx.state().document;
        let series = document.shown_series()?;
        Self::of_series(cx, document.slices.images?, series)
    }

    /// Images by their index; of several series the first.
    pub fn of(cx: &PaneContext<'_>, images: usize) -> Option<Self> {
        let document = &cx.state().document;
        if document.slices.images == Some(images) {
            return Self::shown(cx);
        }
        let series = document.images().get(images)?.series.first()?;
        Self::of_series(cx, images, series)
    }

    fn of_series(cx: &PaneContext<'_>, images: usize, series: &Arc<ImageSeries>) -> Option<Self> {
        let document = &cx.state().document;
        let query = ImageProposalQuery(SeriesRef(Arc::clone(series)));
        let found = Arc::clone(cx.ask(&query).ready()?);
        let set = document.import.settings.get(&images).cloned();
        Some(Self {
            images,
            id: document.images().get(images)?.id.clone(),
            series: Arc::clone(series),
            settings: set.unwrap_or_else(|| Arc::new(found.proposal.preparation.clone())),
            found,
        })
    }

    /// What somebody must say before there are walls.
    pub fn needed(&self) -> Vec<Asked> {
        let mut asked = asked(&self.found.facts, &self.settings);
        asked.retain(|asked| asked.is_needed());
        asked
    }

    /// The question for what is cavity and what wall.
    pub fn tissues_query(&self) -> ImageTissuesQuery {
        ImageTissuesQuery {
            series: SeriesRef(Arc::clone(&self.series)),
            settings: Arc::clone(&self.settings),
        }
    }

    /// The question for the walls.
    pub fn walls_query(&self) -> ImageWallsQuery {
        ImageWallsQuery {
            id: self.id.clone(),
            tissues: self.tissues_query(),
        }
    }

    /// The question for the surface that is shown while a threshold is set; outlines have none.
    pub fn preview_query(&self, document: &Document) -> Option<ImagePreviewQuery> {
        let has_surface = matches!(self.settings.road, Road::Spect | Road::Masks(_));
        has_surface.then(|| ImagePreviewQuery {
            series: SeriesRef(Arc::clone(&self.series)),
            instant: document.instant(),
            settings: Arc::clone(&self.settings),
        })
    }

    /// The walls, if nothing is missing. While a setting is dragged nothing new begins.
    pub fn ask_walls(&self, cx: &PaneContext<'_>) -> Option<Showing<MadeWalls>> {
        let complete = self.needed().is_empty();
        complete.then(|| cx.ask_at_rest(&self.walls_query()))
    }

    /// Changed settings as a command; `drag` makes all changes of a drag one step of undo.
    pub fn changed(&self, drag: bool, change: impl FnOnce(&mut Preparation)) -> Option<Command> {
        let mut settings = Preparation::clone(&self.settings);
        change(&mut settings);
        // What cannot be computed with is never set.
        let usable = settings != *self.settings && settings.check().is_ok();
        usable.then(|| {
            let set = ImportCommand::Set {
                images: self.images,
                settings: Arc::new(settings),
                drag,
            };
            set.into()
        })
    }
}

/// Whether the walls of images are wanted: those on screen from their step on, and all of a batch.
pub fn wants_walls(document: &Document, images: usize) -> bool {
    let shown = document.slices.images == Some(images);
    document.import.batch || (shown && document.import.step >= ImportStep::Walls)
}

/// What a step is called, by the road.
pub fn step_name(step: ImportStep, road: Road) -> &'static str {
    match (step, road) {
        (ImportStep::Images, _) => "Images",
        (ImportStep::Orientation, _) => "Orientation",
        (ImportStep::Tissue, Road::Masks(_)) => "Labels and edits",
        (ImportStep::Tissue, Road::Spect) => "Threshold and edits",
        (ImportStep::Tissue, Road::Cine | Road::Contours) => "Contours",
        (ImportStep::Walls, _) => "Walls",
        (ImportStep::Cohort, _) => "Cohort",
    }
}
