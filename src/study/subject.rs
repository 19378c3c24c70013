//! One subject of a study with what is said about it.

use crate::mesh::Point3;
use crate::units::LengthUnit;

use super::{Anatomy, CycleTiming, Landmark, Landmarks, MeshSequence, Notice, SequenceId};

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
    /// By what the coordinates of the files were multiplied to be those of `sequence`: 10 for centimetres.
    pub scaled_by: f64,
    /// When each frame was taken.
    pub timing: CycleTiming,
    /// Frame of end-diastole as said by the input or the user. Where there is none, measures find it from the volumes, and
    /// shape analysis begins at [`Subject::start_frame`].
    pub end_diastole: Option<usize>,
    /// Frame of end-systole as said by the input or the user; found from the volumes if `None`.
    pub end_systole: Option<usize>,
    /// Body height.
    pub height_cm: Option<f64>,
    /// Body weight.
    pub weight_kg: Option<f64>,
    /// Orientation landmarks, if known.
    pub anatomy: Option<Anatomy>,
    /// Landmarks that the user picked; fewer than the anatomy needs name nothing yet.
    pub picked: Landmarks,
    /// What was found and assumed while reading.
    pub notices: Vec<Notice>,
}

/// How the note on a unit that was set begins.
const UNIT_SET: &str = "unit set by the user: ";

/// All that shape analysis reads of a subject: equal keys, equal poses and sizes. An edit of a label
/// leaves it as it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ShapeKey {
    /// The surfaces.
    pub sequence: SequenceId,
    /// The frame that says how large the subject is, where the beat begins, and from where motion counts.
    pub end_diastole: Option<usize>,
}

/// The unit of length in which the files of a subject count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CoordinateUnit {
    /// Millimetres.
    Millimetre,
    /// Centimetres.
    Centimetre,
    /// Metres.
    Metre,
    /// Voxels, or nobody knows.
    Unknown,
}

impl CoordinateUnit {
    /// All of them.
    pub const ALL: [Self; 4] = [
        Self::Millimetre,
        Self::Centimetre,
        Self::Metre,
        Self::Unknown,
    ];

    /// The word in menus.
    pub fn name(self) -> &'static str {
        match self {
            Self::Millimetre => "millimetres",
            Self::Centimetre => "centimetres",
            Self::Metre => "metres",
            Self::Unknown => "unknown",
        }
    }

    /// By what coordinates are multiplied: to millimetres where the unit is known.
    fn factor(self) -> f64 {
        match self {
            Self::Millimetre | Self::Unknown => 1.0,
            Self::Centimetre => 10.0,
            Self::Metre => 1000.0,
        }
    }
}

impl Subject {
    /// In what its files count.
    pub fn coordinate_unit(&self) -> CoordinateUnit {
        match (self.unit, self.scaled_by) {
            (LengthUnit::FileUnit, _) => CoordinateUnit::Unknown,
            (LengthUnit::Millimetre, 10.0) => CoordinateUnit::Centimetre,
            (LengthUnit::Millimetre, 1000.0) => CoordinateUnit::Metre,
            (LengthUnit::Millimetre, _) => CoordinateUnit::Millimetre,
        }
    }

    /// The subject where its files count in another unit: coordinates and landmarks are in millimetres where that is
    /// known. A note says who set it.
    #[must_use]
    pub fn in_unit(&self, unit: CoordinateUnit) -> Self {
        let mut edited = self.clone();
        let factor = unit.factor() / self.scaled_by;
        if factor != 1.0 {
            edited.sequence = edited.sequence.scaled(factor);
            edited.anatomy = edited.anatomy.map(|anatomy| anatomy.scaled(factor));
            edited.picked = edited.picked.scaled(factor);
        }
        edited.scaled_by = unit.factor();
        edited.unit = match unit {
            CoordinateUnit::Unknown => LengthUnit::FileUnit,
            _ => LengthUnit::Millimetre,
        };
        edited
            .notices
            .retain(|notice| !notice.text.starts_with(UNIT_SET));
        edited
            .notices
            .push(Notice::info(format!("{UNIT_SET}{}", unit.name())));
        edited
    }

    /// Whether any landmark is known or was picked.
    pub fn has_landmarks(&self) -> bool {
        self.anatomy.is_some() || self.picked != Landmarks::default()
    }

    /// The subject with a landmark at a point of its first frame. Where only some landmarks are known, apex and base are
    /// those of `axis`, as its shape has them; the anterior wall is on its usual side of the septum.
    #[must_use]
    pub fn with_landmark(&self, landmark: Landmark, at: Point3, axis: Option<[Point3; 2]>) -> Self {
        let mut edited = self.clone();
        // What the files state is where the picking begins.
        if edited.picked == Landmarks::default()
            && let Some(anatomy) = &self.anatomy
        {
            edited.picked = anatomy.landmarks();
        }
        edited.picked.set(landmark, at);
        let found = self.anatomy.as_ref();
        edited.anatomy = edited
            .picked
            .anatomy(axis, found.map_or(1.0, Anatomy::side));
        edited
    }

    /// The frame at which sizes are taken and from which motions count in distances, maps, transport and experiments: the
    /// end-diastole that was stated, else frame 0, also where the stated one lies beyond the last frame.
    ///
    /// Not that of the volumes, which measures find: a subject without a cavity begins somewhere, too.
    pub fn start_frame(&self) -> usize {
        self.stated_phases().0.unwrap_or(0)
    }

    /// The frames of end-diastole and end-systole that were stated; one beyond the last frame is none.
    pub fn stated_phases(&self) -> (Option<usize>, Option<usize>) {
        let frames = self.sequence.frame_count();
        let there = |stated: Option<usize>| stated.filter(|&frame| frame < frames);
        (there(self.end_diastole), there(self.end_systole))
    }

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
            scaled_by: 1.0,
            timing: CycleTiming::default(),
            end_diastole: None,
            end_systole: None,
            height_cm: None,
            weight_kg: None,
            anatomy: None,
            picked: Landmarks::default(),
            notices: Vec::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{SurfaceKind, SurfaceSequence};

    #[test]
    fn a_subject_begins_at_its_stated_end_diastole_and_at_frame_0_without_or_beyond() {
        let frames = vec![phantom::sphere(1, 1.0), phantom::sphere(1, 2.0)];
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        let mut subject = Subject::new("a", sequence, LengthUnit::Millimetre);
        for (stated, start) in [(None, 0), (Some(0), 0), (Some(1), 1), (Some(2), 0)] {
            subject.end_diastole = stated;
            assert_eq!(subject.start_frame(), start, "{stated:?}");
        }
    }
}
