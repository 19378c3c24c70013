//! What edits do to the state, and how they are taken back, without a window.

use super::*;
use crate::analysis::transport::{CohortTransportParams, Reference};
use crate::app::apply::apply;
use crate::document::testing::{state_of, subject_with_frames};
use crate::document::{TypedField, ViewMode};
use crate::mesh::{Point3, phantom};
use crate::panes::{Command, FileCommand, PlaybackCommand, SelectCommand, ViewCommand};
use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

/// A state with subjects a, b, c, d, and a revision for each edit.
struct Edited {
    state: State,
    revision: u64,
}

impl Edited {
    fn new() -> Self {
        let subjects = ["a", "b", "c", "d"].map(|id| subject_with_frames(id, 4));
        Self {
            state: state_of(subjects.to_vec()),
            revision: 100,
        }
    }

    fn give(&mut self, command: impl Into<Command>) -> Vec<Effect> {
        self.revision += 1;
        let moment = Moment {
            now_s: self.revision as f64,
            pointer_held: false,
            fresh_revision: Revision(self.revision),
        };
        apply(&mut self.state, command.into(), &moment)
    }

    fn select(&mut self, subject: usize) {
        self.give(SelectCommand::SelectSubject(subject));
    }

    fn ids(&self) -> Vec<String> {
        let subjects = self.state.document.study().subjects.iter();
        subjects.map(|subject| subject.id.clone()).collect()
    }

    fn selected(&self) -> &str {
        &self.state.document.selected().unwrap().id
    }

    fn card(&self) -> String {
        let card = self.state.errors.last();
        card.map_or_else(String::new, |card| {
            format!("{}: {}", card.title, card.message)
        })
    }
}

#[test]
fn whatever_names_a_subject_follows_it_when_another_one_is_excluded() {
    let mut edited = Edited::new();
    edited.select(2);
    edited.give(SelectCommand::CompareWith(Some(3)));
    edited.give(ViewCommand::SetViewMode(ViewMode::SideBySide));
    edited.state.document.map.distances.transport = Some(CohortTransportParams {
        reference: Reference::Subject(1),
        ..CohortTransportParams::default()
    });
    let before = edited.state.document.clone();
    edited.give(EditCommand::Exclude(Whose::Subject(0)));
    assert_eq!(edited.ids(), ["b", "c", "d"]);
    let document = &edited.state.document;
    assert_eq!(edited.selected(), "c");
    assert_eq!((document.subject, document.compare_with), (1, Some(2)));
    let reference = |document: &crate::document::Document| {
        document
            .map
            .distances
            .transport
            .map(|transport| transport.reference)
    };
    assert_eq!(reference(document), Some(Reference::Subject(0)));
    // A reference that is excluded is none of the cohort any more.
    edited.give(EditCommand::Exclude(Whose::Subject(0)));
    assert_eq!(reference(&edited.state.document), None);
    edited.give(EditCommand::Undo);
    edited.give(EditCommand::Undo);
    assert_eq!(edited.state.document, before);
    edited.give(EditCommand::Redo);
    assert_eq!(edited.ids(), ["b", "c", "d"]);
    assert_eq!(edited.selected(), "c");
}

#[test]
fn an_excluded_subject_stays_selected_and_can_be_included_again() {
    let mut edited = Edited::new();
    edited.select(1);
    edited.give(EditCommand::Exclude(Whose::Selected));
    assert_eq!(edited.selected(), "b");
    assert_eq!(edited.state.document.subject, 3);
    assert_eq!(edited.state.message, "Excluded b");
    edited.give(EditCommand::Include(Whose::Selected));
    assert_eq!(edited.ids(), ["a", "b", "c", "d"]);
    assert_eq!(edited.state.document.subject, 1);
}

#[test]
fn what_holds_for_the_cohort_is_said_anew_after_an_edit_and_after_undo() {
    let mut edited = Edited::new();
    let says = |edited: &Edited, words: &str| {
        let notices = &edited.state.document.study.report.notices;
        notices
            .iter()
            .filter(|notice| notice.text.contains(words))
            .count()
    };
    let units = "some subjects are in mm and some in file units";
    for (unit, count) in [
        (CoordinateUnit::Unknown, 1),
        (CoordinateUnit::Millimetre, 0),
    ] {
        edited.give(EditCommand::SetUnit(Whose::Subject(0), unit));
        assert_eq!(says(&edited, units), count);
    }
    edited.give(EditCommand::Undo);
    assert_eq!(says(&edited, units), 1);
    edited.give(EditCommand::Exclude(Whose::Subject(0)));
    assert_eq!(says(&edited, units), 0);
    assert_eq!(says(&edited, "3 subjects have the same faces"), 1);
    edited.give(EditCommand::Include(Whose::Subject(3)));
    assert_eq!(says(&edited, units), 1);
    assert_eq!(says(&edited, "have the same faces"), 1);
}

#[test]
fn a_deleted_subject_leaves_the_next_one_selected_and_undo_brings_it_back() {
    let mut edited = Edited::new();
    edited.select(1);
    edited.give(EditCommand::Delete(Whose::Selected));
    assert_eq!(edited.ids(), ["a", "c", "d"]);
    assert_eq!(edited.selected(), "c");
    edited.select(2);
    edited.give(EditCommand::Delete(Whose::Selected));
    assert_eq!(edited.selected(), "c");
    for (count, selected) in [(3, "d"), (3, "c"), (4, "b")] {
        edited.give(EditCommand::Undo);
        assert_eq!((edited.ids().len(), edited.selected()), (count, selected));
    }
}

#[test]
fn the_only_subject_of_a_cohort_is_kept_and_the_reason_said() {
    let mut edited = Edited::new();
    for _ in 0..3 {
        edited.give(EditCommand::Exclude(Whose::Subject(0)));
    }
    let revision = edited.state.document.study().revision;
    edited.give(EditCommand::Exclude(Whose::Subject(0)));
    assert_eq!(
        edited.card(),
        "d was not excluded: d is the only subject of the cohort"
    );
    edited.give(EditCommand::Delete(Whose::Subject(0)));
    assert!(edited.card().starts_with("d was not deleted"));
    assert_eq!(edited.state.document.study().revision, revision);
}

#[test]
fn a_name_that_is_taken_or_empty_is_refused_in_words() {
    let mut edited = Edited::new();
    let rename = |id: &str| EditCommand::Rename {
        subject: 0,
        id: id.to_owned(),
    };
    edited.give(rename("b"));
    assert_eq!(
        edited.card(),
        "a was not renamed: another subject has the id b"
    );
    edited.give(rename("  "));
    assert_eq!(edited.card(), "a was not renamed: an id cannot be empty");
    assert!(!edited.state.history.can_undo());
    edited.give(rename(" P41 "));
    assert_eq!(edited.ids()[0], "P41");
    edited.give(EditCommand::Undo);
    assert_eq!(edited.ids()[0], "a");
}

#[test]
fn labels_of_many_subjects_are_one_step_of_undo_and_the_same_again_is_none() {
    let mut edited = Edited::new();
    let label = EditCommand::SetLabel {
        subjects: vec![0, 2],
        label: "MINF".to_owned(),
    };
    edited.give(label.clone());
    edited.give(label);
    edited.give(EditCommand::SetClass(
        Whose::Subject(2),
        LabelClass::Abnormal,
    ));
    let study = edited.state.document.study();
    assert_eq!(study.class_of(&study.subjects[0]), LabelClass::Abnormal);
    edited.give(EditCommand::Undo);
    edited.give(EditCommand::Undo);
    assert!(!edited.state.history.can_undo());
    assert!(edited.state.document.study().labels().is_empty());
}

#[test]
fn one_frame_is_not_both_phases_and_the_reason_is_said() {
    let mut edited = Edited::new();
    let set = |phase, frame| EditCommand::SetPhase(Whose::Subject(1), phase, frame);
    edited.give(set(Phase::EndSystole, PhaseFrame::Frame(2)));
    edited.give(set(Phase::EndDiastole, PhaseFrame::Frame(2)));
    assert_eq!(
        edited.card(),
        "Frame 2 of b is not end-diastole: it is end-systole already, and one frame cannot be both: set another frame \
         as end-systole first"
    );
    assert_eq!(edited.state.phases_of(1), (None, Some(2)));
    // The frame on screen is that of the selected subject alone.
    edited.give(set(Phase::EndDiastole, PhaseFrame::Shown));
    assert_eq!(edited.state.phases_of(1), (None, Some(2)));
    edited.select(1);
    edited.give(PlaybackCommand::SetPosition(1.0));
    edited.give(set(Phase::EndDiastole, PhaseFrame::Shown));
    assert_eq!(edited.state.phases_of(1), (Some(1), Some(2)));
    edited.give(set(Phase::EndSystole, PhaseFrame::Found));
    assert_eq!(edited.state.phases_of(1), (Some(1), None));
}

#[test]
fn centimetres_are_shown_in_millimetres_and_can_be_corrected() {
    let mut edited = Edited::new();
    let side = |edited: &Edited, index: usize| {
        let subject = edited.state.subject(index).unwrap();
        subject.sequence.surfaces()[0].frames()[0].vertices()[0]
            .coords
            .norm()
    };
    edited.give(EditCommand::SetUnit(
        Whose::Subject(1),
        CoordinateUnit::Unknown,
    ));
    assert_eq!(edited.state.subject(1).unwrap().unit, LengthUnit::FileUnit);
    assert!((side(&edited, 1) - 30.0).abs() < 1e-9);
    edited.give(EditCommand::SetUnit(Whose::All, CoordinateUnit::Centimetre));
    for index in 0..4 {
        assert!((side(&edited, index) - 300.0).abs() < 1e-9);
        let subject = edited.state.subject(index).unwrap();
        assert_eq!(subject.unit, LengthUnit::Millimetre);
        assert_eq!(subject.coordinate_unit(), CoordinateUnit::Centimetre);
        let notice = subject.notices.last().unwrap();
        assert_eq!(notice.text, "unit set by the user: centimetres");
        let about_units = subject
            .notices
            .iter()
            .filter(|n| n.text.contains("unit set"));
        assert_eq!(about_units.count(), 1);
    }
    edited.give(EditCommand::SetUnit(
        Whose::Subject(1),
        CoordinateUnit::Metre,
    ));
    assert!(
        (side(&edited, 1) - 30_000.0).abs() < 1e-6,
        "of the file, not of what was shown"
    );
    edited.give(EditCommand::Undo);
    edited.give(EditCommand::Undo);
    assert_eq!(edited.state.subject(1).unwrap().unit, LengthUnit::FileUnit);
    assert!((side(&edited, 0) - 30.0).abs() < 1e-12);
}

fn open_bowl(id: &str) -> Subject {
    let bowl = SurfaceSequence::new(SurfaceKind::Endocardium, vec![phantom::bowl(25.0, 8, 16)]);
    let sequence = MeshSequence::new(vec![bowl.unwrap()]).unwrap();
    Subject::new(id, sequence, LengthUnit::Millimetre)
}

#[test]
fn one_click_on_the_septum_of_an_open_ventricle_names_its_segments() {
    let mut edited = Edited::new();
    edited.state = state_of(vec![open_bowl("a")]);
    let axis = long_axis(edited.state.subject(0).unwrap(), 0).unwrap();
    let up = axis.direction();
    let across = up.cross(&axis.left).cross(&up);
    let pick = |at: Point3| EditCommand::Pick(Some(PickedPoint { subject: 0, at }));
    edited.give(EditCommand::SetLandmark(Landmark::Septum));
    assert!(!edited.state.history.can_undo(), "nothing was clicked");
    edited.give(pick(axis.base + across * 20.0));
    edited.give(EditCommand::SetLandmark(Landmark::Septum));
    let anatomy = edited.state.subject(0).unwrap().anatomy.unwrap();
    assert!((anatomy.septal - across).norm() < 1e-9);
    assert!((anatomy.apex - axis.apex).norm() < 1e-9);
    assert!(
        (anatomy.anterior - up.cross(&across)).norm() < 1e-9,
        "as in the body"
    );
    // A heart that is its mirror image has the anterior wall on the other side, and keeps it.
    edited.give(pick(axis.base - up.cross(&across) * 20.0));
    edited.give(EditCommand::SetLandmark(Landmark::Anterior));
    edited.give(pick(axis.base - across * 20.0));
    edited.give(EditCommand::SetLandmark(Landmark::Septum));
    let anatomy = edited.state.subject(0).unwrap().anatomy.unwrap();
    assert!((anatomy.septal + across).norm() < 1e-9);
    assert!((anatomy.anterior - up.cross(&across)).norm() < 1e-9);
    edited.give(EditCommand::ClearLandmarks(Whose::Selected));
    assert!(!edited.state.subject(0).unwrap().has_landmarks());
    for _ in 0..4 {
        edited.give(EditCommand::Undo);
    }
    assert!(!edited.state.history.can_undo());
    assert!(!edited.state.subject(0).unwrap().has_landmarks());
}

#[test]
fn of_a_closed_surface_apex_base_and_septum_are_needed_and_what_is_missing_is_said() {
    let mut edited = Edited::new();
    for (landmark, at, said) in [
        (
            Landmark::Apex,
            [0.0, 0.0, -30.0],
            "segments need the septum, too",
        ),
        (
            Landmark::Septum,
            [30.0, 0.0, 0.0],
            "segments need apex and base, too",
        ),
        (Landmark::Base, [0.0, 0.0, 30.0], "a: base set"),
    ] {
        let at = Point3::from(at);
        edited.give(EditCommand::Pick(Some(PickedPoint { subject: 0, at })));
        edited.give(EditCommand::SetLandmark(landmark));
        assert!(
            edited.state.message.ends_with(said),
            "{}",
            edited.state.message
        );
    }
    let anatomy = edited.state.subject(0).unwrap().anatomy.unwrap();
    assert_eq!(anatomy.septal, crate::mesh::Vector3::x());
}

#[test]
fn typing_has_the_row_in_sight_and_ends_with_the_list() {
    let mut edited = Edited::new();
    edited.give(ViewCommand::SetSearch("b".to_owned()));
    let effects = edited.give(EditCommand::TypeInRow(TypedField::Label));
    assert_eq!(effects, [Effect::ShowPane(Pane::COHORT)]);
    assert_eq!(edited.state.document.search, "", "the row was filtered out");
    assert_eq!(edited.state.typing.as_ref().unwrap().subjects, [0]);
    edited.give(EditCommand::Delete(Whose::Subject(3)));
    assert_eq!(
        edited.state.typing, None,
        "a row may be another subject's now"
    );
}

#[test]
fn another_study_is_opened_over_edits_only_when_it_is_said_so() {
    let mut edited = Edited::new();
    assert_eq!(edited.give(FileCommand::Quit), [Effect::Quit]);
    edited.give(EditCommand::Exclude(Whose::Subject(0)));
    assert!(edited.state.is_edited());
    assert_eq!(edited.give(FileCommand::Quit), []);
    assert!(edited.state.leaving.is_some());
    edited.give(FileCommand::Stay);
    assert!(edited.state.leaving.is_none());
    assert_eq!(edited.give(FileCommand::Open(vec!["x".into()])), []);
    let effects = edited.give(FileCommand::Leave);
    assert!(matches!(effects.as_slice(), [Effect::Open(_)]));
    assert_eq!(edited.give(FileCommand::Leave), [], "asked once, left once");
    edited.give(EditCommand::Undo);
    assert!(!edited.state.is_edited(), "what was opened is there again");
    assert_eq!(edited.give(FileCommand::Quit), [Effect::Quit]);
}
