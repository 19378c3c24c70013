//! Everything the user can ask for; panels push these, `app::apply` carries them out.

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
    /// One heart.
    #[default]
    Single,
    /// Two hearts with linked cameras and phase.
    SideBySide,
    /// Every pose of one heart.
    AllPhases,
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
    /// Poses through time, in three dimensions.
    SpaceTime,
    /// How poses and deformations are compared and mapped.
    Metric,
    /// Volumes over the beat.
    Curves,
    /// Clinical measures of the selected subject.
    Measures,
    /// The part of the wall that does not thicken.
    Patch,
    /// What is said of the selected heart, and why.
    Verdict,
    /// The wall laid flat, by segments.
    BullsEye,
    /// The map of the medial shape space.
    MedialMap,
    /// The wall's thickness in several ways of measuring it.
    Thickness,
}

/// Light or dark.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ThemeChoice {
    /// As the system says.
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
    /// Show a subject at a frame and, from a map, play its beat.
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
    /// The second heart of the side-by-side view.
    CompareWith(Option<usize>),
    /// Move to a position in the beat, counted in frames; fractions lie between poses.
    SetPosition(f64),
    /// Whole frames forward or back.
    StepFrame(i32),
    /// Poses forward or back, those between frames included.
    StepPose(i32),
    /// How many poses are computed between two frames; 0 blends frames straight.
    SetInBetweens(u16),
    /// Play one subject's beat on another one's heart, beside the original.
    CarryBeat {
        /// Whose motion.
        from: usize,
        /// On whose heart.
        onto: usize,
    },
    /// Play the selected subject's beat on the heart beside it.
    CarryBeatBeside,
    /// Show the heart beside with its own beat again.
    StopCarrying,
    /// Jump to end-diastole.
    GoToEndDiastole,
    /// Jump to end-systole.
    GoToEndSystole,
    /// Say that the selected subject's end-diastole is this frame; `None` finds it again.
    StateEndDiastole(Option<usize>),
    /// Say that the selected subject's end-systole is this frame; `None` finds it again.
    StateEndSystole(Option<usize>),
    /// Play or pause.
    TogglePlay,
    /// Beats per recorded beat: 1 is real time.
    SetSpeed(f32),
    /// Whether playing starts over.
    ToggleLoop,
    /// One heart, two, or all phases.
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
    FrameAll,
    /// Turntable, or free rotation.
    ToggleFreeCamera,
    /// Show or hide the inner surface.
    ToggleEndocardium,
    /// Show or hide the outer surface or wall.
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
    /// What counts as still, and as a patch.
    SetThickening(ThickeningSettings),
    /// Settings of patches as they were at the start.
    ResetThickening,
    /// Select a patch of this heart or a segment of every heart.
    SelectPart(Option<WallPart>),
    /// Select a patch and look at it.
    ShowPatch {
        /// Its place in the list.
        patch: usize,
        /// From where, in the heart's axes.
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
    /// What colours stand for.
    SetQuantity(Quantity),
    /// The next thing that colours can stand for.
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
    TakeUpView(Box<SavedView>),
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
