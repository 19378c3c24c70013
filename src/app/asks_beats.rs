//! What the window asks the store about beats: poses between frames, a transported motion, where two poses differ.

use std::collections::HashMap;
use std::sync::Arc;

use crate::analysis::geodesics::GeodesicParams;
use crate::document::ViewMode;
use crate::engine::{Contribution, InBetweens, Interval, LookedAt, Showing, Store, Transfer};
use crate::picture::{Quantity, relative_density};

use crate::document::answers::{Answers, InBetweensAnswer};
use crate::document::differences::{PosePair, pair_on_screen};
use crate::document::in_betweens::{BeatInBetweens, BeatMemo, geodesic_params, interval_count};
use crate::document::play::is_between;
use crate::document::state::State;
use crate::document::transported::{TransportState, TransportedSubject, transport_params};
use crate::document::{VisiblePose, visible_poses};

/// Where two poses differ, for all poses of a subject.
type Density = Arc<Vec<Vec<f32>>>;

/// What is made of answers about beats, as long as these stay the same.
#[derive(Debug, Default)]
pub struct BeatAsks {
    /// By subject: the interval on screen, which is computed first.
    looked_at: HashMap<usize, LookedAt>,
    memo: BeatMemo,
    transported: Option<TransportedSubject>,
    difference: Option<(Arc<Vec<f64>>, Density)>,
}

impl BeatAsks {
    /// Asks for what the subjects on screen need.
    pub fn ask(&mut self, state: &State, store: &Store, answers: &mut Answers) {
        // Settings without a geodesic leave linear interpolation; its note says why.
        if let Some(params) = geodesic_params(&state.document)
            && params.check().is_ok()
        {
            answers.in_betweens = self.in_betweens(state, store, params);
        }
        (answers.transported, answers.transport_state) = self.transported(state, store);
        answers.difference = self.difference(state, store);
    }

    fn in_betweens(
        &mut self,
        state: &State,
        store: &Store,
        params: GeodesicParams,
    ) -> Vec<InBetweensAnswer> {
        let mut places = visible_poses(state);
        if state.document.view_mode == ViewMode::AllFrames {
            places.truncate(1);
        }
        if let Some(selected) = places.first_mut() {
            selected.position = state.document.position;
        }
        places.retain(|place| !place.transported);
        let beats = places.iter();
        beats
            .filter_map(|place| self.in_betweens_of(state, store, params, place))
            .collect()
    }

    /// The whole beat once it is there; while it is computed and the beat stands still, the intervals that were on
    /// screen alone. A playing beat changes its poses once, not with every interval.
    fn in_betweens_of(
        &mut self,
        state: &State,
        store: &Store,
        params: GeodesicParams,
        place: &VisiblePose,
    ) -> Option<InBetweensAnswer> {
        let (index, study) = (place.subject, state.document.study());
        let subject = state.subject(index)?;
        let intervals = interval_count(subject);
        if intervals == 0 {
            return None;
        }
        let interval = (place.position.floor().max(0.0) as usize).min(intervals - 1);
        let looked_at = self.looked_at.entry(index).or_default().clone();
        looked_at.set(interval);
        let query = InBetweens {
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
                &Interval {
                    subject: index,
                    interval,
                    params,
                },
            )
        {
            self.memo.put(subject, &params, interval, &[path]);
        }
        let beat: Option<&Arc<BeatInBetweens>> = self.memo.get(subject, &params);
        Some(InBetweensAnswer {
            subject: index,
            beat: beat.cloned(),
            stopped: showing.stopped(),
        })
    }

    fn transported(
        &mut self,
        state: &State,
        store: &Store,
    ) -> (Option<TransportedSubject>, TransportState) {
        let nothing = (None, TransportState::Done);
        let Some(beat) = state.document.visible_transport() else {
            return nothing;
        };
        let (Some(from), Some(onto)) = (state.subject(beat.from), state.subject(beat.onto)) else {
            return nothing;
        };
        let study = state.document.study();
        let params = transport_params(&state.document);
        let query = Transfer {
            from: beat.from,
            onto: beat.onto,
            params,
        };
        let showing = store.ask(study, &query);
        let Showing::Ready(sequence) = &showing else {
            let standing = match (showing.stopped(), showing.failure()) {
                (true, _) => TransportState::Stopped,
                (false, Some(_)) => TransportState::Failed,
                (false, None) => TransportState::Computing,
            };
            return (None, standing);
        };
        let key = (study.revision, beat, params);
        let same =
            |heart: &TransportedSubject| heart.key == key && Arc::ptr_eq(&heart.sequence, sequence);
        if !self.transported.as_ref().is_some_and(same) {
            self.transported = Some(TransportedSubject::new(key, sequence, from, onto));
        }
        (self.transported.clone(), TransportState::Done)
    }

    /// What is shown of the same subjects stays until the next pair of frames is there.
    fn difference(&mut self, state: &State, store: &Store) -> Option<Density> {
        let coloured = state.document.quantity == Quantity::Contribution;
        let pair = coloured
            .then(|| pair_on_screen(&state.document))
            .flatten()?;
        let query = Contribution {
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
