//! Writes what is on screen: a figure of the 3D view, all tables as files.

use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::measures::SubjectMeasures;
use crate::analysis::verdicts::Verdicts;
use crate::engine::{
    AnalysisTables, DeformationMapSettings, Engine, ExportFile, Interrupted, TableSettings,
    ThickeningSettings, VerdictSettings, distance_words,
};
use crate::picture::figure::{
    FigureOrder, FigureSubject, FigureView, PatchOrder, rendered_figure, rendered_patch_figure,
};
use crate::picture::page::{FigureFonts, PageFormat};
use crate::picture::{BullsEyeQuantity, PictureTheme, SceneSettings};
use crate::progress::{Progress, Stopped};
use crate::render::{Camera, Headless};

use super::document::nearest_frame;
use super::play::pose_in;
use super::shown_heart::ShownHeart;
use super::state::State;
use super::viewport::Viewport;

/// Which figure is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FigureKind {
    /// The 3D view.
    View,
    /// The heart with its bull's-eye, patches and verdict.
    Patch,
}

impl FigureKind {
    /// Width and height in pixels: a column of print at 600 dots per inch, two columns at 340.
    fn size(self) -> [u32; 2] {
        match self {
            Self::View => [2000, 1500],
            Self::Patch => [2400, 1800],
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::View => "Figure",
            Self::Patch => "Patch figure",
        }
    }
}

/// A name for the figure of what is on screen, of the pseudonym and the frame.
pub fn figure_name(state: &State, kind: FigureKind) -> String {
    let id = state
        .document
        .selected()
        .map_or_else(|| "figure".to_owned(), |subject| subject.id.clone());
    let safe: String = id
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || "-_.".contains(c) {
                c
            } else {
                '_'
            }
        })
        .collect();
    match kind {
        FigureKind::View => format!("{safe}_frame_{}.png", state.document.frame()),
        FigureKind::Patch => format!("{safe}_patch.png"),
    }
}

/// A heart, a camera and settings: everything that a figure is drawn from.
struct Figure {
    kind: FigureKind,
    study: String,
    shown: ShownHeart,
    measures: Option<SubjectMeasures>,
    settings: SceneSettings,
    camera: Camera,
    bulls_eye: BullsEyeQuantity,
    thickening: ThickeningSettings,
    verdicts: Option<Arc<Verdicts>>,
}

/// Why there is no patch figure of a heart, where there is none.
fn without_patch_figure(state: &State, shown: &ShownHeart) -> Option<String> {
    if shown.medial.is_some() {
        return None;
    }
    Some(match state.wall_of(shown.index) {
        Some((Err(why), _)) => format!("{}: not assessed: {why}", shown.subject.id),
        _ => format!("{}: its wall is still being measured", shown.subject.id),
    })
}

/// Draws and writes the selected heart as it is seen now, off the window's thread.
pub fn write_figure(
    engine: &mut Engine,
    state: &mut State,
    viewport: &Viewport,
    dark: bool,
    kind: FigureKind,
    path: PathBuf,
) {
    let Some(shown) = viewport.shown().first() else {
        return;
    };
    if kind == FigureKind::Patch
        && let Some(reason) = without_patch_figure(state, shown)
    {
        let title = "There is no patch figure of this heart";
        super::errors::push_card(&mut state.errors, title, reason, None);
        return;
    }
    let Some(format) = PageFormat::of(&path) else {
        let reason = format!(
            "{}: the name must end in .png, .svg or .pdf",
            path.display()
        );
        let title = "The figure could not be written";
        super::errors::push_card(&mut state.errors, title, reason, None);
        return;
    };
    let figure = Figure {
        kind,
        study: state.document.study().name.clone(),
        measures: state.measures_of(shown.index).cloned(),
        settings: SceneSettings {
            theme: if dark {
                PictureTheme::DARK
            } else {
                PictureTheme::LIGHT
            },
            ..viewport.settings(state, dark)
        },
        camera: viewport.camera(state, shown),
        bulls_eye: state.document.bulls_eye,
        thickening: state.document.thickening,
        verdicts: state.verdicts().map(|(told, _)| Arc::clone(told)),
        shown: shown.clone(),
    };
    let [width, height] = kind.size();
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let words = format!("{width} × {height} pixels, {name}");
    engine.start_export(kind.name(), words, move |progress| {
        let bytes = drawn(&figure, format, progress)?;
        Ok(vec![ExportFile {
            path,
            bytes: bytes.into(),
        }])
    });
}

fn drawn(figure: &Figure, format: PageFormat, progress: &Progress) -> Result<Vec<u8>, String> {
    progress.begin_phase("drawing", 0.0, 0.8);
    let said = |error: &dyn std::fmt::Display| error.to_string();
    let fonts = FigureFonts::load().map_err(|error| said(&error))?;
    let mut headless = Headless::new().map_err(|error| said(&error))?;
    let shown = &figure.shown;
    let prepared = &shown.heart.prepared;
    let order = FigureOrder {
        study: &figure.study,
        shown: FigureSubject {
            subject: &shown.subject,
            measures: figure.measures.as_ref(),
            frame: nearest_frame(shown.position, prepared.frame_count),
        },
        position: shown.position,
        pose: pose_in(prepared, shown.position),
        prepared,
        extras: shown.extras(),
        scene: figure.settings,
        bulls_eye: figure.bulls_eye,
        thickening: figure.thickening,
        view: FigureView::Seen(figure.camera),
        size: figure.kind.size(),
    };
    let finished = match (figure.kind, &shown.medial) {
        (FigureKind::Patch, Some(medial)) => {
            let order = PatchOrder {
                figure: order,
                found: &medial.found,
                verdicts: figure.verdicts.as_deref(),
                subject: shown.index,
            };
            rendered_patch_figure(&order, &mut headless, &fonts)
        }
        _ => rendered_figure(&order, &mut headless, &fonts),
    };
    let finished = finished.map_err(|error| said(&error))?;
    progress.begin_phase("writing", 0.8, 1.0);
    progress.check().map_err(|stopped| said(&stopped))?;
    let bytes = format.file(&finished.page, &finished.settings, &fonts);
    bytes.map_err(|error| said(&error))
}

/// Writes all tables into a folder, off the window's thread: what `analyze` writes, with the
/// metric that the map on screen has.
pub fn write_tables(engine: &mut Engine, state: &State, folder: PathBuf) {
    let study = Arc::clone(state.document.study());
    if study.subjects.is_empty() {
        return;
    }
    let settings = TableSettings {
        deformations: DeformationMapSettings {
            poses: state.document.map,
            map: state.document.deformation_map,
        },
        verdicts: VerdictSettings {
            thickening: state.document.thickening,
            ..VerdictSettings::default()
        },
    };
    let words = distance_words(&settings.deformations.poses.distances);
    let store = Arc::clone(engine.store());
    engine.start_export("Tables", words, move |progress| {
        let tables =
            AnalysisTables::of(&store, &study, &settings, &folder, progress).map_err(|why| {
                match why {
                    Interrupted::Stopped => Stopped.to_string(),
                    Interrupted::Failed(error) => error.to_string(),
                }
            })?;
        Ok(tables.files(Vec::new())?.0)
    });
}
