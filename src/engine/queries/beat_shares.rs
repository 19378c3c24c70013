//! What the distances within beats are made of.

use crate::analysis::metrics::{EnergyShares, MetricKind};
use crate::analysis::pose_distances::{BeatShares, PoseDistanceParams, beat_shares};
use crate::engine::queries::pose_distances::distance_words;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::study::Study;

/// Shares of angle, curvature and displacement in the distances within beats, by these settings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeatSharesQuery(pub PoseDistanceParams);

impl Query for BeatSharesQuery {
    type Answer = BeatShares;
    const TITLE: &'static str = "Shares of the metric's terms";
    const FAILURE: Option<&'static str> = Some("Shares could not be computed");

    fn parameters(&self) -> String {
        distance_words(&self.0)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        // End-systole may be edited: it is among the two phases.
        Dependencies::study(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<BeatShares, Interrupted> {
        cx.progress().begin_phase("comparing frames", 0.0, 1.0);
        Ok(beat_shares(cx.study(), &self.0.check()?, cx.progress())?)
    }

    fn memory(_: &BeatShares, _: &mut Memory) {}

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// What distances within beats are made of, as the pane and the report say it.
pub fn share_words(found: &BeatShares, kind: MetricKind) -> String {
    let words = |shares: EnergyShares| {
        let parts = [
            (kind.words().term, shares.own),
            ("change of curvature", shares.curvature),
            ("displacement", shares.displacement),
        ];
        let there = parts.into_iter().filter(|(_, share)| *share > 0.0);
        let parts = there.map(|(part, share)| format!("{part} {:.0} %", 100.0 * share));
        parts.collect::<Vec<String>>().join(", ")
    };
    match (found.phases, found.steps) {
        (Some(phases), Some(steps)) => format!(
            "Medians over {} beats, end-diastole to end-systole: {}; frame to frame: {}",
            found.beats,
            words(phases),
            words(steps)
        ),
        _ => "No beat whose poses differ".to_owned(),
    }
}
