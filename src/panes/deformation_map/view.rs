//! The deformation map and the accuracy of classifiers: from the latest results, kept until they or the study change.

use std::sync::Arc;

use egui::Ui;

use crate::analysis::classification::{Accuracy, Classes};
use crate::analysis::deformations::{DeformationMap, DeformationMapError, FEWEST_DEFORMATIONS};
use crate::document::state::State;
use crate::engine::{DeformationMapQuery, PoseMapQuery, Showing, Topic};
use crate::panes::cohort::view::cohort_data;
use crate::panes::pane_context::PaneContext;
use crate::panes::pose_map::view::pose_map;
use crate::panes::same::Same;
use crate::panes::scatter_map::from_state::{MapPoints, left_out, plane};
use crate::panes::scatter_map::{PosePhase, ScatterPoint, ScatterView};
use crate::panes::work_state::WorkState;
use crate::picture::sentence;
use crate::study::Study;

use super::{ClassesView, ClassifierView, DEFORMATION_MAP, DeformationFit, DeformationMapView};

/// How many of the subjects with the most similar motion are named.
const NAMED_NEIGHBOURS: usize = 3;

/// Hands what the pane shows to `draw`; asks for another picture while points walk.
pub fn with_view(
    ui: &mut Ui,
    cx: &PaneContext<'_>,
    draw: impl FnOnce(&mut Ui, &DeformationMapView<'_>),
) {
    let state = cx.state();
    let (poses, cohort) = (pose_map(ui, cx), cohort_data(cx));
    let (poses, cohort) = (poses.borrow_mut(), cohort.borrow_mut());
    let (map, classes) = (state.deformations(), state.classes());
    let kept = (cx.memo()).get::<MapPoints<DeformationMap, Option<Same<Classes>>>>();
    let mut kept = kept.borrow_mut();
    kept.refresh(ui, state, map, Same::of(classes), |map| {
        let classes = classes.map(Arc::as_ref);
        let first = |subject| state.phases_of(subject).0.unwrap_or_default();
        let study = state.document.study();
        // Subjects that are missing among the curves of poses are missing on the pose map.
        let without = map.parts.iter().flat_map(|mapped| &mapped.parts.left_out);
        let without = without.map(|left| (left.subject, &left.reason));
        (points(map, study, classes, first), left_out(study, without))
    });
    let rows = classes.map_or_else(Vec::new, |classes| classifiers(classes));
    let (work, job) = deformation_state(state);
    let view = DeformationMapView {
        map: ScatterView {
            job,
            left_out: match map.is_some_and(|map| map.parts.is_some()) {
                true => kept.left_out(),
                false => poses.left_out(),
            },
            ..kept.view(state, &DEFORMATION_MAP, work, cohort.rows())
        },
        comparison: state.document.deformation_map.comparison,
        fit: map.map(|map| DeformationFit::of(map)).unwrap_or_default(),
        classes: classes_view(state, &rows),
        classes_by: (state.document.study().has_other_classes_than_labels())
            .then(|| state.document.classes_by()),
    };
    draw(ui, &view);
}

fn classes_view<'a>(state: &State, rows: &'a [ClassifierView]) -> ClassesView<'a> {
    match &state.answers.classes {
        None => ClassesView::Absent,
        Some(_) if !rows.is_empty() => ClassesView::Ready(rows),
        Some(Showing::Computing { watch, .. }) => ClassesView::Computing {
            fraction: watch.fraction(),
        },
        Some(Showing::Ready(_)) => {
            ClassesView::Unanswerable("not enough labels; subjects of two classes are needed")
        }
        Some(showing) if showing.failure().is_some() => {
            ClassesView::Unanswerable("the classification failed")
        }
        Some(_) => ClassesView::Absent,
    }
}

/// How the map stands, and which work it waits for: poses are mapped first.
fn deformation_state(state: &State) -> (WorkState, Topic) {
    let poses = WorkState::of(state.answers.map.as_ref());
    if poses != WorkState::Ready {
        return (poses, Topic::of::<PoseMapQuery>());
    }
    let deformations = mapped_subjects(state);
    let own = if deformations >= FEWEST_DEFORMATIONS {
        WorkState::of(state.answers.deformations.as_ref())
    } else {
        let why = DeformationMapError::TooFew { deformations };
        WorkState::Unanswerable(sentence(&why.to_string()))
    };
    (own, Topic::of::<DeformationMapQuery>())
}

/// Whether the pose map holds so many subjects that their deformations can be mapped.
pub fn enough_subjects(state: &State) -> bool {
    mapped_subjects(state) >= FEWEST_DEFORMATIONS
}

/// How many subjects the pose map holds.
fn mapped_subjects(state: &State) -> usize {
    state.map().map_or(0, |map| {
        let poses = &map.distances.poses;
        poses.chunk_by(|a, b| a.subject == b.subject).count()
    })
}

/// One point per subject; `first_frame` is where a click plays from.
pub(super) fn points(
    map: &DeformationMap,
    study: &Study,
    classes: Option<&Classes>,
    first_frame: impl Fn(usize) -> usize,
) -> Vec<ScatterPoint> {
    let clusters = classes
        .map(|classes| &classes.clustering.clusters)
        .filter(|clusters| clusters.len() == map.subjects.len());
    let rows = map.subjects.iter().enumerate();
    rows.filter(|(row, _)| *row < map.embedding.len())
        .map(|(row, subject)| {
            let nearest = nearest(map, row);
            let id = |index: &usize| Some(study.subjects.get(*index)?.id.as_str());
            let named: Vec<&str> = nearest.iter().filter_map(id).collect();
            let mut facts = Vec::new();
            if let Some(first) = named.first() {
                facts.push(format!("Most similar motion: {}", named.join(", ")));
                facts.extend(
                    nearest
                        .first()
                        .and_then(|other| share(map, row, *other, first)),
                );
            }
            ScatterPoint {
                subject: *subject,
                start_frame: first_frame(*subject),
                at: plane(map.embedding.point(row)),
                phase: PosePhase::WholeMotion,
                label: Some(""),
                cluster: clusters.map(|clusters| clusters[row]),
                facts,
                nearest,
                ..ScatterPoint::default()
            }
        })
        .collect()
}

/// "Differs from P7 by 20 % in deformation, 80 % in shape": both parts of equal weight.
fn share(map: &DeformationMap, row: usize, other: usize, name: &str) -> Option<String> {
    let parts = &map.parts.as_ref()?.parts;
    let other = parts
        .subjects
        .iter()
        .position(|subject| *subject == other)?;
    let shape = 100.0 * parts.shape_share(row, other)?;
    let deformation = 100.0 - shape.round();
    Some(format!(
        "Differs from {name} by {deformation:.0} % in deformation, {shape:.0} % in shape"
    ))
}

/// The subjects nearest to that of a row, nearest first: by the distances that are mapped, else by curves (x, y, w t).
fn nearest(map: &DeformationMap, row: usize) -> Vec<usize> {
    let of_curves = |other: usize| -> Option<f64> {
        let pairs = map.curves.get(row)?.iter().zip(map.curves.get(other)?);
        let steps = pairs.flat_map(|(a, b)| [0, 1, 2].map(|axis| (a[axis] - b[axis]).powi(2)));
        Some(steps.sum())
    };
    let apart = |other: usize| match &map.parts {
        Some(mapped) => Some(mapped.distances.get(row, other)),
        None => of_curves(other),
    };
    let mut others: Vec<(f64, usize)> = (map.subjects.iter().enumerate())
        .filter(|(other, _)| *other != row)
        .filter_map(|(other, subject)| Some((apart(other)?, *subject)))
        .collect();
    others.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    let named = others.into_iter().take(NAMED_NEIGHBOURS);
    named.map(|(_, subject)| subject).collect()
}

fn classifiers(classes: &Classes) -> Vec<ClassifierView> {
    let row = |name, what, accuracy: Option<Accuracy>| {
        accuracy.map(|accuracy| ClassifierView {
            name,
            what,
            correct: accuracy.correct,
            of: accuracy.of,
            permutation_mean: accuracy.baseline * accuracy.of as f64,
            p_value: accuracy.p_value,
        })
    };
    [
        row(
            "Nearest neighbour",
            "Each subject is given the label of the subject with the most similar motion",
            classes.nearest_neighbour,
        ),
        row(
            "Linear classifier",
            "Each subject is classified by a linear classifier on the distances of deformations, \
             trained on all others (leave-one-out)",
            classes.linear_classifier,
        ),
        row(
            "Classifier on 2-D embedding",
            "Each subject is classified by a linear classifier on the coordinates of this map, \
             trained on all others (leave-one-out)",
            classes.plane_classifier,
        ),
        row(
            "Cluster agreement τ",
            "Share of subjects whose cluster stands for their label, with the best matching of \
             clusters to labels",
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
    use crate::document::testing::{study_of, subject_with_frames};

    fn map(places: [[f64; 2]; 4]) -> DeformationMap {
        DeformationMap {
            subjects: vec![0, 1, 2, 3],
            curves: [0.0, 1.0, 1.5, 9.0]
                .map(|x| vec![[x, 0.0, 0.0], [x, 1.0, 2.0]])
                .to_vec(),
            time_weight: Some(2.0),
            parts: None,
            embedding: Embedding {
                dimensions: 2,
                coordinates: places.concat(),
                ..Embedding::default()
            },
        }
    }

    #[test]
    fn subjects_know_who_moves_most_alike() {
        let map = map([[0.0; 2]; 4]);
        assert_eq!(nearest(&map, 0), [1, 2, 3]);
        assert_eq!(nearest(&map, 2), [1, 0, 3]);
    }

    #[test]
    fn points_name_who_moves_most_alike_and_play_from_the_first_frame() {
        let subjects = ["a", "b", "c", "d"].map(|id| subject_with_frames(id, 3));
        let study = study_of(subjects.to_vec());
        let points = points(&map([[0.0; 2]; 4]), &study, None, |subject| subject + 5);
        assert_eq!(points.len(), 4);
        assert_eq!(points[2].facts, ["Most similar motion: b, a, d"]);
        assert_eq!((points[2].start_frame, points[2].cluster), (7, None));
    }

    #[test]
    fn accuracies_stand_beside_the_permutation_mean() {
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
        let rows = classifiers(&classes);
        assert_eq!(rows.len(), 1);
        assert!((rows[0].permutation_mean - 12.42).abs() < 1e-9);
    }
}
