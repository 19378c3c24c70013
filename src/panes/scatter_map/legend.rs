//! The strip below a map: how many subjects of each class it holds, how well it fits, and its clusters.

use egui::{Align2, RichText, Sense, Ui, UiBuilder, pos2, vec2};

use crate::panes::commands::{Command, MapCommand};
use crate::study::LabelRole;
use crate::ui::marks::{role_mark, role_name};
use crate::ui::style::{note, note_font};
use crate::ui::theme::{colours, space};

use super::clusters::{cluster_counts, cluster_name};
use super::view::ScatterView;

/// Height of the strip.
pub const LEGEND: f32 = 26.0;

/// Lines of the hover for subjects that are not on the map.
const MAX_LINES: usize = 12;

/// Counts of classes on the left; on the right the clusters or, where there are none, the note.
pub fn legend_ui(ui: &mut Ui, view: &ScatterView, commands: &mut Vec<Command>) {
    let (strip, _) = ui.allocate_exact_size(vec2(ui.available_width(), LEGEND), Sense::hover());
    let inner = strip.shrink2(vec2(space::LARGE, 0.0));
    let mut row = ui.new_child(UiBuilder::new().max_rect(inner));
    row.set_height(LEGEND);
    let clusters = cluster_counts(view.points);
    let sides = egui::Sides::new().height(LEGEND);
    if clusters.is_empty() {
        let wide = inner.width() > 330.0;
        sides.shrink_right().truncate().show(
            &mut row,
            |ui| role_counts_ui(ui, view, wide),
            |ui| note_ui(ui, view, &trust_text(view)),
        );
    } else {
        let wide = inner.width() > 240.0 + 34.0 * clusters.len() as f32;
        sides.shrink_left().show(
            &mut row,
            |ui| {
                role_counts_ui(ui, view, wide);
                if !view.left_out.is_empty() {
                    note_ui(ui, view, &left_out_text(view));
                }
            },
            |ui| clusters_ui(ui, view, &clusters, wide, commands),
        );
    }
}

/// Draws one entry per class that occurs; names are left to the hover where there is little room.
fn role_counts_ui(ui: &mut Ui, view: &ScatterView, wide: bool) {
    let subjects = view.points.chunk_by(|a, b| a.subject == b.subject);
    let roles: Vec<LabelRole> = subjects
        .map(|points| view.role(points[0].subject))
        .collect();
    for role in [LabelRole::Normal, LabelRole::Abnormal, LabelRole::Unknown] {
        let count = roles.iter().filter(|other| **other == role).count();
        if count > 0 {
            role_count_ui(ui, role, count, wide);
        }
    }
}

fn role_count_ui(ui: &mut Ui, role: LabelRole, count: usize, wide: bool) {
    let colours = colours(ui);
    ui.spacing_mut().item_spacing.x = space::SMALL;
    let (mark, _) = ui.allocate_exact_size(vec2(10.0, 12.0), Sense::hover());
    let filled = role != LabelRole::Unknown;
    role_mark(ui, mark.center(), 4.0, role, filled);
    let name = format!("{} {count}", role_name(role));
    let text = if wide {
        name.clone()
    } else {
        count.to_string()
    };
    let galley = ui
        .painter()
        .layout_no_wrap(text, note_font(), colours.muted);
    let (rect, response) = ui.allocate_exact_size(galley.size(), Sense::hover());
    let at = Align2::LEFT_CENTER
        .align_size_within_rect(galley.size(), rect)
        .min;
    ui.painter().galley(pos2(at.x, at.y), galley, colours.muted);
    response.on_hover_text(name);
    ui.add_space(space::MEDIUM);
}

fn note_ui(ui: &mut Ui, view: &ScatterView, text: &str) {
    if ui.available_width() > 70.0 {
        ui.add(egui::Label::new(note(text)).truncate())
            .on_hover_text(explanation(view));
    }
}

/// "stress 0.09 · 3 not on the map".
fn trust_text(view: &ScatterView) -> String {
    let rest = if view.left_out.is_empty() {
        "axes have no unit".to_owned()
    } else {
        left_out_text(view)
    };
    if view.note.is_empty() {
        rest
    } else {
        format!("{} · {rest}", view.note)
    }
}

fn left_out_text(view: &ScatterView) -> String {
    format!("{} not on the map", view.left_out.len())
}

fn explanation(view: &ScatterView) -> String {
    let mut text = view.explanation.clone();
    if !view.left_out.is_empty() {
        text += "\nNot on the map:";
        let lines = view.left_out.iter().take(MAX_LINES);
        lines.for_each(|line| text += &format!("\n{line}"));
        if view.left_out.len() > MAX_LINES {
            text += &format!("\nand {} more", view.left_out.len() - MAX_LINES);
        }
    }
    text
}

fn clusters_ui(
    ui: &mut Ui,
    view: &ScatterView,
    clusters: &[(usize, usize)],
    wide: bool,
    commands: &mut Vec<Command>,
) {
    ui.spacing_mut().item_spacing.x = space::SMALL;
    if wide && view.shows_clusters {
        for (cluster, count) in clusters.iter().rev() {
            let text = format!("{} {count}", cluster_name(*cluster));
            let colour = colours(ui).cluster(*cluster);
            ui.label(RichText::new(text).small().color(colour))
                .on_hover_text(format!("{count} subjects in this cluster"));
            ui.add_space(space::SMALL);
        }
    }
    let mut shown = view.shows_clusters;
    let box_ui = ui
        .checkbox(&mut shown, note("Clusters"))
        .on_hover_text("Groups that k-means finds without knowing the labels");
    if box_ui.clicked() {
        commands.push(MapCommand::ToggleClusters.into());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::scatter_map::tests::{Map, view};

    #[test]
    fn the_note_ends_with_who_is_missing_and_the_hover_names_twelve_of_them() {
        let map = Map::default();
        let mut view = view(&map);
        assert_eq!(trust_text(&view), "stress 0.08 · axes have no unit");
        let missing: Vec<String> = (0..14).map(|index| format!("M{index}: no wall")).collect();
        view.left_out = &missing;
        assert_eq!(trust_text(&view), "stress 0.08 · 14 not on the map");
        let lines = explanation(&view);
        assert!(lines.contains("\nM11: no wall\nand 2 more"));
        assert!(!lines.contains("M12"));
        view.note.clear();
        assert_eq!(trust_text(&view), "14 not on the map");
    }
}
