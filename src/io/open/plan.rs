//! What will be read: which files make which surface of which subject, before any mesh is opened.

use std::path::PathBuf;

use crate::io::OpenError;
use crate::study::{Anatomy, LabelClasses, Notice, SurfaceKind};

/// Everything that the paths lead to.
#[derive(Debug, Default)]
pub(super) struct StudyPlan {
    /// As a manifest says.
    pub(super) name: Option<String>,
    /// As a manifest says.
    pub(super) label_classes: Option<LabelClasses>,
    /// In the order of the input.
    pub(super) subjects: Vec<SubjectPlan>,
    /// What is already known to be unreadable.
    pub(super) errors: Vec<OpenError>,
    /// What was assumed about the study as a whole.
    pub(super) notices: Vec<Notice>,
}

/// One heart to be read.
#[derive(Debug)]
pub(super) struct SubjectPlan {
    pub(super) id: String,
    /// What is named where the subject as a whole is wrong: a folder, a manifest or a single file.
    pub(super) place: PathBuf,
    pub(super) surfaces: Vec<SurfacePlan>,
    pub(super) stated: Stated,
    pub(super) notices: Vec<Notice>,
}

/// One surface to be read: files in the order of frames.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SurfacePlan {
    pub(super) kind: KindPlan,
    pub(super) files: Vec<PathBuf>,
    /// Times that a list of files or their names give.
    pub(super) times: Option<SeriesTimes>,
}

/// Which sheet a surface is going to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum KindPlan {
    /// The name or the manifest says so.
    Known(SurfaceKind),
    /// A left ventricle; its shape will tell whether it is the wall or the cavity.
    Ventricle,
    /// Nothing says that it is part of a heart.
    Unnamed,
}

/// Times of frames, in a unit that is to be found out.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SeriesTimes {
    /// One for each frame.
    pub(super) values: Vec<f64>,
    pub(super) source: TimesSource,
}

/// Where times come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum TimesSource {
    /// A `.pvd` or `.series` file, whose formats fix no unit.
    List,
    /// Decimals in the names of files.
    Names,
    /// Names of files with a unit: seconds.
    NamesInSeconds,
    /// Names of files: per cent of the cycle.
    NamesInPercent,
}

/// What a manifest or the names of files say about a subject beside its meshes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Stated {
    pub(super) label: Option<String>,
    pub(super) unit: Option<StatedUnit>,
    pub(super) frame_times_s: Option<Vec<f64>>,
    pub(super) rr_s: Option<f64>,
    pub(super) end_diastole: Option<usize>,
    pub(super) end_systole: Option<usize>,
    pub(super) height_cm: Option<f64>,
    pub(super) weight_kg: Option<f64>,
    pub(super) anatomy: Option<Anatomy>,
    pub(super) excluded: bool,
}

/// The unit of length that a manifest states.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum StatedUnit {
    /// Millimetres after multiplication by this factor.
    Millimetres(f64),
    /// Voxels or something unknown.
    FileUnits,
}

impl StatedUnit {
    /// The unit that a word means.
    pub(super) fn of_word(word: &str) -> Option<Self> {
        Some(match word.trim().to_ascii_lowercase().as_str() {
            "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" => {
                Self::Millimetres(1.0)
            }
            "cm" => Self::Millimetres(10.0),
            "m" => Self::Millimetres(1000.0),
            "file" | "units" | "unknown" | "none" | "voxel" | "voxels" | "arbitrary" => {
                Self::FileUnits
            }
            _ => return None,
        })
    }
}
