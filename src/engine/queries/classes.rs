//! How well classes are separated by deformations.

use crate::analysis::classification::{Classes, ClassesParams, classify};
use crate::analysis::deformations::deformation_distances;
use crate::engine::queries::deformation_map::{DeformationMapSettings, deformation_words};
use crate::engine::store::{Context, Interrupted, Memory, Query};

/// Share of the time of the classification that the deformation map takes.
const DEFORMATION_MAP_SHARE: f32 = 0.8;

/// Settings of the classification.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClassesSettings {
    /// The distances and the map that classifiers read.
    pub deformations: DeformationMapSettings,
    /// How classifiers are trained and tested.
    pub classes: ClassesParams,
}

impl Query for ClassesSettings {
    type Answer = Classes;
    const TITLE: &'static str = "Classes";
    const FAILURE: Option<&'static str> = Some("The subjects could not be classified");

    fn parameters(&self) -> String {
        let ClassesParams {
            permutations, seed, ..
        } = self.classes;
        let map = deformation_words(&self.deformations);
        format!("{map}, {permutations} permutations, seed {seed}")
    }

    fn run(&self, cx: &Context<'_>) -> Result<Classes, Interrupted> {
        let params = self.classes.check()?;
        let mapping = "embedding deformations";
        let (map, share) = cx.first(mapping, &self.deformations, DEFORMATION_MAP_SHARE)?;
        let part = cx.part("classifying", share, 1.0);
        let poses = part.get(&self.deformations.poses.distances)?;
        let (study, progress) = (cx.study(), part.progress());
        let deformations = deformation_distances(study, &poses, progress)?;
        let labels: Vec<Option<&str>> = (deformations.subjects.iter())
            .map(|&index| study.subjects.get(index)?.label.as_deref())
            .collect();
        progress.begin_phase("classifying", 0.0, 1.0);
        let distances = &deformations.distances;
        Ok(classify(
            distances,
            &map.embedding,
            &labels,
            &params,
            progress,
        )?)
    }

    fn memory(classes: &Classes, memory: &mut Memory) {
        memory.own(size_of_val(&*classes.of_row) + size_of_val(&*classes.clustering.clusters));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}
