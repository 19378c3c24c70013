//! The map of whole deformations.

use crate::analysis::deformations::{
    Comparison, DeformationMap, DeformationMapParams, PartParams, PartWeights, deformation_map,
    map_of_parts,
};
use crate::engine::queries::deformation_parts::{
    DeformationPartsQuery, deformation_distance_words, parts_bytes,
};
use crate::engine::queries::pose_map::{PoseMapQuery, map_words};
use crate::engine::store::{Context, Interrupted, Memory, Query};

/// Share of the time of a deformation map that its distances or its pose map take.
const DISTANCE_SHARE: f32 = 0.95;

/// Settings of the map of whole deformations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeformationMapQuery {
    /// The metric by which deformations are compared, and the pose map on which they are curves.
    pub poses: PoseMapQuery,
    /// What is compared, and how it becomes a map.
    pub map: DeformationMapParams,
}

impl DeformationMapQuery {
    /// How both parts of distances are computed.
    pub fn parts(&self) -> PartParams {
        PartParams::like(&self.poses.distances, self.map.smoothing)
    }
}

impl Query for DeformationMapQuery {
    type Answer = DeformationMap;
    const TITLE: &'static str = "Deformation map";
    const FAILURE: Option<&'static str> = Some("The deformation map could not be computed");

    fn parameters(&self) -> String {
        deformation_words(self)
    }

    fn run(&self, cx: &Context<'_>) -> Result<DeformationMap, Interrupted> {
        let params = self.map.check()?;
        if let Comparison::Parts(weights) = self.map.comparison {
            let comparing = "comparing deformations";
            let (parts, share) = cx.first(
                comparing,
                &DeformationPartsQuery(self.parts()),
                DISTANCE_SHARE,
            )?;
            cx.progress()
                .begin_phase("embedding deformations", share, 1.0);
            return Ok(map_of_parts(&parts, weights, &params, cx.progress())?);
        }
        let (poses, share) = cx.first("embedding poses", &self.poses, DISTANCE_SHARE)?;
        let progress = cx.progress();
        progress.begin_phase("embedding deformations", share, 1.0);
        let rows = &poses.distances.poses;
        let embedding = &poses.embedding;
        Ok(deformation_map(
            cx.study(),
            rows,
            embedding,
            &params,
            progress,
        )?)
    }

    fn memory(map: &DeformationMap, memory: &mut Memory) {
        for curve in &map.curves {
            memory.own(size_of_val(&**curve));
        }
        memory.own(size_of_val(&*map.embedding.coordinates));
        if let Some(mapped) = &map.parts {
            memory.own(size_of_val(mapped.distances.upper()));
            memory.shared(&mapped.parts, parts_bytes(&mapped.parts));
        }
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// Settings of a deformation map, as summaries and the activity list say them.
pub fn deformation_words(settings: &DeformationMapQuery) -> String {
    let map = &settings.map;
    let chosen = |typed: Option<String>| typed.unwrap_or_else(|| "automatic".to_owned());
    let neighbours = chosen(map.neighbours.map(|k| k.to_string()));
    let compared = match map.comparison {
        Comparison::Parts(PartWeights { deformation, shape }) => format!(
            "{} by {}, weights {deformation} and {shape}",
            map.comparison.name(),
            deformation_distance_words(&settings.parts())
        ),
        Comparison::Poses => {
            let time = chosen(map.time_weight.map(|w| w.to_string()));
            format!("{}, time weight {time}", map_words(&settings.poses))
        }
    };
    format!("{compared}, neighbours {neighbours}")
}
