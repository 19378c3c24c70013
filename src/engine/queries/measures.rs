//! Volumes and ejection fraction of every subject.

use std::sync::Arc;

use crate::analysis::measures::{SubjectMeasures, measure_study, measure_subject};
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query, Urgency};
use crate::study::{Study, Subject};

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

/// Clinical measures of one subject, for what is on screen before those of all are known; both are equal.
#[derive(Clone, Debug)]
pub struct SubjectMeasuresQuery(pub Arc<Subject>);

impl PartialEq for SubjectMeasuresQuery {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Query for SubjectMeasuresQuery {
    type Answer = SubjectMeasures;
    const TITLE: &'static str = "Volumes and ejection fraction of a subject";
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, _: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, _: &Context<'_>) -> Result<SubjectMeasures, Interrupted> {
        Ok(measure_subject(&self.0))
    }

    fn memory(subject: &SubjectMeasures, memory: &mut Memory) {
        memory.own(size_of_val(&*subject.frames));
    }

    fn replaces(&self, other: &Self) -> bool {
        self.0.sequence.id() == other.0.sequence.id()
    }
}
