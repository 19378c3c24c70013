//! The flat map: a grid, clusters, points and paths, and the legend below.

use egui::{Color32, Pos2, Ui};

use crate::panes::commands::Command;
use crate::ui::theme::colours;

use super::clusters::draw_clusters;
use super::draw::{Projection, draw_points};
use super::estimate::estimate_ui;
use super::ground::{Ground, ground_ui};
use super::keys;
use super::legend::{LEGEND, legend_ui};
use super::respond::{pointed_at, respond_ui};
use super::state::without_map_ui;
use super::view::ScatterView;

impl Projection for Ground {
    const HAS_DEPTH: bool = false;

    fn rect(&self) -> egui::Rect {
        self.rect
    }

    fn see(&self, at: [f64; 2], _share: f64) -> (Pos2, f32) {
        (self.on_screen(at), 0.0)
    }

    fn fade(&self, _depth: f32) -> f32 {
        1.0
    }
}

/// Draws a map with its legend, or says why there is none; `below` points of the height stay free.
pub fn scatter_map_ui(ui: &mut Ui, view: &ScatterView, below: f32, commands: &mut Vec<Command>) {
    if view.points.is_empty() {
        without_map_ui(ui, view, commands);
        return;
    }
    let ground = ground_ui(ui, view, LEGEND + below);
    let response = ground.response.clone();
    let hovered = ground.nearest(view, response.hover_pos());
    let on_key = keys::step(ui, view, &response, commands);
    ground.draw_grid(ui);
    if view.shows_clusters {
        draw_clusters(ui, view.points, &ground);
    }
    let selection = colours(ui).selection;
    let current: Vec<(Pos2, Color32)> = (view.current.iter())
        .map(|at| (ground.on_screen(*at), selection))
        .collect();
    let pointed = pointed_at(ui, view, &response, hovered.or(on_key));
    draw_points(ui, view, &ground, &current, pointed);
    estimate_ui(ui, view, &ground, &response, commands);
    let clicked = response.clicked().then(|| response.interact_pointer_pos());
    let clicked = clicked.and_then(|place| ground.nearest(view, place));
    respond_ui(ui, view, &ground, response, hovered, clicked, commands);
    legend_ui(ui, view, commands);
}
