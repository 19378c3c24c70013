//! Distances of all poses, and settings of a metric in words.

use crate::analysis::metrics::{Corners, CurvatureRole, MetricParams};
use crate::analysis::pose_distances::{
    KnownDistances, PoseDistanceParams, PoseDistances, pose_distances_knowing,
};
use crate::analysis::transport::Reference;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::study::Study;

/// Distances of all poses of the study, with these settings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseDistancesQuery(pub PoseDistanceParams);

impl Query for PoseDistancesQuery {
    type Answer = PoseDistances;
    const TITLE: &'static str = "Pose distances";

    fn parameters(&self) -> String {
        distance_words(&self.0)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::all_shapes(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<PoseDistances, Interrupted> {
        cx.progress().begin_phase("comparing poses", 0.0, 1.0);
        let checked = self.0.check()?;
        // After an edit only the distances to poses of the edited subjects are computed.
        let similar = cx.similar(self);
        let similar = similar.and_then(|(state, distances)| Some((state.shape_keys()?, distances)));
        let known = similar
            .as_ref()
            .map(|(shapes, distances)| KnownDistances { shapes, distances });
        let known = known.as_ref();
        Ok(pose_distances_knowing(cx.study(), &checked, known, cx.progress())?.distances)
    }

    fn memory(distances: &PoseDistances, memory: &mut Memory) {
        memory.own(distances_bytes(distances));
    }

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// Memory that distances hold.
pub(super) fn distances_bytes(distances: &PoseDistances) -> usize {
    size_of_val(distances.distances.upper()) + size_of_val(&*distances.poses)
}

/// How poses are compared, as summaries and the activity list say it.
pub fn distance_words(params: &PoseDistanceParams) -> String {
    let mut metric = metric_words(&params.metric);
    if params.smoothing > 0.0 {
        metric += &format!(", smoothed over {} √area", params.smoothing);
    }
    match params.transport {
        None => metric,
        Some(transport) => match transport.reference {
            Reference::Mean => format!("{metric}, transported onto the mean"),
            Reference::Subject(index) => format!("{metric}, transported onto subject {index}"),
        },
    }
}

/// A metric with the settings that matter to it, as the activity list and figures say it.
pub fn metric_words(metric: &MetricParams) -> String {
    let kind = metric.kind.words().id;
    if !metric.kind.has_forms() {
        return kind.to_owned();
    }
    let form = metric.form.id();
    let curvature = if metric.curvature_role() == CurvatureRole::Term {
        format!(", μ = {}", metric.mu)
    } else {
        String::new()
    };
    let corners = match metric.corners {
        Corners::Raw => "corner terms as printed",
        Corners::ScaleFree => "scale-invariant corner terms",
    };
    format!(
        "{kind}, {form} form{curvature}, {corners}, λ = {}",
        metric.lambda
    )
}
