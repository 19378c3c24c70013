//! Commands that edit the study: each is one step of undo, and says in words why it is refused.

use std::sync::Arc;

use crate::analysis::segments::long_axis;
use crate::io::renew_cohort_notices;
use crate::panes::cohort::view::visible_subjects;
use crate::panes::{EditCommand, Pane, Phase, PhaseFrame, Whose};
use crate::study::{CoordinateUnit, EditError, LabelClass, Landmark, Revision, Study, Subject};

use super::change::{Moment, change};
use super::effect::Effect;
use crate::app::errors::push_card;
use crate::document::document::OpeningReport;
use crate::document::{PickedPoint, State, Typing};

/// Applies an edit of the study.
pub fn apply(state: &mut State, command: EditCommand, moment: &Moment) -> Option<Effect> {
    match command {
        // Applied where the history is.
        EditCommand::Undo | EditCommand::Redo => {}
        EditCommand::TypeInRow(field) => {
            let subject = state.document.selected_index()?;
            let subjects = vec![subject];
            return type_into(
                state,
                moment,
                Typing {
                    field,
                    subject,
                    subjects,
                },
            );
        }
        EditCommand::Type(typing) => return type_into(state, moment, typing),
        EditCommand::StopTyping => state.typing = None,
        EditCommand::SetLabel { subjects, label } => {
            state.typing = None;
            let study = state.document.study();
            let labelled = study.labelling(&subjects, &label, moment.fresh_revision);
            let pairs = study.all().zip(labelled.all());
            if { pairs }.any(|(before, now)| before.label != now.label) {
                edit(state, moment, |_, _| labelled);
            }
        }
        EditCommand::Rename { subject, id } => rename(state, moment, subject, &id),
        EditCommand::SetClass(whose, class) => {
            let label = (state.subject(one(state, whose)?)?.label).clone()?;
            set_class(state, moment, &label, class);
        }
        EditCommand::Exclude(whose) => {
            let index = one(state, whose)?;
            relist(
                state,
                moment,
                index,
                ["Excluded", "excluded"],
                Study::excluding,
            );
        }
        EditCommand::Include(whose) => {
            let index = one(state, whose)?;
            relist(
                state,
                moment,
                index,
                ["Included", "included"],
                Study::including,
            );
        }
        EditCommand::Delete(whose) => {
            let index = one(state, whose)?;
            relist(
                state,
                moment,
                index,
                ["Deleted", "deleted"],
                Study::removing,
            );
        }
        EditCommand::SetUnit(whose, unit) => set_unit(state, moment, whose, unit),
        EditCommand::SetPhase(whose, phase, frame) => {
            let index = one(state, whose)?;
            set_phase(state, moment, index, phase, frame);
        }
        EditCommand::Pick(point) => state.picked = point,
        EditCommand::SetLandmark(landmark) => {
            let point = state.picked?;
            set_landmark(state, moment, landmark, point);
        }
        EditCommand::ClearLandmarks(whose) => {
            let index = one(state, whose)?;
            edit_subject(state, moment, index, |subject| {
                subject.anatomy = None;
                subject.picked = Default::default();
            });
        }
    }
    None
}

/// The one subject that a command concerns.
fn one(state: &State, whose: Whose) -> Option<usize> {
    match whose {
        Whose::Selected => state.document.selected_index(),
        Whose::Subject(index) => state.subject(index).map(|_| index),
        Whose::All => None,
    }
}

/// Shows an edited study in which all subjects keep their indices.
fn edit(state: &mut State, moment: &Moment, edit: impl FnOnce(&Study, Revision) -> Study) {
    let edited = edit(state.document.study(), moment.fresh_revision);
    change(state, moment, None, |document| document.show_edited(edited));
}

fn edit_subject(
    state: &mut State,
    moment: &Moment,
    index: usize,
    change: impl FnOnce(&mut Subject),
) {
    let Some(subject) = state.subject(index) else {
        return;
    };
    let mut edited = Subject::clone(subject);
    change(&mut edited);
    if edited != **subject {
        edit(state, moment, |study, revision| {
            study.with_subject(index, edited, revision)
        });
    }
}

/// Edits who belongs to the cohort or the study; says what was done.
fn relist(
    state: &mut State,
    moment: &Moment,
    index: usize,
    [done, refused]: [&str; 2],
    edit: impl FnOnce(&Study, usize, Revision) -> Result<Study, EditError>,
) {
    let id = state.subject(index).map(|subject| subject.id.clone());
    let id = id.unwrap_or_default();
    match edit(state.document.study(), index, moment.fresh_revision) {
        Ok(study) => {
            let report = report_after(state, &study);
            change(state, moment, None, |document| {
                document.show_relisted(study);
                document.study.report = report;
            });
            state.play.playing = false;
            state.message = format!("{done} {id}");
        }
        Err(why) => {
            let title = format!("{id} was not {refused}");
            push_card(&mut state.errors, title, why.to_string());
        }
    }
}

/// The load report, with what holds for the cohort as it is after an edit.
fn report_after(state: &State, edited: &Study) -> Arc<OpeningReport> {
    let mut report = OpeningReport::clone(&state.document.study.report);
    renew_cohort_notices(&mut report.notices, [state.document.study(), edited]);
    Arc::new(report)
}

/// Opens the row of a subject for typing, and has it in sight.
fn type_into(state: &mut State, moment: &Moment, typing: Typing) -> Option<Effect> {
    state.subject(typing.subject)?;
    if !visible_subjects(state).contains(&typing.subject) {
        change(state, moment, None, |document| document.search.clear());
    }
    state.typing = Some(typing);
    Some(Effect::ShowPane(Pane::COHORT))
}

fn rename(state: &mut State, moment: &Moment, index: usize, id: &str) {
    state.typing = None;
    let Some(subject) = state.subject(index) else {
        return;
    };
    let id = id.trim().to_owned();
    if let Err(why) = state.document.study().check_id(index, &id) {
        let title = format!("{} was not renamed", subject.id);
        return push_card(&mut state.errors, title, why.to_string());
    }
    edit_subject(state, moment, index, |subject| subject.id = id);
}

fn set_class(state: &mut State, moment: &Moment, label: &str, class: LabelClass) {
    if state.document.study().label_classes.class_of(Some(label)) != class {
        edit(state, moment, |study, revision| {
            study.with_class(label, class, revision)
        });
    }
}

fn set_unit(state: &mut State, moment: &Moment, whose: Whose, unit: CoordinateUnit) {
    let study = state.document.study();
    if whose == Whose::All && !study.unread.is_empty() {
        let why = EditError::StillReading.to_string();
        return push_card(&mut state.errors, "The unit was not changed", why);
    }
    let indices = match whose {
        Whose::All => (0..study.count()).collect(),
        Whose::Selected | Whose::Subject(_) => Vec::from_iter(one(state, whose)),
    };
    let others = indices.into_iter().filter_map(|index| {
        let subject = study.subject(index)?;
        (subject.coordinate_unit() != unit).then(|| (index, subject.in_unit(unit)))
    });
    let others: Vec<(usize, Subject)> = others.collect();
    if others.is_empty() {
        return;
    }
    let count = others.len();
    let edited = study.with_subjects(others, moment.fresh_revision);
    let report = report_after(state, &edited);
    change(state, moment, None, |document| {
        document.show_edited(edited);
        document.study.report = report;
    });
    // It counts in the unit before.
    state.picked = None;
    state.message = match count {
        1 => format!("Unit of 1 subject: {}", unit.name()),
        _ => format!("Unit of {count} subjects: {}", unit.name()),
    };
}

/// One frame cannot be both phases: nothing would be ejected.
fn set_phase(state: &mut State, moment: &Moment, index: usize, phase: Phase, frame: PhaseFrame) {
    let Some(subject) = state.subject(index) else {
        return;
    };
    let frame = match frame {
        PhaseFrame::Found => None,
        PhaseFrame::Frame(frame) => Some(frame),
        PhaseFrame::Shown if state.document.subject == index => Some(state.document.frame()),
        PhaseFrame::Shown => return,
    };
    if frame.is_some_and(|frame| frame >= subject.sequence.frame_count()) {
        return;
    }
    let (end_diastole, end_systole) = state.phases_of(index);
    let (other, other_frame) = match phase {
        Phase::EndDiastole => (Phase::EndSystole, end_systole),
        Phase::EndSystole => (Phase::EndDiastole, end_diastole),
    };
    if let Some(frame) = frame.filter(|frame| Some(*frame) == other_frame) {
        let title = format!("Frame {frame} of {} is not {}", subject.id, phase.name());
        let why = format!(
            "it is {} already, and one frame cannot be both: set another frame as {} first",
            other.name(),
            other.name()
        );
        return push_card(&mut state.errors, title, why);
    }
    edit_subject(state, moment, index, |subject| match phase {
        Phase::EndDiastole => subject.end_diastole = frame,
        Phase::EndSystole => subject.end_systole = frame,
    });
}

fn set_landmark(state: &mut State, moment: &Moment, landmark: Landmark, point: PickedPoint) {
    let Some(subject) = state.subject(point.subject).map(Arc::clone) else {
        return;
    };
    // Of the first frame, as landmarks are.
    let axis = long_axis(&subject, 0)
        .ok()
        .map(|axis| [axis.apex, axis.base]);
    let edited = subject.with_landmark(landmark, point.at, axis);
    let picked = &edited.picked;
    let missing = match (edited.anatomy, picked.septum, axis) {
        (Some(_), ..) => "",
        (None, None, _) => ": segments need the septum, too",
        (None, Some(_), None) => ": segments need apex and base, too",
        (None, Some(_), Some(_)) => ": but landmarks coincide or lie on one line",
    };
    state.message = format!("{}: {} set{missing}", subject.id, landmark.name());
    edit_subject(state, moment, point.subject, |subject| *subject = edited);
}

#[cfg(test)]
mod tests;
