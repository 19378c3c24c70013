//! What stands on a page, in the order in which it is laid down.

use std::sync::Arc;

use crate::picture::page::faces::FurtherFace;
use crate::picture::page::fonts::FigureFonts;
use crate::picture::page::weight::Weight;
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
    /// A line of words, or a piece of one, in one typeface.
    Text {
        /// What is said.
        words: String,
        /// The typeface; `None` for Inter.
        face: Option<FurtherFace>,
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

impl Mark {
    /// The same, with every length `scale` times as long and its origin at `at`.
    fn placed(&self, at: [f32; 2], scale: f32) -> Self {
        let place = |[x, y]: [f32; 2]| [at[0] + scale * x, at[1] + scale * y];
        let mut mark = self.clone();
        match &mut mark {
            Self::Fill { corners, .. } => {
                corners.iter_mut().for_each(|point| *point = place(*point));
            }
            Self::Line { points, width, .. } => {
                points.iter_mut().for_each(|point| *point = place(*point));
                *width *= scale;
            }
            Self::Text { size, at, .. } => {
                *at = place(*at);
                *size *= scale;
            }
            Self::Picture { at, size, .. } => {
                *at = place(*at);
                *size = size.map(|side| scale * side);
            }
        }
        mark
    }
}

impl Page {
    /// Lays another page onto this one, its upper left corner at `at` and its lengths `scale` times as long.
    pub fn lay(&mut self, page: &Self, at: [f32; 2], scale: f32) {
        if let Some(colour) = page.background {
            let far = [0, 1].map(|axis| at[axis] + scale * page.size[axis]);
            self.rectangle(at, far, colour);
        }
        let marks = page.marks.iter();
        self.marks.extend(marks.map(|mark| mark.placed(at, scale)));
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
        for run in fonts.runs(words, set.weight, set.size) {
            self.marks.push(Mark::Text {
                words: run.words,
                face: run.face,
                weight: set.weight,
                size: set.size,
                at: [at[0] - back + run.x, at[1]],
                colour: set.colour,
            });
        }
        width
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_laid_onto_another_keeps_its_shapes() {
        let mut small = Page::new([100.0, 50.0], Some([1.0; 3]));
        small.rectangle([10.0, 10.0], [20.0, 30.0], [0.0; 3]);
        small.line(&[[0.0, 0.0], [100.0, 50.0]], false, 4.0, [0.0; 3]);
        let mut sheet = Page::new([200.0, 200.0], None);
        sheet.lay(&small, [50.0, 100.0], 0.5);
        let corners = |mark: &Mark| match mark {
            Mark::Fill { corners, .. } => corners.clone(),
            Mark::Line { points, width, .. } => {
                assert_eq!(*width, 2.0);
                points.clone()
            }
            Mark::Text { .. } | Mark::Picture { .. } => Vec::new(),
        };
        assert_eq!(corners(&sheet.marks[0])[2], [100.0, 125.0]);
        assert_eq!(corners(&sheet.marks[1])[0], [55.0, 105.0]);
        assert_eq!(corners(&sheet.marks[2])[1], [100.0, 125.0]);
    }
}
