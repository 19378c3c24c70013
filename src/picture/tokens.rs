//! Colours of pictures: tissue, selection and the two themes of figures.

use crate::render::Rgba;

/// Inner side of the wall, and blood pools.
pub const ENDOCARDIUM: [f32; 3] = srgb(0xa9_4a4a);
/// Outer side of the wall.
pub const EPICARDIUM: [f32; 3] = srgb(0xd9_c3a5);
/// The cut through the wall at its base: between the two sides.
pub const WALL_CUT: [f32; 3] = srgb(0xc0_8673);
/// Surfaces that are not said to be part of a heart.
pub const OTHER_SURFACE: [f32; 3] = srgb(0xc9_b29a);
/// How much the outer side covers the inner one.
pub const EPICARDIUM_OPACITY: f32 = 0.22;
/// Strength of the dark line where an opaque surface turns away.
pub const SILHOUETTE: f32 = 0.35;
/// The same where a translucent surface turns away: without it the outer side has no edge.
pub const TRANSLUCENT_SILHOUETTE: f32 = 0.6;

/// A colour written as `0xrrggbb`, as red, green and blue in `0..=1`.
pub const fn srgb(hex: u32) -> [f32; 3] {
    [
        ((hex >> 16) & 0xff) as f32 / 255.0,
        ((hex >> 8) & 0xff) as f32 / 255.0,
        (hex & 0xff) as f32 / 255.0,
    ]
}

/// Colours around a heart in a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PictureTheme {
    /// Behind everything.
    pub background: [f32; 3],
    /// Names and numbers.
    pub text: [f32; 3],
    /// Units and notes.
    pub muted: [f32; 3],
    /// Thin lines and frames.
    pub line: [f32; 3],
    /// Faces of the orientation cube.
    pub cube: [f32; 3],
    /// Edges drawn on surfaces.
    pub wireframe: Rgba,
    /// Patches and what is selected.
    pub selection: [f32; 3],
    /// Words about patches: the same hue, as far from the background as text is.
    pub emphasis: [f32; 3],
}

impl PictureTheme {
    /// Whether it is light on dark.
    pub fn is_dark(&self) -> bool {
        self.text.iter().sum::<f32>() > self.background.iter().sum::<f32>()
    }

    /// Light on dark: reading rooms and slides.
    pub const DARK: Self = Self {
        background: srgb(0x1a_1e24),
        text: srgb(0xd7_dce2),
        muted: srgb(0x8a_94a1),
        line: srgb(0x5a_6470),
        cube: srgb(0x2a_3038),
        wireframe: [0.05, 0.06, 0.07, 0.55],
        selection: srgb(0xff_d166),
        emphasis: srgb(0xff_d166),
    };
    /// Light on black: slides and posters.
    pub const BLACK: Self = Self {
        background: srgb(0),
        ..Self::DARK
    };
    /// Dark on white: print.
    pub const LIGHT: Self = Self {
        background: srgb(0xff_ffff),
        text: srgb(0x1d_2530),
        muted: srgb(0x68_727f),
        line: srgb(0x9a_a3ae),
        cube: srgb(0xec_eef1),
        wireframe: [0.1, 0.12, 0.14, 0.45],
        selection: srgb(0xb8_860b),
        emphasis: srgb(0x70_4300),
    };
}
