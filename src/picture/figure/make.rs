//! From a heart to a finished figure: scene, rendering, text, settings.

use std::sync::Arc;

use crate::analysis::thickening::ThickeningSettings;
use crate::picture::axes::AnatomicalView;
use crate::picture::bulls_eye::BullsEyeQuantity;
use crate::picture::figure::content::{FigureContent, FigureSubject};
use crate::picture::figure::layout::{FigureFrame, drawn_figure};
use crate::picture::figure::saved_view::{SavedCamera, SavedView};
use crate::picture::page::{FigureFonts, FigureSettings, Page, VIEW_KEY};
use crate::picture::prepared::PreparedSubject;
use crate::picture::scene::{SubjectExtras, SubjectScene, scene_with_extras};
use crate::picture::scene_settings::SceneSettings;
use crate::picture::subject_frame::SubjectFrame;
use crate::render::{Camera, GeometryPose, Headless, RenderError};

/// Where a figure is taken from.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum FigureView {
    /// Base up, a little from above.
    #[default]
    Home,
    /// One of the six anatomical directions.
    Anatomical(AnatomicalView),
    /// As the window sees it.
    Seen(Camera),
}

/// Everything that decides how a figure looks.
#[derive(Clone, Copy, Debug)]
pub struct FigureOrder<'a> {
    /// Name of the study.
    pub study: &'a str,
    /// What a figure of the heart alone says of its verdict; empty where none is asked for.
    pub verdict: &'a str,
    /// Who and when.
    pub shown: FigureSubject<'a>,
    /// Place in the beat, counted in frames.
    pub position: f64,
    /// The same as a pose of `prepared`.
    pub pose: GeometryPose,
    /// The heart, ready for drawing.
    pub prepared: &'a PreparedSubject,
    /// What is drawn beside its surfaces.
    pub extras: SubjectExtras<'a>,
    /// Colours and what is drawn.
    pub scene: SceneSettings,
    /// What the bull's-eye shows, here or in the window that takes the view up again.
    pub bulls_eye: BullsEyeQuantity,
    /// How the wall was assessed.
    pub thickening: ThickeningSettings,
    /// Where from.
    pub view: FigureView,
    /// Pixels across and down.
    pub size: [u32; 2],
}

/// A finished figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// What stands on it.
    pub page: Page,
    /// What it was made with, for the file.
    pub settings: FigureSettings,
}

/// Renders a figure. Unless the camera is given, the whole beat fits, so that figures of one beat can be laid side
/// by side.
///
/// # Errors
/// If the graphics driver fails.
pub fn rendered_figure(
    order: &FigureOrder<'_>,
    headless: &mut Headless,
    fonts: &FigureFonts,
) -> Result<Figure, RenderError> {
    let heart = scene_with_extras(order.prepared, order.extras, &order.scene, order.pose);
    let mut content = order.content(&heart);
    if !order.verdict.is_empty() {
        content.moment = match content.moment.as_str() {
            "" => order.verdict.to_owned(),
            moment => format!("{moment} · {}", order.verdict),
        };
    }
    let frame = FigureFrame::of(order.size, &content, fonts);
    let camera = order.camera(frame.heart_aspect());
    let [width, height] = [frame.size[0], frame.heart_height];
    let picture = headless.picture(&heart.scene, &camera, width, height, frame.scale)?;
    let page = drawn_figure(
        &frame,
        &content,
        Arc::new(picture),
        &camera,
        &order.scene.theme,
        order.scene.transparent,
        fonts,
    );
    let mut settings = order.settings(&content, &camera);
    if !order.verdict.is_empty() {
        settings.push(("Verdict", order.verdict.to_owned()));
    }
    Ok(Figure { page, settings })
}

impl FigureOrder<'_> {
    /// What the figure says beside its heart.
    pub(super) fn content(&self, heart: &SubjectScene) -> FigureContent {
        let legends = [&heart.legend, &heart.atom_legend].into_iter().flatten();
        FigureContent::of(
            self.shown,
            self.position,
            legends.cloned().collect(),
            self.prepared.axes.cube(),
        )
    }

    /// The camera for a picture of the heart of this width by height.
    pub(super) fn camera(&self, aspect: f32) -> Camera {
        let axes = &self.prepared.axes;
        let turned = match self.view {
            FigureView::Home => axes.home(),
            FigureView::Anatomical(view) => axes.view(view),
            FigureView::Seen(camera) => return camera,
        };
        self.prepared.camera_from(turned, aspect)
    }

    /// What the figure is made with, for the file: in words, and as a view that the window can restore.
    pub(super) fn settings(&self, content: &FigureContent, camera: &Camera) -> FigureSettings {
        let version = env!("CARGO_PKG_VERSION");
        let mut settings = vec![
            ("Software", format!("Cardiomorph {version}")),
            ("Comment", "research use, not for diagnosis".to_owned()),
            ("Title", content.title.clone()),
            ("Frame", self.position.to_string()),
            ("Moment", content.moment.clone()),
            ("Quantity", self.scene.quantity.word().to_owned()),
        ];
        for legend in &content.legends {
            let limits = legend.limits;
            let words = format!("{} to {} {}", limits.low, limits.high, legend.unit);
            settings.push(("Colour limits", words.trim_end().to_owned()));
            settings.push(("Colour limits are", legend.note.to_owned()));
        }
        let [x, y, z, w] = camera.world_from_camera.to_array();
        settings.push(("Camera rotation x y z w", format!("{x} {y} {z} {w}")));
        settings.push(("Camera target", format!("{}", camera.target)));
        settings.push(("Camera half height", camera.half_height.to_string()));
        let view = SavedView::of(
            self.study,
            self.shown.subject,
            self.position,
            SavedCamera::of(*camera, &SubjectFrame::of(self.prepared)),
            &self.scene,
            self.bulls_eye,
            self.thickening,
        );
        settings.push((VIEW_KEY, view.text()));
        settings
    }
}
