//! Which images are looked at, where, and how bright: plain values of the document.

use crate::mesh::Point3;

/// How the images of the study are looked at.
#[derive(Clone, Debug, PartialEq)]
pub struct SliceView {
    /// Index of the images on screen; `None` shows none.
    pub images: Option<usize>,
    /// Which of their series.
    pub series: usize,
    /// Where the three slices cross, in the world of the image (LPS, millimetres); `None` is the middle of the volume.
    pub crosshair: Option<Point3>,
    /// Width and level of the grey values; `None` is what the values themselves suggest.
    pub window: Option<GreyWindow>,
    /// Whether the outlines of the surfaces are drawn over the slices.
    pub outlines: bool,
    /// Whether grey values are blended between voxels.
    pub smooth: bool,
}

impl Default for SliceView {
    fn default() -> Self {
        Self {
            images: None,
            series: 0,
            crosshair: None,
            window: None,
            outlines: true,
            smooth: true,
        }
    }
}

/// Which values are black and which are white: from `level - width / 2` to `level + width / 2`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GreyWindow {
    /// From black to white, above 0.
    pub width: f64,
    /// The value of middle grey.
    pub level: f64,
}

impl GreyWindow {
    /// From the value that is black to the one that is white.
    pub fn between(black: f64, white: f64) -> Self {
        Self {
            // Where all values are equal, any width shows them.
            width: (white - black).max(f64::from(f32::MIN_POSITIVE)),
            level: 0.5 * (black + white),
        }
    }

    /// Whether its numbers can be drawn with.
    pub fn is_usable(self) -> bool {
        self.width.is_finite() && self.level.is_finite() && self.width > 0.0
    }

    /// The grey of a value, black for what is no number.
    pub fn grey(self, value: f32) -> u8 {
        let share = (f64::from(value) - self.level) / self.width + 0.5;
        // `as` takes NaN to 0.
        (255.0 * share.clamp(0.0, 1.0)).round() as u8
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn greys_go_from_black_to_white_and_what_is_no_number_is_black() {
        let window = GreyWindow::between(100.0, 300.0);
        let greys = [50.0, 100.0, 200.0, 300.0, 900.0, f32::NAN].map(|value| window.grey(value));
        assert_eq!(greys, [0, 0, 128, 255, 255, 0]);
        let flat = GreyWindow::between(7.0, 7.0);
        assert!(flat.is_usable() && flat.grey(8.0) == 255);
    }
}
