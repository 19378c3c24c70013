//! The map of all poses.

use crate::analysis::embedding::{MapMethod, PoseMap, embed};
use crate::analysis::pose_distances::PoseDistanceParams;
use crate::engine::queries::pose_distances::{PoseDistancesQuery, distance_words, distances_bytes};
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::study::Study;

/// Share of a map's time that its distances take: some 95 % on 184 poses of 2,500 vertices.
const DISTANCE_SHARE: f32 = 0.95;

/// The map is a plane.
const MAP_DIMENSIONS: usize = 2;

/// Settings of the map of all poses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseMapQuery {
    /// How poses are compared.
    pub distances: PoseDistanceParams,
    /// How distances become a map.
    pub method: MapMethod,
}

impl Query for PoseMapQuery {
    type Answer = PoseMap;
    const TITLE: &'static str = "Pose map";
    const FAILURE: Option<&'static str> = Some("The pose map could not be computed");

    fn parameters(&self) -> String {
        map_words(self)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::all_shapes(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<PoseMap, Interrupted> {
        // Another method of mapping finds the distances known.
        let distances = PoseDistancesQuery(self.distances);
        let (distances, share) = cx.first("comparing poses", &distances, DISTANCE_SHARE)?;
        let progress = cx.progress();
        progress.begin_phase("embedding poses", share, 1.0);
        Ok(PoseMap {
            embedding: embed(&distances.distances, self.method, MAP_DIMENSIONS, progress)?,
            distances,
        })
    }

    fn memory(map: &PoseMap, memory: &mut Memory) {
        memory.shared(&map.distances, distances_bytes(&map.distances));
        memory.own(size_of_val(&*map.embedding.coordinates));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// Settings of a pose map, as the activity list says them.
pub(super) fn map_words(params: &PoseMapQuery) -> String {
    let method = method_words(params.method);
    format!("{}, {method}", distance_words(&params.distances))
}

/// A method of mapping, as the activity list says it.
pub(super) fn method_words(method: MapMethod) -> String {
    match method {
        MapMethod::ClassicalMds => "classical MDS".to_owned(),
        MapMethod::Smacof => "SMACOF".to_owned(),
        MapMethod::Isomap { neighbours } => format!("Isomap of {neighbours} neighbours"),
    }
}
