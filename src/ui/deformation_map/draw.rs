//! Draws the map of deformations: grid, clusters, hearts, and the selection on top.

use egui::{Align2, Rect, RichText, Sense, Shape, Stroke, Ui, UiBuilder, vec2};

use crate::ui::command::Command;
use crate::ui::deformation_map::clusters::{cluster_counts, cluster_name, hulls};
use crate::ui::deformation_map::{DeformationMapView, DeformationPoint};
use crate::ui::map_ground::{Ground, Labels, MapState, role_counts_ui};
use crate::ui::marks::role_mark;
use crate::ui::style::{medium_note_font, note};
use crate::ui::theme::{colours, line, space};

/// Draws everything on the ground; `pointed` is under the pointer or the keyboard.
pub fn draw_map(ui: &Ui, view: &DeformationMapView, ground: &Ground, pointed: Option<usize>) {
    let painter = ui.painter_at(ground.rect);
    let colours = colours(ui);
    ground.draw_grid(ui);
    if view.shows_clusters {
        for hull in hulls(view.points, ground, colours) {
            painter.add(hull.shape);
            let name = cluster_name(hull.cluster);
            let colour = colours.cluster(hull.cluster);
            let highest = ground.rect.top() + 16.0;
            let at = hull.letter_at - vec2(0.0, 2.0);
            let at = egui::pos2(at.x, at.y.max(highest));
            painter.text(at, Align2::CENTER_BOTTOM, name, medium_note_font(), colour);
        }
    }
    let dimmed = !matches!(view.state, MapState::Ready | MapState::Empty);
    let chosen =
        |point: &&DeformationPoint| [view.selected, view.compared].contains(&Some(point.subject));
    let strength = match (dimmed, view.selected.is_some()) {
        (true, _) => 0.35,
        (false, true) => 0.8,
        (false, false) => 0.95,
    };
    for point in view.points.iter().filter(|point| !chosen(point)) {
        let role = role_of(view, point);
        let colour = colours.pane.lerp_to_gamma(colours.role(role), strength);
        let at = ground.on_screen(point.at);
        role_mark(&painter, at, 4.5, role, colour, true);
    }
    draw_neighbours(view, ground, ui);
    let mut labels = Labels::new(&painter, ground.rect, colours.pane);
    let others = view.points.iter().map(|point| ground.on_screen(point.at));
    let others: Vec<_> = others.collect();
    // The second heart first: the selection lies on top of it.
    for (subject, colour) in [
        (view.compared, colours.strong),
        (view.selected, colours.selection),
    ] {
        let chosen = view.points.iter().find(|p| Some(p.subject) == subject);
        if let Some(point) = chosen {
            let at = ground.on_screen(point.at);
            painter.circle_filled(at, 8.5, colours.pane);
            role_mark(&painter, at, 5.5, role_of(view, point), colour, true);
            painter.circle_stroke(at, 9.5, Stroke::new(line::MARK, colour));
            labels.keep_free(Rect::from_center_size(at, vec2(20.0, 20.0)));
        }
    }
    for (subject, colour) in [
        (view.selected, colours.selection),
        (view.compared, colours.strong),
    ] {
        if let Some(point) = view.points.iter().find(|p| Some(p.subject) == subject)
            && let Some(subject) = view.subjects.get(point.subject)
        {
            labels.beside(
                ground.on_screen(point.at),
                14.0,
                subject.id.clone(),
                colour,
                &others,
            );
        }
    }
    if let Some(point) = pointed.and_then(|index| view.points.get(index)) {
        let at = ground.on_screen(point.at);
        painter.circle_stroke(at, 11.5, Stroke::new(line::MARK, colours.strong));
    }
}

/// Threads from the selected heart to those that move most like it.
fn draw_neighbours(view: &DeformationMapView, ground: &Ground, ui: &Ui) {
    let find = |subject: usize| view.points.iter().find(|point| point.subject == subject);
    let Some(point) = view.selected.and_then(find) else {
        return;
    };
    let painter = ui.painter_at(ground.rect);
    let stroke = Stroke::new(line::THIN, colours(ui).selection.gamma_multiply(0.55));
    for other in point.nearest.iter().copied().filter_map(find) {
        let ends = [ground.on_screen(point.at), ground.on_screen(other.at)];
        painter.extend(Shape::dashed_line(&ends, stroke, 3.0, 3.0));
    }
}

fn role_of(view: &DeformationMapView, point: &DeformationPoint) -> crate::study::LabelRole {
    view.subjects
        .get(point.subject)
        .map(|subject| subject.role)
        .unwrap_or_default()
}

/// Draws what the map keeps and how well, for the header: short where there is little room.
///
/// `kept` points of the width are for what stands on the left.
pub fn deformation_note(ui: &mut Ui, view: &DeformationMapView, kept: f32) {
    let long = note_parts(view, "neighbours ").join(" · ");
    let parts = note_parts(view, "k ");
    let room = ui.available_width() - kept;
    let width = |text: &str| {
        let font = crate::ui::style::note_font();
        let galley = ui
            .painter()
            .layout_no_wrap(text.to_owned(), font, egui::Color32::PLACEHOLDER);
        galley.size().x
    };
    // First words go where there is no room, then the last part.
    let fitting = std::iter::once(long.clone())
        .filter(|long| !long.is_empty())
        .chain(
            (1..=parts.len())
                .rev()
                .map(|count| parts[..count].join(" · ")),
        )
        .find(|text| width(text) <= room);
    if let Some(text) = fitting {
        ui.label(note(text))
            .on_hover_text(format!("{long}\n\n{WHAT}"));
    }
}

const WHAT: &str = "Locally linear embedding: every heart is written as a mixture of its \
                    neighbours, and lies in the plane where these mixtures fit best. The error is \
                    what the mixtures miss, as a share of the curves' spread. Time counts by its \
                    weight: so much of the pose map's unit for one beat.";

/// "neighbours 8", "error 0.012", "time × 1.4", as far as they are known.
fn note_parts(view: &DeformationMapView, neighbours: &str) -> Vec<String> {
    let neighbours = view.neighbours.map(|count| format!("{neighbours}{count}"));
    let error = view
        .reconstruction_error
        .map(|error| format!("error {}", significant(error)));
    let time = view
        .time_weight
        .map(|weight| format!("time × {}", significant(weight)));
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

/// Counts of roles on the left; clusters and their switch on the right.
pub fn legend_ui(ui: &mut Ui, view: &DeformationMapView, height: f32, commands: &mut Vec<Command>) {
    let (strip, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let inner = strip.shrink2(vec2(space::LARGE, 0.0));
    let mut row = ui.new_child(UiBuilder::new().max_rect(inner));
    row.set_height(height);
    let counts = cluster_counts(view.points);
    let wide = inner.width() > 240.0 + 34.0 * counts.len() as f32;
    egui::Sides::new().height(height).shrink_left().show(
        &mut row,
        |ui| {
            role_counts_ui(ui, view.subjects, wide);
            if !view.left_out.is_empty() && ui.available_width() > 70.0 {
                ui.add(egui::Label::new(note(view.left_out)).truncate())
                    .on_hover_text(view.left_out);
            }
        },
        |ui| {
            if counts.is_empty() {
                return;
            }
            ui.spacing_mut().item_spacing.x = space::SMALL;
            if wide && view.shows_clusters {
                for (cluster, count) in counts.iter().rev() {
                    let text = format!("{} {count}", cluster_name(*cluster));
                    let colour = colours(ui).cluster(*cluster);
                    ui.label(RichText::new(text).small().color(colour))
                        .on_hover_text(format!("{count} hearts in this cluster"));
                    ui.add_space(space::SMALL);
                }
            }
            let mut shown = view.shows_clusters;
            let box_ui = ui
                .checkbox(&mut shown, note("Clusters"))
                .on_hover_text("Groups that k-means finds without knowing the labels");
            if box_ui.clicked() {
                commands.push(Command::ToggleClusters);
            }
        },
    );
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
