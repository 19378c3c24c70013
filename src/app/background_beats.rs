//! Background work on beats: poses between frames, carried beats, differences of two poses.

use std::slice;
use std::sync::Arc;

use crate::analysis::geodesics::GeodesicParams;
use crate::analysis::transport::TransportParams;
use crate::engine::{AnalysisRequest, Engine, Showing, WorkKind};
use crate::picture::{Quantity, relative_density};
use crate::study::{Revision, Subject};
use crate::ui::ViewMode;

use super::carried::{CarriedHeart, CarryingState, transport_params};
use super::differences::{PosePair, pair_on_screen};
use super::document::CarriedBeat;
use super::in_betweens::{geodesic_params, interval_count};
use super::play::is_between;
use super::stage::{OnStage, on_stage};
use super::state::State;

/// Poses between frames that were asked for.
#[derive(Clone, Debug)]
struct AskedInBetweens {
    subject: Arc<Subject>,
    index: usize,
    params: GeodesicParams,
    /// The interval on screen, which is found first.
    interval: usize,
}

impl AskedInBetweens {
    fn request(&self) -> AnalysisRequest {
        AnalysisRequest::InBetweens {
            subject: self.index,
            params: self.params,
        }
    }
}

/// What the answers that come in belong to.
#[derive(Debug, Default)]
pub struct AskedBeats {
    in_betweens: Option<AskedInBetweens>,
    transfer: Option<(Revision, CarriedBeat, TransportParams)>,
    contribution: Option<PosePair>,
}

impl AskedBeats {
    /// Asks for what the hearts on screen need; free if it is there or under way.
    pub fn request(&mut self, state: &State, engine: &mut Engine) {
        let study = state.document.study();
        let moving = |place: &OnStage| state.play.playing || is_between(place.position);
        if let Some(wanted) = wanted_in_betweens(state, moving) {
            engine.look_at_interval(wanted.interval);
            engine.request(study, wanted.request());
            self.in_betweens = Some(wanted);
        }
        if let Some(beat) = state.document.carrying()
            && state.carried_heart().is_none()
        {
            let params = transport_params(&state.document);
            engine.request(study, transfer_request(beat, params));
            self.transfer = Some((study.revision, beat, params));
        }
        if let Some(pair) = wanted_pair(state)
            && !state.results.differences.has(&pair)
        {
            engine.request(study, contribution_request(&pair));
            self.contribution = Some(pair);
        }
    }

    /// What the user asks to be computed again; `None` if nothing of this kind is on screen.
    pub fn retry(&mut self, state: &State, kind: WorkKind) -> Option<AnalysisRequest> {
        match kind {
            WorkKind::InBetweens => {
                let wanted = wanted_in_betweens(state, |_| true)?;
                let request = wanted.request();
                self.in_betweens = Some(wanted);
                Some(request)
            }
            WorkKind::Transfer => {
                let beat = state.document.carrying()?;
                let params = transport_params(&state.document);
                self.transfer = Some((state.document.study().revision, beat, params));
                Some(transfer_request(beat, params))
            }
            WorkKind::Contribution => {
                let pair = wanted_pair(state)?;
                self.contribution = Some(pair);
                Some(contribution_request(&pair))
            }
            _ => None,
        }
    }

    /// Takes in what was computed since the last frame.
    pub fn take(&mut self, state: &mut State, engine: &Engine) {
        self.take_in_betweens(state, engine);
        self.take_carried(state, engine);
        self.take_contribution(state, engine);
        let pair = wanted_pair(state);
        state.results.differences.show(pair.as_ref());
    }

    /// The whole beat once it is there; while it is computed and the beat stands still, the
    /// interval on screen alone. A playing beat changes its poses once, not with every interval.
    fn take_in_betweens(&self, state: &mut State, engine: &Engine) {
        let Some(asked) = &self.in_betweens else {
            return;
        };
        match engine.showing(WorkKind::InBetweens) {
            Showing::Ready(outcome) => {
                if let Some(paths) = outcome.in_betweens() {
                    let store = &mut state.results.in_betweens;
                    store.put(&asked.subject, &asked.params, 0, paths);
                }
            }
            Showing::Computing { .. } if !state.play.playing => {
                let request = AnalysisRequest::Interval {
                    subject: asked.index,
                    interval: asked.interval,
                    params: asked.params,
                };
                let known = state.results.in_betweens.get(&asked.subject, &asked.params);
                if known.is_none_or(|beat| beat.path(asked.interval).is_none())
                    && let Some(outcome) = engine.known(state.document.study(), &request)
                    && let Some(path) = outcome.interval()
                {
                    let store = &mut state.results.in_betweens;
                    let path = slice::from_ref(path);
                    store.put(&asked.subject, &asked.params, asked.interval, path);
                }
            }
            _ => {}
        }
    }

    fn take_carried(&self, state: &mut State, engine: &Engine) {
        let showing = engine.showing(WorkKind::Transfer);
        if let (Some(key), Showing::Ready(outcome)) = (self.transfer, &showing)
            && key.0 == state.document.study().revision
            && let Some(sequence) = outcome.transfer()
            && let (Some(from), Some(onto)) = (state.subject(key.1.from), state.subject(key.1.onto))
        {
            let taken = state.results.carried.as_ref();
            if !taken.is_some_and(|heart| Arc::ptr_eq(&heart.sequence, sequence)) {
                let heart = CarriedHeart::new(key, sequence, from, onto);
                state.results.carried = Some(heart);
            }
        }
        let missing = state.document.carrying().is_some() && state.carried_heart().is_none();
        state.results.carrying = match showing {
            _ if !missing => CarryingState::Done,
            Showing::Stopped { .. } => CarryingState::Stopped,
            Showing::Failed { .. } => CarryingState::Failed,
            _ => CarryingState::Computing,
        };
    }

    fn take_contribution(&self, state: &mut State, engine: &Engine) {
        let Some(pair) = self.contribution else {
            return;
        };
        if pair.revision != state.document.study().revision || state.results.differences.has(&pair)
        {
            return;
        }
        if let Showing::Ready(outcome) = engine.showing(WorkKind::Contribution)
            && let Some(contributions) = outcome.contribution()
            && let Some(density) = density(state, &pair, contributions)
        {
            state.results.differences.put(pair, density);
        }
    }
}

/// The beat whose in-betweens are not all there, of those on screen that may move.
pub fn unfinished(state: &State) -> Option<(Arc<Subject>, GeodesicParams)> {
    let wanted = wanted_in_betweens(state, |_| true)?;
    Some((wanted.subject, wanted.params))
}

/// The in-betweens to compute next: of the selected heart before the one beside it, of the
/// interval on screen before the others.
fn wanted_in_betweens(state: &State, moving: impl Fn(&OnStage) -> bool) -> Option<AskedInBetweens> {
    let params = geodesic_params(&state.document)?;
    // Settings without a shortest way leave the straight one; what is said of it says why.
    params.check().ok()?;
    let store = &state.results.in_betweens;
    let mut wanted = None;
    let mut places = on_stage(state);
    if state.document.view_mode == ViewMode::AllFrames {
        places.truncate(1);
    }
    if let Some(selected) = places.first_mut() {
        selected.position = state.document.position;
    }
    for place in places.iter().filter(|place| !place.carried) {
        let subject = state.subject(place.subject)?;
        let intervals = interval_count(subject);
        let beat = store.get(subject, &params);
        let complete = beat.is_some_and(|beat| beat.complete());
        if !moving(place) || intervals == 0 || complete || store.is_halted(subject, &params) {
            continue;
        }
        wanted = Some(AskedInBetweens {
            subject: Arc::clone(subject),
            index: place.subject,
            params,
            interval: (place.position.floor().max(0.0) as usize).min(intervals - 1),
        });
        break;
    }
    wanted
}

fn transfer_request(beat: CarriedBeat, params: TransportParams) -> AnalysisRequest {
    AnalysisRequest::Transfer {
        from: beat.from,
        onto: beat.onto,
        params,
    }
}

fn contribution_request(pair: &PosePair) -> AnalysisRequest {
    AnalysisRequest::Contribution {
        a: pair.a,
        b: pair.b,
        distances: pair.distances,
    }
}

/// The poses whose difference the colours stand for.
fn wanted_pair(state: &State) -> Option<PosePair> {
    let coloured = state.document.quantity == Quantity::Contribution;
    coloured.then(|| pair_on_screen(&state.document)).flatten()
}

fn density(state: &State, pair: &PosePair, contributions: &[f64]) -> Option<Vec<f32>> {
    let a = &state.subject(pair.a.subject)?.sequence;
    let b = &state.subject(pair.b.subject)?.sequence;
    let (start, end) = (a.pose(pair.a.frame)?, b.pose(pair.b.frame)?);
    let faces = a.joined_faces();
    relative_density(faces.triangles(), [&start, &end], contributions)
}
