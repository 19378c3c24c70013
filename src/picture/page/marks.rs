//! What stands on a page, in the order in which it is laid down.

use std::sync::Arc;

use crate::picture::page::fonts::{FigureFonts, Weight};
use crate::render::Picture;

/// One thing on a page. Lengths are in pixels of the page, from its upper left corner; colours are
/// sRGB in `0..=1`.
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A filled shape; where it crosses itself, every second layer is a hole.
    Fill {
        /// Around it.
        corners: Vec<[f32; 2]>,
        /// Of the inside.
        colour: [f32; 3],
        /// 1 hides what is below.
        opacity: f32,
    },
    /// A line through points, with round corners and ends.
    Line {
        /// From first to last.
        points: Vec<[f32; 2]>,
        /// Whether it returns to the first.
        closed: bool,
        /// In pixels.
        width: f32,
        /// Of the line.
        colour: [f32; 3],
        /// 1 hides what is below.
        opacity: f32,
    },
    /// A line of words.
    Text {
        /// What is said.
        words: String,
        /// Thickness of letters.
        weight: Weight,
        /// The em in pixels.
        size: f32,
        /// Where the base line starts.
        at: [f32; 2],
        /// Of the letters.
        colour: [f32; 3],
    },
    /// Pixels stretched over a rectangle.
    Picture {
        /// Upper left corner.
        at: [f32; 2],
        /// Width and height.
        size: [f32; 2],
        /// The pixels.
        picture: Arc<Picture>,
    },
}

/// A page before it is a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Page {
    /// Width and height in pixels.
    pub size: [f32; 2],
    /// Behind everything; `None` leaves it transparent.
    pub background: Option<[f32; 3]>,
    /// From the lowest to the topmost.
    pub marks: Vec<Mark>,
}

impl Page {
    /// An empty page.
    pub fn new(size: [f32; 2], background: Option<[f32; 3]>) -> Self {
        Self {
            size,
            background,
            marks: Vec::new(),
        }
    }

    /// A filled shape.
    pub fn fill(&mut self, corners: &[[f32; 2]], colour: [f32; 3]) {
        self.marks.push(Mark::Fill {
            corners: corners.to_vec(),
            colour,
            opacity: 1.0,
        });
    }

    /// A filled rectangle given by two corners.
    pub fn rectangle(&mut self, low: [f32; 2], high: [f32; 2], colour: [f32; 3]) {
        self.fill(&[low, [high[0], low[1]], high, [low[0], high[1]]], colour);
    }

    /// A line through points.
    pub fn line(&mut self, points: &[[f32; 2]], closed: bool, width: f32, colour: [f32; 3]) {
        self.marks.push(Mark::Line {
            points: points.to_vec(),
            closed,
            width,
            colour,
            opacity: 1.0,
        });
    }

    /// Pixels stretched over a rectangle.
    pub fn picture(&mut self, at: [f32; 2], size: [f32; 2], picture: Arc<Picture>) {
        self.marks.push(Mark::Picture { at, size, picture });
    }
}

/// How a line of words is set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Type {
    /// Thickness of letters.
    pub weight: Weight,
    /// The em in pixels.
    pub size: f32,
    /// Of the letters.
    pub colour: [f32; 3],
}

/// Which part of a line of words stands at its place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Anchor {
    /// Its beginning.
    #[default]
    Start,
    /// Its middle.
    Middle,
    /// Its end.
    End,
}

impl Page {
    /// A line of words whose base line passes through `at`; returns its width in pixels.
    pub fn words(
        &mut self,
        fonts: &FigureFonts,
        words: &str,
        set: Type,
        anchor: Anchor,
        at: [f32; 2],
    ) -> f32 {
        let width = fonts.width(words, set.weight, set.size);
        let back = match anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => 0.5 * width,
            Anchor::End => width,
        };
        if !words.is_empty() {
            self.marks.push(Mark::Text {
                words: words.to_owned(),
                weight: set.weight,
                size: set.size,
                at: [at[0] - back, at[1]],
                colour: set.colour,
            });
        }
        width
    }
}
