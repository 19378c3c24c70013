//! What the window asks the store about motions: interpolated poses, a transported motion, where two poses differ.

use std::collections::HashMap;
use std::sync::Arc;

use crate::analysis::geodesics::GeodesicParams;
use crate::document::ViewMode;
use crate::engine::{
    ContributionQuery, InterpolatedPosesQuery, IntervalQuery, LookedAt, MotionTransportQuery,
    Showing, Store,
};
use crate::picture::{Quantity, relative_density};

use crate::document::answers::{Answers, InterpolationAnswer};
use crate::document::differences::{PosePair, pair_on_screen};
use crate::document::interpolated_poses::{
    InterpolatedMotion, MotionMemo, geodesic_params, interval_count,
};
use crate::document::play::is_between;
use crate::document::state::State;
use crate::document::transported::{TransportState, TransportedSubject, transport_params};
use crate::document::{VisiblePose, visible_poses};

/// Where two poses differ, for all poses of a subject.
type Density = Arc<Vec<Vec<f32>>>;

/// What is made of answers about motions, as long as these stay the same.
#[derive(Debug, Default)]
pub struct MotionAsks {
    /// By subject: the interval on screen, which is computed first.
    looked_at: HashMap<usize, LookedAt>,
    memo: MotionMemo,
    transported: Option<TransportedSubject>,
    difference: Option<(Arc<Vec<f64>>, Density)>,
}

impl MotionAsks {
    /// Asks for what the subjects on screen need.
    pub fn ask(&mut self, state: &State, store: &Store, answers: &mut Answers) {
        // Settings without a geodesic leave linear interpolation; its note says why.
        if let Some(params) = geodesic_params(&state.document)
            && params.check().is_ok()
        {
            answers.interpolated_poses = self.interpolated_poses(state, store, params);
        }
        (answers.transported, answers.transport_state) = self.transported(state, store);
        answers.difference = self.difference(state, store);
    }

    fn interpolated_poses(
        &mut self,
        state: &State,
        store: &Store,
        params: GeodesicParams,
    ) -> Vec<InterpolationAnswer> {
        let mut places = visible_poses(state);
        if state.document.view_mode == ViewMode::AllFrames {
            places.truncate(1);
        }
        if let Some(selected) = places.first_mut() {
            selected.position = state.document.position;
        }
        places.retain(|place| !place.transported);
        let motions = places.iter();
        motions
            .filter_map(|place| self.interpolated_poses_of(state, store, params, place))
            .collect()
    }

    /// The whole motion once it is there; while it is computed and the subject rests, the intervals that were on
    /// screen alone. A playing motion changes its poses once, not with every interval.
    fn interpolated_poses_of(
        &mut self,
        state: &State,
        store: &Store,
        params: GeodesicParams,
        place: &VisiblePose,
    ) -> Option<InterpolationAnswer> {
        let (index, study) = (place.subject, state.document.study());
        let subject = state.subject(index)?;
        let intervals = interval_count(subject);
        if intervals == 0 {
            return None;
        }
        let interval = (place.position.floor().max(0.0) as usize).min(intervals - 1);
        let looked_at = self.looked_at.entry(index).or_default().clone();
        looked_at.set(interval);
        let query = InterpolatedPosesQuery {
            subject: index,
            params,
            looked_at,
        };
        let moves = state.play.playing || is_between(place.position);
        let showing = match moves {
            true => store.ask(study, &query),
            false => store.watch(study, &query),
        };
        if let Some(paths) = showing.ready() {
            self.memo.put(subject, &params, 0, paths);
        } else if !state.play.playing
            && let Some(path) = store.known(
                study,
                &IntervalQuery {
                    subject: index,
                    interval,
                    params,
                },
            )
        {
            self.memo.put(subject, &params, interval, &[path]);
        }
        let motion: Option<&Arc<InterpolatedMotion>> = self.memo.get(subject, &params);
        Some(InterpolationAnswer {
            subject: index,
            motion: motion.cloned(),
            stopped: showing.stopped(),
        })
    }

    fn transported(
        &mut self,
        state: &State,
        store: &Store,
    ) -> (Option<TransportedSubject>, TransportState) {
        let nothing = (None, TransportState::Done);
        let Some(motion) = state.document.visible_transport() else {
            return nothing;
        };
        let (Some(from), Some(onto)) = (state.subject(motion.from), state.subject(motion.onto))
        else {
            return nothing;
        };
        let study = state.document.study();
        let params = transport_params(&state.document);
        let query = MotionTransportQuery {
            from: motion.from,
            onto: motion.onto,
            params,
        };
        let showing = store.ask(study, &query);
        let Showing::Ready(moved) = &showing else {
            let standing = match (showing.stopped(), showing.failure()) {
                (true, _) => TransportState::Stopped,
                (false, Some(_)) => TransportState::Failed,
                (false, None) => TransportState::Computing,
            };
            return (None, standing);
        };
        let key = (study.revision, motion, params);
        let same = |transported: &TransportedSubject| {
            transported.key == key && Arc::ptr_eq(&transported.motion, moved)
        };
        if !self.transported.as_ref().is_some_and(same) {
            self.transported = Some(TransportedSubject::new(key, moved, from, onto));
        }
        (self.transported.clone(), TransportState::Done)
    }

    /// What is shown of the same subjects stays until the next pair of frames is there.
    fn difference(&mut self, state: &State, store: &Store) -> Option<Density> {
        let coloured = state.document.quantity == Quantity::Contribution;
        let pair = coloured
            .then(|| pair_on_screen(&state.document))
            .flatten()?;
        let query = ContributionQuery {
            a: pair.a,
            b: pair.b,
            distances: pair.distances,
        };
        let showing = store.ask(state.document.study(), &query);
        let latest = showing.latest()?;
        let is_made = |made: &(Arc<Vec<f64>>, Density)| Arc::ptr_eq(&made.0, latest);
        if !self.difference.as_ref().is_some_and(is_made) {
            // An answer of before can be divided by the poses of its own frames only.
            let ready = showing.ready()?;
            let made = Arc::new(vec![density(state, &pair, ready)?]);
            self.difference = Some((Arc::clone(ready), made));
        }
        self.difference.as_ref().map(|(_, made)| Arc::clone(made))
    }
}

fn density(state: &State, pair: &PosePair, contributions: &[f64]) -> Option<Vec<f32>> {
    let a = &state.subject(pair.a.subject)?.sequence;
    let b = &state.subject(pair.b.subject)?.sequence;
    let (start, end) = (a.pose(pair.a.frame)?, b.pose(pair.b.frame)?);
    let faces = a.joined_faces();
    relative_density(faces.triangles(), [&start, &end], contributions)
}
