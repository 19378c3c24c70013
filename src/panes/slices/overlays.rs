//! What lies over the slices: the surfaces of the subject, or those of the import as far as it is.

use std::sync::Arc;

use egui::Color32;

use super::section::section;
use super::slice::{Mark, Outline};
use crate::analysis::preparation::Road;
use crate::document::{ImageTool, ImportStep};
use crate::image::{Contour, ContourPart, VolumeFrame};
use crate::mesh::TriMesh;
use crate::panes::import::current::Current;
use crate::panes::pane_context::PaneContext;
use crate::study::{Subject, SurfaceKind};
use crate::ui::theme::Colours;

/// An outline belongs to the slice that it lies in up to this many slices.
const IN_SLICE: f64 = 0.5;

/// The shape that is looked at in the images.
pub enum Shown {
    /// None is there.
    Nothing,
    /// Surfaces of a subject, made or in the study, at a frame.
    Walls(Arc<Subject>, usize),
    /// The surface of a threshold or of labels.
    Preview(Arc<TriMesh>),
    /// Outlines in slices.
    Contours(Arc<Vec<Contour>>),
}

impl Shown {
    /// What the step of the import shows, else the subject of the images.
    pub fn of(cx: &PaneContext<'_>, current: Option<&Current>) -> Self {
        let document = &cx.state().document;
        let imported = current.and_then(|current| imported(cx, current));
        imported.unwrap_or_else(|| {
            let images = document.slices.images;
            let subject = images.and_then(|images| document.subject_of_images(images));
            let selected = subject.filter(|subject| *subject == document.subject);
            match selected.and_then(|_| document.selected()) {
                Some(subject) => Self::Walls(Arc::clone(subject), document.frame()),
                None => Self::Nothing,
            }
        })
    }

    /// Its outlines in a slice.
    pub fn outlines(
        &self,
        frame: &VolumeFrame,
        instant: usize,
        (normal, depth): (usize, usize),
    ) -> Vec<Outline> {
        let depth = depth as f64;
        match self {
            Self::Nothing => Vec::new(),
            Self::Walls(subject, at) => {
                let surfaces = subject.sequence.surfaces().iter();
                let outline = |surface: &crate::study::SurfaceSequence| {
                    let mesh = surface.frames().get(*at)?;
                    let colour = colour_of(surface.kind());
                    Some(outline(frame, mesh, (normal, depth), colour))
                };
                surfaces.filter_map(outline).collect()
            }
            Self::Preview(mesh) => {
                let colour = Colours::of(true).selection;
                vec![outline(frame, mesh, (normal, depth), colour)]
            }
            Self::Contours(contours) => {
                let here = contours.iter().filter(|contour| contour.instant == instant);
                let lines = here.filter_map(|contour| drawn(frame, contour, (normal, depth)));
                lines.collect()
            }
        }
    }
}

/// What the import shows at its step, once it is known.
fn imported(cx: &PaneContext<'_>, current: &Current) -> Option<Shown> {
    let document = &cx.state().document;
    match document.import.step {
        ImportStep::Images | ImportStep::Orientation | ImportStep::Cohort => None,
        ImportStep::Tissue => match current.settings.road {
            Road::Cine | Road::Contours => {
                let complete = current.needed().is_empty();
                let tissues = complete.then(|| cx.ask_at_rest(&current.tissues_query()));
                let found = tissues.as_ref().and_then(|tissues| tissues.latest());
                let found = found.map(|found| &found.contours);
                let frame = document.image_frame()?;
                Some(Shown::Contours(with_drawn(
                    found,
                    &current.settings.contours,
                    &frame,
                )))
            }
            Road::Spect | Road::Masks(_) => {
                let query = current.preview_query(document)?;
                let preview = cx.ask(&query).latest().cloned();
                Some(preview.map_or(Shown::Nothing, Shown::Preview))
            }
        },
        ImportStep::Walls => {
            let showing = current.ask_walls(cx)?;
            let made = showing.latest()?;
            // Volumes without tissues have no frame: nothing is drawn over them.
            let frame = made.prepared.instants.iter();
            let frame = frame
                .clone()
                .position(|instant| *instant == document.instant());
            Some(match frame {
                Some(frame) => Shown::Walls(Arc::clone(&made.subject), frame),
                None => Shown::Nothing,
            })
        }
    }
}

/// Outlines that were found, with those in their place that somebody drew: found ones follow only once the pointer is let go.
fn with_drawn(
    found: Option<&Arc<Vec<Contour>>>,
    drawn: &Arc<Vec<Contour>>,
    frame: &VolumeFrame,
) -> Arc<Vec<Contour>> {
    let Some(found) = found.filter(|_| !drawn.is_empty()) else {
        return Arc::clone(found.unwrap_or(drawn));
    };
    let slice = |contour: &Contour| {
        let first = contour
            .points
            .first()
            .map(|point| frame.voxel(*point).z.round());
        (
            contour.instant,
            contour.part,
            first.map(|slice| slice as i64),
        )
    };
    let taken: Vec<_> = drawn.iter().map(slice).collect();
    let others = found
        .iter()
        .filter(|contour| !taken.contains(&slice(contour)));
    Arc::new(others.chain(drawn.iter()).cloned().collect())
}

/// Marked points, while they are of interest.
pub fn marks(cx: &PaneContext<'_>, current: &Current, frame: &VolumeFrame) -> Vec<Mark> {
    let document = &cx.state().document;
    let step = document.import.step;
    let in_hand = cx.state().image_tool;
    if !(ImportStep::Orientation..=ImportStep::Walls).contains(&step) {
        return Vec::new();
    }
    let points = &current.settings.points;
    let named = [
        (ImageTool::Apex, "apex", points.apex),
        (ImageTool::Base, "base", points.base),
        (ImageTool::Septum, "septum", points.septum),
        (ImageTool::Blood, "blood", points.blood),
    ];
    let shown = step == ImportStep::Orientation;
    named
        .into_iter()
        .filter(|(tool, ..)| shown || in_hand == Some(*tool))
        .filter_map(|(_, name, place)| {
            Some(Mark {
                voxel: frame.voxel(place?),
                name,
            })
        })
        .collect()
}

fn outline(
    frame: &VolumeFrame,
    mesh: &TriMesh,
    (normal, depth): (usize, f64),
    colour: Color32,
) -> Outline {
    Outline {
        pieces: section(frame, mesh.vertices(), mesh.triangles(), normal, depth),
        colour,
    }
}

/// A closed outline, where it lies in the slice.
fn drawn(frame: &VolumeFrame, contour: &Contour, (normal, depth): (usize, f64)) -> Option<Outline> {
    let voxels: Vec<_> = (contour.points.iter())
        .map(|point| frame.voxel(*point))
        .collect();
    let within = |voxel: &crate::mesh::Point3| (voxel[normal] - depth).abs() <= IN_SLICE;
    if !voxels.iter().all(within) {
        return None;
    }
    let next = voxels.iter().cycle().skip(1);
    Some(Outline {
        pieces: voxels
            .iter()
            .zip(next)
            .map(|(from, to)| [*from, *to])
            .collect(),
        colour: contour_colour(contour.part),
    })
}

/// The colour of a surface over an image, which stands before black in both themes.
fn colour_of(kind: SurfaceKind) -> Color32 {
    let colours = Colours::of(true);
    match kind {
        SurfaceKind::Epicardium => colours.epicardium,
        _ => colours.endocardium,
    }
}

fn contour_colour(part: ContourPart) -> Color32 {
    let colours = Colours::of(true);
    match part {
        ContourPart::Endocardium => colours.endocardium,
        ContourPart::Epicardium => colours.epicardium,
        ContourPart::RightCavity => colours.accent,
    }
}
