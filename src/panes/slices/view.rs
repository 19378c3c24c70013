//! The pane "Images": three slices that cross at one point, and whose heart at which instant they show.

use std::sync::Arc;

use egui::{Rect, Ui, vec2};

use super::contour_drag::{dragged as moved_outline, nearest, put};
use super::grey::FoundWindow;
use super::overlays::{Shown, marks};
use super::plane::SlicePlane;
use super::slice::{SliceTile, value_text};
use super::surface::surface_ui;
use super::texture::{SlicePicture, SliceTextures};
use crate::document::{State, image_timing};
use crate::io::ImageSeries;
use crate::mesh::Point3;
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, FileCommand, ImagesCommand};
use crate::panes::import::current::Current;
use crate::panes::import::tools::{clicked, strokes};
use crate::panes::pane_context::PaneContext;
use crate::ui::controls::empty_pane_ui;
use crate::ui::style::{note, title_font};
use crate::ui::theme::{colours, space};

/// Draws the slices, or what would fill the pane.
pub fn slices_ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let state = cx.state();
    let Some(series) = state.document.shown_series() else {
        no_images_ui(ui, state, commands);
        return;
    };
    let area = ui.available_rect_before_wrap().shrink(space::MEDIUM);
    let [first, second, third, rest] = tiles(area);
    let current = Current::shown(cx);
    let over = Over {
        shown: Shown::of(cx, current.as_ref()),
        current,
    };
    for (normal, rect) in [(2, first), (1, second), (0, third)] {
        slice_ui(ui, cx, (series, &over), (normal, rect), commands);
    }
    let mut facts = ui.new_child(egui::UiBuilder::new().max_rect(rest.shrink(space::SMALL)));
    facts_ui(&mut facts, cx, series);
    let below = rest.with_min_y(facts.min_rect().bottom() + space::SMALL);
    surface_ui(ui, cx, below, &over.shown);
}

/// What lies over the slices, and whose import a click belongs to.
struct Over {
    shown: Shown,
    current: Option<Current>,
}

/// Four tiles, two above two.
fn tiles(area: Rect) -> [Rect; 4] {
    let size = 0.5 * (area.size() - vec2(space::SMALL, space::SMALL));
    let size = size.max(vec2(1.0, 1.0));
    let step = size + vec2(space::SMALL, space::SMALL);
    [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]]
        .map(|[column, row]| Rect::from_min_size(area.min + vec2(column, row) * step, size))
}

fn no_images_ui(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let whose = (state.document.selected()).filter(|_| !state.document.images().is_empty());
    let heading = match whose {
        Some(subject) => format!("No images of {}", subject.id),
        None => "No images".to_owned(),
    };
    let what = "Gated SPECT, cine MR or label images (DICOM, NIfTI, NRRD, MetaImage, also zipped) are shown here in three \
                slices, with the outlines of the surfaces over them.";
    empty_pane_ui(ui, &heading, what, |ui| {
        command_button_ui(ui, "Open folder…", FileCommand::ChooseFolder, commands);
    });
}

fn slice_ui(
    ui: &mut Ui,
    cx: &PaneContext<'_>,
    (series, over): (&Arc<ImageSeries>, &Over),
    (normal, rect): (usize, Rect),
    commands: &mut Vec<Command>,
) {
    let state = cx.state();
    let document = &state.document;
    let Some((frame, cross)) = document.image_frame().zip(document.crosshair()) else {
        return;
    };
    let frame = &frame;
    let instant = document.instant();
    let found = cx.memo().get::<FoundWindow>().borrow_mut().of(series);
    let window = document.slices.window.unwrap_or(found);
    let mut tile = SliceTile {
        frame,
        plane: SlicePlane::new(frame, normal),
        cross: frame.voxel(cross),
        texture: None,
        window,
        outlines: Vec::new(),
        marks: Vec::new(),
        oriented: series.position_known,
        measured: document.images_are_measured(),
        value: &|voxel| value_at(series, instant, voxel),
    };
    let picture = SlicePicture {
        plane: tile.plane,
        depth: tile.depth(),
        instant,
        window,
        smooth: document.slices.smooth,
    };
    let textures = cx.memo().get::<SliceTextures>();
    tile.texture = textures.borrow_mut().texture(ui.ctx(), series, picture);
    if document.slices.outlines {
        let outlines = over.shown.outlines(frame, instant, (normal, tile.depth()));
        tile.outlines = outlines;
    }
    if let Some(current) = &over.current {
        tile.marks = marks(cx, current, frame);
    }
    if let Some(place) = tile.ui(ui, rect, commands) {
        let at = frame.position(place.voxel);
        let dragged = dragged_outline(ui, cx, over, (&tile, at, place.dragged));
        commands.extend(dragged.or_else(|| place_command(state, over, (at, place.dragged))));
    }
    if !cx.pointer_held {
        ui.data_mut(|data| data.remove::<Grip>(grip_id()));
    }
}

/// The corner of an outline that is dragged, with where the pointer was.
#[derive(Clone, Copy)]
struct Grip {
    corner: Option<usize>,
    at: Point3,
}

/// A corner is gripped within this distance of the pointer, in millimetres.
const GRIP_MM: f64 = 5.0;

fn grip_id() -> egui::Id {
    egui::Id::unique("gripped outline")
}

/// While outlines are shown, a drag that begins at one moves it.
fn dragged_outline(
    ui: &Ui,
    cx: &PaneContext<'_>,
    over: &Over,
    (tile, at, dragged): (&SliceTile<'_>, Point3, bool),
) -> Option<Command> {
    let (Shown::Contours(contours), Some(current)) = (&over.shown, &over.current) else {
        return None;
    };
    if !dragged || cx.state().image_tool.is_some() {
        return None;
    }
    let instant = cx.state().document.instant();
    let begun: Option<Grip> = ui.data(|data| data.get_temp(grip_id()));
    let Some(grip) = begun else {
        let found = nearest(contours, instant, at, GRIP_MM);
        let corner = found.map(|(_, corner)| corner);
        ui.data_mut(|data| data.insert_temp(grip_id(), Grip { corner, at }));
        return None;
    };
    // A drag that began elsewhere moves the crosshair.
    grip.corner?;
    let (number, corner) = nearest(contours, instant, grip.at, GRIP_MM)?;
    let of = contours.get(number)?;
    ui.data_mut(|data| {
        data.insert_temp(
            grip_id(),
            Grip {
                corner: Some(corner),
                at,
            },
        )
    });
    let moved = moved_outline(of, corner, at - grip.at);
    let (frame, normal, depth) = (tile.frame, tile.plane.normal, tile.depth() as f64);
    current.changed(true, |settings| {
        put(settings, moved, |contour| {
            let first = contour.points.first();
            first.is_some_and(|point| (frame.voxel(*point)[normal] - depth).abs() <= 0.5)
        });
    })
}

/// What a click or a stroke at a position asks for: the tool in hand, else the crosshair.
fn place_command(state: &State, over: &Over, (at, dragged): (Point3, bool)) -> Option<Command> {
    let crosshair = || Some(ImagesCommand::MoveTo(at).into());
    let Some((tool, current)) = state.image_tool.zip(over.current.as_ref()) else {
        return crosshair();
    };
    if dragged && !strokes(tool) {
        return crosshair();
    }
    clicked(current, tool, state.document.import.eraser_mm, at, dragged)
}

/// The value of the voxel nearest to a place of the grid.
fn value_at(series: &ImageSeries, instant: usize, voxel: Point3) -> Option<f32> {
    let size = series.image.frame().size();
    let mut index = 0;
    for axis in [2, 1, 0] {
        let place = voxel[axis].round();
        if !(place >= 0.0 && place < size[axis] as f64) {
            return None;
        }
        index = index * size[axis] + place as usize;
    }
    let value = *series.image.volumes().get(instant)?.get(index)?;
    value.is_finite().then_some(value)
}

/// Whose heart it is, at which instant, and what the image is like.
fn facts_ui(ui: &mut Ui, cx: &PaneContext<'_>, series: &ImageSeries) {
    let document = &cx.state().document;
    let strong = colours(ui).strong;
    let id = document.shown_images().map_or("", |images| &images.id);
    let title = egui::RichText::new(id).font(title_font()).color(strong);
    ui.add(egui::Label::new(title).truncate());
    ui.add(egui::Label::new(instant_words(cx.state(), series)).truncate());
    for line in facts(series) {
        ui.add(egui::Label::new(note(line)).wrap());
    }
    let found = cx.memo().get::<FoundWindow>();
    let shown = (document.shown_series()).map(|series| found.borrow_mut().of(series));
    if let Some(window) = document.slices.window.or(shown) {
        let [width, level] = [window.width, window.level].map(|value| value_text(value as f32));
        ui.add(egui::Label::new(note(format!("Window {width} · level {level}"))).truncate());
    }
}

/// "Gate 3 of 8 · 250 ms · ED".
pub fn instant_words(state: &State, series: &ImageSeries) -> String {
    let document = &state.document;
    let (instant, count) = (document.instant(), document.instant_count());
    if count == 1 {
        return "One volume".to_owned();
    }
    let what = if series.gates.is_some() {
        "Gate"
    } else {
        "Frame"
    };
    let mut words = format!("{what} {} of {count}", instant + 1);
    let timing = image_timing(series);
    if let Some(time) = timing.time_at(instant as f64, count) {
        words += &format!(" · {:.0} ms", 1e3 * time.0);
    }
    if document.selected().is_some() {
        let frame = Some(document.frame());
        let (end_diastole, end_systole) = state.phases_of(document.subject);
        if frame == end_diastole {
            words += " · ED";
        } else if frame == end_systole {
            words += " · ES";
        }
    }
    words
}

/// What the image is like: kind, size, distances.
fn facts(series: &ImageSeries) -> Vec<String> {
    let [i, j, k] = series.image.frame().size();
    let kind = series.modality.map_or("", |modality| modality.letters());
    let kind = format!("{kind} {}", series.format);
    let spacing = series.image.frame().spacing();
    let [x, y, z] = spacing.map(|length| format!("{length:.1}"));
    let apart = match series.spacing_known() {
        true => format!("{x} × {y} × {z} mm apart"),
        false => "distances between voxels not in the file".to_owned(),
    };
    let mut lines = vec![format!("{} · {i} × {j} × {k} voxels, {apart}", kind.trim())];
    if !series.position_known {
        lines.push("Position in the patient not in the file: no directions are named".to_owned());
    }
    if !series.times_known() {
        lines.push("Times of the volumes not in the file".to_owned());
    }
    lines
}
