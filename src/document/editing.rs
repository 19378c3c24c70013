//! What is being edited: the cell that is typed into, the point that was clicked, what waits until edits are exported.

use std::path::PathBuf;

use crate::engine::OpenSource;
use crate::mesh::Point3;
use crate::study::Revision;

/// What can be typed in the cohort table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TypedField {
    /// The label.
    Label,
    /// The name of the subject: its id.
    Name,
}

/// The cell of the cohort table that is typed into.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Typing {
    /// What is typed.
    pub field: TypedField,
    /// In whose row: index into the study's subjects.
    pub subject: usize,
    /// Who gets what is typed; the subject of the row is one of them.
    pub subjects: Vec<usize>,
}

/// A point of a surface that was clicked, where that vertex is in the first frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PickedPoint {
    /// Whose: index into the study's subjects.
    pub subject: usize,
    /// Where, in the coordinates of the subject.
    pub at: Point3,
}

/// A study that is being written.
#[derive(Clone, Debug)]
pub struct StudyExport {
    /// Its manifest.
    pub(crate) manifest: PathBuf,
    /// What is written.
    pub(crate) revision: Revision,
    /// What it is left for once it is written.
    pub(crate) then: Option<Leaving>,
}

/// What would leave a study with edits that are not exported.
#[derive(Clone, Debug, PartialEq)]
pub enum Leaving {
    /// Another study in its place.
    Open(OpenSource),
    /// The same study, read once more with links that lead out of it.
    FollowLinks,
    /// The end of the program.
    Quit,
}
