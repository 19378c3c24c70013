//! What a report is made of; all its pages read it.

use crate::analysis::classification::Classes;
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::PoseMap;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::verdicts::Verdicts;
use crate::study::Study;

/// What a report is made of.
#[derive(Clone, Copy, Debug)]
pub struct ReportOrder<'a> {
    /// Its subjects, with their labels.
    pub study: &'a Study,
    /// Measures of every subject, in the order of the study.
    pub measures: &'a [SubjectMeasures],
    /// Verdicts on every subject, and the classifier behind them.
    pub verdicts: &'a Verdicts,
    /// The pose map.
    pub poses: Option<&'a PoseMap>,
    /// The map of whole deformations.
    pub deformations: Option<&'a DeformationMap>,
    /// How well the labels are classified on it.
    pub classes: Option<&'a Classes>,
    /// How all of it was made, in words.
    pub parameters: &'a [String],
}
