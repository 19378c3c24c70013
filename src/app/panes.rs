//! The tiles of the window: their headers, borders and contents.

use std::collections::{HashMap, HashSet};

use egui::epaint::RectShape;
use egui::{Color32, CornerRadius, Rect, Sense, Shape, Stroke, StrokeKind, Ui};
use egui_tiles::{
    Behavior, Container, ResizeState, SimplificationOptions, TabState, Tabs, Tile, TileId, Tiles,
    Tree, UiResponse,
};

use crate::panes::{Command, Header, Pane, PaneContext, PaneSpec, spec_of};
use crate::ui::theme::{colours, line, radius, space};
use crate::ui::{medium_font, named_header_ui, pane_header_ui, tab_ui, text_width};

use super::corners::corner_masks;
use super::layout::PaneTile;
use super::tab_strip::{air_behind, fitted_tabs_ui};

/// The panes of one frame, as the tiles draw them.
pub struct Panes<'a> {
    /// What they may look at.
    pub cx: PaneContext<'a>,
    /// What the user asked for.
    pub commands: &'a mut Vec<Command>,
    /// Containers of tabs, which have a border.
    pub framed: HashSet<TileId>,
    /// Panes whose title stands in a bar of tabs, each with the titles of the whole bar.
    pub tabbed: HashMap<TileId, Vec<&'static str>>,
    /// The air before the name of each such pane; `None` where a narrow bar has it in its menu.
    pub gaps: HashMap<TileId, Option<f32>>,
}

/// Containers of tabs, and panes that share one with another open pane, with the titles of all that share it.
pub fn tab_containers(
    tree: &Tree<PaneTile>,
) -> (HashSet<TileId>, HashMap<TileId, Vec<&'static str>>) {
    let mut framed = HashSet::new();
    let mut tabbed = HashMap::new();
    for (id, tile) in tree.tiles.iter() {
        if let Tile::Container(Container::Tabs(tabs)) = tile {
            framed.insert(*id);
            let open = open_children(&tree.tiles, tabs);
            if open.len() > 1 {
                let panes = open.iter().filter_map(|pane| tree.tiles.get_pane(pane));
                let titles: Vec<&str> = panes.map(|pane| title_of(pane.0)).collect();
                tabbed.extend(open.into_iter().map(|pane| (pane, titles.clone())));
            }
        }
    }
    (framed, tabbed)
}

fn open_children(tiles: &Tiles<PaneTile>, tabs: &Tabs) -> Vec<TileId> {
    tabs.children
        .iter()
        .copied()
        .filter(|child| tiles.is_visible(*child))
        .collect()
}

/// How much of the width the title of a pane without tabs takes at most.
const TITLE_WIDTH: f32 = 120.0;
/// The same of a title in plain words.
const NAME_WIDTH: f32 = 56.0;

fn title_of(pane: Pane) -> &'static str {
    spec_of(pane).map_or("", |spec| spec.title)
}

impl Panes<'_> {
    /// The header of a pane that has no tab.
    fn header_ui(&mut self, ui: &mut Ui, spec: &PaneSpec) {
        let (cx, commands) = (&self.cx, &mut *self.commands);
        match spec.header {
            Header::Always(draw) => draw(ui, cx, commands),
            Header::Named(draw) => named_header_ui(ui, spec.title, |ui| {
                draw(ui, cx, NAME_WIDTH, commands);
            }),
            Header::Title | Header::Beside(_) => pane_header_ui(
                ui,
                |ui| {
                    tab_ui(ui, spec.title, true);
                },
                |ui| beside_ui(ui, spec, cx, TITLE_WIDTH, commands),
            ),
        }
    }
}

/// What stands right of a title or of tabs that take `taken` points.
fn beside_ui(
    ui: &mut Ui,
    spec: &PaneSpec,
    cx: &PaneContext<'_>,
    taken: f32,
    commands: &mut Vec<Command>,
) {
    match spec.header {
        Header::Beside(draw) | Header::Named(draw) => draw(ui, cx, taken, commands),
        Header::Title | Header::Always(_) => {}
    }
}

impl Behavior<PaneTile> for Panes<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, tile_id: TileId, pane: &mut PaneTile) -> UiResponse {
        let pane = pane.0;
        let whole = ui.max_rect();
        ui.painter().rect_filled(whole, 0.0, colours(ui).pane);
        ui.spacing_mut().item_spacing.y = 0.0;
        let mut answer = UiResponse::None;
        if !self.tabbed.contains_key(&tile_id) {
            // The strip itself moves the tile; what stands on it takes its own clicks.
            let mut strip = whole;
            strip.set_height(space::PANE_HEADER);
            let id = ui.scope_id().with(("strip", tile_id));
            let grip = ui.interact(strip, id, Sense::click_and_drag());
            if grip.drag_started() {
                answer = UiResponse::DragStarted;
            }
        }
        let Some(spec) = spec_of(pane) else {
            return answer;
        };
        if matches!(spec.header, Header::Always(_)) || !self.tabbed.contains_key(&tile_id) {
            self.header_ui(ui, spec);
        }
        let rest = ui.available_rect_before_wrap();
        let mut content = ui.new_child(egui::UiBuilder::new().max_rect(rest));
        content.set_clip_rect(rest.intersect(ui.clip_rect()));
        (spec.ui)(&mut content, &self.cx, self.commands);
        answer
    }

    fn tab_title_for_pane(&mut self, pane: &PaneTile) -> egui::WidgetText {
        title_of(pane.0).into()
    }

    fn tab_ui(
        &mut self,
        tiles: &mut Tiles<PaneTile>,
        ui: &mut Ui,
        id: egui::Id,
        tile_id: TileId,
        state: &TabState,
    ) -> egui::Response {
        let title = match tiles.get_pane(&tile_id) {
            Some(pane) => title_of(pane.0),
            None => "Tiles",
        };
        let gap = self.gaps.get(&tile_id).copied();
        let Some(gap) = gap.unwrap_or(Some(space::LARGE)) else {
            // It stands in the menu of the bar.
            let nowhere = Rect::from_min_size(ui.cursor().min, egui::Vec2::ZERO);
            return ui.interact(nowhere, id, Sense::hover());
        };
        ui.add_space(gap);
        let shown = tab_ui(ui, title, state.active);
        // Drag and drop needs the tile's own id; the drawn tab lies below.
        ui.interact(shown.rect, id, Sense::click_and_drag())
    }

    fn top_bar_right_ui(
        &mut self,
        tiles: &Tiles<PaneTile>,
        ui: &mut Ui,
        _tile_id: TileId,
        tabs: &Tabs,
        _scroll_offset: &mut f32,
    ) {
        let active = tabs.active.and_then(|active| tiles.get_pane(&active));
        let Some(spec) = active.and_then(|pane| spec_of(pane.0)) else {
            return;
        };
        // What the names of the tabs need; the rest is for choosers and notes.
        let shared = tabs.children.iter().find_map(|pane| self.tabbed.get(pane));
        let names = tabs_width(ui, shared);
        let open = tabs.children.iter().copied();
        let open = open.filter(|pane| self.tabbed.contains_key(pane));
        let (open, panes): (Vec<TileId>, Vec<Pane>) = open
            .filter_map(|tile| Some((tile, tiles.get_pane(&tile)?.0)))
            .unzip();
        ui.add_space(match spec.header {
            Header::Title => air_behind(ui, &panes),
            Header::Beside(_) | Header::Named(_) | Header::Always(_) => space::LARGE,
        });
        beside_ui(ui, spec, &self.cx, names, self.commands);
        let front = open.iter().position(|tile| tabs.active == Some(*tile));
        let fitted = fitted_tabs_ui(ui, &panes, front.unwrap_or(0), self.commands);
        let gaps = fitted.shown.iter().map(|shown| shown.then_some(fitted.gap));
        self.gaps.extend(open.into_iter().zip(gaps));
    }

    fn is_tab_bar_visible(&self, _tile_id: TileId, tabs: &Tabs) -> bool {
        tabs.children
            .iter()
            .any(|child| self.tabbed.contains_key(child))
    }

    fn tab_bar_height(&self, _style: &egui::Style) -> f32 {
        space::PANE_HEADER
    }

    fn gap_width(&self, _style: &egui::Style) -> f32 {
        space::PANE_GAP
    }

    fn min_size(&self) -> f32 {
        120.0
    }

    fn tab_bar_color(&self, visuals: &egui::Visuals) -> Color32 {
        crate::ui::theme::Colours::of(visuals.dark_mode).pane
    }

    fn tab_bar_hline_stroke(&self, visuals: &egui::Visuals) -> Stroke {
        Stroke::new(
            line::THIN,
            crate::ui::theme::Colours::of(visuals.dark_mode).line,
        )
    }

    fn resize_stroke(&self, style: &egui::Style, state: ResizeState) -> Stroke {
        let colours = crate::ui::theme::Colours::of(style.visuals.dark_mode);
        match state {
            ResizeState::Idle => Stroke::NONE,
            ResizeState::Hovering => Stroke::new(line::STRONG, colours.line),
            ResizeState::Dragging => Stroke::new(line::STRONG, colours.accent),
        }
    }

    fn simplification_options(&self) -> SimplificationOptions {
        SimplificationOptions {
            all_panes_must_have_tabs: true,
            ..SimplificationOptions::default()
        }
    }

    fn paint_on_top_of_tile(
        &self,
        painter: &egui::Painter,
        style: &egui::Style,
        tile_id: TileId,
        rect: Rect,
    ) {
        if !self.framed.contains(&tile_id) {
            return;
        }
        let colours = crate::ui::theme::Colours::of(style.visuals.dark_mode);
        painter.add(Shape::mesh(corner_masks(
            rect,
            f32::from(radius::PANE),
            colours.window,
        )));
        painter.add(RectShape::stroke(
            rect,
            CornerRadius::same(radius::PANE),
            Stroke::new(line::THIN, colours.line),
            StrokeKind::Inside,
        ));
    }
}

/// How wide the names of a bar of tabs are, with the air around them.
fn tabs_width(ui: &Ui, names: Option<&Vec<&'static str>>) -> f32 {
    let air = space::LARGE + ui.spacing().item_spacing.x;
    let names = names.into_iter().flatten();
    let widths = names.map(|name| text_width(ui, name, medium_font()));
    widths.map(|name| name + air).sum::<f32>() + space::LARGE
}
