//! Where the tiles of the window lie: moved, closed, restored and remembered.

use std::collections::HashSet;

use egui_tiles::{Container, Linear, LinearDir, Tile, TileId, Tiles, Tree};
use serde::{Deserialize, Serialize};

use crate::panes::{PANES, Pane, Place};

/// Shares of the window's width: cohort, 3D view, results.
const COLUMN_SHARES: [f32; 3] = [0.2, 0.505, 0.295];

/// Panes that a fresh layout does not show: images bring them.
const CLOSED_AT_FIRST: [Pane; 3] = [Pane::SLICES, Pane::IMPORT, Pane::BATCH];

/// Shares of the right column's height: map, and below it measures beside curves.
const RIGHT_SHARES: [f32; 2] = [0.53, 0.47];

/// Shares of the width below the map: measures, curves.
const BELOW_SHARES: [f32; 2] = [0.44, 0.56];

/// A pane that can be written into a saved layout.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(into = "String", try_from = "String")]
pub struct PaneTile(pub Pane);

impl From<PaneTile> for String {
    fn from(tile: PaneTile) -> Self {
        tile.0.word().to_owned()
    }
}

impl TryFrom<String> for PaneTile {
    type Error = String;

    fn try_from(word: String) -> Result<Self, String> {
        PANES
            .iter()
            .find(|spec| spec.pane.word() == word)
            .map(|spec| Self(spec.pane))
            .ok_or_else(|| format!("no pane is called {word:?}"))
    }
}

/// The tiles of the window. Closed panes stay in the tree, unseen, and come back to their place.
#[derive(Debug)]
pub struct Layout {
    /// The tree that `egui_tiles` draws.
    pub tree: Tree<PaneTile>,
}

impl Default for Layout {
    fn default() -> Self {
        let mut tiles = Tiles::default();
        let mut tabs = |place: Place| {
            let children = PANES
                .iter()
                .filter(|spec| spec.place == place)
                .map(|spec| tiles.insert_pane(PaneTile(spec.pane)))
                .collect();
            tiles.insert_tab_tile(children)
        };
        let left = tabs(Place::Left);
        let middle = tabs(Place::Middle);
        let map = tabs(Place::Above);
        let below = [Place::BelowLeft, Place::BelowRight].map(&mut tabs);
        let below = insert_linear(&mut tiles, LinearDir::Horizontal, &below, &BELOW_SHARES);
        let right = [map, below];
        let right = insert_linear(&mut tiles, LinearDir::Vertical, &right, &RIGHT_SHARES);
        let columns = [left, middle, right];
        let root = insert_linear(&mut tiles, LinearDir::Horizontal, &columns, &COLUMN_SHARES);
        let mut layout = Self {
            tree: Tree::new(tree_id(), root, tiles),
        };
        for pane in CLOSED_AT_FIRST {
            layout.set_open(pane, false);
        }
        layout
    }
}

fn tree_id() -> egui::Id {
    egui::Id::unique("tiles")
}

fn insert_linear(
    tiles: &mut Tiles<PaneTile>,
    direction: LinearDir,
    children: &[TileId],
    shares: &[f32],
) -> TileId {
    let mut linear = Linear::new(direction, children.to_vec());
    for (child, share) in children.iter().zip(shares) {
        linear.shares.set_share(*child, *share);
    }
    tiles.insert_container(Container::Linear(linear))
}

impl Layout {
    /// A saved layout; the default one where the text cannot be read or lacks a pane.
    pub fn from_saved(text: &str) -> Self {
        serde_json::from_str::<Tree<PaneTile>>(text)
            .ok()
            .map(|tree| Self { tree }.with_later_panes())
            .filter(Self::has_every_pane_once)
            .unwrap_or_default()
    }

    /// The layout as text.
    pub fn to_saved(&self) -> Option<String> {
        serde_json::to_string(&self.tree).ok()
    }

    /// Whether a pane is open; it may be hidden behind another tab.
    pub fn is_open(&self, pane: Pane) -> bool {
        self.tile_of(pane)
            .is_some_and(|tile| self.tree.is_visible(tile))
    }

    /// The panes that are seen: open, and in front of other tabs.
    pub fn seen(&self) -> HashSet<Pane> {
        let tiles = self.tree.active_tiles().into_iter();
        tiles
            .filter_map(|tile| self.tree.tiles.get_pane(&tile))
            .map(|pane| pane.0)
            .collect()
    }

    /// Opens a pane in its place and brings it before other tabs, or closes it.
    pub fn set_open(&mut self, pane: Pane, open: bool) {
        let Some(tile) = self.tile_of(pane) else {
            return;
        };
        self.tree.set_visible(tile, open);
        if open {
            self.show(pane);
        } else {
            self.leave_tab(tile);
        }
    }

    /// Brings a pane before other tabs.
    pub fn show(&mut self, pane: Pane) {
        self.tree
            .make_active(|_, tile| matches!(tile, Tile::Pane(PaneTile(other)) if *other == pane));
    }

    /// A closed tab that lay in front gives way to an open one beside it.
    fn leave_tab(&mut self, closed: TileId) {
        let Some(parent) = self.tree.tiles.parent_of(closed) else {
            return;
        };
        let Some(Tile::Container(Container::Tabs(tabs))) = self.tree.tiles.get(parent) else {
            return;
        };
        let next = tabs
            .children
            .iter()
            .copied()
            .find(|child| self.tree.is_visible(*child));
        if tabs.active == Some(closed)
            && let Some(next) = next
        {
            self.tree.make_active(|tile, _| tile == next);
        }
    }

    fn tile_of(&self, pane: Pane) -> Option<TileId> {
        self.tree.tiles.find_pane(&PaneTile(pane))
    }

    /// Panes that layouts of earlier versions lack appear as tabs beside one of their place.
    fn with_later_panes(mut self) -> Self {
        for spec in PANES {
            let beside = PANES
                .iter()
                .filter(|other| other.place == spec.place)
                .find_map(|other| self.tile_of(other.pane));
            let parent = beside.and_then(|tile| self.tree.tiles.parent_of(tile));
            let (None, Some(parent)) = (self.tile_of(spec.pane), parent) else {
                continue;
            };
            let tile = self.tree.tiles.insert_pane(PaneTile(spec.pane));
            if let Some(Tile::Container(Container::Tabs(tabs))) = self.tree.tiles.get_mut(parent) {
                tabs.add_child(tile);
            }
            if CLOSED_AT_FIRST.contains(&spec.pane) {
                self.set_open(spec.pane, false);
            }
        }
        self
    }

    fn has_every_pane_once(&self) -> bool {
        PANES.iter().all(|spec| {
            self.tree
                .tiles
                .tiles()
                .filter(|tile| matches!(tile, Tile::Pane(PaneTile(other)) if *other == spec.pane))
                .count()
                == 1
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The layout as text, read again: the order of entries says nothing.
    fn saved(layout: &Layout) -> serde_json::Value {
        let mut saved: serde_json::Value =
            serde_json::from_str(&layout.to_saved().unwrap()).unwrap();
        // A set: its order differs from run to run.
        let closed = saved["tiles"]["invisible"].as_array_mut().unwrap();
        closed.sort_by_key(serde_json::Value::as_u64);
        saved
    }

    #[test]
    fn a_layout_comes_back_from_its_text() {
        let mut layout = Layout::default();
        layout.set_open(Pane::CURVES, false);
        let back = Layout::from_saved(&layout.to_saved().unwrap());
        assert!(!back.is_open(Pane::CURVES));
        assert!(back.is_open(Pane::POSE_MAP));
        assert_eq!(saved(&back), saved(&layout));
    }

    #[test]
    fn a_pane_is_seen_while_it_is_open_and_in_front() {
        let mut layout = Layout::default();
        layout.show(Pane::POSE_MAP);
        let seen = layout.seen();
        assert!(seen.contains(&Pane::POSE_MAP) && seen.contains(&Pane::VIEWPORT));
        assert!(!seen.contains(&Pane::MEDIAL_MAP));
        layout.set_open(Pane::MEDIAL_MAP, true);
        assert!(layout.seen().contains(&Pane::MEDIAL_MAP));
        assert!(!layout.seen().contains(&Pane::POSE_MAP));
        layout.set_open(Pane::MEDIAL_MAP, false);
        assert!(!layout.seen().contains(&Pane::MEDIAL_MAP));
    }

    #[test]
    fn a_closed_pane_comes_back_to_its_place() {
        let mut layout = Layout::default();
        let before = saved(&layout);
        layout.set_open(Pane::VIEWPORT, false);
        assert!(!layout.is_open(Pane::VIEWPORT));
        layout.set_open(Pane::VIEWPORT, true);
        assert!(layout.is_open(Pane::VIEWPORT));
        assert_eq!(saved(&layout), before);
    }

    #[test]
    fn only_one_tab_of_a_place_is_in_front() {
        let mut layout = Layout::default();
        layout.show(Pane::VERDICT);
        assert!(layout.seen().contains(&Pane::VERDICT));
        assert!(layout.is_open(Pane::PATCH) && !layout.seen().contains(&Pane::PATCH));
        layout.set_open(Pane::VERDICT, false);
        assert!(!layout.seen().contains(&Pane::VERDICT));
    }

    #[test]
    fn closing_the_tab_in_front_shows_the_one_behind() {
        let mut layout = Layout::default();
        layout.show(Pane::COHORT);
        layout.set_open(Pane::COHORT, false);
        let activity = layout.tile_of(Pane::ACTIVITY).unwrap();
        assert!(layout.tree.active_tiles().contains(&activity));
    }

    #[test]
    fn a_layout_from_before_the_later_panes_gets_them_as_tabs_and_keeps_its_places() {
        let later = [
            (Pane::DEFORMATION_MAP, Pane::POSE_MAP),
            (Pane::SPATIOTEMPORAL, Pane::POSE_MAP),
            (Pane::METRIC, Pane::COHORT),
            (Pane::PATCH, Pane::MEASURES),
            (Pane::VERDICT, Pane::PATCH),
            (Pane::BULLS_EYE, Pane::CURVES),
            (Pane::MEDIAL_MAP, Pane::POSE_MAP),
            (Pane::THICKNESS, Pane::CURVES),
        ];
        let mut layout = Layout::default();
        layout.set_open(Pane::CURVES, false);
        for (pane, _) in later {
            let tile = layout.tile_of(pane).unwrap();
            layout.tree.remove_recursively(tile);
        }
        let back = Layout::from_saved(&layout.to_saved().unwrap());
        assert!(!back.is_open(Pane::CURVES), "what was closed stays closed");
        for (pane, neighbour) in later {
            let parent = |pane| back.tree.tiles.parent_of(back.tile_of(pane).unwrap());
            assert_eq!(parent(pane), parent(neighbour));
        }
    }

    #[test]
    fn damaged_or_foreign_text_gives_the_default_layout() {
        let text = Layout::default().to_saved().unwrap();
        let default = saved(&Layout::default());
        assert_eq!(saved(&Layout::from_saved("{")), default);
        assert_eq!(saved(&Layout::from_saved("null")), default);
        let twice = text.replace("\"curves\"", "\"viewport\"");
        assert_eq!(saved(&Layout::from_saved(&twice)), default);
    }
}
