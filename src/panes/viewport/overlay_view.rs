//! What lies over a heart in the 3D view: its name, colour bar, scale bar and orientation cube.

use crate::document::ViewMode;
use crate::document::VisiblePose;
use crate::document::differences::hindrance;
use crate::document::document::nearest_frame;
use crate::document::in_betweens::{BetweenWords, between_words};
use crate::document::state::State;
use crate::document::transported::{TransportState, transported_title};
use crate::panes::beat::straight_because;
use crate::panes::patch::words::patch_note;
use crate::panes::{
    ColourBarView, Command, CubeView, PatchNote, ScaleBarView, TransportCommand,
    ViewportOverlayView,
};
use crate::picture::{
    ColourLegend, HeartAxes, HeartScene, PreparedSubject, Quantity, USER_LIMITS, frame_words,
};
use crate::render::Camera;
use crate::study::{LabelRole, Subject};

/// Owned texts behind the overlay of one heart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OverlayData {
    title: String,
    subtitle: String,
    role: LabelRole,
    between: BetweenWords,
    /// Why colours are missing; stands where the badge would be.
    missing: Option<&'static str>,
    leave: Option<(&'static str, Command)>,
    patch: Option<PatchNote>,
}

impl OverlayData {
    /// Names a heart; in the grid of all phases, the whole beat.
    pub fn of(state: &State, cell: &VisiblePose) -> Self {
        let Some(subject) = state.subject(cell.subject) else {
            return Self::default();
        };
        let count = subject.sequence.frame_count();
        let frame = nearest_frame(cell.position, count);
        let phase = phase_name(state.phases_of(cell.subject), frame);
        if state.document.view_mode == ViewMode::AllFrames {
            let label = subject.label.as_deref().unwrap_or("no label");
            return Self {
                title: subject.id.clone(),
                subtitle: format!("{label} · all {count} frames"),
                role: state.document.study().role(subject),
                missing: missing_colours(state, cell),
                patch: patch_note(state, cell.subject),
                ..Self::default()
            };
        }
        let document = &state.document;
        let beside = document
            .visible_transport()
            .filter(|beat| beat.onto == cell.subject);
        if let Some(from) = beside.and_then(|beat| state.subject(beat.from)) {
            return Self::beside_its_origin(state, cell, from, subject);
        }
        let mut parts: Vec<String> = subject.label.iter().cloned().collect();
        parts.push(frame_words(frame, count));
        parts.extend(phase.map(str::to_owned));
        let in_betweens = state.in_betweens_of(cell.subject).map(|beat| &**beat);
        Self {
            title: subject.id.clone(),
            subtitle: parts.join(" · "),
            role: document.study().role(subject),
            between: between_words(in_betweens, cell.position, straight_because(state)),
            missing: missing_colours(state, cell),
            leave: None,
            patch: patch_note(state, cell.subject),
        }
    }

    /// Names the heart that plays a transported motion, or will.
    fn beside_its_origin(
        state: &State,
        cell: &VisiblePose,
        from: &Subject,
        onto: &Subject,
    ) -> Self {
        let role = state.document.study().role(onto);
        let own = (
            "Show own motion",
            Command::Transport(TransportCommand::StopTransport),
        );
        if cell.transported {
            let count = from.sequence.frame_count();
            let frame = nearest_frame(cell.position, count);
            let mut parts = vec!["transported motion".to_owned(), frame_words(frame, count)];
            let phase = phase_name(state.phases_of(state.document.subject), frame);
            parts.extend(phase.map(str::to_owned));
            return Self {
                title: transported_title(from, onto),
                subtitle: parts.join(" · "),
                role,
                between: between_words(
                    None,
                    cell.position,
                    "A transported motion is interpolated linearly",
                ),
                missing: None,
                leave: Some(own),
                patch: None,
            };
        }
        let beat = state.document.transported;
        let (standing, leave) = match (state.answers.transport_state, beat) {
            (TransportState::Stopped, Some(beat)) => {
                let (from, onto) = (beat.from, beat.onto);
                let again = (
                    "Transport again",
                    Command::Transport(TransportCommand::TransportMotion { from, onto }),
                );
                (
                    format!("transport from {} was stopped", from_id(state, from)),
                    again,
                )
            }
            (TransportState::Failed, _) => (format!("transport from {} failed", from.id), own),
            _ => (format!("transport from {} is being computed", from.id), own),
        };
        let in_betweens = state.in_betweens_of(cell.subject).map(|beat| &**beat);
        Self {
            title: onto.id.clone(),
            subtitle: format!("own motion · {standing}"),
            role,
            between: between_words(in_betweens, cell.position, straight_because(state)),
            missing: None,
            leave: Some(leave),
            patch: None,
        }
    }

    /// What the overlay shows.
    pub fn view<'a>(
        &'a self,
        legends: Option<&'a HeartScene>,
        prepared: &PreparedSubject,
        camera: &Camera,
        height: f32,
        last: bool,
    ) -> ViewportOverlayView<'a> {
        ViewportOverlayView {
            title: &self.title,
            subtitle: &self.subtitle,
            role: self.role,
            badge: self.missing.or(self.between.badge),
            badge_note: &self.between.note,
            leave: self.leave.clone(),
            colour_bar: legends.and_then(|legends| Some(colour_bar(legends.legend.as_ref()?))),
            atom_bar: legends.and_then(|legends| Some(colour_bar(legends.atom_legend.as_ref()?))),
            patch: self.patch.as_ref(),
            scale_bar: last.then(|| ScaleBarView {
                points_per_unit: f64::from(height / (2.0 * camera.half_height)),
                unit: prepared.unit.length_symbol(),
            }),
            cube: last.then(|| cube(&prepared.axes, camera)),
        }
    }
}

fn from_id(state: &State, subject: usize) -> &str {
    state.subject(subject).map_or("", |subject| &subject.id)
}

/// Why colours that were chosen are not there; said once, at the selected heart.
fn missing_colours(state: &State, cell: &VisiblePose) -> Option<&'static str> {
    let document = &state.document;
    if document.bar_quantity() == Quantity::ThicknessRatio || document.visibility.atoms {
        let untold = matches!(state.wall_of(cell.subject), Some((Err(_), _)));
        return untold.then_some("Thickness not assessed");
    }
    let wanted = document.quantity == Quantity::Contribution && cell.subject == document.subject;
    wanted.then(|| hindrance(document)).flatten()
}

/// ED and ES by their usual short names.
pub fn phase_name(
    (end_diastole, end_systole): (Option<usize>, Option<usize>),
    frame: usize,
) -> Option<&'static str> {
    if end_diastole == Some(frame) {
        Some("ED")
    } else if end_systole == Some(frame) {
        Some("ES")
    } else {
        None
    }
}

fn colour_bar(legend: &ColourLegend) -> ColourBarView<'_> {
    let bytes = |colour: [f32; 3]| colour.map(|part| (255.0 * part).round() as u8);
    ColourBarView {
        title: &legend.title,
        unit: legend.unit,
        map: legend.map.colours.clone(),
        limits: [f64::from(legend.limits.low), f64::from(legend.limits.high)],
        logarithmic: legend.limits.logarithmic,
        ticks: &legend.ticks,
        below: bytes(legend.map.below),
        above: bytes(legend.map.above),
        note: legend.note,
        typed: legend.note == USER_LIMITS,
    }
}

fn cube(axes: &HeartAxes, camera: &Camera) -> CubeView {
    let direction = |v: crate::mesh::Vector3| glam::DVec3::new(v.x, v.y, v.z).as_vec3();
    CubeView {
        world_from_camera: camera.world_from_camera,
        base: direction(axes.up),
        septal: direction(axes.side),
        anterior: direction(axes.front),
        known: axes.named,
    }
}
