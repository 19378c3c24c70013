//! Which of the series of a study the walls are made of.

use std::cmp::Reverse;

use super::series_facts;
use crate::analysis::preparation::{Road, proposed};
use crate::io::ImageSeries;

/// Series of one study as subjects: of each the series of which walls are made, then the others, which lie with the first.
///
/// Every gated SPECT series is a subject of its own, as rest and stress are; of others the one that fits best is taken: by the
/// road that is set, by what can be expected in it, then by volumes, slices and size.
pub(super) fn chosen(mut series: Vec<ImageSeries>, road: Option<Road>) -> Vec<Vec<ImageSeries>> {
    series.sort_by_cached_key(|series| Reverse(rank(series, road)));
    let mut subjects: Vec<Vec<ImageSeries>> = Vec::new();
    for series in series {
        let own = is_gated_spect(&series, road);
        match subjects.first_mut() {
            Some(first) if !own || !is_gated_spect(&first[0], road) => first.push(series),
            _ => subjects.push(vec![series]),
        }
    }
    subjects
}

fn is_gated_spect(series: &ImageSeries, road: Option<Road>) -> bool {
    let facts = series_facts(series);
    let proposal = proposed(&facts);
    let road = road.unwrap_or(proposal.preparation.road);
    facts.instants > 1 && proposal.suitable && road == Road::Spect && facts.modality.is_some()
}

/// The greater, the better.
fn rank(series: &ImageSeries, road: Option<Road>) -> (bool, bool, bool, usize, usize) {
    let facts = series_facts(series);
    let proposal = proposed(&facts);
    let own = proposal.preparation.road.name();
    let slices = facts.size.iter().copied().min().unwrap_or(0);
    let voxels: usize = facts.size.iter().product();
    (
        road.is_none_or(|road| road.name() == own),
        proposal.suitable,
        facts.instants > 1,
        slices,
        voxels * facts.instants,
    )
}
