//! The panes of the window, a folder each: what a pane asks for, and how it is drawn.
//!
//! Begin with [`PANES`], the table of all panes, then read `measures/spec.rs` and `measures/mod.rs` as the shortest
//! example, and `thickness/` for one that asks a question of its own. A pane looks at [`PaneContext`] and pushes [`Command`]s; it changes nothing itself. `commands/` lists what can be
//! asked for, with names, keys and menus. `scatter_map/` is the map that all panes with points share, `viewport/` the
//! 3D view.

pub(crate) mod action_state;
pub(crate) mod actions;
pub(crate) mod activity;
pub(crate) mod bulls_eye;
pub(crate) mod buttons;
pub(crate) mod cohort;
pub(crate) mod commands;
pub(crate) mod curves;
pub(crate) mod cycle_axis;
pub(crate) mod deformation_map;
pub(crate) mod figure;
pub(crate) mod import;
pub(crate) mod measures;
pub(crate) mod medial_map;
pub(crate) mod metric;
pub(crate) mod pane;
pub(crate) mod pane_context;
pub(crate) mod patch;
pub(crate) mod pose_map;
pub(crate) mod pose_words;
pub(crate) mod same;
pub(crate) mod scatter_map;
pub(crate) mod shortcuts;
pub(crate) mod slices;
pub(crate) mod spatiotemporal;
pub(crate) mod subject_drag;
pub(crate) mod table;
pub(crate) mod thickness;
pub(crate) mod verdict;
pub(crate) mod verdict_marks;
pub(crate) mod viewport;
pub(crate) mod work_state;
pub(crate) mod work_ui;

pub use {action_state::*, actions::*, activity::*, bulls_eye::*, buttons::*, cycle_axis::*};
pub use {cohort::rows::*, cohort::*, commands::*, curves::*, deformation_map::*, pane_context::*};
pub use {measures::*, medial_map::*, metric::*, pane::*, patch::*, pose_map::*, scatter_map::*};
pub use {shortcuts::*, spatiotemporal::*, subject_drag::*, table::*, thickness::*, verdict::*};
pub use {verdict_marks::*, viewport::*, work_state::*};
