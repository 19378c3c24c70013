//! How a heart is drawn: quantity, colours, surfaces, marks.

use crate::picture::colour_ranges::CohortColourRanges;
use crate::picture::medial::MedialSettings;
use crate::picture::quantity::Quantity;
use crate::picture::tokens::PictureTheme;
use crate::render::Shading;

/// How a heart is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SceneSettings {
    /// Quantity shown in colour.
    pub quantity: Quantity,
    /// The study's fixed ranges.
    pub cohort_ranges: CohortColourRanges,
    /// Typed limits in their place.
    pub typed_limits: Option<[f64; 2]>,
    /// Whether the inner side of the wall is drawn.
    pub inner: bool,
    /// Whether the outer side is drawn.
    pub outer: bool,
    /// Whether the cut at the base is drawn, so that the wall reads as one.
    pub rim: bool,
    /// Whether edges are drawn.
    pub wireframe: bool,
    /// Whether vertices are drawn as discs.
    pub vertices: bool,
    /// Smooth or flat.
    pub shading: Shading,
    /// What of the middle of the wall is drawn.
    pub medial: MedialSettings,
    /// Colours around the heart.
    pub theme: PictureTheme,
    /// Whether nothing is drawn behind it.
    pub transparent: bool,
}

impl Default for SceneSettings {
    fn default() -> Self {
        Self {
            quantity: Quantity::default(),
            cohort_ranges: CohortColourRanges::default(),
            typed_limits: None,
            inner: true,
            outer: true,
            rim: true,
            wireframe: false,
            vertices: false,
            shading: Shading::default(),
            medial: MedialSettings::default(),
            theme: PictureTheme::DARK,
            transparent: false,
        }
    }
}
