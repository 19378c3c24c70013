//! Commands about the classifier from a file that makes the verdicts.

use crate::app::errors::push_card;
use crate::document::state::State;
use crate::panes::RuleCommand;

use super::change::{Moment, change};
use super::effect::Effect;

/// Applies a command about the classifier from a file.
pub fn apply(state: &mut State, command: RuleCommand, moment: &Moment) -> Option<Effect> {
    if state.document.selected().is_none() {
        let why = "there is no study that it could classify";
        push_card(&mut state.errors, "No classifier was opened", why);
        return None;
    }
    match command {
        RuleCommand::Choose => return Some(Effect::ChooseRule),
        RuleCommand::Open(rule) => return Some(Effect::ReadRule { rule, then: None }),
        RuleCommand::Export(path) => return Some(Effect::ExportRule(path)),
        RuleCommand::Use(rule) => {
            state.message = format!("Classified by “{}”", rule.name());
            change(state, moment, None, |document| document.rule = Some(rule));
        }
        RuleCommand::Forget => change(state, moment, None, |document| document.rule = None),
    }
    None
}
