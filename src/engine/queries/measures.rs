//! Volumes and ejection fraction of every subject.

use crate::analysis::measures::{SubjectMeasures, measure_study, measure_subject};
use crate::engine::store::{Context, Interrupted, Memory, Query};

/// Clinical measures of every subject of the study; those of excluded subjects come last, for whoever looks at them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeasuresQuery;

impl Query for MeasuresQuery {
    type Answer = Vec<SubjectMeasures>;
    const TITLE: &'static str = "Volumes and ejection fraction";
    const FAILURE: Option<&'static str> = Some("Volumes could not be computed");

    fn run(&self, cx: &Context<'_>) -> Result<Self::Answer, Interrupted> {
        cx.progress().begin_phase("measuring volumes", 0.0, 1.0);
        let mut measures = measure_study(cx.study(), cx.progress())?;
        let excluded = cx.study().excluded.iter();
        measures.extend(excluded.map(|excluded| measure_subject(&excluded.subject)));
        Ok(measures)
    }

    fn memory(subjects: &Self::Answer, memory: &mut Memory) {
        memory.own(size_of_val(&**subjects));
        for subject in subjects {
            memory.own(size_of_val(&*subject.frames));
        }
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}
