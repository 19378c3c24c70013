//! Clinical measures as plain values.

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

/// Measures of one subject over the beat.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectMeasures {
    /// Says what the volumes and areas are counted in.
    pub unit: LengthUnit,
    /// One per frame.
    pub frames: Vec<FrameMeasures>,
    /// Frame of the greatest filling; `None` where no volume can be told.
    pub end_diastole: Option<usize>,
    /// Frame of the least filling.
    pub end_systole: Option<usize>,
    /// Who said so.
    pub phase_source: PhaseSource,
    /// End-diastolic volume.
    pub edv: Option<f64>,
    /// End-systolic volume.
    pub esv: Option<f64>,
    /// Stroke volume, EDV − ESV.
    pub sv: Option<f64>,
    /// Ejection fraction, SV / EDV, as a fraction.
    pub ef: Option<f64>,
    /// Mass of the myocardium at end-diastole, where coordinates are millimetres.
    pub mass: Option<Grams>,
}
