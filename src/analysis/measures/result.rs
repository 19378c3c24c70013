//! Clinical measures as plain values.

use crate::study::checks::both_phases_at;
use crate::units::{Grams, LengthUnit};

/// Where the frames of end-diastole and end-systole come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PhaseSource {
    /// Greatest and least volume of the blood pool.
    VolumeCurve,
    /// Said by the input or by the user.
    Stated,
}

/// Size of one pose. Volumes are in the subject's shown unit (ml, or cubic file units), areas
/// likewise (cm², or square file units), lengths in coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FrameMeasures {
    /// Volume inside the endocardium or of the cavity, closed at the base.
    pub endo_volume: Option<f64>,
    /// Volume inside the epicardium, closed at the base.
    pub epi_volume: Option<f64>,
    /// Volume of the myocardium: epicardial less endocardial, or that of a closed wall.
    pub wall_volume: Option<f64>,
    /// Area of the endocardium or cavity.
    pub endo_area: Option<f64>,
    /// Area of the epicardium.
    pub epi_area: Option<f64>,
    /// Lowest and highest coordinates of all surfaces.
    pub bounding_box: [[f64; 3]; 2],
}

/// Why a measure is missing though its surfaces are there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MeasureNote {
    /// The only frame is said to be end-systole.
    EndSystoleOnly,
    /// There is one frame.
    OneFrame,
    /// End-diastole and end-systole are the same frame.
    SameFrame(usize),
    /// The cavity has the same volume at both.
    EqualVolumes,
    /// What lies between endocardium and epicardium is no wall: what their check says.
    Wall(String),
}

impl std::fmt::Display for MeasureNote {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::EndSystoleOnly => {
                write!(
                    f,
                    "the only frame is end-systole: no EDV, no ejection fraction"
                )
            }
            Self::OneFrame => write!(f, "one frame: no ESV, no ejection fraction"),
            Self::SameFrame(frame) => write!(f, "{}", both_phases_at(*frame)),
            Self::EqualVolumes => write!(
                f,
                "the cavity has the same volume at end-diastole and end-systole: no ejection fraction"
            ),
            Self::Wall(sentence) => write!(f, "{sentence}"),
        }
    }
}

/// Measures of one subject over the beat.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectMeasures {
    /// Says what the volumes and areas are counted in.
    pub unit: LengthUnit,
    /// One per frame.
    pub frames: Vec<FrameMeasures>,
    /// Frame of end-diastole: that of the study, else that of the greatest cavity; `None` where neither is known.
    pub end_diastole: Option<usize>,
    /// Frame of end-systole: that of the study, else that of the least cavity; `None` where neither is known.
    pub end_systole: Option<usize>,
    /// Who said so.
    pub phase_source: PhaseSource,
    /// End-diastolic volume.
    pub edv: Option<f64>,
    /// End-systolic volume.
    pub esv: Option<f64>,
    /// Stroke volume, EDV − ESV.
    pub sv: Option<f64>,
    /// Ejection fraction, SV / EDV, as a fraction; `None` where no volume changes, which is no beat.
    pub ef: Option<f64>,
    /// Mass of the myocardium at end-diastole, where coordinates are millimetres and the surfaces are those of a wall.
    pub mass: Option<Grams>,
    /// Why measures are missing.
    pub notes: Vec<MeasureNote>,
}
