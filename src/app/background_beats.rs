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
    params: GeodesicParams,
    interval: Option<usize>,
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
            engine.request(study, in_betweens_request(state, &wanted));
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
                let request = in_betweens_request(state, &wanted);
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
        if let Some(asked) = &self.in_betweens
            && let Showing::Ready(outcome) = engine.showing(WorkKind::InBetweens)
        {
            let store = &mut state.results.in_betweens;
            if let (Some(first), Some(path)) = (asked.interval, outcome.interval()) {
                store.put(&asked.subject, &asked.params, first, slice::from_ref(path));
            } else if let Some(paths) = outcome.in_betweens() {
                store.put(&asked.subject, &asked.params, 0, paths);
            }
        }
        self.take_carried(state, engine);
        self.take_contribution(state, engine);
        let pair = wanted_pair(state);
        state.results.differences.show(pair.as_ref());
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
    if state.document.view_mode == ViewMode::AllPhases {
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
        let interval = place.position.floor().max(0.0) as usize;
        let first = interval < intervals && beat.is_none_or(|beat| beat.path(interval).is_none());
        wanted = Some(AskedInBetweens {
            subject: Arc::clone(subject),
            params,
            interval: first.then_some(interval),
        });
        break;
    }
    wanted
}

fn in_betweens_request(state: &State, asked: &AskedInBetweens) -> AnalysisRequest {
    let subjects = &state.document.study().subjects;
    let place = subjects
        .iter()
        .position(|other| Arc::ptr_eq(other, &asked.subject));
    let (subject, params) = (place.unwrap_or(usize::MAX), asked.params);
    match asked.interval {
        Some(interval) => AnalysisRequest::Interval {
            subject,
            interval,
            params,
        },
        None => AnalysisRequest::InBetweens { subject, params },
    }
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
        metric: pair.metric,
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
