//! Commands about the classifier from a file that makes the verdicts.

use crate::app::errors::push_card;
use crate::document::state::State;
use crate::panes::ClassifierCommand;

use super::change::{Moment, change};
use super::effect::Effect;

/// Applies a command about the classifier from a file.
pub fn apply(state: &mut State, command: ClassifierCommand, moment: &Moment) -> Option<Effect> {
    if state.document.selected().is_none() {
        let why = "there is no study that it could classify";
        push_card(&mut state.errors, "No classifier was opened", why);
        return None;
    }
    match command {
        ClassifierCommand::Choose => return Some(Effect::ChooseClassifier),
        ClassifierCommand::Open(rule) => return Some(Effect::ReadClassifier { rule, then: None }),
        ClassifierCommand::Export(path) => return Some(Effect::ExportClassifier(path)),
        ClassifierCommand::Use(rule) => {
            state.message = format!("Classified by “{}”", rule.name());
            change(state, moment, None, |document| document.rule = Some(rule));
        }
        ClassifierCommand::Forget => change(state, moment, None, |document| document.rule = None),
    }
    None
}
