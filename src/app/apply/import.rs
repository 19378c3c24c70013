//! Commands about the import of images.

use std::sync::Arc;

use crate::analysis::preparation::Preparation;
use crate::document::state::State;
use crate::document::undo::Gesture;
use crate::panes::ImportCommand;

use super::change::{Moment, change};
use super::effect::Effect;

/// Radii of the eraser in millimetres.
const ERASER_MM: std::ops::RangeInclusive<f64> = 1.0..=100.0;

/// Applies a command about an import; what reaches beyond the state comes back as an effect.
pub fn apply(state: &mut State, command: ImportCommand, moment: &Moment) -> Option<Effect> {
    match command {
        ImportCommand::UseTool(tool) => {
            // The same once more lays it down.
            state.image_tool = tool.filter(|_| state.image_tool != tool);
        }
        ImportCommand::GoTo(step) => {
            state.image_tool = None;
            change(state, moment, None, |d| d.import.step = step);
        }
        ImportCommand::Step(step) => {
            state.image_tool = None;
            change(state, moment, None, |d| {
                d.import.step = d.import.step.stepped(step).unwrap_or(d.import.step);
            });
        }
        ImportCommand::Set {
            images,
            settings,
            drag,
        } => {
            if images < state.document.images().len() {
                change(state, moment, drag.then_some(Gesture::Import), |d| {
                    d.import.settings.insert(images, settings);
                });
            }
        }
        ImportCommand::Reset(images) => change(state, moment, None, |d| {
            d.import.settings.remove(&images);
        }),
        ImportCommand::SetAll { settings } => set_all(state, moment, settings),
        ImportCommand::SetEraser(radius_mm) => change(state, moment, Some(Gesture::Import), |d| {
            if ERASER_MM.contains(&radius_mm) {
                d.import.eraser_mm = radius_mm;
            }
        }),
        ImportCommand::ToggleBatch => change(state, moment, None, |d| {
            d.import.batch = !d.import.batch;
        }),
        ImportCommand::Add(images) => return Some(Effect::AddWalls(images)),
    }
    None
}

fn set_all(state: &mut State, moment: &Moment, settings: Vec<Arc<Preparation>>) {
    let count = state.document.images().len();
    change(state, moment, None, |d| {
        d.import.settings = settings.into_iter().take(count).enumerate().collect();
    });
}
