//! From a heart to a finished figure: scene, rendering, text, settings.

use crate::picture::axes::AnatomicalView;
use crate::picture::figure::canvas::Canvas;
use crate::picture::figure::content::{FigureContent, FigureSubject};
use crate::picture::figure::layout::{FigureFrame, drawn_figure};
use crate::picture::figure::picture_file::FigureSettings;
use crate::picture::figure::text::FigureFonts;
use crate::picture::prepared::PreparedSubject;
use crate::picture::scene::{HeartExtras, SceneSettings, heart_scene};
use crate::render::{Camera, GeometryPose, Headless, RenderError};

/// Where a figure is taken from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FigureView {
    /// Base up, a little from above.
    #[default]
    Home,
    /// One of the six anatomical directions.
    Anatomical(AnatomicalView),
    /// Turned as in the window; the distance is chosen to fit.
    Turned(glam::Quat),
}

/// Everything that decides how a figure looks.
#[derive(Clone, Copy, Debug)]
pub struct FigureOrder<'a> {
    /// Who and when.
    pub shown: FigureSubject<'a>,
    /// The heart, ready for drawing.
    pub prepared: &'a PreparedSubject,
    /// What is drawn beside its surfaces.
    pub extras: HeartExtras<'a>,
    /// Colours and what is drawn.
    pub scene: SceneSettings,
    /// Where from.
    pub view: FigureView,
    /// Pixels across and down.
    pub size: [u32; 2],
}

/// A finished figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Its pixels.
    pub canvas: Canvas,
    /// What it was made with, for the file.
    pub settings: FigureSettings,
}

/// Renders a figure. The whole beat fits, so that figures of one beat can be laid side by side.
///
/// # Errors
/// If the graphics driver fails.
pub fn rendered_figure(
    order: &FigureOrder<'_>,
    headless: &mut Headless,
    fonts: &FigureFonts,
) -> Result<Figure, RenderError> {
    let pose = GeometryPose {
        from: order.shown.frame,
        to: order.shown.frame,
        blend: 0.0,
    };
    let heart = heart_scene(order.prepared, order.extras, &order.scene, pose);
    let axes = &order.prepared.axes;
    let content = FigureContent::of(order.shown, heart.legend, axes.cube());
    let frame = FigureFrame::of(order.size, &content, fonts);
    let turned = match order.view {
        FigureView::Home => axes.home(),
        FigureView::Anatomical(view) => axes.view(view),
        FigureView::Turned(rotation) => rotation,
    };
    let camera = order.prepared.camera_from(turned, frame.heart_aspect());
    let picture = headless.picture(
        &heart.scene,
        &camera,
        frame.size[0],
        frame.heart_height,
        frame.scale,
    )?;
    let canvas = drawn_figure(
        &frame,
        &content,
        &picture.rgba,
        &camera,
        &order.scene.theme,
        order.scene.transparent,
        fonts,
    );
    let settings = settings(order, &content, &camera);
    Ok(Figure { canvas, settings })
}

fn settings(order: &FigureOrder<'_>, content: &FigureContent, camera: &Camera) -> FigureSettings {
    let version = env!("CARGO_PKG_VERSION");
    let mut settings = vec![
        ("Software", format!("Cardiomorph {version}")),
        ("Comment", "research use, not for diagnosis".to_owned()),
        ("Title", content.title.clone()),
        ("Frame", order.shown.frame.to_string()),
        ("Moment", content.moment.clone()),
        ("Quantity", order.scene.quantity.word().to_owned()),
    ];
    if let Some(legend) = &content.legend {
        let limits = legend.limits;
        let unit = legend.unit;
        settings.push((
            "Colour limits",
            format!("{} to {} {unit}", limits.low, limits.high)
                .trim_end()
                .to_owned(),
        ));
        settings.push(("Colour limits are", legend.note.to_owned()));
    }
    let [x, y, z, w] = camera.world_from_camera.to_array();
    settings.push(("Camera rotation x y z w", format!("{x} {y} {z} {w}")));
    settings.push(("Camera target", format!("{}", camera.target)));
    settings.push(("Camera half height", camera.half_height.to_string()));
    settings
}
