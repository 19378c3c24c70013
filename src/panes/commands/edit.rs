//! Undo and redo, and edits of the study: labels, names, who belongs to the cohort, units, landmarks, phases.

use super::action::{CTRL, Menu, NONE, Row, SHIFT, row};
use crate::document::{PickedPoint, TypedField, Typing};
use crate::study::{CoordinateUnit, LabelClass, Landmark};
use egui::Key;

/// Undo and redo, and edits of the study. Each edit is one step of undo.
#[derive(Clone, Debug, PartialEq)]
pub enum EditCommand {
    /// Undo the last change of state.
    Undo,
    /// Take the last undo back.
    Redo,
    /// Type into the row of the selected subject.
    TypeInRow(TypedField),
    /// Type into a row of the cohort table, for these subjects.
    Type(Typing),
    /// Type no more; nothing is changed.
    StopTyping,
    /// Label subjects; an empty label is none.
    SetLabel {
        /// Indices into the study's subjects.
        subjects: Vec<usize>,
        /// Their label.
        label: String,
    },
    /// Give a subject another id.
    Rename {
        /// Index into the study's subjects.
        subject: usize,
        /// No other subject has it.
        id: String,
    },
    /// What the label of a subject counts as, wherever it stands.
    SetClass(Whose, LabelClass),
    /// Leave a subject out of all analyses of the cohort.
    Exclude(Whose),
    /// Count an excluded subject again.
    Include(Whose),
    /// Take a subject out of the study; nothing is deleted on disk.
    Delete(Whose),
    /// In what the files of subjects count.
    SetUnit(Whose, CoordinateUnit),
    /// A frame of end-diastole or end-systole.
    SetPhase(Whose, Phase, PhaseFrame),
    /// The point that was clicked last, which landmarks are set to.
    Pick(Option<PickedPoint>),
    /// Set a landmark to the point that was clicked last.
    SetLandmark(Landmark),
    /// Let go of all landmarks of a subject.
    ClearLandmarks(Whose),
}

/// Which subjects an edit concerns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whose {
    /// The selected one.
    Selected,
    /// That of an index into the study's subjects.
    Subject(usize),
    /// All of the study.
    All,
}

/// A phase of the cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// The ventricle is full.
    EndDiastole,
    /// The ventricle has contracted.
    EndSystole,
}

impl Phase {
    /// The word in menus.
    pub fn name(self) -> &'static str {
        match self {
            Self::EndDiastole => "end-diastole",
            Self::EndSystole => "end-systole",
        }
    }
}

/// Which frame is a phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseFrame {
    /// The one on screen.
    Shown,
    /// This one.
    Frame(usize),
    /// The one that the volume curve tells.
    Found,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<EditCommand>] = &[
    row(Menu::Edit, 0, "Undo", Some((CTRL, Key::Z)), EditCommand::Undo),
    row(Menu::Edit, 0, "Redo", Some((CTRL.plus(SHIFT), Key::Z)), EditCommand::Redo),
    row(Menu::Edit, 2, "Edit label…", Some((NONE, Key::L)), EditCommand::TypeInRow(TypedField::Label)),
    row(Menu::Edit, 2, "Class of the label: normal", None, EditCommand::SetClass(Whose::Selected, LabelClass::Normal)),
    row(Menu::Edit, 2, "Class of the label: abnormal", None, EditCommand::SetClass(Whose::Selected, LabelClass::Abnormal)),
    row(Menu::Edit, 2, "Class of the label: other", None, EditCommand::SetClass(Whose::Selected, LabelClass::Neither)),
    row(Menu::Edit, 2, "Rename subject…", None, EditCommand::TypeInRow(TypedField::Name)),
    row(Menu::Edit, 3, "End-diastole: this frame", None, EditCommand::SetPhase(Whose::Selected, Phase::EndDiastole, PhaseFrame::Shown)),
    row(Menu::Edit, 3, "End-diastole: from the volume curve", None, EditCommand::SetPhase(Whose::Selected, Phase::EndDiastole, PhaseFrame::Found)),
    row(Menu::Edit, 3, "End-systole: this frame", None, EditCommand::SetPhase(Whose::Selected, Phase::EndSystole, PhaseFrame::Shown)),
    row(Menu::Edit, 3, "End-systole: from the volume curve", None, EditCommand::SetPhase(Whose::Selected, Phase::EndSystole, PhaseFrame::Found)),
    row(Menu::Edit, 3, "Unit: millimetres", None, EditCommand::SetUnit(Whose::Selected, CoordinateUnit::Millimetre)),
    row(Menu::Edit, 3, "Unit: centimetres", None, EditCommand::SetUnit(Whose::Selected, CoordinateUnit::Centimetre)),
    row(Menu::Edit, 3, "Unit: metres", None, EditCommand::SetUnit(Whose::Selected, CoordinateUnit::Metre)),
    row(Menu::Edit, 3, "Unit: unknown", None, EditCommand::SetUnit(Whose::Selected, CoordinateUnit::Unknown)),
    row(Menu::Edit, 3, "Unit of all subjects: millimetres", None, EditCommand::SetUnit(Whose::All, CoordinateUnit::Millimetre)),
    row(Menu::Edit, 3, "Unit of all subjects: centimetres", None, EditCommand::SetUnit(Whose::All, CoordinateUnit::Centimetre)),
    row(Menu::Edit, 3, "Unit of all subjects: metres", None, EditCommand::SetUnit(Whose::All, CoordinateUnit::Metre)),
    row(Menu::Edit, 3, "Unit of all subjects: unknown", None, EditCommand::SetUnit(Whose::All, CoordinateUnit::Unknown)),
    row(Menu::Edit, 3, "Landmarks: apex at the clicked point", None, EditCommand::SetLandmark(Landmark::Apex)),
    row(Menu::Edit, 3, "Landmarks: base at the clicked point", None, EditCommand::SetLandmark(Landmark::Base)),
    row(Menu::Edit, 3, "Landmarks: septum at the clicked point", None, EditCommand::SetLandmark(Landmark::Septum)),
    row(Menu::Edit, 3, "Landmarks: anterior wall at the clicked point", None, EditCommand::SetLandmark(Landmark::Anterior)),
    row(Menu::Edit, 3, "Landmarks: none", None, EditCommand::ClearLandmarks(Whose::Selected)),
    row(Menu::Edit, 4, "Exclude from the cohort", None, EditCommand::Exclude(Whose::Selected)),
    row(Menu::Edit, 4, "Include in the cohort", None, EditCommand::Include(Whose::Selected)),
    row(Menu::Edit, 4, "Delete from the study", Some((NONE, Key::Delete)), EditCommand::Delete(Whose::Selected)),
];
