//! The patch figure: a heart, its bull's-eye, its patches in a table, the verdict, and how all of it was made.

mod bulls_eye;
mod content;
mod draw;
mod frame;
mod make;
mod order;

pub use make::rendered_patch_figure;
pub use order::PatchOrder;
