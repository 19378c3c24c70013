//! From a heart and its patches to a finished patch figure.

use std::sync::Arc;

use crate::picture::figure::make::{Figure, FigureView};
use crate::picture::figure::patch::content::{PatchContent, patch_settings};
use crate::picture::figure::patch::draw::drawn_patch_figure;
use crate::picture::figure::patch::frame::PatchFrame;
use crate::picture::figure::patch::order::PatchOrder;
use crate::picture::medial::facing_patch;
use crate::picture::page::FigureFonts;
use crate::picture::scene::scene_with_extras;
use crate::render::{Headless, RenderError};

/// Renders a patch figure, by default from where the largest patch is seen best.
///
/// # Errors
/// If the graphics driver fails.
pub fn rendered_patch_figure(
    order: &PatchOrder<'_>,
    headless: &mut Headless,
    fonts: &FigureFonts,
) -> Result<Figure, RenderError> {
    let mut figure = order.figure;
    figure.scene.medial.patch_look = order.standing().look();
    // Patches in a wall that is not resolved may be blur or noise.
    figure.scene.medial.patches &= order.wall.not_assessed.is_none();
    let heart = scene_with_extras(figure.prepared, figure.extras, &figure.scene, figure.pose);
    let content = PatchContent::of(figure.content(&heart), order);
    let frame = PatchFrame::of(figure.size, &content, fonts);
    let camera = match (figure.view, order.wall.thickening.patches.first()) {
        (FigureView::Home, Some(largest)) => {
            let axes = &figure.prepared.axes;
            let turned = facing_patch(order.wall, largest, axes).unwrap_or(axes.home());
            figure.prepared.camera_from(turned, frame.heart_aspect())
        }
        _ => figure.camera(frame.heart_aspect()),
    };
    let [width, height] = frame.heart_size;
    let picture = headless.picture(&heart.scene, &camera, width, height, frame.scale)?;
    let page = drawn_patch_figure(
        &frame,
        &content,
        Arc::new(picture),
        &camera,
        &figure.scene.theme,
        figure.scene.transparent,
        fonts,
    );
    let mut settings = figure.settings(&content.heart, &camera);
    settings.extend(patch_settings(&content));
    Ok(Figure { page, settings })
}
