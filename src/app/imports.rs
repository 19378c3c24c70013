//! Walls that were made of images go into the study, and images that were opened bring their panes.

use std::sync::Arc;

use crate::analysis::preparation::Preparation;
use crate::document::Document;
use crate::document::state::State;
use crate::engine::{ImageTissuesQuery, ImageWallsQuery, MadeWalls, SeriesRef, Store};
use crate::panes::{Command, Pane, WindowCommand};
use crate::study::{Revision, Study, Subject};
use crate::ui::text::counted;

use super::apply::{Moment, change};

/// Puts the walls of images by these settings into the study, as one step of undo: in the place of the surfaces of the
/// subject of the images, or as a further subject. What is not made yet stays out.
pub fn add_walls(
    state: &mut State,
    store: &Store,
    images: &[(usize, Arc<Preparation>)],
    moment: &Moment,
) {
    let document = &state.document;
    let made: Vec<(usize, Arc<MadeWalls>)> = (images.iter())
        .filter_map(|(images, settings)| {
            let query = walls_query(document, *images, settings)?;
            Some((*images, store.known(document.study(), &query)?))
        })
        .collect();
    let [(first, _), ..] = made.as_slice() else {
        state.message = "No walls are made yet".to_owned();
        return;
    };
    let (first, count) = (*first, made.len());
    let study = with_walls(document, &made, moment.fresh_revision);
    change(state, moment, None, |d| {
        d.show_relisted(study);
        // Whose walls were just made is looked at.
        if let Some(subject) = d.subject_of_images(first).filter(|_| count == 1) {
            d.select_subject(subject);
        }
    });
    state.leave_listing();
    state.message = match made.as_slice() {
        [(_, one)] => format!("{} is in the cohort", one.subject.id),
        _ => format!("{} are in the cohort", counted(count, "subject")),
    };
}

/// The question whose answer the walls of images are; of several series that on screen, else the first.
fn walls_query(
    document: &Document,
    images: usize,
    settings: &Arc<Preparation>,
) -> Option<ImageWallsQuery> {
    let entry = document.images().get(images)?;
    let shown = document.shown_series();
    let shown = shown.filter(|_| document.slices.images == Some(images));
    Some(ImageWallsQuery {
        id: entry.id.clone(),
        tissues: ImageTissuesQuery {
            series: SeriesRef(Arc::clone(shown.or(entry.series.first())?)),
            settings: Arc::clone(settings),
        },
    })
}

fn with_walls(document: &Document, made: &[(usize, Arc<MadeWalls>)], revision: Revision) -> Study {
    let study = document.study();
    let (mut changed, mut added) = (Vec::new(), Study::default());
    for (images, walls) in made {
        let known = document.subject_of_images(*images);
        let known = known.and_then(|index| Some((index, study.subject(index)?)));
        match known {
            Some((index, before)) => changed.push((index, with_facts(&walls.subject, before))),
            None => added.subjects.push(Arc::clone(&walls.subject)),
        }
    }
    let study = study.with_subjects(changed, revision);
    match added.subjects.is_empty() {
        true => study,
        false => study.adding(&added, revision),
    }
}

/// The new walls with what was known of the subject.
fn with_facts(walls: &Subject, before: &Subject) -> Subject {
    Subject {
        id: before.id.clone(),
        label: before.label.clone(),
        height_cm: before.height_cm,
        weight_kg: before.weight_kg,
        ..walls.clone()
    }
}

/// The panes that images bring when they are opened: in front where somebody must say something before there are walls,
/// else behind those of the hearts.
pub fn panes_of_images(state: &State) -> Vec<Command> {
    let images = state.document.images();
    if images.is_empty() {
        return Vec::new();
    }
    let mut panes = vec![Pane::IMPORT];
    if images.len() > 1 {
        panes.push(Pane::BATCH);
    }
    panes.push(Pane::SLICES);
    if state.document.selected().is_some() {
        panes.extend([Pane::COHORT, Pane::VIEWPORT]);
    }
    let show = |pane| Command::from(WindowCommand::ShowPane(pane));
    panes.into_iter().map(show).collect()
}
