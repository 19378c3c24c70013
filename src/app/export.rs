//! Writes what is on screen: a figure of the 3D view, all tables as files.

use std::path::PathBuf;
use std::sync::Arc;

use crate::engine::{
    AnalysisTables, Cache, DeformationMapSettings, Engine, ExportFile, TableSettings,
    distance_words,
};
use crate::picture::figure::{
    FigureContent, FigureFonts, FigureFrame, FigureSettings, FigureSubject, drawn_figure,
    encoded_png,
};
use crate::picture::{PictureTheme, SceneSettings, heart_scene};
use crate::progress::Progress;
use crate::render::{Camera, Headless};

use super::play::pose_in;
use super::shown_heart::ShownHeart;
use super::state::State;
use super::viewport::Viewport;

/// Width and height of an exported figure in pixels: a column of print at 600 dots per inch.
const FIGURE_SIZE: [u32; 2] = [2000, 1500];

/// A name for the figure of what is on screen, of the pseudonym and the frame.
pub fn figure_name(state: &State) -> String {
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
    format!("{safe}_frame_{}.png", state.document.frame())
}

/// A heart, a camera and settings: everything that a figure is drawn from.
struct Figure {
    shown: ShownHeart,
    settings: SceneSettings,
    camera: Camera,
    content: FigureContent,
    words: FigureSettings,
}

/// Draws and writes the selected heart as it is seen now, off the window's thread.
pub fn write_figure(
    engine: &mut Engine,
    state: &State,
    viewport: &Viewport,
    dark: bool,
    path: PathBuf,
) {
    let Some(shown) = viewport.shown().first() else {
        return;
    };
    let figure = figure(state, viewport, shown, dark);
    let words = format!(
        "{} × {} pixels, {}",
        FIGURE_SIZE[0],
        FIGURE_SIZE[1],
        path.file_name().unwrap_or_default().to_string_lossy()
    );
    engine.start_export("Figure", words, move |progress| {
        let bytes = drawn(&figure, progress)?;
        Ok(vec![ExportFile {
            path,
            bytes: bytes.into(),
        }])
    });
}

fn figure(state: &State, viewport: &Viewport, shown: &ShownHeart, dark: bool) -> Figure {
    let settings = SceneSettings {
        theme: if dark {
            PictureTheme::DARK
        } else {
            PictureTheme::LIGHT
        },
        ..viewport.settings(state, dark)
    };
    let prepared = &shown.heart.prepared;
    let pose = pose_in(prepared, shown.position);
    let legend = heart_scene(prepared, shown.extras(), &settings, pose).legend;
    let subject = FigureSubject {
        subject: &shown.subject,
        measures: state.measures_of(shown.index),
        frame: super::document::nearest_frame(shown.position, prepared.frame_count),
    };
    let words = vec![
        (
            "Software",
            concat!("Cardiomorph ", env!("CARGO_PKG_VERSION")).to_owned(),
        ),
        ("Subject", shown.subject.id.clone()),
        ("Position", format!("{:.3} frames", shown.position)),
        ("Colour", format!("{:?}", settings.quantity)),
        ("Camera", camera_words(&viewport.camera(state, shown))),
    ];
    Figure {
        words,
        content: FigureContent::of(subject, legend, prepared.axes.cube()),
        camera: viewport.camera(state, shown),
        shown: shown.clone(),
        settings,
    }
}

/// A camera in numbers with which the picture can be taken again.
fn camera_words(camera: &Camera) -> String {
    let (target, turn) = (camera.target, camera.world_from_camera);
    format!(
        "target {:.3} {:.3} {:.3}, rotation {:.5} {:.5} {:.5} {:.5}, half height {:.3}",
        target.x, target.y, target.z, turn.x, turn.y, turn.z, turn.w, camera.half_height
    )
}

fn drawn(figure: &Figure, progress: &Progress) -> Result<Vec<u8>, String> {
    progress.begin_phase("drawing", 0.0, 0.8);
    let fonts = FigureFonts::load().map_err(|error| error.to_string())?;
    let frame = FigureFrame::of(FIGURE_SIZE, &figure.content, &fonts);
    let prepared = &figure.shown.heart.prepared;
    let pose = pose_in(prepared, figure.shown.position);
    let scene = heart_scene(prepared, figure.shown.extras(), &figure.settings, pose).scene;
    let mut headless = Headless::new().map_err(|error| error.to_string())?;
    let heart = headless
        .picture(
            &scene,
            &figure.camera,
            frame.size[0],
            frame.heart_height,
            frame.scale,
        )
        .map_err(|error| error.to_string())?;
    progress.begin_phase("writing", 0.8, 1.0);
    progress.check().map_err(|stopped| stopped.to_string())?;
    let canvas = drawn_figure(
        &frame,
        &figure.content,
        &heart.rgba,
        &figure.camera,
        &figure.settings.theme,
        false,
        &fonts,
    );
    encoded_png(&canvas, &figure.words).map_err(|error| error.to_string())
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
        thickening: state.document.thickening,
    };
    let words = distance_words(&settings.deformations.poses.distances);
    engine.start_export("Tables", words, move |progress| {
        let tables = AnalysisTables::of(&study, &settings, &folder, &Cache::default(), progress)
            .map_err(|error| error.to_string())?;
        Ok(tables.files(Vec::new())?.0)
    });
}
