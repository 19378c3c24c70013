//! One subject of a study with what is said about it.

use crate::units::LengthUnit;

use super::{Anatomy, CycleTiming, MeshSequence, Notice, SequenceId};

/// One subject: its beat, its label and what the input says beside the meshes.
#[derive(Clone, Debug, PartialEq)]
pub struct Subject {
    /// Pseudonym; unique in a study.
    pub id: String,
    /// Free text, such as `normal` or `MINF`.
    pub label: Option<String>,
    /// The surfaces over the beat.
    pub sequence: MeshSequence,
    /// What one unit of the coordinates is.
    pub unit: LengthUnit,
    /// When each frame was taken.
    pub timing: CycleTiming,
    /// Frame of end-diastole as said by the input or the user; found from the volumes if `None`.
    pub end_diastole: Option<usize>,
    /// Frame of end-systole as said by the input or the user; found from the volumes if `None`.
    pub end_systole: Option<usize>,
    /// Body height.
    pub height_cm: Option<f64>,
    /// Body weight.
    pub weight_kg: Option<f64>,
    /// Orientation landmarks, if known.
    pub anatomy: Option<Anatomy>,
    /// What was found and assumed while reading.
    pub notices: Vec<Notice>,
}

/// All that shape analysis reads of a subject: equal keys, equal poses and sizes. An edit of a label
/// leaves it as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ShapeKey {
    /// The surfaces.
    pub sequence: SequenceId,
    /// The frame that says how large the subject is, where the beat begins, and from where motion counts.
    pub end_diastole: Option<usize>,
}

impl Subject {
    /// What its shapes are known by.
    pub fn shape_key(&self) -> ShapeKey {
        ShapeKey {
            sequence: self.sequence.id(),
            end_diastole: self.end_diastole,
        }
    }

    /// A subject of which only the meshes are known.
    pub fn new(id: impl Into<String>, sequence: MeshSequence, unit: LengthUnit) -> Self {
        Self {
            id: id.into(),
            label: None,
            sequence,
            unit,
            timing: CycleTiming::default(),
            end_diastole: None,
            end_systole: None,
            height_cm: None,
            weight_kg: None,
            anatomy: None,
            notices: Vec::new(),
        }
    }
}
