//! Panels, plots and widgets: they draw prepared views and push commands.

mod about;
mod action_state;
mod actions;
mod activity;
mod beat_axis;
mod bulls_eye;
mod cohort_rows;
mod cohort_table;
mod command;
mod command_palette;
mod controls;
mod curves;
mod deformation_map;
mod empty_state;
mod error_cards;
mod fuzzy;
mod load_report;
mod map_ground;
mod marks;
mod measures_card;
mod medial_map;
mod menu_bar;
mod metric_panel;
mod metric_words;
mod normal_ranges;
mod number_field;
mod patch_panel;
mod pointer_steps;
mod pose_map;
mod shortcut_sheet;
mod shortcuts;
mod space_time;
mod status_bar;
mod style;
mod subject_drag;
pub mod theme;
mod thickness_panel;
mod time_bar;
mod verdict_marks;
mod verdict_panel;
mod viewport_header;
mod viewport_overlay;

pub use about::about_ui;
pub use action_state::ActionState;
pub use actions::{ACTIONS, Action, Menu};
pub use activity::{WorkItem, WorkState, activity_ui};
pub use beat_axis::BeatAxis;
pub use bulls_eye::{BullsEyePatch, BullsEyeView, bulls_eye_ui};
pub use cohort_rows::{CohortColumn, CohortRow, CohortSort, CohortVerdict, visible_rows};
pub use cohort_table::{CohortView, cohort_table_ui};
pub use command::{Command, Pane, ThemeChoice, ViewMode};
pub use command_palette::{CommandPaletteView, command_palette_ui};
pub use controls::{empty_pane_ui, pane_header_ui, tab_ui};
pub use curves::{Curve, CurveKind, CurvesView, curves_ui};
pub use deformation_map::{
    ClassesView, DeformationMapView, DeformationPoint, RuleView, deformation_map_ui,
    deformation_note,
};
pub use empty_state::{EmptyStateView, empty_state_ui};
pub use error_cards::{ErrorCard, error_cards_ui};
pub use load_report::{ReportSubject, load_report_ui};
pub use map_ground::{MapState, MapSubject};
pub use marks::role_name;
pub use measures_card::{MeasuresView, measures_card_ui};
pub use medial_map::{
    MedialMapView, MedialPoint, medial_map_choosers_ui, medial_map_header_ui, medial_map_ui,
};
pub use menu_bar::{MenuBarView, menu_bar_ui};
pub use metric_panel::{MetricPanelView, metric_panel_ui};
pub use patch_panel::{PatchPanelView, PatchRow, WallState, patch_panel_ui};
pub use pose_map::{
    MapPoint, PoseMapView, PosePhase, pose_map_choosers_ui, pose_map_header_ui, pose_map_ui,
};
pub use shortcut_sheet::shortcut_sheet_ui;
pub use shortcuts::{claim_tab, pressed_commands, shortcut_text};
pub use space_time::{SpaceTimeCurve, SpaceTimePoint, SpaceTimeView, space_time_ui};
pub use status_bar::{StatusBarView, StatusJob, status_bar_ui};
pub use style::{apply, choose, install, medium_font};
pub use subject_drag::{
    DraggedSubject, SubjectTarget, dragged_subject, dragged_subject_ui, subject_target_ui,
};
pub use thickness_panel::{
    Difference, ThicknessPanelView, ThicknessRow, ThicknessState, ThicknessStrip,
    thickness_panel_ui,
};
pub use time_bar::{TimeBarView, time_bar_ui};
pub use verdict_marks::{VerdictMark, verdict_mark};
pub use verdict_panel::{
    AlikeHeart, Chance, EvidenceRow, Familiar, RuleTold, ToldVerdict, VerdictPanelView,
    VerdictState, verdict_panel_ui,
};
pub use viewport_header::{ViewportHeaderView, quantity_name, viewport_header_ui};
pub use viewport_overlay::{
    ColourBarView, CubeView, PatchNote, ScaleBarView, ViewportOverlayView, viewport_overlay_ui,
};
