//! Options of `figure`: what is drawn, from where, how large.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::cli::patch_options::PatchOptions;
use crate::cli::words::{QuantityWord, ThemeWord, ViewWord};
use crate::picture::figure::{FigureBackground, check_figure_size};

/// Options of `figure`.
#[derive(Debug, Args)]
pub struct FigureArgs {
    /// Studies, folders and files, together as one study; the built-in cohort if none is given
    #[arg(value_name = "STUDY")]
    pub study: Vec<PathBuf>,
    /// Id of the subject, as `info` lists it [default: the first]
    #[arg(long, value_name = "ID")]
    pub subject: Option<String>,
    /// Frame, numbered from 0 [default: 0, or end-systole with --patch]
    #[arg(long, value_name = "N")]
    pub frame: Option<usize>,
    /// Patch figure: the subject with its atoms, bull's-eye, table of patches, verdict
    #[arg(long)]
    pub patch: bool,
    /// Quantity shown in colour
    #[arg(long, value_enum, default_value_t = QuantityWord::Tissue)]
    pub colour: QuantityWord,
    /// Limits of the colour scale, LOW,HIGH [default: fixed limits]
    #[arg(long, value_name = "LOW,HIGH", value_parser = limits, allow_hyphen_values = true)]
    pub limits: Option<[f64; 2]>,
    /// File to write; its extension gives the format: .png, .svg or .pdf
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Pixels, from 320x240 to 8192x8192 [default: 1200x900, or 2400x1800 with --patch]
    #[arg(long, value_name = "WxH", value_parser = size)]
    pub size: Option<[u32; 2]>,
    /// What stands behind it; white and black bring their own colours of words
    #[arg(long, value_enum, default_value_t = BackgroundWord::Theme)]
    pub background: BackgroundWord,
    /// The same as --background transparent
    #[arg(long, conflicts_with = "background")]
    pub transparent: bool,
    /// Light for print, dark for slides
    #[arg(long, value_enum, default_value_t = ThemeWord::Light)]
    pub theme: ThemeWord,
    /// Viewing direction; anatomical directions need a known orientation
    #[arg(long, value_enum)]
    pub view: Option<ViewWord>,
    /// Draw edges
    #[arg(long)]
    pub wireframe: bool,
    /// How the wall is assessed.
    #[command(flatten)]
    pub patches: PatchOptions,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Words of `--background`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BackgroundWord {
    /// That of the theme
    Theme,
    /// White
    White,
    /// Black
    Black,
    /// Nothing
    Transparent,
}

impl FigureArgs {
    /// What stands behind the figure.
    pub fn ground(&self) -> FigureBackground {
        match self.background {
            _ if self.transparent => FigureBackground::Transparent,
            BackgroundWord::Theme => FigureBackground::Theme,
            BackgroundWord::White => FigureBackground::White,
            BackgroundWord::Black => FigureBackground::Black,
            BackgroundWord::Transparent => FigureBackground::Transparent,
        }
    }
}

fn size(text: &str) -> Result<[u32; 2], String> {
    let sides: Option<Vec<u32>> = text
        .split(['x', '×'])
        .map(|side| side.parse().ok())
        .collect();
    match sides.as_deref() {
        Some(&[width, height]) if check_figure_size([width, height], false).is_ok() => {
            Ok([width, height])
        }
        _ => Err("two numbers as in 1200x900, from 320x240 to 8192x8192".to_owned()),
    }
}

fn limits(text: &str) -> Result<[f64; 2], String> {
    let ends: Option<Vec<f64>> = text.split(',').map(|end| end.trim().parse().ok()).collect();
    match ends.as_deref() {
        Some(&[low, high]) if low.is_finite() && high.is_finite() && low < high => Ok([low, high]),
        _ => Err("two numbers as in 0,20, the lower one first".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_and_limits_are_checked_where_they_are_read() {
        assert_eq!(size("640x480"), Ok([640, 480]));
        for wrong in ["640", "100x100", "9000x100", "axb", "1x2x3"] {
            assert!(size(wrong).is_err(), "{wrong}");
        }
        assert_eq!(limits("-1.5, 2"), Ok([-1.5, 2.0]));
        for wrong in ["1", "2,1", "0,NaN", "a,b"] {
            assert!(limits(wrong).is_err(), "{wrong}");
        }
    }
}
