//! What lies over a heart in the 3D view: its name, colour bar, scale bar and orientation cube.

use crate::app::document::nearest_frame;
use crate::app::play::is_between;
use crate::app::stage::OnStage;
use crate::app::state::State;
use crate::picture::{ColourLegend, HeartAxes, PreparedSubject, frame_words};
use crate::render::Camera;
use crate::study::LabelRole;
use crate::ui::{ColourBarView, CubeView, ScaleBarView, ViewMode, ViewportOverlayView};

/// What is said of poses between frames, until geodesic in-betweens exist.
const BETWEEN: &str = "interpolated (linear)";

/// Owned texts behind the overlay of one heart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OverlayData {
    title: String,
    subtitle: String,
    role: LabelRole,
    between: bool,
}

impl OverlayData {
    /// Names a heart; in the grid of all phases, the whole beat.
    pub fn of(state: &State, cell: &OnStage) -> Self {
        let Some(subject) = state.subject(cell.subject) else {
            return Self::default();
        };
        let count = subject.sequence.frame_count();
        let frame = nearest_frame(cell.position, count);
        let phase = phase_name(state.phases_of(cell.subject), frame);
        if state.document.view_mode == ViewMode::AllPhases {
            let label = subject.label.as_deref().unwrap_or("no label");
            return Self {
                title: subject.id.clone(),
                subtitle: format!("{label} · all {count} frames"),
                role: state.document.study().role(subject),
                between: false,
            };
        }
        let mut parts: Vec<String> = subject.label.iter().cloned().collect();
        parts.push(frame_words(frame, count));
        parts.extend(phase.map(str::to_owned));
        Self {
            title: subject.id.clone(),
            subtitle: parts.join(" · "),
            role: state.document.study().role(subject),
            between: is_between(cell.position),
        }
    }

    /// What the overlay shows.
    pub fn view<'a>(
        &'a self,
        legend: Option<&'a ColourLegend>,
        prepared: &PreparedSubject,
        camera: &Camera,
        height: f32,
        last: bool,
    ) -> ViewportOverlayView<'a> {
        ViewportOverlayView {
            title: &self.title,
            subtitle: &self.subtitle,
            role: self.role,
            badge: self.between.then_some(BETWEEN),
            colour_bar: legend.map(colour_bar),
            scale_bar: last.then(|| ScaleBarView {
                points_per_unit: f64::from(height / (2.0 * camera.half_height)),
                unit: prepared.unit.length_symbol(),
            }),
            cube: last.then(|| cube(&prepared.axes, camera)),
        }
    }
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
        typed: legend.note.contains("typed"),
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
