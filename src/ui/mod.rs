//! Widgets, theme, marks and number fields: what panes and bars are drawn with, whatever they show.

pub(crate) mod controls;
pub(crate) mod fuzzy;
pub(crate) mod label_marks;
pub(crate) mod marks;
pub(crate) mod named_parts;
pub(crate) mod number_field;
pub(crate) mod pointer_steps;
pub(crate) mod style;
pub(crate) mod text;
pub mod theme;

pub use label_marks::LabelMark;
pub use marks::class_name;
pub use style::{add_faces, apply, install, medium_font};
pub use {controls::*, text::*};
