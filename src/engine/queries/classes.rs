//! How well classes are separated by deformations.

use crate::analysis::classification::{
    Classes, ClassesParamError, ClassesParams, ClassifyError, classify,
};
use crate::analysis::deformations::deformation_distances;
use crate::engine::queries::deformation_map::{
    DeformationMapSettings, DeformationsError, deformation_words,
};
use crate::engine::queries::pose_distances::DistancesError;
use crate::engine::store::{Context, Dependencies, Failure, Interrupted, Memory, Query};
use crate::study::checks::Copies;
use crate::study::{LabelRole, Study};

/// Share of the time of the classification that the deformation map takes.
const DEFORMATION_MAP_SHARE: f32 = 0.8;

/// What the classes are that subjects are told apart by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ClassesBy {
    /// The labels of the study.
    #[default]
    Label,
    /// Normal and abnormal, as the study says of its labels.
    Role,
}

/// Settings of the classification.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClassesSettings {
    /// The distances and the map that classifiers read.
    pub deformations: DeformationMapSettings,
    /// How classifiers are trained and tested.
    pub classes: ClassesParams,
    /// What is told apart.
    pub by: ClassesBy,
}

/// Why there is no classification.
#[derive(Debug, thiserror::Error)]
pub enum ClassesError {
    /// A setting is out of range.
    #[error(transparent)]
    Settings(#[from] ClassesParamError),
    /// There is no deformation map.
    #[error(transparent)]
    Deformations(Failure<DeformationsError>),
    /// There are no distances of poses.
    #[error(transparent)]
    Distances(Failure<DistancesError>),
    /// The classes cannot be classified.
    #[error(transparent)]
    Classes(ClassifyError),
}

impl Query for ClassesSettings {
    type Answer = Classes;
    type Error = ClassesError;
    const TITLE: &'static str = "Classes";
    const FAILURE: Option<&'static str> = Some("The subjects could not be classified");

    fn parameters(&self) -> String {
        let ClassesParams {
            permutations, seed, ..
        } = self.classes;
        let map = deformation_words(&self.deformations);
        let by = match self.by {
            ClassesBy::Label => "",
            ClassesBy::Role => ", normal and abnormal",
        };
        format!("{map}, {permutations} permutations, seed {seed}{by}")
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::study(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<Classes, Interrupted<ClassesError>> {
        let params = (self.classes.check()).map_err(|error| Interrupted::Failed(error.into()))?;
        let mapping = cx.part("embedding deformations", 0.0, DEFORMATION_MAP_SHARE);
        let map =
            (mapping.get(&self.deformations)).map_err(|why| why.map(ClassesError::Deformations))?;
        let part = cx.part("classifying", DEFORMATION_MAP_SHARE, 1.0);
        let poses = (part.get(&self.deformations.poses.distances))
            .map_err(|why| why.map(ClassesError::Distances))?;
        let (study, progress) = (cx.study(), part.progress());
        let deformations = deformation_distances(study, &poses, progress)?;
        // Copies of a subject would be tested on themselves.
        let once = Copies::of(&study.subjects).labels_once(&study.subjects);
        let labels: Vec<Option<&str>> = (deformations.subjects.iter())
            .map(|&index| {
                let label = once.get(index).copied().flatten()?;
                match (self.by, study.label_roles.role(Some(label))) {
                    (ClassesBy::Label, _) => Some(label),
                    (ClassesBy::Role, LabelRole::Normal) => Some("normal"),
                    (ClassesBy::Role, LabelRole::Abnormal) => Some("abnormal"),
                    (ClassesBy::Role, LabelRole::Unknown) => None,
                }
            })
            .collect();
        progress.begin_phase("classifying", 0.0, 1.0);
        let distances = &deformations.distances;
        match classify(distances, &map.embedding, &labels, &params, progress) {
            Ok(classes) => Ok(classes),
            Err(ClassifyError::Stopped(_)) => Err(Interrupted::Stopped),
            Err(error) => Err(Interrupted::Failed(ClassesError::Classes(error))),
        }
    }

    fn memory(classes: &Classes, memory: &mut Memory) {
        memory.own(size_of_val(&*classes.of_row) + size_of_val(&*classes.clustering.clusters));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}
