//! The patch figure as it goes to paper, part by part.

use egui::{Rect, pos2, vec2};

use super::{compare_part, program_on_reference_driver};
use crate::cli::patch_figures;

pub const NAMES: [&str; 3] = ["bulls_eye", "heart", "table"];

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
