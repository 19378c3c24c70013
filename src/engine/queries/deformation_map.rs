//! The map of whole deformations.

use crate::analysis::deformations::{DeformationMap, DeformationMapParams, deformation_map};
use crate::engine::queries::pose_map::{PoseMapQuery, map_words};
use crate::engine::store::{Context, Interrupted, Memory, Query};

/// Share of the time of a deformation map that its pose map takes.
const POSE_MAP_SHARE: f32 = 0.95;

/// Settings of the map of whole deformations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeformationMapQuery {
    /// The pose map on which deformations are curves.
    pub poses: PoseMapQuery,
    /// How curves become a map.
    pub map: DeformationMapParams,
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
        let (poses, share) = cx.first("embedding poses", &self.poses, POSE_MAP_SHARE)?;
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
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// Settings of a deformation map, as the activity list says them.
pub(super) fn deformation_words(settings: &DeformationMapQuery) -> String {
    let DeformationMapParams {
        time_weight,
        neighbours,
        ..
    } = settings.map;
    let chosen = |typed: Option<String>| typed.unwrap_or_else(|| "automatic".to_owned());
    let time = chosen(time_weight.map(|w| w.to_string()));
    let neighbours = chosen(neighbours.map(|k| k.to_string()));
    let poses = map_words(&settings.poses);
    format!("{poses}, time weight {time}, neighbours {neighbours}")
}
