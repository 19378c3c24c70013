//! Every command of the user; panes push them, `app::apply` applies them.

use std::path::PathBuf;

use crate::analysis::deformations::DeformationMapParams;
use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::MetricKind;
use crate::engine::{PoseMapParams, ThickeningSettings, Topic};
use crate::picture::figure::SavedView;
use crate::picture::{AnatomicalView, BullsEyeQuantity, Quantity, WallPart};
use crate::render::{Camera, Shading};

/// What the 3D view shows at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ViewMode {
    /// One subject.
    #[default]
    Single,
    /// Two subjects with linked cameras and time.
    SideBySide,
    /// All frames of one subject.
    AllFrames,
}

/// A tile of the window.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pane {
    /// The list of subjects.
    Cohort,
    /// Finished and running work.
    Activity,
    /// The 3D view.
    Viewport,
    /// The map of poses.
    PoseMap,
    /// The map of whole deformations.
    DeformationMap,
    /// The spatiotemporal plot: poses and time in three dimensions.
    SpaceTime,
    /// How poses and deformations are compared and mapped.
    Metric,
    /// Volumes over the cardiac cycle.
    Curves,
    /// Clinical measures of the selected subject.
    Measures,
    /// Regions of low thickening, and the thresholds.
    Patch,
    /// The verdict on the selected subject, with its evidence.
    Verdict,
    /// The polar map of the wall, by AHA segment.
    BullsEye,
    /// The map of the medial shape space.
    MedialMap,
    /// Wall thickness by several methods.
    Thickness,
}

/// Light or dark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ThemeChoice {
    /// As the desktop is set.
    #[default]
    System,
    /// Dark.
    Dark,
    /// Light.
    Light,
}

/// One request of the user.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Ask for files to open.
    ChooseFiles,
    /// Ask for a folder to open.
    ChooseFolder,
    /// Open these.
    Open(Vec<PathBuf>),
    /// Open the cohort that ships inside.
    OpenBuiltIn,
    /// Show a subject at a frame and, from a map, play its motion.
    SelectPose {
        /// Index into the study's subjects.
        subject: usize,
        /// Frame of its sequence.
        frame: usize,
        /// Whether to play on from there.
        play: bool,
    },
    /// Show a subject, keeping the phase.
    SelectSubject(usize),
    /// The next subject of the table, or the one before for −1.
    StepSubject(i32),
    /// The second subject of the side-by-side view.
    CompareWith(Option<usize>),
    /// Move to a position in the cycle, counted in frames; fractions lie between poses.
    SetPosition(f64),
    /// Whole frames forward or back.
    StepFrame(i32),
    /// Poses forward or back, those between frames included.
    StepPose(i32),
    /// How many poses are computed between two frames; 0 blends frames straight.
    SetInBetweens(u16),
    /// Transport the motion of one subject to another, and show both side by side.
    TransportMotion {
        /// Subject of the motion.
        from: usize,
        /// Subject that it is transported to.
        onto: usize,
    },
    /// Transport the motion of the selected subject to the other one of the side-by-side view.
    TransportToOther,
    /// Show the other subject with its own motion again.
    StopTransport,
    /// Jump to end-diastole.
    GoToEndDiastole,
    /// Jump to end-systole.
    GoToEndSystole,
    /// Set the end-diastole of the selected subject; `None` takes it from the volume curve.
    StateEndDiastole(Option<usize>),
    /// Set the end-systole of the selected subject; `None` takes it from the volume curve.
    StateEndSystole(Option<usize>),
    /// Play or pause.
    TogglePlay,
    /// Speed relative to the recorded motion: 1 is real time.
    SetSpeed(f32),
    /// Whether playing starts over.
    ToggleLoop,
    /// One subject, two, or all frames of one.
    SetViewMode(ViewMode),
    /// Move the camera; `drag` groups the steps of one drag for undo.
    SetCamera {
        /// The new camera.
        camera: Camera,
        /// Whether a drag goes on.
        drag: bool,
    },
    /// Look from an anatomical direction.
    ViewFrom(AnatomicalView),
    /// Fit everything into view.
    FitView,
    /// Turntable, or free rotation.
    ToggleFreeCamera,
    /// Show or hide the endocardium.
    ToggleEndocardium,
    /// Show or hide the epicardium or the wall.
    ToggleEpicardium,
    /// Show or hide edges.
    ToggleWireframe,
    /// Show or hide vertices as discs.
    ToggleVertices,
    /// Show or hide atoms of the medial surface.
    ToggleAtoms,
    /// Show or hide spokes from the atoms to the wall.
    ToggleSpokes,
    /// Show or hide the borders of patches.
    TogglePatches,
    /// Show or hide ANV and MP.
    ToggleDirection,
    /// Thresholds of patches.
    SetThickening(ThickeningSettings),
    /// Settings of patches as they were at the start.
    ResetThickening,
    /// Select a patch of this subject or a segment of every subject.
    SelectPart(Option<WallPart>),
    /// Select a patch and look at it.
    ShowPatch {
        /// Its place in the list.
        patch: usize,
        /// From where, in the axes of the heart.
        camera: Camera,
    },
    /// What the bull's-eye shows.
    SetBullsEye(BullsEyeQuantity),
    /// The next thing that the bull's-eye can show.
    NextBullsEye,
    /// One colour for each segment, or every place its own.
    ToggleBullsEyeSegments,
    /// Smooth or flat.
    SetShading(Shading),
    /// The quantity shown in colour.
    SetQuantity(Quantity),
    /// The next quantity shown in colour.
    NextQuantity,
    /// Typed limits of the colours; `None` goes back to the fixed range.
    SetColourLimits(Option<[f64; 2]>),
    /// How poses are compared and mapped.
    SetPoseMap(PoseMapParams),
    /// Which metric compares poses.
    SetMetric(MetricKind),
    /// How distances become the map of poses.
    SetMapMethod(MapMethod),
    /// How whole deformations are mapped.
    SetDeformationMap(DeformationMapParams),
    /// All settings of metric and maps as they were at the start.
    ResetMaps,
    /// Show or hide the clusters of the map of deformations.
    ToggleClusters,
    /// Open a tile, or bring it before other tabs.
    ShowPane(Pane),
    /// Compute what was cancelled or failed again.
    Retry(Topic),
    /// Stop background work.
    Cancel(Topic),
    /// Close an error card.
    DismissError(usize),
    /// Filter the cohort table.
    SetSearch(String),
    /// Sort the cohort table by a column; again turns the order.
    SortCohort(usize),
    /// Light or dark.
    SetTheme(ThemeChoice),
    /// Show or hide a tile.
    TogglePane(Pane),
    /// All tiles where they were.
    ResetLayout,
    /// Show or hide the command palette.
    TogglePalette,
    /// Show or hide the sheet of shortcuts.
    ToggleShortcuts,
    /// Show or hide the load report.
    ToggleLoadReport,
    /// Show or hide About.
    ToggleAbout,
    /// Write a figure of the 3D view; `None` asks where.
    ExportFigure(Option<PathBuf>),
    /// Write the figure of the patch: heart, bull's-eye, table, verdict; `None` asks where.
    ExportPatchFigure(Option<PathBuf>),
    /// Show what a picture shows.
    RestoreView(Box<SavedView>),
    /// Write all tables; `None` asks where.
    ExportTables(Option<PathBuf>),
    /// Undo the last change of state.
    Undo,
    /// Take the last undo back.
    Redo,
    /// Full screen or window.
    ToggleFullScreen,
    /// Leave the program.
    Quit,
}
