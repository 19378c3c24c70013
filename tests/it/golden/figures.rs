//! The patch figure as it goes to paper, part by part, and the figures of other panes.

use cardiomorph::document::ThemeChoice;
use cardiomorph::panes::{Command, FileCommand, Pane};
use cardiomorph::picture::figure::{FigureLook, FigureTheme};
use egui::{Rect, pos2, vec2};

use super::{
    compare, compare_part, on_reference_driver, program_on_reference_driver, wait, window_after,
};
use crate::cli::patch_figures;

pub const NAMES: [&str; 7] = [
    "bulls_eye",
    "heart",
    "table",
    "pose_map",
    "deformation_map",
    "polar_map",
    "volume",
];

/// Parts of a figure of 1000 × 750 pixels: left, top, width, height.
const PARTS: [[f32; 4]; 3] = [
    [540.0, 140.0, 460.0, 460.0],
    [160.0, 160.0, 240.0, 360.0],
    [0.0, 590.0, 1000.0, 160.0],
];

#[test]
fn the_patch_figure_looks_as_it_did() {
    if !program_on_reference_driver() {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("P05.png");
    patch_figures::figure(&out, &["--size", "1000x750"]).unwrap();
    let picture = image::open(&out).unwrap().into_rgba8();
    for (name, [left, top, width, height]) in NAMES.into_iter().zip(PARTS) {
        let part = Rect::from_min_size(pos2(left, top), vec2(width, height));
        compare_part(&picture, part, &format!("figures/{name}"));
    }
}

#[test]
fn figures_of_panes_look_as_they_did() {
    if !on_reference_driver() {
        return;
    }
    let look = |theme| {
        let size = Some([800, 600]);
        let look = FigureLook {
            size,
            theme,
            ..FigureLook::default()
        };
        Command::File(FileCommand::SetFigureLook(look))
    };
    let folder = tempfile::tempdir().unwrap();
    let commands = vec![look(FigureTheme::Light)];
    let mut harness = window_after([1280.0, 800.0], ThemeChoice::Dark, commands, |app| {
        app.state().verdict_of(super::SUBJECT).is_some()
    });
    let panes = [
        Pane::POSE_MAP,
        Pane::DEFORMATION_MAP,
        Pane::BULLS_EYE,
        Pane::CURVES,
    ];
    for (name, pane) in NAMES[PARTS.len()..].iter().zip(panes) {
        if pane == Pane::CURVES {
            harness.state_mut().push(look(FigureTheme::Dark));
        }
        let path = folder.path().join(format!("{name}.png"));
        let export = FileCommand::ExportPaneFigure(pane, Some(path.clone()));
        harness.state_mut().push(Command::File(export));
        wait(&mut harness, "the figure", |_| path.exists());
        let picture = image::open(&path).unwrap().into_rgba8();
        compare(&picture, &format!("figures/{name}"));
    }
}
