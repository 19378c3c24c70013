//! All that is known of how one subject's wall thickens: its atoms, its patches, where on the wall they lie, and whether the wall
//! can be assessed at all.

use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial::MedialBeat;
use crate::analysis::segments::{LongAxis, Polar, Segment, long_axis, polar, segment};
use crate::analysis::thickening::{
    CheckedThickeningParams, Thickening, ThickeningError, phases, thickening,
};
use crate::progress::Progress;
use crate::study::Subject;

use super::{CheckedVerdictParams, NotAssessed, VerdictInput, examine, wall_in_doubt};

/// What window, tables and figures read of one subject.
#[derive(Clone, Debug, PartialEq)]
pub struct SubjectThickening {
    /// Its atoms at every frame.
    pub beat: Arc<MedialBeat>,
    /// How they thicken, and where they do not.
    pub thickening: Thickening,
    /// Why there is no verdict on its wall, where it is not resolved: patches in it may be blur or noise.
    pub not_assessed: Option<NotAssessed>,
    /// The long axis at end-diastole.
    pub axis: Option<LongAxis>,
    /// Why there is no axis, where there is none.
    pub without_axis: Option<String>,
    /// Per atom, in which segment it lies at end-diastole; all `None` where septum and anterior wall are not known.
    pub segments: Vec<Option<Segment>>,
    /// Per atom, its place on the bull's-eye at end-diastole; all `None` without an axis.
    pub polar: Vec<Option<Polar>>,
}

impl SubjectThickening {
    /// From the atoms and measures of a subject.
    ///
    /// # Errors
    /// As [`thickening()`].
    pub fn new(
        subject: &Subject,
        beat: Arc<MedialBeat>,
        measures: &SubjectMeasures,
        params: &CheckedThickeningParams,
        verdicts: &CheckedVerdictParams,
        progress: &Progress,
    ) -> Result<Self, ThickeningError> {
        let end_diastole = phases(&beat, measures)[0];
        let (axis, without_axis) = match long_axis(subject, end_diastole) {
            Ok(axis) => (Some(axis), None),
            Err(error) => (None, Some(error.to_string())),
        };
        let assessed = thickening(&beat, measures, axis.as_ref(), params, progress)?;
        let centres = beat.frames[end_diastole].positions();
        let input = VerdictInput {
            beat: &beat,
            thickening: &assessed,
        };
        Ok(Self {
            not_assessed: wall_in_doubt(subject).or_else(|| examine(&input, verdicts).err()),
            beat,
            thickening: assessed,
            segments: (centres.iter())
                .map(|&point| segment(axis.as_ref()?, point))
                .collect(),
            polar: (centres.iter())
                .map(|&point| Some(polar(axis.as_ref()?, point)))
                .collect(),
            axis,
            without_axis,
        })
    }
}
