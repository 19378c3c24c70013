//! What a user chooses of how figures look: size, background, theme.

use serde::{Deserialize, Serialize};

use crate::picture::figure::{MAX_SIZE, MIN_PATCH_SIZE, MIN_SIZE};
use crate::picture::tokens::PictureTheme;

/// What stands behind a figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FigureBackground {
    /// The background of the theme.
    #[default]
    Theme,
    /// White, with dark words.
    White,
    /// Black, with light words.
    Black,
    /// Nothing; words have the colours of the theme.
    Transparent,
}

/// Which colours the words and marks of a figure have.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FigureTheme {
    /// Those of the window.
    #[default]
    Window,
    /// Dark on white, for print.
    Light,
    /// Light on dark, for slides.
    Dark,
}

/// How figures look; remembered from one to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct FigureLook {
    /// Pixels across and down; `None` for the usual size of its kind.
    pub size: Option<[u32; 2]>,
    /// Behind everything.
    pub background: FigureBackground,
    /// Of words and marks.
    pub theme: FigureTheme,
}

/// A size that no figure has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{width} × {height} pixels: a figure needs {min_width} × {min_height} to {MAX_SIZE} × {MAX_SIZE}"
)]
pub struct FigureSizeError {
    width: u32,
    height: u32,
    min_width: u32,
    min_height: u32,
}

/// Whether a figure, or a patch figure, may have this size.
///
/// # Errors
/// If a side is too small for its text or larger than can be drawn.
pub fn check_figure_size(size: [u32; 2], patch: bool) -> Result<(), FigureSizeError> {
    let least = if patch { MIN_PATCH_SIZE } else { MIN_SIZE };
    let fits = |axis: usize| (least[axis]..=MAX_SIZE).contains(&size[axis]);
    if fits(0) && fits(1) {
        return Ok(());
    }
    Err(FigureSizeError {
        width: size[0],
        height: size[1],
        min_width: least[0],
        min_height: least[1],
    })
}

impl FigureBackground {
    /// All, in the order of menus.
    pub const ALL: [Self; 4] = [Self::Theme, Self::White, Self::Black, Self::Transparent];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Theme => "As the theme",
            Self::White => "White",
            Self::Black => "Black",
            Self::Transparent => "Transparent",
        }
    }

    /// The colours of a figure of a dark or light theme, and whether nothing stands behind it. White and black have
    /// colours of their own: words stand out from what is behind them in any combination.
    pub fn colours(self, dark: bool) -> (PictureTheme, bool) {
        let theme = if dark {
            PictureTheme::DARK
        } else {
            PictureTheme::LIGHT
        };
        match self {
            Self::Theme => (theme, false),
            Self::Transparent => (theme, true),
            Self::White => (PictureTheme::LIGHT, false),
            Self::Black => (PictureTheme::BLACK, false),
        }
    }
}

impl FigureTheme {
    /// All, in the order of menus.
    pub const ALL: [Self; 3] = [Self::Window, Self::Light, Self::Dark];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Window => "As the window",
            Self::Light => "Light",
            Self::Dark => "Dark",
        }
    }
}

impl FigureLook {
    /// The colours of a figure asked for in a dark or light window, and whether nothing stands behind it.
    pub fn colours(&self, dark_window: bool) -> (PictureTheme, bool) {
        self.background.colours(match self.theme {
            FigureTheme::Window => dark_window,
            FigureTheme::Light => false,
            FigureTheme::Dark => true,
        })
    }

    /// The same without a size that no figure has, which a settings file may hold.
    #[must_use]
    pub fn usable(self) -> Self {
        let size = self.size;
        Self {
            size: size.filter(|size| check_figure_size(*size, false).is_ok()),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Contrast as WCAG 2.1 defines it.
    fn contrast(a: [f32; 3], b: [f32; 3]) -> f32 {
        let luminance = |colour: [f32; 3]| {
            let part = |share: f32| {
                if share <= 0.03928 {
                    share / 12.92
                } else {
                    ((share + 0.055) / 1.055).powf(2.4)
                }
            };
            0.2126 * part(colour[0]) + 0.7152 * part(colour[1]) + 0.0722 * part(colour[2])
        };
        let (a, b) = (luminance(a), luminance(b));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    #[test]
    fn words_stand_out_from_every_background_in_every_theme() {
        for background in FigureBackground::ALL {
            for dark in [false, true] {
                let (theme, transparent) = background.colours(dark);
                assert_eq!(transparent, background == FigureBackground::Transparent);
                let behind = [theme.background, theme.cube, theme.cube.map(|c| 0.75 * c)];
                for (index, ground) in behind.into_iter().enumerate() {
                    // On the cube stand letters in the colour of text.
                    let words = [theme.text, theme.muted, theme.emphasis];
                    for words in &words[..if index == 0 { 3 } else { 1 }] {
                        let found = contrast(*words, ground);
                        assert!(found >= 4.5, "{background:?}, dark {dark}: {found}");
                    }
                }
            }
        }
        assert_eq!(FigureBackground::White.colours(true).0.background, [1.0; 3]);
        assert_eq!(
            FigureBackground::Black.colours(false).0.background,
            [0.0; 3]
        );
    }

    #[test]
    fn sizes_are_limited_before_anything_is_drawn() {
        assert_eq!(check_figure_size([320, 240], false), Ok(()));
        assert_eq!(check_figure_size([8192, 8192], true), Ok(()));
        for (wrong, patch) in [
            ([319, 240], false),
            ([8193, 800], false),
            ([640, 480], true),
        ] {
            let refused = check_figure_size(wrong, patch).unwrap_err().to_string();
            assert!(refused.contains("a figure needs"), "{refused}");
        }
        let huge = FigureLook {
            size: Some([1_000_000, 9]),
            ..FigureLook::default()
        };
        assert_eq!(huge.usable().size, None);
    }
}
