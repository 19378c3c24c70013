//! The map of deformations and what is said of classes: from the latest results, kept until they or the study change.

use std::sync::Arc;

use crate::analysis::classification::{Accuracy, Classes};
use crate::analysis::deformations::DeformationMap;
use crate::app::morph::Morph;
use crate::app::state::State;
use crate::app::views::map_view::{compared, map_state, plane, same_arc};
use crate::engine::{DeformationMapSettings, Interrupted, PoseMapParams, Showing, Topic};
use crate::study::Revision;
use crate::ui::{
    ClassesView, DeformationMapView, DeformationPoint, MapState, MapSubject, MetricPanelView,
    RuleView,
};

/// Fewer deformations have no neighbourhoods.
pub const FEWEST_DEFORMATIONS: usize = 4;

/// How many of those that move most alike are named.
const NAMED_NEIGHBOURS: usize = 3;

type MadeFrom = (
    u64,
    Revision,
    Option<Arc<DeformationMap>>,
    Option<Arc<Classes>>,
    bool,
);

/// Points of the map with what they were made from.
#[derive(Debug, Default)]
pub struct DeformationData {
    made_from: Option<MadeFrom>,
    /// Where points belong.
    targets: Vec<DeformationPoint>,
    /// Where they are now.
    points: Vec<DeformationPoint>,
    rules: Vec<RuleView>,
    morph: Morph,
}

impl DeformationData {
    /// Makes points again where the study or a result changed, and moves those that are under way;
    /// whether any still are. Without `motion` they are there at once.
    pub fn refresh(&mut self, state: &State, now_s: f64, motion: bool) -> bool {
        let opening = state.document.study.opening;
        let revision = state.document.study().revision;
        let (map, classes) = (state.deformations(), state.classes());
        let measured = state.measures().is_some();
        let made = self.made_from.as_ref();
        let same_opening = made.is_some_and(|made| made.0 == opening);
        let same_map = same_opening && made.is_some_and(|made| same_arc(made.2.as_ref(), map));
        let same = same_map
            && made.is_some_and(|made| {
                made.1 == revision && same_arc(made.3.as_ref(), classes) && made.4 == measured
            });
        if !same {
            self.targets = map.map_or_else(Vec::new, |map| points(state, map, classes));
            self.rules = classes.map_or_else(Vec::new, |classes| rules(classes));
            if !same_map {
                self.morph = if motion && same_opening {
                    let targets: Vec<_> = self.targets.iter().map(keyed).collect();
                    Morph::between(self.points.iter().map(keyed), &targets, now_s)
                } else {
                    Morph::default()
                };
            }
            let made = (opening, revision, map.cloned(), classes.cloned(), measured);
            self.made_from = Some(made);
        }
        let moved = self.morph.is_under_way();
        let moves = self.morph.moves(now_s);
        if !same {
            self.points.clone_from(&self.targets);
        }
        if moved || !same {
            for (index, point) in self.points.iter_mut().enumerate() {
                point.at = self.morph.place(index, self.targets[index].at, now_s);
            }
        }
        moves
    }

    /// What the pane shows.
    pub fn view<'a>(
        &'a self,
        state: &State,
        subjects: &'a [MapSubject],
        left_out: &'a str,
    ) -> DeformationMapView<'a> {
        let document = &state.document;
        let map = state.deformations();
        let embedding = map.map(|map| &map.embedding);
        let (map_state, job) = deformation_state(state);
        DeformationMapView {
            state: map_state,
            job,
            subjects,
            points: &self.points,
            selected: document.selected().map(|_| document.subject),
            compared: compared(state),
            neighbours: embedding.and_then(|embedding| embedding.neighbours),
            reconstruction_error: embedding.and_then(|embedding| embedding.reconstruction_error),
            time_weight: map.map(|map| map.time_weight),
            shows_clusters: document.shows_clusters,
            classes: self.classes(state),
            left_out,
        }
    }

    fn classes(&self, state: &State) -> ClassesView<'_> {
        match &state.answers.classes {
            None => ClassesView::Absent,
            Some(Showing::Computing { watch, .. }) if self.rules.is_empty() => {
                ClassesView::Computing {
                    fraction: watch.fraction(),
                }
            }
            Some(_) if !self.rules.is_empty() => ClassesView::Ready(&self.rules),
            Some(Showing::Ready(_)) => {
                ClassesView::Unanswerable("not enough labels; hearts of two classes are needed")
            }
            Some(Showing::Interrupted {
                why: Interrupted::Failed(_),
                ..
            }) => ClassesView::Unanswerable("they could not be classified"),
            Some(_) => ClassesView::Absent,
        }
    }
}

/// How the map stands, and which work holds it up: poses are mapped first.
fn deformation_state(state: &State) -> (MapState, Topic) {
    let poses = map_state(state, state.answers.map.as_ref());
    if poses != MapState::Ready {
        return (poses, Topic::of::<PoseMapParams>());
    }
    let own = if enough_subjects(state) {
        map_state(state, state.answers.deformations.as_ref())
    } else {
        let why = format!("Fewer than {FEWEST_DEFORMATIONS} subjects: no deformation map");
        MapState::Unanswerable(why)
    };
    (own, Topic::of::<DeformationMapSettings>())
}

/// Whether the map of poses holds so many hearts that their deformations can be mapped.
pub fn enough_subjects(state: &State) -> bool {
    state.map().is_some_and(|map| {
        let poses = &map.distances.poses;
        poses.chunk_by(|a, b| a.subject == b.subject).count() >= FEWEST_DEFORMATIONS
    })
}

/// What the panel of settings shows.
pub fn metric_panel_view<'a>(state: &State, subjects: &'a [MapSubject]) -> MetricPanelView<'a> {
    let document = &state.document;
    let map = state.deformations();
    MetricPanelView {
        poses: document.map,
        deformations: document.deformation_map,
        subjects,
        selected: document.selected().map(|_| document.subject),
        neighbours: map.and_then(|map| map.embedding.neighbours),
        time_weight: map.map(|map| map.time_weight),
    }
}

fn keyed(point: &DeformationPoint) -> (usize, [f64; 2]) {
    (point.subject, point.at)
}

fn points(
    state: &State,
    map: &DeformationMap,
    classes: Option<&Arc<Classes>>,
) -> Vec<DeformationPoint> {
    let clusters = classes
        .map(|classes| &classes.clustering.clusters)
        .filter(|clusters| clusters.len() == map.subjects.len());
    let rows = map.subjects.iter().enumerate();
    rows.filter(|(row, _)| *row < map.embedding.len())
        .map(|(row, subject)| DeformationPoint {
            subject: *subject,
            at: plane(map.embedding.point(row)),
            first_frame: state.phases_of(*subject).0.unwrap_or_default(),
            cluster: clusters.map(|clusters| clusters[row]),
            nearest: nearest(map, row),
        })
        .collect()
}

/// The subjects whose curves (x, y, w t) are nearest to that of a row, nearest first.
fn nearest(map: &DeformationMap, row: usize) -> Vec<usize> {
    let Some(own) = map.curves.get(row) else {
        return Vec::new();
    };
    let apart = |other: &[[f64; 3]]| -> f64 {
        let pairs = own.iter().zip(other);
        pairs
            .flat_map(|(a, b)| [0, 1, 2].map(|axis| (a[axis] - b[axis]).powi(2)))
            .sum()
    };
    let mut others: Vec<(f64, usize)> = map
        .curves
        .iter()
        .zip(&map.subjects)
        .enumerate()
        .filter(|(other, _)| *other != row)
        .map(|(_, (curve, subject))| (apart(curve), *subject))
        .collect();
    others.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let named = others.into_iter().take(NAMED_NEIGHBOURS);
    named.map(|(_, subject)| subject).collect()
}

fn rules(classes: &Classes) -> Vec<RuleView> {
    let rule = |name, what, accuracy: Option<Accuracy>| {
        accuracy.map(|accuracy| RuleView {
            name,
            what,
            correct: accuracy.correct,
            of: accuracy.of,
            chance: accuracy.baseline * accuracy.of as f64,
            p_value: accuracy.p_value,
        })
    };
    [
        rule(
            "Nearest neighbour",
            "Each heart in turn is given the label of the heart that moves most like it",
            classes.nearest_neighbour,
        ),
        rule(
            "Linear rule",
            "Each heart in turn is judged by a linear rule on the distances of deformations, made \
             from all others",
            classes.linear_rule,
        ),
        rule(
            "Rule in this plane",
            "Each heart in turn is judged by a straight line on this map, made from all others",
            classes.plane_rule,
        ),
        rule(
            "Clusters, τ",
            "Share of hearts whose cluster stands for their label, where clusters and labels are \
             matched as well as can be",
            classes.tau,
        ),
    ]
    .into_iter()
    .flatten()
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::embedding::Embedding;
    use crate::app::testing::{state_of, subject_with_frames};

    fn map(places: [[f64; 2]; 4]) -> DeformationMap {
        DeformationMap {
            subjects: vec![0, 1, 2, 3],
            curves: [0.0, 1.0, 1.5, 9.0]
                .map(|x| vec![[x, 0.0, 0.0], [x, 1.0, 2.0]])
                .to_vec(),
            time_weight: 2.0,
            embedding: Embedding {
                dimensions: 2,
                coordinates: places.concat(),
                ..Embedding::default()
            },
        }
    }

    fn show(state: &mut State, map: DeformationMap) {
        state.answers.opening = state.document.study.opening;
        state.answers.deformations = Some(Showing::Ready(Arc::new(map)));
    }

    #[test]
    fn hearts_know_who_moves_most_like_them() {
        let map = map([[0.0; 2]; 4]);
        assert_eq!(nearest(&map, 0), [1, 2, 3]);
        assert_eq!(nearest(&map, 2), [1, 0, 3]);
    }

    #[test]
    fn a_new_map_is_met_from_the_old_one_and_reached() {
        let subjects = ["a", "b", "c", "d"].map(|id| subject_with_frames(id, 3));
        let mut state = state_of(subjects.to_vec());
        let mut data = DeformationData::default();
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
        show(&mut state, map(square));
        assert!(
            !data.refresh(&state, 1.0, true),
            "the first map is there at once"
        );
        assert_eq!(data.points[2].at, [2.0, 2.0]);
        let turned = [square[1], square[2], square[3], square[0]];
        show(&mut state, map(turned));
        assert!(data.refresh(&state, 2.0, true));
        assert_eq!(data.points[2].at, [2.0, 2.0]);
        assert!(data.refresh(&state, 2.15, true));
        assert!(data.points[2].at[0] < 2.0 && data.points[2].at[0] > 0.0);
        assert!(!data.refresh(&state, 2.31, true));
        assert_eq!(data.points[2].at, [0.0, 2.0]);
        show(&mut state, map(square));
        assert!(
            !data.refresh(&state, 3.0, false),
            "no motion where none is wanted"
        );
        assert_eq!(data.points[2].at, [2.0, 2.0]);
    }

    #[test]
    fn rules_are_counted_beside_chance() {
        let accuracy = Accuracy {
            correct: 20,
            of: 23,
            baseline: 0.54,
            p_value: 0.002,
        };
        let classes = Classes {
            nearest_neighbour: Some(accuracy),
            ..Classes::default()
        };
        let rules = rules(&classes);
        assert_eq!(rules.len(), 1);
        assert!((rules[0].chance - 12.42).abs() < 1e-9);
    }
}
