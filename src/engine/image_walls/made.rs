//! One study of images: its walls, what must be said first, or why there are none.

use std::path::PathBuf;
use std::sync::Arc;

use super::studies::ImageStudy;
use super::{ImageWallSettings, ImageWalls, prepared_subject, series_facts};
use crate::analysis::preparation::{
    Asked, Preparation, PreparationError, Prepared, asked, prepared, proposed,
};
use crate::analysis::walls_from_masks::SurfaceFit;
use crate::io::{ImageSeries, OpenError, OpenedImages};
use crate::progress::{Progress, Stopped};
use crate::study::{Notice, Subject};

/// What became of the images of one subject.
pub(super) struct Made {
    /// `None` where a subject was made of outlines alone.
    pub images: Option<OpenedImages>,
    pub outcome: Outcome,
}

pub(super) enum Outcome {
    /// Walls, with the settings that they were made with.
    Walls(Box<Subject>, Vec<SurfaceFit>, Box<Preparation>),
    /// Somebody must say more.
    Asked(Vec<Asked>),
    /// No heart can be expected in the images; why is among their notes.
    Unsuitable,
    /// No walls.
    Failed(OpenError),
}

/// Makes the walls of one study.
///
/// # Errors
/// Only if it was asked to stop.
pub(super) fn made_of(
    study: ImageStudy,
    settings: &ImageWallSettings,
    progress: &Progress,
) -> Result<Made, Stopped> {
    let ImageStudy { id, path, series } = study;
    let mut notices = Vec::new();
    if series.len() > 1 {
        notices.push(Notice::info(format!(
            "walls are made of 1 of {} series of the study",
            series.len()
        )));
    }
    let series: Vec<Arc<ImageSeries>> = series.into_iter().map(Arc::new).collect();
    let outcome = match series.first() {
        Some(first) => outcome(&id, path, first, settings, &mut notices, progress)?,
        None => Outcome::Unsuitable,
    };
    let made = match &outcome {
        Outcome::Walls(subject, ..) => Some(subject.sequence.id()),
        _ => None,
    };
    let images = OpenedImages {
        id,
        series,
        notices,
        made,
    };
    Ok(Made {
        images: Some(images),
        outcome,
    })
}

fn outcome(
    id: &str,
    path: PathBuf,
    series: &ImageSeries,
    settings: &ImageWallSettings,
    notices: &mut Vec<Notice>,
    progress: &Progress,
) -> Result<Outcome, Stopped> {
    let facts = series_facts(series);
    let proposal = proposed(&facts);
    let preparation = settings.of(id, proposal.preparation);
    let needed: Vec<Asked> = asked(&facts, &preparation);
    let needed: Vec<Asked> = needed
        .into_iter()
        .filter(|asked| asked.is_needed())
        .collect();
    // Labels that are not known are asked for, though nothing else is known of the image.
    let is_asked = needed.contains(&Asked::Labels);
    if !settings.is_set(id) && !proposal.suitable && !is_asked {
        notices.push(Notice::warning(format!(
            "no walls are made: {}",
            proposal.reason
        )));
        return Ok(Outcome::Unsuitable);
    }
    if !needed.is_empty() {
        let words: Vec<&str> = needed.iter().map(|asked| asked.words()).collect();
        notices.push(Notice::warning(format!(
            "{}: walls need {}, by somebody who sees the images or by options of mesh",
            preparation.road.words(),
            words.join(", ")
        )));
        return Ok(Outcome::Asked(needed));
    }
    match prepared(&series.image, &preparation, progress) {
        Ok(prepared) => Ok(walls_of(id, series, preparation, prepared)),
        Err(PreparationError::Stopped(stopped)) => Err(stopped),
        Err(error) => Ok(Outcome::Failed(failure(id, path, &error))),
    }
}

/// The subject of walls, and what is told with it.
pub(super) fn walls_of(
    id: &str,
    series: &ImageSeries,
    preparation: Preparation,
    prepared: Prepared,
) -> Outcome {
    let fits = prepared.walls.fits.clone();
    let subject = prepared_subject(id, series, &preparation, prepared);
    Outcome::Walls(Box::new(subject), fits, Box::new(preparation))
}

/// The error of a study that has a name.
pub(super) fn failure(id: &str, path: PathBuf, error: &dyn std::fmt::Display) -> OpenError {
    OpenError {
        subject: Some(id.to_owned()),
        path,
        reason: format!("{id}: {error}"),
    }
}

impl Made {
    /// Puts it to the others.
    pub fn add_to(self, walls: &mut ImageWalls) {
        let id = self.images.as_ref().map(|images| images.id.clone());
        match self.outcome {
            Outcome::Walls(subject, fits, preparation) => {
                let id = subject.id.clone();
                let fits = fits.into_iter().map(|fit| (id.clone(), fit));
                walls.fits.extend(fits);
                walls.opened.study.subjects.push(Arc::new(*subject));
                walls.preparations.push((id, *preparation));
            }
            Outcome::Asked(asked) => walls.asked.extend(id.map(|id| (id, asked))),
            Outcome::Unsuitable => {}
            Outcome::Failed(error) => walls.opened.errors.push(error),
        }
        walls.opened.images.extend(self.images);
    }
}
