//! The words of the deformation map, its note, and the card below it.

use egui::Ui;

use crate::analysis::deformations::Comparison;
use crate::engine::{ClassesBy, DeformationMapQuery, Topic};
use crate::panes::commands::{Command, MapCommand};
use crate::panes::scatter_map::{MapWords, ScatterView, play, scatter_map_ui};
use crate::ui::controls::{choices_ui, chooser_ui};
use crate::ui::style::{note, note_font};

use super::classes::{self, ClassesView};

/// What the deformation map shows.
#[derive(Clone, Debug)]
pub struct DeformationMapView<'a> {
    /// Its points, and how the map stands.
    pub map: ScatterView<'a>,
    /// What of two beats is compared.
    pub comparison: Comparison,
    /// Size of the neighbourhoods that the map keeps.
    pub neighbours: Option<usize>,
    /// How far points are from what their neighbours say of them; no unit.
    pub reconstruction_error: Option<f64>,
    /// Kruskal's stress where the map is one of the distances by stress majorisation; no unit.
    pub stress: Option<f64>,
    /// How much of the map's unit one cycle counts for.
    pub time_weight: Option<f64>,
    /// How well classifiers find the labels.
    pub classes: ClassesView<'a>,
    /// What subjects are classified by, where the study offers labels and classes.
    pub classes_by: Option<ClassesBy>,
}

/// The words of the map.
pub static DEFORMATION_MAP: MapWords = MapWords {
    job: Topic::of::<DeformationMapQuery>(),
    name: "Deformation map",
    item: "Deformation",
    empty: "No deformations",
    what: "Every subject is one point here; subjects that deform alike lie near each other, whatever their shape unless \
           that is compared, too.",
    none: "The deformation map could not be computed",
    hints: &["Click to play this subject"],
    command: play,
};

/// Draws the map with its legend and, below, how well classifiers find the labels.
pub fn deformation_map_ui(ui: &mut Ui, view: &DeformationMapView, commands: &mut Vec<Command>) {
    let card = classes::height(ui.available_size(), &view.classes);
    scatter_map_ui(ui, &view.map, card, commands);
    if card > 0.0 && !view.map.points.is_empty() {
        classes::classes_ui(ui, &view.classes, view.classes_by, card, commands);
    }
}

/// Draws what is compared, as a chooser, and beside it what the map keeps and how well: short where there is little room.
///
/// `kept` points of the width are for what stands on the left.
pub fn deformation_header_ui(
    ui: &mut Ui,
    view: &DeformationMapView,
    kept: f32,
    commands: &mut Vec<Command>,
) {
    // Without room for the chooser, menu and palette have its choices.
    if ui.available_width() - kept > 150.0 {
        let now = view.comparison.name();
        let chooser = chooser_ui(ui, "Compare", now, |ui| {
            let named = Comparison::NAMED.map(|comparison| (comparison.name(), comparison.name()));
            let chosen = choices_ui(ui, named, now);
            let wanted = Comparison::NAMED
                .into_iter()
                .find(|c| Some(c.name()) == chosen);
            commands.extend(wanted.map(|wanted| MapCommand::SetComparison(wanted).into()));
        });
        chooser.on_hover_text(COMPARISONS);
    }
    deformation_note(ui, view, kept);
}

const COMPARISONS: &str = "Deformation: motion relative to the own end-diastole, transported onto the mean shape. \
                           Shape: the end-diastolic pose, size normalised. Both: squared distances, each over its median. \
                           Curves of poses: poses with their shape, as on the pose map.";

/// Draws what the map keeps and how well: short where there is little room.
pub fn deformation_note(ui: &mut Ui, view: &DeformationMapView, kept: f32) {
    let long = note_parts(view, ["neighbours", "reconstruction error"]).join(" · ");
    let parts = note_parts(view, ["k", "error"]);
    let room = ui.available_width() - kept;
    let fits = |text: &String| {
        let text = text.clone();
        let painter = ui.painter();
        let galley = painter.layout_no_wrap(text, note_font(), egui::Color32::PLACEHOLDER);
        galley.size().x <= room
    };
    // Where there is no room, words go first, then the last part.
    let shorter = (0..=parts.len())
        .rev()
        .map(|count| parts[..count].join(" · "));
    let fitting = std::iter::once(long.clone()).chain(shorter).find(fits);
    if let Some(text) = fitting.filter(|text| !text.is_empty()) {
        ui.label(note(text))
            .on_hover_text(format!("{long}\n\n{EXPLANATION}"));
    }
}

const EXPLANATION: &str = "Locally linear embedding: the motion of every subject is reconstructed \
                           from its neighbours, and is embedded where these reconstructions fit \
                           best. Error: reconstruction error relative to the variance of the \
                           motions. Where neighbourhoods fall into separate parts, the map is one of the distances \
                           themselves, by stress majorisation, and has a stress instead. Time, where curves of poses are compared, has this weight, in units of \
                           the pose map per cycle.";

/// "neighbours 8", "reconstruction error 0.012", "time × 1.4", as far as they are known; "SMACOF", "stress 0.12" where the map
/// is one of distances.
fn note_parts(view: &DeformationMapView, [neighbours, error]: [&str; 2]) -> Vec<String> {
    let [neighbours, error] = match view.stress {
        Some(stress) => [
            Some("SMACOF".to_owned()),
            Some(format!("stress {}", significant(stress))),
        ],
        None => [
            view.neighbours.map(|count| format!("{neighbours} {count}")),
            (view.reconstruction_error).map(|value| format!("{error} {}", significant(value))),
        ],
    };
    let time = view.time_weight;
    let time = time.map(|weight| format!("time × {}", significant(weight)));
    [neighbours, error, time].into_iter().flatten().collect()
}

/// Two figures: what an error or a weight deserves; one where it is very small.
fn significant(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let first_digit = -value.abs().log10().floor() as i32;
    if first_digit > 5 {
        return "< 0.00001".to_owned();
    }
    let digits = first_digit + i32::from(first_digit < 3);
    format!("{value:.*}", digits.max(0) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_two_figures() {
        assert_eq!(significant(0.01234), "0.012");
        assert_eq!(significant(1.416), "1.4");
        assert_eq!(significant(23.4), "23");
        assert_eq!(significant(0.0), "0");
        assert_eq!(significant(8.7e-5), "0.00009");
        assert_eq!(significant(1.2e-7), "< 0.00001");
    }
}
