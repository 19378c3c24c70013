//! The kinds of machines that images come from.

/// The kind of machine that made an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Modality {
    /// Gamma camera: planar or SPECT.
    NuclearMedicine,
    /// Positron emission tomography.
    PositronEmission,
    /// Magnetic resonance.
    MagneticResonance,
    /// Computed tomography.
    ComputedTomography,
    /// Ultrasound.
    Ultrasound,
    /// A segmentation.
    Segmentation,
    /// Another one that the file names.
    Other,
}

impl Modality {
    /// The two or three letters that DICOM gives it.
    pub fn letters(self) -> &'static str {
        match self {
            Self::NuclearMedicine => "NM",
            Self::PositronEmission => "PT",
            Self::MagneticResonance => "MR",
            Self::ComputedTomography => "CT",
            Self::Ultrasound => "US",
            Self::Segmentation => "SEG",
            Self::Other => "OT",
        }
    }
}
