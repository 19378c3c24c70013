//! Both parts of the distances of beats.

use crate::analysis::deformations::{PartDistances, PartParams, part_distances};
use crate::engine::queries::pose_distances::distance_words;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::study::Study;

/// Distances of deformations and of shapes of the study, with these settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeformationPartsQuery(pub PartParams);

impl Query for DeformationPartsQuery {
    type Answer = PartDistances;
    const TITLE: &'static str = "Deformations and shapes";
    const FAILURE: Option<&'static str> = Some("Deformations could not be compared");

    fn parameters(&self) -> String {
        deformation_distance_words(&self.0)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::all_motions(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<PartDistances, Interrupted> {
        cx.progress()
            .begin_phase("comparing deformations", 0.0, 1.0);
        Ok(part_distances(cx.study(), &self.0.check()?, cx.progress())?)
    }

    fn memory(parts: &PartDistances, memory: &mut Memory) {
        memory.own(parts_bytes(parts));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// How deformations and shapes are compared, as the activity list says it.
pub(super) fn deformation_distance_words(params: &PartParams) -> String {
    let motions = distance_words(&params.of_motions());
    format!(
        "{motions}; shapes smoothed over {} √area",
        params.shape_smoothing
    )
}

/// Memory that both parts hold.
pub(super) fn parts_bytes(parts: &PartDistances) -> usize {
    size_of_val(parts.deformation.upper()) + size_of_val(parts.shape.upper())
}
