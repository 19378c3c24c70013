//! The panes of the window, a folder each: what a pane asks for, and how it is drawn.
//!
//! Begin with [`PANES`], the table of all panes, then read `measures/spec.rs` and `measures/mod.rs` as the shortest
//! example. A pane looks at [`Look`] and pushes [`Command`]s; it changes nothing itself. `commands/` lists what can be
//! asked for, with names, keys and menus. `scatter_map/` is the map that all panes with points share, `viewport/` the
//! 3D view.

pub(crate) mod action_state;
pub(crate) mod actions;
pub(crate) mod activity;
pub(crate) mod beat;
pub(crate) mod beat_axis;
pub(crate) mod bulls_eye;
pub(crate) mod cohort;
pub(crate) mod commands;
pub(crate) mod curves;
pub(crate) mod deformation_map;
pub(crate) mod look;
pub(crate) mod measures;
pub(crate) mod medial_map;
pub(crate) mod metric;
pub(crate) mod normal_ranges;
pub(crate) mod pane;
pub(crate) mod patch;
pub(crate) mod pose_map;
pub(crate) mod scatter_map;
pub(crate) mod shortcuts;
pub(crate) mod spatiotemporal;
pub(crate) mod subject_drag;
pub(crate) mod table;
pub(crate) mod thickness;
pub(crate) mod verdict;
pub(crate) mod verdict_marks;
pub(crate) mod viewport;

pub use action_state::ActionState;
pub use actions::ALL_ACTIONS;
pub use activity::{WorkItem, WorkState, activity_ui};
pub use beat_axis::BeatAxis;
pub use bulls_eye::{BullsEyePatch, BullsEyeView, bulls_eye_ui};
pub use cohort::rows::{CohortColumn, CohortRow, CohortSort, CohortVerdict, visible_rows};
pub use cohort::{CohortView, cohort_table_ui};
pub use commands::{
    Action, BeatCommand, Command, EditCommand, FileCommand, MapCommand, Menu, Pane,
    TransportCommand, ViewCommand, WallCommand, WindowCommand, WorkCommand,
};
pub use curves::{Curve, CurveKind, CurvesView, curves_ui};
pub use deformation_map::{
    ClassesView, ClassifierView, DEFORMATION_MAP, DeformationMapView, deformation_map_ui,
    deformation_note,
};
pub use look::{Look, Memo};
pub use measures::{MeasuresView, measures_card_ui};
pub use medial_map::{
    MEDIAL_MAP, MedialMapView, medial_facts, medial_map_choosers_ui, medial_map_header_ui,
    medial_map_note, medial_map_ui,
};
pub use metric::{MetricPanelView, metric_panel_ui};
pub use pane::{Draw, DrawBeside, Header, PaneSpec, Place};
pub use patch::{PatchLine, PatchPanelView, WallState, patch_panel_ui};
pub use pose_map::{
    POSE_MAP, PoseMapView, pose_map_choosers_ui, pose_map_header_ui, pose_map_note, pose_map_ui,
};
pub use scatter_map::{
    MapState, MapSubject, MapWords, PosePhase, ScatterData, ScatterPoint, ScatterView,
    places_between,
};
pub use shortcuts::{claim_tab, pressed_commands, shortcut_text};
pub use spatiotemporal::{SPACE_TIME, SpaceTimeView, space_time_ui};
pub use subject_drag::{
    DraggedSubject, SubjectTarget, dragged_subject, dragged_subject_ui, subject_target_ui,
};
pub use table::{PANES, spec_of};
pub use thickness::{
    Difference, ThicknessPanelView, ThicknessRow, ThicknessState, ThicknessStrip,
    thickness_panel_ui,
};
pub use verdict::{
    ClassifierReport, ClassifierResult, EvidenceRow, SimilarSubject, TrainingDistance,
    VerdictPanelView, VerdictReport, VerdictState, verdict_panel_ui,
};
pub use verdict_marks::{VerdictMark, verdict_mark};
pub use viewport::empty_state::{EmptyStateView, empty_state_ui};
pub use viewport::header::{ViewportHeaderView, quantity_name, viewport_header_ui};
pub use viewport::overlay::{
    ColourBarView, CubeView, PatchNote, ScaleBarView, ViewportOverlayView, viewport_overlay_ui,
};
