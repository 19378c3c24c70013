//! How well classes are separated by deformations.

use crate::analysis::classification::{Classes, ClassesParams, classify};
use crate::analysis::deformations::deformation_distances;
use crate::engine::queries::deformation_map::{DeformationMapQuery, deformation_words};
use crate::engine::queries::pose_distances::PoseDistancesQuery;
use crate::engine::store::{Context, Interrupted, Memory, Query};
use crate::study::LabelClass;
use crate::study::checks::Copies;

/// Share of the time of the classification that the deformation map takes.
const DEFORMATION_MAP_SHARE: f32 = 0.8;

/// What the classes are that subjects are classified by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ClassesBy {
    /// The labels of the study.
    #[default]
    Label,
    /// Normal and abnormal, as the study says of its labels.
    Class,
}

impl ClassesBy {
    /// The words on screen.
    pub fn name(self) -> &'static str {
        match self {
            Self::Label => "by label",
            Self::Class => "normal and abnormal",
        }
    }
}

/// Settings of the classification.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClassesQuery {
    /// The distances and the map that classifiers read.
    pub deformations: DeformationMapQuery,
    /// How classifiers are trained and tested.
    pub classes: ClassesParams,
    /// What is classified.
    pub by: ClassesBy,
}

impl Query for ClassesQuery {
    type Answer = Classes;
    const TITLE: &'static str = "Classes";
    const FAILURE: Option<&'static str> = Some("The subjects could not be classified");

    fn parameters(&self) -> String {
        let ClassesParams {
            permutations, seed, ..
        } = self.classes;
        let map = deformation_words(&self.deformations);
        let by = match self.by {
            ClassesBy::Label => "",
            ClassesBy::Class => ", normal and abnormal",
        };
        format!("{map}, {permutations} permutations, seed {seed}{by}")
    }

    fn run(&self, cx: &Context<'_>) -> Result<Classes, Interrupted> {
        let params = self.classes.check()?;
        let mapping = "embedding deformations";
        let (map, share) = cx.first(mapping, &self.deformations, DEFORMATION_MAP_SHARE)?;
        let part = cx.part("classifying", share, 1.0);
        let (study, progress) = (cx.study(), part.progress());
        let of_curves;
        let distances = match &map.parts {
            Some(mapped) => &mapped.distances,
            None => {
                let poses = part.get(&PoseDistancesQuery(self.deformations.poses.distances))?;
                of_curves = deformation_distances(study, &poses, progress)?.distances;
                &of_curves
            }
        };
        // Copies of a subject would be tested on themselves.
        let once = Copies::of(&study.subjects).labels_once(&study.subjects);
        let labels: Vec<Option<&str>> = (map.subjects.iter())
            .map(|&index| {
                let label = once.get(index).copied().flatten()?;
                match (self.by, study.label_classes.class_of(Some(label))) {
                    (ClassesBy::Label, _) => Some(label),
                    (ClassesBy::Class, LabelClass::Normal) => Some("normal"),
                    (ClassesBy::Class, LabelClass::Abnormal) => Some("abnormal"),
                    (ClassesBy::Class, LabelClass::Neither) => None,
                }
            })
            .collect();
        progress.begin_phase("classifying", 0.0, 1.0);
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
