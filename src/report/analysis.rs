//! Everything that an analysis of a study says, in one object.

use serde_json::{Value, json};

use super::measures::{SubjectRow, subjects_json};
use super::summary::{
    beat_shares_json, classification_json, deformations_json, map_json, medial_map_json,
};
use super::verdict_json::verdicts_json;
use crate::analysis::classification::Classes;
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::Embedding;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial_map::MedialMap;
use crate::analysis::metrics::MetricKind;
use crate::analysis::pose_distances::{BeatShares, PoseDistances};
use crate::analysis::verdicts::{VerdictParams, Verdicts};
use crate::study::{LabelClass, Study};

/// What an analysis of a study found, all but the walls themselves, of which there are too many for memory.
#[derive(Clone, Debug)]
pub struct AnalysisReport<'a> {
    /// The subjects.
    pub study: &'a Study,
    /// Their measures.
    pub measures: &'a [SubjectMeasures],
    /// Distances of their poses.
    pub distances: &'a PoseDistances,
    /// How poses are compared, in a sentence.
    pub metric: &'a str,
    /// What distances within beats are made of by that metric, whose kind stands beside.
    pub shares: (&'a BeatShares, MetricKind),
    /// What of two beats is compared and how, in a sentence.
    pub comparison: &'a str,
    /// Pose maps, each with the word for its method.
    pub maps: Vec<(&'static str, &'a Embedding)>,
    /// The deformation map and the classification on it, where there is one.
    pub deformations: Option<(&'a DeformationMap, &'a Classes)>,
    /// The classification of normal and abnormal subjects, where the study says which labels are which.
    pub classes_by_role: Option<&'a Classes>,
    /// Verdicts on the subjects.
    pub verdicts: &'a Verdicts,
    /// How they are made.
    pub verdict_params: &'a VerdictParams,
    /// The map of medial poses, or why there is none.
    pub medial_map: Result<&'a MedialMap, &'a str>,
    /// Thickening of every wall, see [`wall_json`](super::wall_json()).
    pub thickening: &'a Value,
}

impl AnalysisReport<'_> {
    /// `summary.json`, without the list of files.
    pub fn summary(&self) -> Value {
        let study = self.study;
        let count = |class| {
            let subjects = study.subjects.iter();
            subjects
                .filter(|subject| study.class_of(subject) == class)
                .count()
        };
        let left_out = self.distances.left_out.iter().map(|left_out| {
            let id = study.subjects.get(left_out.subject).map(|s| &s.id);
            json!({ "subject": id, "reason": left_out.reason })
        });
        let maps = self.maps.iter();
        let maps = maps.map(|(method, map)| ((*method).to_owned(), map_json(map)));
        let mut summary = json!({
            "program": "Cardiomorph",
            "version": env!("CARGO_PKG_VERSION"),
            "note": "research use, not for diagnosis",
            "study": study.name,
            "labels": {
                "normal": count(LabelClass::Normal),
                "abnormal": count(LabelClass::Abnormal),
                "other": count(LabelClass::Neither),
            },
            "subjects": subjects_json(&SubjectRow::of_study(study, self.measures)),
            "poses": self.distances.poses.len(),
            "metric": self.metric,
            "shares": beat_shares_json(self.shares.0, self.shares.1),
            "left_out": left_out.collect::<Vec<Value>>(),
            "maps": maps.collect::<serde_json::Map<String, Value>>(),
        });
        let mut further = Vec::new();
        if let Some((map, classes)) = self.deformations {
            further.push((
                "deformations",
                deformations_json(study, map, self.comparison),
            ));
            further.push(("classification", classification_json(classes)));
        }
        further.push(("thickening", self.thickening.clone()));
        further.push((
            "verdicts",
            verdicts_json(self.verdicts, self.verdict_params),
        ));
        further.push(("medial_map", medial_map_json(study, self.medial_map)));
        if let Some(classes) = self.classes_by_role {
            further.push((
                "classification_normal_abnormal",
                classification_json(classes),
            ));
        }
        if let Value::Object(object) = &mut summary {
            object.extend(
                further
                    .into_iter()
                    .map(|(key, value)| (key.to_owned(), value)),
            );
        }
        summary
    }
}
