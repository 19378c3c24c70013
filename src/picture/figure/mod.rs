//! Figures for papers and reports: a heart, or its abnormal patch, with everything that is needed to read it.

mod content;
mod cube;
mod layout;
mod look;
mod make;
mod patch;
mod pen;
mod plan;
mod saved_view;

pub use content::{FigureContent, FigureSubject};
pub(in crate::picture) use layout::imprint;
pub use look::{FigureBackground, FigureLook, FigureSizeError, FigureTheme, check_figure_size};
pub use make::{Figure, FigureOrder, FigureView, rendered_figure};
pub(in crate::picture) use patch::draw_bulls_eye;
pub use patch::{BullsEyeContent, PatchOrder, rendered_patch_figure};
pub(in crate::picture) use pen::Pen;
pub use saved_view::{SavedCamera, SavedShows, SavedSubject, SavedView, SavedViewError};

/// Smallest width and height of a figure in pixels: below, its text would not be legible.
pub const MIN_SIZE: [u32; 2] = [320, 240];
/// Smallest width and height of a patch figure in pixels.
pub const MIN_PATCH_SIZE: [u32; 2] = [800, 600];
/// Greatest width and height of a figure in pixels.
pub const MAX_SIZE: u32 = 8192;
