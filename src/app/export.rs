//! Writes what is on screen: a figure of the 3D view, all tables as files.
//!
//! What an export holds is fixed when it is asked for. Its place is chosen later, while the window goes on:
//! whatever is selected or opened in the meantime changes neither the name nor the content.

use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::analysis::thickening::ThickeningSettings;
use crate::analysis::verdicts::Verdicts;
use crate::document::ViewMode;
use crate::engine::{
    Engine, Store, TableSettings, VerdictQuery, distance_words, file_name, replace_results,
    tables_of_study,
};
use crate::picture::figure::{
    FigureLook, FigureOrder, FigureSubject, FigureView, PatchOrder, check_figure_size,
    rendered_figure, rendered_patch_figure,
};
use crate::picture::page::{FigureFonts, PageFormat};
use crate::picture::{BullsEyeQuantity, PictureTheme, SceneSettings, frames_around, sentence};
use crate::progress::Progress;
use crate::render::{Camera, Headless};
use crate::study::Study;

use super::asks::{deformation_settings, verdict_settings};
use super::errors::interruption;
use super::figure_file::write_figure_file;
use crate::document::document::{Document, nearest_frame};
use crate::document::play::pose_in;
use crate::document::state::State;
use crate::panes::viewport::shown_subject::ShownSubject;
use crate::panes::viewport::viewport::Viewport;

/// Which figure is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureKind {
    /// The 3D view.
    View,
    /// The subject with its bull's-eye, patches and verdict.
    Patch,
}

impl FigureKind {
    /// Width and height in pixels where none are chosen: a column of print at 600 dots per inch, two columns at 340.
    fn usual_size(self) -> [u32; 2] {
        match self {
            Self::View => [2000, 1500],
            Self::Patch => [2400, 1800],
        }
    }

    /// What the dialog is called that asks for its place.
    pub fn dialog_title(self) -> &'static str {
        match self {
            Self::View => "Save the 3D view as a figure",
            Self::Patch => "Save the patch figure",
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::View => "Figure",
            Self::Patch => "Patch figure",
        }
    }
}

/// Size and colours of a figure as they were chosen when it was asked for.
#[derive(Clone, Copy, Debug)]
pub struct FigureColours {
    pub(super) size: Option<[u32; 2]>,
    dark: bool,
    pub(super) theme: PictureTheme,
    pub(super) transparent: bool,
}

impl FigureColours {
    /// Those of a look in a dark or light window.
    pub fn of(look: FigureLook, dark: bool) -> Self {
        let (theme, transparent) = look.colours(dark);
        Self {
            size: look.size,
            dark,
            theme,
            transparent,
        }
    }
}

/// A subject, a camera and settings as they were when the figure was asked for: everything that it is drawn from.
pub struct FigureExport {
    kind: FigureKind,
    size: [u32; 2],
    study: Arc<Study>,
    /// Index of the subject in that study.
    subject: usize,
    shown: ShownSubject,
    measures: Option<SubjectMeasures>,
    settings: SceneSettings,
    camera: Camera,
    bulls_eye: BullsEyeQuantity,
    thickening: ThickeningSettings,
    /// What the verdict is asked with, for a patch figure: it may not be known yet.
    verdict: VerdictQuery,
    /// What a figure of the 3D view says of it: there is no room for more, and no reason to wait for a cohort.
    verdict_words: String,
}

/// Why there is no figure now.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoFigure {
    /// The selected subject is not on screen yet, or its wall is still being measured.
    NotYet,
    /// It cannot be had; the words name the subject.
    Refused(String),
}

impl FigureExport {
    /// The subject that `document` selects as the document shows it: the document of the command, which may be older
    /// than that of the state.
    ///
    /// # Errors
    /// If the view still shows another subject, its wall is still being measured, or it has none for a patch figure.
    pub fn of(
        document: &Document,
        state: &State,
        viewport: &Viewport,
        colours: &FigureColours,
        kind: FigureKind,
    ) -> Result<Self, NoFigure> {
        let is_patch = kind == FigureKind::Patch;
        let size = colours.size.unwrap_or(kind.usual_size());
        check_figure_size(size, is_patch).map_err(|error| NoFigure::Refused(error.to_string()))?;
        let shown = selected_on_screen(document, viewport).ok_or(NoFigure::NotYet)?;
        // Since it was drawn, subjects that were read may have come before it.
        let place = |study: &Study| {
            let place = (study.all()).position(|subject| Arc::ptr_eq(subject, &shown.subject));
            place.ok_or(NoFigure::NotYet)
        };
        let index = place(state.document.study())?;
        // What is said of a subject among others waits for all of them.
        let study = match document.study().unread.is_empty() {
            true => document.study(),
            false => state.document.study(),
        };
        if is_patch && !study.unread.is_empty() {
            return Err(NoFigure::NotYet);
        }
        let wall = state.wall_of(index);
        if is_patch {
            match wall {
                Some((Err(why), true)) => {
                    let why = format!("{} is not assessed: {why}", shown.subject.id);
                    return Err(NoFigure::Refused(why));
                }
                Some((Ok(_), true)) if shown.medial.is_some() => {}
                _ => return Err(NoFigure::NotYet),
            }
        }
        Ok(Self {
            kind,
            size,
            study: Arc::clone(study),
            subject: place(study)?,
            measures: state.measures_of(index).cloned(),
            settings: SceneSettings {
                theme: colours.theme,
                transparent: colours.transparent,
                ..shown.settings(&viewport.settings(document, colours.dark))
            },
            camera: viewport.camera(document, shown),
            bulls_eye: document.bulls_eye,
            thickening: document.thickening,
            verdict: verdict_settings(document),
            verdict_words: verdict_words(state, index),
            shown: ShownSubject {
                position: match document.view_mode {
                    ViewMode::AllFrames => document.frame() as f64,
                    ViewMode::Single | ViewMode::SideBySide => document.position,
                },
                ..shown.clone()
            },
        })
    }

    /// A name for its file, of the pseudonym and the frame that it shows.
    pub fn file_name(&self) -> String {
        let safe = file_name(&self.shown.subject.id);
        match self.kind {
            FigureKind::View => match frames_around(self.shown.position, self.frame_count()) {
                Some([from, to]) => format!("{safe}_between_frames_{from}_and_{to}.png"),
                None => format!("{safe}_frame_{}.png", self.frame()),
            },
            FigureKind::Patch => format!("{safe}_patch.png"),
        }
    }

    fn frame(&self) -> usize {
        nearest_frame(self.shown.position, self.frame_count())
    }

    fn frame_count(&self) -> usize {
        self.shown.placed.prepared.frame_count
    }

    /// Draws and writes it, off the window's thread.
    ///
    /// # Errors
    /// If the name has an ending that no figure has.
    pub fn write(self, engine: &mut Engine, path: PathBuf) -> Result<(), String> {
        let (name, size) = (self.kind.name(), self.size);
        write_figure_file(engine, path, name, size, move |store, format, progress| {
            drawn(&self, store, format, progress)
        })
    }
}

/// The selected subject where it is on screen.
fn selected_on_screen<'a>(document: &Document, viewport: &'a Viewport) -> Option<&'a ShownSubject> {
    let selected = document.selected()?;
    let mut shown = viewport.shown().iter();
    shown.find(|shown| Arc::ptr_eq(&shown.subject, selected))
}

/// The verdict on a subject, as far as it is known with the settings of today.
fn verdict_words(state: &State, subject: usize) -> String {
    let of_today = matches!(state.verdicts(), Some((_, true)));
    let verdict = state.verdict_of(subject).filter(|_| of_today);
    match (verdict, state.wall_of(subject)) {
        (Some(Ok(verdict)), _) => sentence(verdict.finding.name()),
        (Some(Err(_)), _) | (None, Some((Err(_), true))) => "Not assessed".to_owned(),
        (None, _) if state.document.study().is_excluded(subject) => {
            "Not assessed: excluded from the cohort".to_owned()
        }
        (None, _) => "Not yet assessed".to_owned(),
    }
}

/// The verdicts that a patch figure waits for; `None` where they could not be had, for which there is a card.
fn awaited_verdicts(
    figure: &FigureExport,
    store: &Store,
    progress: &Progress,
) -> Result<Option<Arc<Verdicts>>, String> {
    if figure.kind != FigureKind::Patch {
        return Ok(None);
    }
    let part = progress.part("waiting for the verdict", 0.0, 0.5);
    let verdicts = store.answer(&figure.study, &figure.verdict, &part);
    progress.check().map_err(|stopped| stopped.to_string())?;
    Ok(verdicts.ok())
}

fn drawn(
    figure: &FigureExport,
    store: &Store,
    format: PageFormat,
    progress: &Progress,
) -> Result<Vec<u8>, String> {
    let verdicts = awaited_verdicts(figure, store, progress)?;
    progress.begin_phase("drawing", 0.5, 0.8);
    let message = |error: &dyn std::fmt::Display| error.to_string();
    let fonts = FigureFonts::load().map_err(|error| message(&error))?;
    let mut headless = Headless::new().map_err(|error| message(&error))?;
    let shown = &figure.shown;
    let prepared = &shown.placed.prepared;
    let order = FigureOrder {
        study: &figure.study.name,
        verdict: &figure.verdict_words,
        shown: FigureSubject {
            subject: &shown.subject,
            measures: figure.measures.as_ref(),
            frame: figure.frame(),
        },
        position: shown.position,
        pose: pose_in(prepared, shown.position),
        prepared,
        extras: shown.extras(),
        scene: figure.settings,
        bulls_eye: figure.bulls_eye,
        thickening: figure.thickening,
        view: FigureView::Seen(figure.camera),
        size: figure.size,
    };
    let finished = match (figure.kind, &shown.medial) {
        (FigureKind::Patch, Some(medial)) => {
            let order = PatchOrder {
                figure: order,
                wall: &medial.wall,
                verdicts: verdicts.as_deref(),
                subject: figure.subject,
            };
            rendered_patch_figure(&order, &mut headless, &fonts)
        }
        _ => rendered_figure(&order, &mut headless, &fonts),
    };
    let finished = finished.map_err(|error| message(&error))?;
    progress.begin_phase("writing", 0.8, 1.0);
    progress.check().map_err(|stopped| message(&stopped))?;
    let bytes = format.file(&finished.page, &finished.settings, &fonts);
    bytes.map_err(|error| message(&error))
}

/// A study and settings as they were when its tables were asked for.
pub struct TableExport {
    study: Arc<Study>,
    settings: TableSettings,
}

impl TableExport {
    /// What `analyze` writes, with the metric that the map on screen has; `None` while nothing is open.
    pub fn now(state: &State) -> Option<Self> {
        let study = Arc::clone(state.document.study());
        (!study.subjects.is_empty()).then(|| Self {
            study,
            settings: TableSettings {
                deformations: deformation_settings(state),
                verdicts: verdict_settings(&state.document),
                ..TableSettings::default()
            },
        })
    }

    /// Writes all tables into a folder, off the window's thread: all of them in place of those of an earlier run, or, if it
    /// fails or is stopped, none.
    pub fn write(self, engine: &mut Engine, folder: PathBuf) {
        let words = distance_words(&self.settings.deformations.poses.distances);
        let store = Arc::clone(engine.store());
        engine.start_writing("Tables", words, move |progress| {
            let tables = tables_of_study(&store, &self.study, &self.settings, &folder, progress);
            let tables = tables.map_err(interruption)?;
            progress.check().map_err(|stopped| stopped.to_string())?;
            replace_results(&folder, tables)
        });
    }
}
