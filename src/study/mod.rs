//! What the user opened: subjects, their beating surfaces, the cardiac cycle and the anatomy.

mod anatomy;
pub mod built_in;
mod cardiac_cycle;
pub mod checks;
mod edits;
mod label;
mod mesh_sequence;
mod natural_order;
mod notice;
#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
mod study;
mod subject;

pub use anatomy::{Anatomy, Landmark, Landmarks};
pub use cardiac_cycle::CycleTiming;
pub use edits::EditError;
pub use label::{LabelClass, LabelClasses, plain_label};
pub use mesh_sequence::{
    CorrespondenceKey, MeshSequence, SequenceError, SequenceId, SurfaceKind, SurfaceSequence,
};
pub use natural_order::natural_order;
pub use notice::{Notice, Severity};
pub use study::{ExcludedSubject, ReadSubject, Revision, Study, UnreadSubject};
pub use subject::{CoordinateUnit, ShapeKey, Subject};
