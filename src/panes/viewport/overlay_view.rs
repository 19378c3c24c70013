//! What lies over a subject in the 3D view: its name, colour bar, scale bar and orientation cube.

use std::borrow::Cow;

use crate::analysis::pose_distances::PoseId;
use crate::analysis::transport::TransportAccount;
use crate::document::ViewMode;
use crate::document::VisiblePose;
use crate::document::differences::hindrance;
use crate::document::document::{TransportChoice, nearest_frame};
use crate::document::interpolated_poses::between_words;
use crate::document::state::State;
use crate::document::transported::TransportState;
use crate::engine::EstimatedPose;
use crate::panes::cohort::view::label_marks;
use crate::panes::commands::TransportCommand;
use crate::panes::patch::words::patch_note;
use crate::panes::pose_words::between_words_of;
use crate::panes::viewport::overlay::{
    ColourBarView, CubeView, PatchNote, ScaleBarView, SubjectCaption, ViewportOverlayView,
};
use crate::picture::{
    ColourLegend, PreparedSubject, Quantity, SubjectAxes, SubjectScene, USER_LIMITS, is_between,
    position_words, sentence,
};
use crate::render::Camera;
use crate::study::Subject;
use crate::ui::LabelMark;
use crate::ui::text::counted;

/// Names a subject; in the grid of all frames, its whole motion.
pub fn caption(state: &State, tile: &VisiblePose) -> SubjectCaption {
    let (document, subject) = (&state.document, state.subject(tile.subject));
    let Some(subject) = subject else {
        return SubjectCaption::default();
    };
    let beside = document.visible_transport();
    let beside = beside.filter(|motion| motion.onto == tile.subject);
    if let Some(from) = beside.and_then(|motion| state.subject(motion.from)) {
        return beside_its_origin(state, tile, from, subject);
    }
    let count = subject.sequence.frame_count();
    let badge = missing_colours(state, tile).map(Cow::Borrowed);
    let caption = SubjectCaption {
        title: subject.id.clone(),
        mark: mark_of(state, tile.subject),
        patch: patch_note(state, tile.subject).filter(|note| note.found || badge.is_none()),
        badge,
        ..SubjectCaption::default()
    };
    let excluded = document.study().is_excluded(tile.subject);
    let excluded = excluded.then(|| "excluded".to_owned()).into_iter();
    if document.view_mode == ViewMode::AllFrames {
        let label = subject.label.as_deref().unwrap_or("no label");
        let words = [label.to_owned(), format!("all {count} frames")];
        let mut patch = caption.patch;
        if let Some(patch) = &mut patch {
            // More would come over the first row of the grid.
            patch.lines.truncate(1);
        }
        return SubjectCaption {
            subtitle: excluded.chain(words).collect::<Vec<_>>().join(" · "),
            patch,
            ..caption
        };
    }
    let between = between_words_of(state, tile.subject, tile.position);
    let words = excluded.chain(subject.label.clone());
    let moment = moment_words(state, tile.subject, tile.position, count);
    SubjectCaption {
        subtitle: words.chain(moment).collect::<Vec<_>>().join(" · "),
        badge: caption.badge.or(between.badge),
        badge_note: between.note,
        ..caption
    }
}

/// "frame 3 (0–7)", "ES": the frame at a position, with its phase in the motion of a subject; between frames
/// neither is named.
fn moment_words(
    state: &State,
    subject: usize,
    position: f64,
    count: usize,
) -> impl Iterator<Item = String> {
    let frame = (!is_between(position)).then(|| nearest_frame(position, count));
    let phase = frame.and_then(|frame| state.phase_name(subject, frame));
    std::iter::once(position_words(position, count)).chain(phase.map(str::to_owned))
}

/// Names the subject that plays a transported motion, or will.
fn beside_its_origin(
    state: &State,
    tile: &VisiblePose,
    from: &Subject,
    onto: &Subject,
) -> SubjectCaption {
    let own = ("Show own motion", TransportCommand::StopTransport.into());
    let (title, words, between, leave);
    let mut note = None;
    let mut title_end = String::new();
    if tile.transported {
        let count = from.sequence.frame_count();
        let moment = moment_words(state, state.document.subject, tile.position, count);
        let why = "A transported motion is interpolated linearly";
        title = format!("Motion of {}", from.id);
        title_end = format!(" on {}", onto.id);
        words = std::iter::once("transported motion".to_owned())
            .chain(moment)
            .collect();
        between = between_words(None, tile.position, why);
        leave = own;
        note = (state.transported_subject()).map(|subject| transport_note(&subject.motion.account));
    } else {
        let standing;
        (standing, leave) = match (state.answers.transport_state, state.document.transported) {
            (TransportState::Stopped, Some(TransportChoice { from, onto })) => {
                let again = TransportCommand::TransportMotion { from, onto };
                ("was stopped", ("Transport again", again.into()))
            }
            (TransportState::Failed, _) => ("failed", own),
            _ => ("is being computed", own),
        };
        title = onto.id.clone();
        words = vec![
            "own motion".to_owned(),
            format!("transport from {} {standing}", from.id),
        ];
        between = between_words_of(state, tile.subject, tile.position);
    }
    let words: Vec<String> = words;
    SubjectCaption {
        title,
        title_end,
        subtitle: words.join(" · "),
        mark: mark_of(state, tile.subject),
        badge: between.badge,
        badge_note: between.note,
        leave: Some(leave),
        patch: note,
    }
}

/// How a motion was transported; what is no geodesic stands out.
fn transport_note(account: &TransportAccount) -> PatchNote {
    let path = sentence(&account.path_words());
    let kept = format!("lengths kept within {:.1} %", 100.0 * account.norm_change());
    if account.not_converged() > 0 {
        let heading = "The geodesic did not converge".to_owned();
        return PatchNote {
            short: heading.clone(),
            heading,
            lines: vec![path, kept],
            found: true,
        };
    }
    PatchNote {
        heading: path,
        short: "along a geodesic".to_owned(),
        lines: vec![kept],
        found: false,
    }
}

/// Names a pose that is estimated at a place of the pose map, with what it is estimated from.
pub fn estimated_caption(state: &State, pose: &EstimatedPose) -> SubjectCaption {
    let words = source_words(state, pose);
    SubjectCaption {
        title: pose.subject.id.clone(),
        subtitle: words.join(" · "),
        badge: Some(estimated_words(pose).into()),
        badge_note: format!(
            "The pose that the map implies at this place: the mean of the nearest poses, aligned, weighted by their \
             distance on the map. Nothing is measured on it.\n\n{}",
            words.join("\n")
        ),
        ..SubjectCaption::default()
    }
}

/// "estimated from 4 poses".
pub fn estimated_words(pose: &EstimatedPose) -> String {
    format!("estimated from {}", counted(pose.sources.len(), "pose"))
}

/// "P05 frame 3: 42 %", for each pose that another one is estimated from.
pub fn source_words(state: &State, pose: &EstimatedPose) -> Vec<String> {
    let words = |(source, weight): &(PoseId, f64)| {
        let id = &state.subject(source.subject)?.id;
        Some(format!(
            "{id} frame {}: {:.0} %",
            source.frame,
            100.0 * weight
        ))
    };
    pose.sources.iter().filter_map(words).collect()
}

/// Shape and colour of a subject's label.
fn mark_of(state: &State, subject: usize) -> LabelMark {
    let marks = label_marks(state.document.study());
    marks.get(subject).copied().unwrap_or_default()
}

/// What lies over a subject beside its caption.
pub fn overlay_view<'a>(
    legends: Option<&'a SubjectScene>,
    prepared: &PreparedSubject,
    camera: &Camera,
    height: f32,
    last: bool,
) -> ViewportOverlayView<'a> {
    ViewportOverlayView {
        colour_bar: legends.and_then(|legends| Some(colour_bar(legends.legend.as_ref()?))),
        atom_bar: legends.and_then(|legends| Some(colour_bar(legends.atom_legend.as_ref()?))),
        scale_bar: last.then(|| ScaleBarView {
            points_per_unit: f64::from(height / (2.0 * camera.half_height)),
            unit: prepared.unit.length_symbol(),
        }),
        cube: last.then(|| cube(&prepared.axes, camera)),
        subject: points_of(prepared, camera, height),
    }
}

/// Where some points of each surface are at some times, from the middle of a picture of this height.
fn points_of(prepared: &PreparedSubject, camera: &Camera, height: f32) -> Vec<egui::Vec2> {
    const TIMES: usize = 4;
    const POINTS: usize = 300;
    let size = glam::Vec2::splat(height);
    let places = (prepared.surfaces.iter()).flat_map(|surface| {
        let times = &surface.geometry.positions;
        let times = times.iter().step_by(times.len().div_ceil(TIMES).max(1));
        times.flat_map(|points| points.iter().step_by(points.len().div_ceil(POINTS).max(1)))
    });
    let seen = places.filter_map(|point| camera.project(glam::Vec3::from_array(*point), size));
    seen.map(|seen| seen.pixel - 0.5 * size)
        .map(|offset| egui::vec2(offset.x, offset.y))
        .collect()
}

/// Why colours that were chosen are not there; said once, at the selected subject.
fn missing_colours(state: &State, tile: &VisiblePose) -> Option<&'static str> {
    let document = &state.document;
    if document.bar_quantity() == Quantity::ThicknessRatio || document.visibility.atoms {
        let untold = matches!(state.wall_of(tile.subject), Some((Err(_), _)));
        return untold.then_some("Thickness not assessed");
    }
    let wanted = document.quantity == Quantity::Contribution && tile.subject == document.subject;
    wanted.then(|| hindrance(document)).flatten()
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

fn cube(axes: &SubjectAxes, camera: &Camera) -> CubeView {
    let direction = |v: crate::mesh::Vector3| glam::DVec3::new(v.x, v.y, v.z).as_vec3();
    CubeView {
        world_from_camera: camera.world_from_camera,
        base: direction(axes.up),
        septal: direction(axes.side),
        anterior: direction(axes.front),
        known: axes.named,
    }
}
