//! An image with the distances and times that somebody typed.

use super::{Preparation, PreparationError, TypedTimes};
use crate::image::{Image, VolumeFrame};

/// The image with typed distances and times in the place of those of the file; as it is where none were typed. Voxel (0, 0, 0)
/// stays where it is, axes keep their directions, and values are shared.
///
/// Of a typed beat of length T the n volumes begin at 0, T/n, 2T/n, … .
///
/// # Errors
/// If settings are out of range, or there are not as many times as volumes.
pub fn stated_image(image: &Image, preparation: &Preparation) -> Result<Image, PreparationError> {
    preparation.check()?;
    let frame = match preparation.spacing_mm {
        None => *image.frame(),
        Some(spacing) => {
            let directions = image.frame().directions();
            let steps = [0, 1, 2].map(|axis| directions[axis] * spacing[axis]);
            VolumeFrame::new(image.frame().size(), image.frame().origin(), steps)
                .map_err(|error| PreparationError::Typed(error.into()))?
        }
    };
    let instants = image.volumes().len();
    let times = match &preparation.times {
        None => image.times_ms().map(<[f64]>::to_vec),
        Some(TypedTimes::Each(times)) => Some(times.clone()),
        Some(TypedTimes::Cycle(cycle)) => {
            let begin = |instant| cycle * instant as f64 / instants as f64;
            Some((0..instants).map(begin).collect())
        }
    };
    Image::new(frame, image.volumes().to_vec(), times).map_err(PreparationError::Typed)
}
