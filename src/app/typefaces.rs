//! Typefaces for the names of a study in letters that the window's own faces lack.

use std::borrow::Cow;
use std::convert::Infallible;

use egui::Context;

use crate::document::state::State;
use crate::engine::{Engine, Job};
use crate::picture::page::{FacesFor, faces_for, letter_code};
use crate::study::Revision;
use crate::ui;

use super::errors::push_card;

/// Letters that a card names.
const MAX_NAMED: usize = 5;

/// Looks for faces once a study is opened, off the window's thread.
#[derive(Default)]
pub struct Typefaces {
    /// The state of the study whose names were looked at.
    revision: Revision,
    job: Option<Job<FacesFor, Infallible>>,
}

impl Typefaces {
    /// Asks for the faces of a study that is new on screen, and takes in what was found. Call once a frame.
    pub fn poll(&mut self, ctx: &Context, state: &mut State, engine: &Engine) {
        let revision = state.document.study().revision;
        if self.revision != revision {
            self.revision = revision;
            let texts = foreign_texts(state);
            self.job = (!texts.is_empty()).then(|| {
                engine.spawn_aside(move |_| Ok(faces_for(texts.iter().map(String::as_str))))
            });
        }
        let Some(found) = self.job.as_mut().and_then(Job::poll) else {
            return;
        };
        self.job = None;
        match found {
            Ok(found) => take_in(ctx, state, found),
            Err(error) => {
                let title = "Some names may not be legible";
                push_card(&mut state.errors, title, error.to_string());
            }
        }
    }
}

/// Names and labels of the study that hold more than the letters of western Europe, all of which Inter has.
fn foreign_texts(state: &State) -> Vec<String> {
    let study = state.document.study();
    let texts = study
        .all()
        .flat_map(|subject| [Some(&subject.id), subject.label.as_ref()]);
    let foreign = |text: &&String| text.contains(|c: char| c.is_control() || c > '\u{17f}');
    let texts = texts.flatten().chain(std::iter::once(&study.name));
    texts.filter(foreign).cloned().collect()
}

fn take_in(ctx: &Context, state: &mut State, found: FacesFor) {
    let codes = found.codes.map(|bytes| (Cow::Owned(bytes), 0));
    let faces = found.faces.into_iter();
    let faces = faces.map(|(bytes, index)| (Cow::Borrowed(bytes), index));
    let faces: Vec<(Cow<'static, [u8]>, u32)> = faces.chain(codes).collect();
    if !faces.is_empty() {
        ui::add_faces(ctx, faces);
    }
    if !found.without.is_empty() {
        let mut named: Vec<String> = (found.without.iter().take(MAX_NAMED))
            .map(|letter| letter_code(*letter))
            .collect();
        if found.without.len() > MAX_NAMED {
            named.push("…".to_owned());
        }
        let reason = format!(
            "their codes are shown: {}; a font package for the script adds them",
            named.join(", ")
        );
        let title = "No typeface on this machine has some letters of this study";
        push_card(&mut state.errors, title, reason);
    }
}
