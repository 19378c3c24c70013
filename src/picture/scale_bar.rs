//! A bar of a round length, so that size can be read off a picture.

use crate::picture::ticks::{nice_floor, tick_text};
use crate::render::Camera;
use crate::units::LengthUnit;

/// A length that is round in the study's unit, and how long it is on the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct ScaleBar {
    /// Length in coordinates.
    pub length: f64,
    /// Length on the picture in pixels, at the depth of the camera's target.
    pub pixels: f32,
    /// `20 mm`.
    pub text: String,
}

impl ScaleBar {
    /// The longest of 1, 2, 5, 10, … units that fits into `max_pixels`, for a picture of
    /// `picture_height` pixels.
    pub fn fitting(
        camera: &Camera,
        picture_height: f32,
        max_pixels: f32,
        unit: LengthUnit,
    ) -> Option<Self> {
        let per_pixel = f64::from(2.0 * camera.half_height / picture_height);
        let most = per_pixel * f64::from(max_pixels);
        let length = nice_floor(most);
        if length <= 0.0 {
            return None;
        }
        let symbol = unit.length_symbol();
        Some(Self {
            length,
            pixels: (length / per_pixel) as f32,
            text: format!("{} {symbol}", tick_text(length, length)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_round_length_that_fits_is_taken() {
        let camera = Camera {
            half_height: 60.0,
            ..Camera::default()
        };
        // 120 mm over 800 pixels: 0.15 mm a pixel.
        for (most, text, pixels) in [
            (150.0, "20 mm", 133.33),
            (133.5, "20 mm", 133.33),
            (133.0, "10 mm", 66.67),
            (400.0, "50 mm", 333.33),
            (6.0, "0.5 mm", 3.33),
        ] {
            let bar = ScaleBar::fitting(&camera, 800.0, most, LengthUnit::Millimetre).unwrap();
            assert_eq!(bar.text, text, "{most}");
            assert!((bar.pixels - pixels).abs() < 0.01, "{most}: {}", bar.pixels);
        }
    }
}
