//! Patches of the selected heart in words: the table, the note over the picture, what is not assessed and why.

use crate::analysis::segments::{Level, Segment};
use crate::analysis::thickening::{Extent, Patch, Thickening};
use crate::app::shown_heart::ShownHeart;
use crate::app::state::State;
use crate::engine::{Engine, Showing, SubjectThickening, WorkKind};
use crate::mesh::Vector3;
use crate::picture::WallPart;
use crate::render::Camera;
use crate::ui::{PatchNote, PatchPanelView, PatchRow, WallState};

/// Share of a patch below which a segment goes without saying.
const LEAST_OF_PATCH: f64 = 0.05;
/// A framed patch has this much of the heart around it, as a share of the heart's size.
const LEAST_HALF_HEIGHT: f64 = 0.42;

/// Texts of the patch pane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PatchData {
    state: WallState,
    heading: String,
    note: String,
    rows: Vec<PatchRow>,
    noise: Option<f64>,
    tolerance: Option<f64>,
    well: Option<f64>,
}

impl PatchData {
    /// What is known of the selected heart's wall. `shown` is the heart on screen, for cameras.
    pub fn of(state: &State, engine: &Engine, shown: Option<&ShownHeart>) -> Self {
        let document = &state.document;
        let known = state.wall_of(document.subject);
        let wall = wall_state(state, engine);
        let Some((Ok(found), _)) = known else {
            return Self {
                state: wall,
                ..Self::default()
            };
        };
        let thickening = &found.thickening;
        let selected = match document.part {
            Some(WallPart::Patch(patch)) => Some(patch),
            _ => None,
        };
        let rows = thickening.patches.iter().enumerate();
        Self {
            heading: heading(thickening),
            note: extent_note(thickening),
            rows: rows
                .map(|(index, patch)| PatchRow {
                    selected: selected == Some(index),
                    camera: shown.and_then(|shown| patch_camera(found, patch, shown)),
                    ..row(found, patch)
                })
                .collect(),
            noise: Some(thickening.noise),
            tolerance: Some(thickening.tolerance),
            well: Some(thickening.well.exp() - 1.0),
            state: wall,
        }
    }

    /// How the wall stands.
    pub fn state(&self) -> &WallState {
        &self.state
    }

    /// What the pane shows.
    pub fn view<'a>(&'a self, state: &'a State) -> PatchPanelView<'a> {
        PatchPanelView {
            subject: state.document.selected().map(|subject| &*subject.id),
            state: &self.state,
            heading: &self.heading,
            note: &self.note,
            rows: &self.rows,
            settings: state.document.thickening,
            noise: self.noise,
            tolerance: self.tolerance,
            well: self.well,
        }
    }
}

/// How the wall of the selected heart stands.
pub fn wall_state(state: &State, engine: &Engine) -> WallState {
    if state.document.selected().is_none() {
        return WallState::Empty;
    }
    let known = state.wall_of(state.document.subject);
    match known {
        Some((Ok(_), true)) => return WallState::Ready,
        Some((Err(why), true)) => return WallState::NotAssessed(why.clone()),
        _ => {}
    }
    match engine.showing(WorkKind::Medial) {
        Showing::Stopped { .. } => WallState::Stopped,
        Showing::Computing { watch, .. } => WallState::Computing {
            fraction: watch.fraction(),
        },
        _ => WallState::Computing { fraction: 0.0 },
    }
}

/// "1 patch · 31 % of the LV".
fn heading(found: &Thickening) -> String {
    match (found.extent, found.patches.as_slice()) {
        (Extent::HardlyAnywhere, _) => "Hardly any thickening anywhere".to_owned(),
        (_, []) => "No patch".to_owned(),
        (_, patches) => {
            let share: f64 = patches.iter().map(|patch| patch.share).sum();
            let count = match patches.len() {
                1 => "1 patch".to_owned(),
                count => format!("{count} patches"),
            };
            format!("{count} · {} of the LV", percent(share))
        }
    }
}

/// What the whole wall does, in a sentence.
fn extent_note(found: &Thickening) -> String {
    let well = percent(found.well.exp() - 1.0);
    match found.extent {
        Extent::HardlyAnywhere => {
            format!(
                "Even the part that works best thickens by {well}: no part stands out as a patch"
            )
        }
        Extent::Everywhere => format!("All of the wall thickens, where it works well by {well}"),
        Extent::AllButPatches => format!("The rest of the wall thickens by {well}"),
    }
}

fn row(found: &SubjectThickening, patch: &Patch) -> PatchRow {
    PatchRow {
        area_cm2: patch.area_cm2,
        share: patch.share,
        thickening: patch.thickening.exp() - 1.0,
        confidence: patch.confidence,
        segments: if patch.segments.is_empty() {
            without_segments(found)
        } else {
            segment_words(patch)
        },
        ..PatchRow::default()
    }
}

fn without_segments(found: &SubjectThickening) -> String {
    match &found.without_axis {
        Some(why) => format!("segments not known: {why}"),
        None => "segments not known: the orientation is not".to_owned(),
    }
}

/// The walls that a patch touches, the largest share first, each with its levels: "basal–mid
/// anteroseptal, apical septal and inferior, apex".
pub fn segment_words(patch: &Patch) -> String {
    let mut walls: Vec<(&str, Vec<Level>)> = Vec::new();
    let told = (patch.segments.iter()).filter(|part| part.of_patch >= LEAST_OF_PATCH);
    for part in told {
        let wall = wall_of(part.segment);
        let level = part.segment.level();
        match walls.iter_mut().find(|(other, _)| *other == wall) {
            Some((_, levels)) => levels.push(level),
            None => walls.push((wall, vec![level])),
        }
    }
    // Walls of the same levels are said together.
    let mut groups: Vec<(String, Vec<&str>)> = Vec::new();
    for (wall, levels) in &mut walls {
        let levels = level_words(levels);
        match groups.iter_mut().find(|(other, _)| *other == levels) {
            Some((_, walls)) => walls.push(wall),
            None => groups.push((levels, vec![wall])),
        }
    }
    // The apex has no wall; it is said last.
    groups.sort_by_key(|(levels, _)| levels == Level::Apex.name());
    let words = groups.into_iter().map(|(levels, walls)| {
        if levels == Level::Apex.name() {
            levels
        } else {
            format!("{levels} {}", listed(&walls))
        }
    });
    words.collect::<Vec<_>>().join(", ")
}

/// "mid", "basal–apical", "basal and apical".
fn level_words(levels: &mut [Level]) -> String {
    levels.sort();
    match *levels {
        [] => String::new(),
        [only] => only.name().to_owned(),
        [first, .., last] => {
            let whole = last.index() - first.index() + 1 == levels.len();
            let between = if whole { "–" } else { " and " };
            format!("{}{between}{}", first.name(), last.name())
        }
    }
}

/// "septal, lateral and inferior".
fn listed(walls: &[&str]) -> String {
    match walls {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// The name without its level: "anteroseptal".
fn wall_of(segment: Segment) -> &'static str {
    let name = segment.name();
    name.split_once(' ').map_or(name, |(_, wall)| wall)
}

/// What the picture of a heart says of its patches; `None` where they are hidden or nothing is known yet.
pub fn patch_note(state: &State, subject: usize) -> Option<PatchNote> {
    let document = &state.document;
    if !document.visibility.patches {
        return None;
    }
    let (Ok(found), _) = state.wall_of(subject)? else {
        return None;
    };
    let thickening = &found.thickening;
    let chosen = match document.part {
        Some(WallPart::Patch(patch)) if subject == document.subject => Some(patch),
        _ => None,
    };
    let one = match (thickening.patches.as_slice(), chosen) {
        ([only], _) => Some((0, only)),
        (patches, Some(index)) => patches.get(index).map(|patch| (index, patch)),
        _ => None,
    };
    let mut heading = heading(thickening);
    let mut lines = Vec::new();
    if let Some((index, patch)) = one {
        if thickening.patches.len() > 1 {
            let count = thickening.patches.len();
            heading = format!(
                "Patch {} of {count} · {} of the LV",
                index + 1,
                percent(patch.share)
            );
        }
        if !patch.segments.is_empty() {
            lines.push(segment_words(patch));
        }
        let area = patch.area_cm2.map(|area| format!("{} · ", area_text(area)));
        lines.push(format!(
            "{}PT {:.2} × · elsewhere {:.2} ×",
            area.unwrap_or_default(),
            patch.thickening.exp(),
            thickening.well.exp()
        ));
    } else {
        for patch in thickening.patches.iter().take(3) {
            let area = patch
                .area_cm2
                .map_or_else(|| percent(patch.share), area_text);
            lines.push(match patch.segments.as_slice() {
                [] => area,
                _ => format!("{area} · {}", segment_words(patch)),
            });
        }
    }
    Some(PatchNote {
        heading,
        lines,
        found: !thickening.patches.is_empty(),
    })
}

/// No more digits than an area deserves.
fn area_text(area_cm2: f64) -> String {
    if area_cm2 < 9.95 {
        format!("{area_cm2:.1} cm²")
    } else {
        format!("{area_cm2:.0} cm²")
    }
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

/// A camera in the heart's axes that looks straight at a patch, base up.
fn patch_camera(found: &SubjectThickening, patch: &Patch, shown: &ShownHeart) -> Option<Camera> {
    let rest = found.beat.frames.get(found.thickening.end_diastole)?;
    let normal: Vector3 = (patch.atoms.iter())
        .filter_map(|&atom| rest.normals.get(atom as usize))
        .sum();
    let axes = &shown.heart.prepared.axes;
    // A patch all around has no direction of its own: it is seen from the front.
    let least = 0.2 * patch.atoms.len() as f64;
    let towards = if normal.norm() > least {
        normal.normalize()
    } else {
        axes.front
    };
    let reach = (patch.atoms.iter())
        .filter_map(|&atom| rest.atoms.get(atom as usize))
        .map(|atom| (atom.position - patch.centroid).norm())
        .fold(0.0, f64::max);
    let half_height = (1.25 * reach).max(LEAST_HALF_HEIGHT * found.thickening.size);
    let to_f32 = |v: Vector3| glam::DVec3::new(v.x, v.y, v.z).as_vec3();
    let camera = Camera {
        target: to_f32(patch.centroid.coords),
        world_from_camera: facing(to_f32(towards), to_f32(axes.up), to_f32(axes.front)),
        half_height: half_height as f32,
        ..Camera::default()
    };
    Some(shown.heart.frame.heart_camera(camera))
}

/// Rotation whose z axis is `towards` and whose y axis is as near to `up` as can be.
fn facing(towards: glam::Vec3, up: glam::Vec3, other: glam::Vec3) -> glam::Quat {
    let z = towards.normalize_or_zero();
    let up = if up.dot(z).abs() > 0.95 { other } else { up };
    let x = up.cross(z).normalize_or_zero();
    let y = z.cross(x);
    glam::Quat::from_mat3(&glam::Mat3::from_cols(x, y, z)).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::thickening::{PatchSegment, Steadiness};
    use crate::mesh::Point3;

    fn patch(segments: &[u8]) -> Patch {
        let part = |number: &u8| PatchSegment {
            segment: Segment::new(*number).unwrap(),
            of_segment: 0.5,
            of_patch: 1.0 / segments.len() as f64,
        };
        Patch {
            atoms: Vec::new(),
            area: 1.0,
            area_cm2: None,
            share: 0.1,
            segments: segments.iter().map(part).collect(),
            centroid: Point3::origin(),
            border: Vec::new(),
            thickening: 0.0,
            confidence: 1.0,
            path: Vec::new(),
            steadiness: Steadiness::default(),
        }
    }

    #[test]
    fn segments_are_said_as_a_person_would() {
        let said = |segments: &[u8]| segment_words(&patch(segments));
        assert_eq!(said(&[8]), "mid anteroseptal");
        assert_eq!(said(&[2, 8]), "basal–mid anteroseptal");
        assert_eq!(said(&[1, 13]), "basal and apical anterior");
        assert_eq!(said(&[7, 17, 1, 13]), "basal–apical anterior, apex");
        let wide = said(&[8, 2, 14, 16, 15, 9]);
        assert_eq!(
            wide,
            "basal–mid anteroseptal, apical septal, lateral and inferior, mid inferoseptal"
        );
        assert_eq!(said(&[]), "");
    }

    #[test]
    fn a_camera_faces_what_it_looks_at_with_the_base_up() {
        let towards = glam::Vec3::new(0.6, 0.1, 0.7).normalize();
        for towards in [towards, glam::Vec3::Z] {
            let turn = facing(towards, glam::Vec3::Z, glam::Vec3::X);
            assert!((turn * glam::Vec3::Z - towards).length() < 1e-6);
        }
        let turn = facing(towards, glam::Vec3::Z, glam::Vec3::X);
        assert!((turn * glam::Vec3::Y).z > 0.0);
        assert!((turn * glam::Vec3::X).z.abs() < 1e-6);
    }
}
