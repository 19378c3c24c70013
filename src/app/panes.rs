//! The tiles of the window: their headers, borders and contents.

use std::collections::HashSet;
use std::sync::Arc;
use std::sync::atomic::AtomicU64;

use egui::epaint::RectShape;
use egui::{Color32, CornerRadius, Rect, Sense, Shape, Stroke, StrokeKind, Ui};
use egui_tiles::{
    Behavior, Container, ResizeState, SimplificationOptions, TabState, Tabs, Tile, TileId, Tiles,
    Tree, UiResponse,
};

use crate::panes::{
    BullsEyeView, Command, DeformationMapView, EmptyStateView, MeasuresView, MedialMapView,
    MetricPanelView, Pane, PatchPanelView, PoseMapView, SpaceTimeView, ThicknessPanelView,
    VerdictPanelView, WorkItem, activity_ui, bulls_eye_ui, cohort_table_ui, curves_ui,
    deformation_map_ui, deformation_note, empty_state_ui, measures_card_ui, medial_map_choosers_ui,
    medial_map_header_ui, medial_map_ui, metric_panel_ui, patch_panel_ui, pose_map_choosers_ui,
    pose_map_header_ui, pose_map_ui, space_time_ui, thickness_panel_ui, verdict_panel_ui,
    viewport_header_ui,
};
use crate::ui::theme::{colours, line, radius, space};
use crate::ui::{pane_header_ui, tab_ui};

use super::corners::corner_masks;
use super::layout::PaneTile;
use crate::document::state::State;
use crate::panes::beat::BeatData;
use crate::panes::cohort::view::CohortData;
use crate::panes::viewport::header_view::viewport_header_view;
use crate::panes::viewport::hearts::Viewport;

/// Everything the panes of one frame need.
pub struct Panes<'a> {
    /// The state.
    pub state: &'a State,
    /// Rows of the cohort.
    pub cohort: &'a CohortData,
    /// Numbers of the beat.
    pub beat: &'a BeatData,
    /// The map.
    pub map: PoseMapView<'a>,
    /// The map of deformations.
    pub deformations: DeformationMapView<'a>,
    /// The map of the medial shape space.
    pub medial_map: MedialMapView<'a>,
    /// Thickness in several ways.
    pub thickness: ThicknessPanelView<'a>,
    /// The spatiotemporal plot.
    pub space_time: SpaceTimeView<'a>,
    /// Settings of metric and maps.
    pub metric: MetricPanelView<'a>,
    /// The measures.
    pub measures: MeasuresView<'a>,
    /// The patches.
    pub patch: PatchPanelView<'a>,
    /// What is said of the selected heart.
    pub verdict: VerdictPanelView<'a>,
    /// The wall laid flat.
    pub bulls_eye: BullsEyeView<'a>,
    /// The activity list.
    pub activity: &'a [WorkItem],
    /// Whether volumes are being computed.
    pub measuring: bool,
    /// Whether verdicts are still to come.
    pub classifying: bool,
    /// Whether something is being opened.
    pub opening: bool,
    /// The 3D view.
    pub viewport: &'a mut Viewport,
    /// Takes the time of the paint callbacks.
    pub meter: &'a Arc<AtomicU64>,
    /// What the user asked for.
    pub commands: &'a mut Vec<Command>,
    /// Containers of tabs, which have a border.
    pub framed: HashSet<TileId>,
    /// Panes whose title stands in a bar of tabs.
    pub tabbed: HashSet<TileId>,
}

/// Containers of tabs, and panes that share one with another open pane.
pub fn tab_containers(tree: &Tree<PaneTile>) -> (HashSet<TileId>, HashSet<TileId>) {
    let mut framed = HashSet::new();
    let mut tabbed = HashSet::new();
    for (id, tile) in tree.tiles.iter() {
        if let Tile::Container(Container::Tabs(tabs)) = tile {
            framed.insert(*id);
            let open = open_children(&tree.tiles, tabs);
            if open.len() > 1 {
                tabbed.extend(open);
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

/// The words on tabs.
pub fn pane_title(pane: Pane) -> &'static str {
    match pane {
        Pane::Cohort => "Cohort",
        Pane::Activity => "Activity",
        Pane::Viewport => "3D view",
        Pane::PoseMap => "Poses",
        Pane::DeformationMap => "Deformations",
        Pane::SpaceTime => "Spatiotemporal",
        Pane::Metric => "Metric and maps",
        Pane::Curves => "Volume",
        Pane::Measures => "Measures",
        Pane::Patch => "Patch",
        Pane::Verdict => "Verdict",
        Pane::BullsEye => "Bull's-eye",
        Pane::MedialMap => "Medial",
        Pane::Thickness => "Thickness",
    }
}

impl Panes<'_> {
    fn plain_header_ui(&mut self, ui: &mut Ui, pane: Pane) {
        let note = self.header_note(pane);
        let deformations = &self.deformations;
        pane_header_ui(
            ui,
            |ui| {
                tab_ui(ui, pane_title(pane), true);
            },
            |ui| match (pane, note) {
                (Pane::DeformationMap, _) => deformation_note(ui, deformations, 120.0),
                (_, Some(note)) => {
                    ui.label(egui::RichText::new(note).weak());
                }
                (_, None) => {}
            },
        );
    }

    fn header_note(&self, pane: Pane) -> Option<String> {
        match pane {
            Pane::Cohort => {
                let count = self.cohort.rows().len();
                (count > 0).then(|| count.to_string())
            }
            Pane::Curves => self
                .state
                .document
                .selected()
                .map(|subject| subject.unit.volume_symbol().to_owned()),
            _ => None,
        }
    }

    fn content_ui(&mut self, ui: &mut Ui, pane: Pane) {
        match pane {
            Pane::Cohort => {
                let view = self
                    .cohort
                    .view(self.state, [self.measuring, self.classifying]);
                cohort_table_ui(ui, &view, self.commands);
            }
            Pane::Activity => activity_ui(ui, self.activity, self.commands),
            Pane::Viewport => self.viewport_ui(ui),
            Pane::PoseMap => pose_map_ui(ui, &self.map, self.commands),
            Pane::DeformationMap => deformation_map_ui(ui, &self.deformations, self.commands),
            Pane::SpaceTime => space_time_ui(ui, &self.space_time, self.commands),
            Pane::Metric => metric_panel_ui(ui, &self.metric, self.commands),
            Pane::Curves => {
                let curves = self.beat.curves();
                let view = self.beat.curves_view(self.state, &curves, self.measuring);
                curves_ui(ui, &view, self.commands);
            }
            Pane::Measures => measures_card_ui(ui, &self.measures, self.commands),
            Pane::Patch => patch_panel_ui(ui, &self.patch, self.commands),
            Pane::Verdict => verdict_panel_ui(ui, &self.verdict, self.commands),
            Pane::BullsEye => bulls_eye_ui(ui, &self.bulls_eye, self.commands),
            Pane::MedialMap => medial_map_ui(ui, &self.medial_map, self.commands),
            Pane::Thickness => thickness_panel_ui(ui, &self.thickness, self.commands),
        }
    }

    fn viewport_ui(&mut self, ui: &mut Ui) {
        if self.state.document.study().subjects.is_empty() {
            let view = EmptyStateView {
                files_hover: ui.input(|input| !input.raw.hovered_files.is_empty()),
                opening: self.opening,
            };
            empty_state_ui(ui, &view, self.commands);
            return;
        }
        self.viewport.ui(ui, self.state, self.meter, self.commands);
    }
}

impl Behavior<PaneTile> for Panes<'_> {
    fn pane_ui(&mut self, ui: &mut Ui, tile_id: TileId, pane: &mut PaneTile) -> UiResponse {
        let pane = pane.0;
        let whole = ui.max_rect();
        ui.painter().rect_filled(whole, 0.0, colours(ui).pane);
        ui.spacing_mut().item_spacing.y = 0.0;
        let mut answer = UiResponse::None;
        if !self.tabbed.contains(&tile_id) {
            // The strip itself moves the tile; what stands on it takes its own clicks.
            let mut strip = whole;
            strip.set_height(space::PANE_HEADER);
            let id = ui.scope_id().with(("strip", tile_id));
            let grip = ui.interact(strip, id, Sense::click_and_drag());
            if grip.drag_started() {
                answer = UiResponse::DragStarted;
            }
        }
        match pane {
            Pane::Viewport => {
                viewport_header_ui(ui, &viewport_header_view(self.state), self.commands);
            }
            Pane::PoseMap if !self.tabbed.contains(&tile_id) => {
                pose_map_header_ui(ui, &self.map, self.commands);
            }
            Pane::MedialMap if !self.tabbed.contains(&tile_id) => {
                medial_map_header_ui(ui, &self.medial_map, self.commands);
            }
            _ if !self.tabbed.contains(&tile_id) => self.plain_header_ui(ui, pane),
            _ => {}
        }
        let rest = ui.available_rect_before_wrap();
        let mut content = ui.new_child(egui::UiBuilder::new().max_rect(rest));
        content.set_clip_rect(rest.intersect(ui.clip_rect()));
        self.content_ui(&mut content, pane);
        answer
    }

    fn tab_title_for_pane(&mut self, pane: &PaneTile) -> egui::WidgetText {
        pane_title(pane.0).into()
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
            Some(pane) => pane_title(pane.0),
            None => "Tiles",
        };
        ui.add_space(space::LARGE);
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
        // What the names of the tabs need; the rest is for choosers and notes.
        let names = tabs_width(ui, tiles, &self.tabbed, tabs);
        match active.map(|pane| pane.0) {
            Some(Pane::PoseMap) => {
                ui.add_space(space::LARGE);
                let room = ui.available_width() - names;
                if room > 90.0 {
                    pose_map_choosers_ui(ui, &self.map, room > 250.0, self.commands);
                }
                return;
            }
            Some(Pane::MedialMap) => {
                ui.add_space(space::LARGE);
                if ui.available_width() - names > 90.0 {
                    medial_map_choosers_ui(ui, &self.medial_map, self.commands);
                }
                return;
            }
            Some(Pane::DeformationMap) => {
                ui.add_space(space::LARGE);
                deformation_note(ui, &self.deformations, names);
                return;
            }
            _ => {}
        }
        if let Some(note) = active.and_then(|pane| self.header_note(pane.0)) {
            ui.add_space(space::LARGE);
            ui.label(egui::RichText::new(note).weak());
        }
    }

    fn is_tab_bar_visible(&self, _tile_id: TileId, tabs: &Tabs) -> bool {
        tabs.children
            .iter()
            .any(|child| self.tabbed.contains(child))
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

/// How wide the names of the open tabs of a container are, with the air around them.
fn tabs_width(ui: &Ui, tiles: &Tiles<PaneTile>, tabbed: &HashSet<TileId>, tabs: &Tabs) -> f32 {
    let open = tabs.children.iter().filter(|child| tabbed.contains(child));
    open.filter_map(|child| tiles.get_pane(child))
        .map(|pane| {
            let text = pane_title(pane.0).to_owned();
            let font = crate::ui::medium_font();
            let galley = ui
                .painter()
                .layout_no_wrap(text, font, Color32::PLACEHOLDER);
            galley.size().x + space::LARGE + ui.spacing().item_spacing.x
        })
        .sum::<f32>()
        + space::LARGE
}
