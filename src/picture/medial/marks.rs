//! What of the medial surface stands in a scene: discs, spokes, borders of patches, ANV and MP.

use std::sync::Arc;

use crate::analysis::medial::MedialSurface;
use crate::analysis::medial_space::PoseDescriptor;
use crate::analysis::segments::Segment;
use crate::mesh::{Point3, Vector3};
use crate::picture::colour_ranges::THICKNESS_RATIO;
use crate::picture::legend::{ColourLegend, USER_LIMITS};
use crate::picture::prepared::{PreparedSubject, SurfaceRole};
use crate::picture::quantity::Quantity;
use crate::picture::scene_settings::SceneSettings;
use crate::render::{
    ColourRange, GeometryPose, Lines, Points, Rgba, Scene, Shading, Surface, SurfaceColour,
};
use crate::study::SurfaceKind;

use super::outline::{Lies, dashed, rounded};
use super::settings::{PatchLook, SubjectMedial, WallPart};

/// How far a line lies off its surface, as a share of the radius there.
const LIFT: f64 = 0.1;
/// Lines are finer where another patch is selected.
const BORDER_WIDTH: [f32; 2] = [3.0, 1.6];
const UNSELECTED_OPACITY: f32 = 0.7;
/// Length of a dash and of the gap after it, as shares of the heart's size.
const DASH: [f64; 2] = [0.022, 0.018];
const SPOKE_WIDTH: f32 = 1.0;
const RING_WIDTH: f32 = 1.6;
const ARROW_WIDTH: f32 = 2.5;
const DOT_DIAMETER: f32 = 10.0;
/// Length of the arrow of ANV, and of its head, as shares of the heart's size.
const ARROW: [f64; 2] = [0.28, 0.05];

/// The colour bar of atoms.
pub(in crate::picture) fn atom_legend(
    heart: &SubjectMedial<'_>,
    prepared: &PreparedSubject,
    settings: &SceneSettings,
) -> Option<ColourLegend> {
    let note = if settings.medial.limits.is_some() {
        USER_LIMITS
    } else {
        "fixed limits, log scale"
    };
    ColourLegend::of(
        Quantity::ThicknessRatio,
        prepared.unit,
        atom_limits(settings),
        note,
        heart.prepared.extremes,
    )
}

fn atom_limits(settings: &SceneSettings) -> ColourRange {
    match settings.medial.limits {
        Some([low, high]) if low > 0.0 && high > low => ColourRange {
            low: low as f32,
            high: high as f32,
            ..THICKNESS_RATIO
        },
        _ => THICKNESS_RATIO,
    }
}

/// Adds what the settings ask for to the scene of a heart at a pose, told in frames.
pub(in crate::picture) fn add_marks(
    scene: &mut Scene,
    heart: &SubjectMedial<'_>,
    prepared: &PreparedSubject,
    settings: &SceneSettings,
    pose: GeometryPose,
) {
    let frames = &heart.prepared.drawn.frames;
    let (Some(from), Some(to)) = (frames.get(pose.from), frames.get(pose.to)) else {
        return;
    };
    let now = Now {
        from,
        to,
        share: f64::from(pose.blend),
    };
    let medial = &settings.medial;
    if medial.atoms {
        scene.surfaces.extend(disc_surface(heart, settings, pose));
    }
    let [red, green, blue] = settings.theme.selection;
    let colour = |opacity| [red, green, blue, opacity];
    if medial.spokes {
        let [red, green, blue] = settings.theme.muted;
        let strips = spokes(heart, &now);
        scene
            .lines
            .push(lines(strips, [red, green, blue, 0.8], SPOKE_WIDTH));
    }
    if medial.patches {
        let places = lies(prepared, settings);
        let [red, green, blue] = patch_colour(settings);
        let colour = |opacity| [red, green, blue, opacity];
        add_borders(scene, heart, &now, settings, &places, &colour);
    }
    if let Some(WallPart::Segment(segment)) = medial.part {
        let strips = rings(heart, segment, pose);
        scene.lines.push(lines(strips, colour(1.0), RING_WIDTH));
    }
    if medial.direction {
        let [red, green, blue] = patch_colour(settings);
        add_directions(scene, heart, pose, settings, [red, green, blue, 1.0]);
    }
    scene.lines.retain(|lines| !lines.strips.is_empty());
}

fn patch_colour(settings: &SceneSettings) -> [f32; 3] {
    match settings.medial.patch_look {
        PatchLook::Found => settings.theme.selection,
        PatchLook::Faint => settings.theme.muted,
    }
}

/// A medial surface between two frames.
struct Now<'a> {
    from: &'a MedialSurface,
    to: &'a MedialSurface,
    share: f64,
}

impl Now<'_> {
    fn between(&self, a: Point3, b: Point3) -> Point3 {
        a + self.share * (b - a)
    }

    fn centre(&self, atom: usize) -> Point3 {
        self.between(self.from.atoms[atom].position, self.to.atoms[atom].position)
    }

    fn feet(&self, atom: usize) -> [Point3; 2] {
        let [a, b] = [self.from, self.to].map(|frame| frame.atoms[atom].boundary_points());
        [0, 1].map(|side| self.between(a[side], b[side]))
    }

    /// A place on or near an atom where a line is seen.
    fn place(&self, atom: usize, lies: Lies) -> Point3 {
        let centre = self.centre(atom);
        let [inner, outer] = self.feet(atom);
        match lies {
            Lies::Middle => centre + LIFT * (outer - centre),
            Lies::Cavity => inner + LIFT * (inner - centre),
            Lies::InnerFromOutside => inner - LIFT * (inner - centre),
            Lies::Outside => outer + LIFT * (outer - centre),
        }
    }
}

fn lines(strips: Vec<Vec<[f32; 3]>>, colour: Rgba, width: f32) -> Lines {
    Lines {
        strips: Arc::new(strips),
        colour,
        width,
    }
}

fn single(point: Point3) -> [f32; 3] {
    point.coords.cast::<f32>().into()
}

fn disc_surface(
    heart: &SubjectMedial<'_>,
    settings: &SceneSettings,
    pose: GeometryPose,
) -> Option<Surface> {
    let map = Quantity::ThicknessRatio.colour_map()?;
    (!heart.prepared.discs.triangles.is_empty()).then(|| Surface {
        geometry: Arc::clone(&heart.prepared.discs),
        pose,
        colour: SurfaceColour::Scalars {
            scalars: Arc::clone(&heart.prepared.ratios),
            map: map.colours,
            limits: atom_limits(settings),
            below: map.below,
            above: map.above,
        },
        opacity: 1.0,
        shading: Shading::Smooth,
        wireframe: None,
        silhouette: 0.0,
        pickable: true,
    })
}

fn spokes(heart: &SubjectMedial<'_>, now: &Now<'_>) -> Vec<Vec<[f32; 3]>> {
    let beat = &heart.prepared.beat;
    let regular = (0..beat.regular.len()).filter(|&atom| beat.regular[atom]);
    regular
        .map(|atom| {
            let [inner, outer] = now.feet(atom);
            [inner, now.centre(atom), outer].map(single).to_vec()
        })
        .collect()
}

/// Where borders are drawn: on the medial surface where atoms are, and on each wall that hides it.
fn lies(prepared: &PreparedSubject, settings: &SceneSettings) -> Vec<Lies> {
    let role = |wanted: &dyn Fn(SurfaceRole) -> bool| {
        prepared.surfaces.iter().any(|surface| wanted(surface.role))
    };
    let inner = settings.inner && role(&|role| role == SurfaceRole::Inner);
    let outer = settings.outer
        && !inner
        && role(&|role| {
            matches!(
                role,
                SurfaceRole::Outer
                    | SurfaceRole::Alone(SurfaceKind::Wall | SurfaceKind::Epicardium)
            )
        });
    let mut places = Vec::new();
    if settings.medial.atoms || !(inner || outer) {
        places.push(Lies::Middle);
    }
    if inner {
        places.push(Lies::Cavity);
        if !settings.medial.atoms {
            places.push(Lies::InnerFromOutside);
        }
    }
    if outer {
        places.extend([Lies::Cavity, Lies::Outside]);
    }
    places
}

fn add_borders(
    scene: &mut Scene,
    heart: &SubjectMedial<'_>,
    now: &Now<'_>,
    settings: &SceneSettings,
    places: &[Lies],
    colour: &dyn Fn(f32) -> Rgba,
) {
    let selected = match settings.medial.part {
        Some(WallPart::Patch(patch)) => Some(patch),
        _ => None,
    };
    let mut strips = [Vec::new(), Vec::new()];
    for (index, patch) in heart.wall.thickening.patches.iter().enumerate() {
        let faint = settings.medial.patch_look == PatchLook::Faint;
        let fine = match selected {
            Some(patch) => patch != index,
            None => faint,
        };
        for &lies in places {
            let borders = patch.border.iter().map(|border| {
                let corners: Vec<[f64; 3]> = (border.iter())
                    .map(|&atom| now.place(atom as usize, lies).coords.into())
                    .collect();
                let line = rounded(&corners).into_iter();
                line.map(|point| point.map(|part| part as f32)).collect()
            });
            let borders = borders.filter(|line: &Vec<[f32; 3]>| !line.is_empty());
            let strips = &mut strips[usize::from(fine)];
            if faint {
                let lengths = DASH.map(|share| share * heart.wall.thickening.size);
                strips.extend(borders.flat_map(|line| dashed(&line, lengths)));
            } else {
                strips.extend(borders);
            }
        }
    }
    for (fine, strips) in strips.into_iter().enumerate() {
        let opacity = [1.0, UNSELECTED_OPACITY][fine];
        let border = lines(strips, colour(opacity), BORDER_WIDTH[fine]);
        scene.lines.push(border);
    }
}

/// Rings around the discs of a segment's atoms.
fn rings(heart: &SubjectMedial<'_>, segment: Segment, pose: GeometryPose) -> Vec<Vec<[f32; 3]>> {
    let atoms = heart.wall.segments.iter().enumerate();
    atoms
        .filter(|(_, of)| **of == Some(segment))
        .filter_map(|(atom, _)| {
            let mut ring = heart.prepared.disc(atom as u32, pose);
            ring.extend(ring.first().copied());
            (ring.len() > 2).then_some(ring)
        })
        .collect()
}

/// ANV from MP of every patch, or of all akinetic atoms where there is no patch.
fn add_directions(
    scene: &mut Scene,
    heart: &SubjectMedial<'_>,
    pose: GeometryPose,
    settings: &SceneSettings,
    colour: Rgba,
) {
    let thickening = &heart.wall.thickening;
    let frame = if pose.blend < 0.5 { pose.from } else { pose.to };
    let Some(step) = thickening.steps.iter().position(|step| step.from == frame) else {
        return;
    };
    let selected =
        |index: usize| !matches!(settings.medial.part, Some(WallPart::Patch(p)) if p != index);
    let mut descriptors: Vec<&PoseDescriptor> = (thickening.patches.iter().enumerate())
        .filter(|(index, _)| selected(*index))
        .filter_map(|(_, patch)| patch.path.get(step)?.as_ref())
        .collect();
    if thickening.patches.is_empty() {
        descriptors.extend(&thickening.steps[step].descriptor);
    }
    let place = |descriptor: &PoseDescriptor| heart.prepared.origin.counted(descriptor.position);
    let mut strips = Vec::new();
    for descriptor in &descriptors {
        if let Some(normal) = descriptor.normal {
            strips.extend(arrow(place(descriptor), normal, thickening.size));
        }
    }
    scene.lines.push(lines(strips, colour, ARROW_WIDTH));
    if !descriptors.is_empty() {
        let dots = descriptors.iter().map(|d| single(place(d))).collect();
        scene.points.push(Points {
            positions: Arc::new(dots),
            colours: Arc::new(vec![colour]),
            diameter: DOT_DIAMETER,
        });
    }
}

fn arrow(from: Point3, direction: Vector3, size: f64) -> Vec<Vec<[f32; 3]>> {
    let [length, head] = ARROW.map(|share| share * size);
    let tip = from + length * direction;
    let across = [Vector3::x(), Vector3::y(), Vector3::z()]
        .into_iter()
        .map(|axis| direction.cross(&axis))
        .max_by(|a, b| a.norm().total_cmp(&b.norm()))
        .and_then(|across| across.try_normalize(0.0))
        .unwrap_or_else(Vector3::x);
    let along = direction.cross(&across);
    let mut strips = vec![vec![single(from), single(tip)]];
    for side in [across, -across, along, -along] {
        let back = tip - head * direction + 0.45 * head * side;
        strips.push(vec![single(back), single(tip)]);
    }
    strips
}
