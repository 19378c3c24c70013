//! The bull's-eye: the wall of the ventricle as a disc, apex in the middle, anterior wall up, septum left.

mod draw;
mod plot;
#[cfg(test)]
mod tests;

use egui::{Color32, Role, Sense, Ui, WidgetInfo, vec2};

use crate::analysis::segments::{FlatMap, Level, Segment};

pub use plot::BullsEyePick;
use plot::Plot;

/// What the disc is filled with. The colours are the caller's, so that they agree with its colour bar.
#[derive(Clone, Copy, Debug)]
pub enum BullsEyeFill<'a> {
    /// One colour per segment; `None` where nothing is told.
    Segments(&'a [Option<Color32>; Segment::COUNT]),
    /// One colour per level, for hearts whose orientation is not known.
    Levels(&'a [Option<Color32>; Level::ALL.len()]),
    /// One colour per vertex of the surface that was laid flat, blended between.
    Continuous {
        /// The surface on the disc.
        map: &'a FlatMap,
        /// One per vertex.
        colours: &'a [Color32],
    },
}

/// What the bull's-eye shows.
#[derive(Clone, Debug)]
pub struct BullsEyeView<'a> {
    /// What the disc is filled with.
    pub fill: BullsEyeFill<'a>,
    /// Whether septum and anterior wall are known. Without them no segment is named or numbered.
    pub oriented: bool,
    /// What the values are, as "Thickening".
    pub quantity: &'a str,
    /// Per segment the value with its unit, as "42 %"; empty where nothing is told. By the first
    /// segment of a level where the heart is not oriented.
    pub values: &'a [String; Segment::COUNT],
    /// The selected segment.
    pub selected: Option<Segment>,
    /// Segments in which the patch lies: outlined.
    pub outlined: &'a [Segment],
}

/// Draws the bull's-eye into what room there is and says what was clicked.
pub fn bulls_eye_ui(ui: &mut Ui, view: &BullsEyeView) -> Option<BullsEyePick> {
    let room = ui.available_size().max(vec2(120.0, 120.0));
    let (rect, response) = ui.allocate_exact_size(room, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "Bull's-eye"));
    let plot = Plot::new(rect);
    let hovered = (response.hover_pos()).and_then(|pointer| plot.pick(pointer, view.oriented));
    draw::draw(ui, view, &plot, hovered);
    let clicked = response
        .interact_pointer_pos()
        .filter(|_| response.clicked())
        .and_then(|pointer| plot.pick(pointer, view.oriented));
    if let Some(pick) = hovered {
        response.on_hover_text_at_pointer(hover_text(view, pick));
    }
    clicked
}

/// "2 · basal anteroseptal: Thickening 42 %".
fn hover_text(view: &BullsEyeView, pick: BullsEyePick) -> String {
    let (what, value) = match pick.segment {
        Some(segment) => (
            format!("{} · {}", segment.number(), segment.name()),
            &view.values[segment.index()],
        ),
        None => {
            let first = pick.level.segments().next();
            let index = first.map_or(0, Segment::index);
            (pick.level.name().to_owned(), &view.values[index])
        }
    };
    if value.is_empty() {
        format!("{what}: {} not told", view.quantity.to_lowercase())
    } else {
        format!("{what}: {} {value}", view.quantity.to_lowercase())
    }
}
