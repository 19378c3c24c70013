//! What is said over the picture of a subject, as plain values.

use std::borrow::Cow;

use super::patch_note::PatchNote;
use crate::panes::commands::Command;
use crate::ui::label_marks::LabelMark;

/// What is said over the 3D picture of a subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SubjectCaption {
    /// Pseudonym; empty when nothing is shown.
    pub title: String,
    /// What may stand in a second line of the title: " on N03".
    pub title_end: String,
    /// "MINF · frame 1 of 2 · ES".
    pub subtitle: String,
    /// Shape beside the title.
    pub mark: LabelMark,
    /// Whether the picture is between two poses, or estimated, and how: `interpolated`.
    pub badge: Option<Cow<'static, str>>,
    /// More about the badge, for whoever points at it; may be empty.
    pub badge_note: String,
    /// What ends the special state that the title names: words of the button and its command.
    pub leave: Option<(&'static str, Command)>,
    /// The patches of this subject: number, size, segments.
    pub patch: Option<PatchNote>,
}
