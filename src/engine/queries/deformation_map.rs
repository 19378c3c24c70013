//! The map of whole deformations.

use crate::analysis::deformations::{
    DeformationMap, DeformationMapError, DeformationMapParams, DeformationParamError,
    deformation_map,
};
use crate::engine::queries::pose_map::{PoseMapError, PoseMapParams, map_words};
use crate::engine::store::{Context, Dependencies, Failure, Interrupted, Memory, Query};
use crate::study::Study;

/// Share of the time of a deformation map that its pose map takes.
const POSE_MAP_SHARE: f32 = 0.95;

/// Settings of the map of whole deformations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeformationMapSettings {
    /// The pose map on which deformations are curves.
    pub poses: PoseMapParams,
    /// How curves become a map.
    pub map: DeformationMapParams,
}

/// Why there is no deformation map.
#[derive(Debug, thiserror::Error)]
pub enum DeformationsError {
    /// A setting is out of range.
    #[error(transparent)]
    Settings(#[from] DeformationParamError),
    /// There is no pose map.
    #[error(transparent)]
    Poses(Failure<PoseMapError>),
    /// The curves cannot be mapped.
    #[error(transparent)]
    Map(DeformationMapError),
}

impl Query for DeformationMapSettings {
    type Answer = DeformationMap;
    type Error = DeformationsError;
    const TITLE: &'static str = "Deformation map";
    const FAILURE: Option<&'static str> = Some("The deformation map could not be computed");

    fn parameters(&self) -> String {
        deformation_words(self)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::study(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<DeformationMap, Interrupted<DeformationsError>> {
        let params = (self.map.check()).map_err(|error| Interrupted::Failed(error.into()))?;
        let mapping = cx.part("embedding poses", 0.0, POSE_MAP_SHARE);
        let poses = (mapping.get(&self.poses)).map_err(|why| why.map(DeformationsError::Poses))?;
        let progress = cx.progress();
        progress.begin_phase("embedding deformations", POSE_MAP_SHARE, 1.0);
        let rows = &poses.distances.poses;
        match deformation_map(cx.study(), rows, &poses.embedding, &params, progress) {
            Ok(map) => Ok(map),
            Err(DeformationMapError::Stopped(_)) => Err(Interrupted::Stopped),
            Err(error) => Err(Interrupted::Failed(DeformationsError::Map(error))),
        }
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
pub(super) fn deformation_words(settings: &DeformationMapSettings) -> String {
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
