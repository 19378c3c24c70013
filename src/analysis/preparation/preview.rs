//! What a threshold and edits leave of a volume, shown while they are set.

use super::{Preparation, PreparationError, Road, stated_image};
use crate::analysis::surface_extraction::{isosurface, mask_surface};
use crate::image::{Border, Image, Mask, VolumeFrame, edited, gaussian_blur};
use crate::mesh::TriMesh;
use crate::progress::Progress;

/// One blurred volume, of which surfaces at many thresholds and after many edits are wanted: the blur is most of the work.
#[derive(Clone, Debug)]
pub struct BrightSurface {
    frame: VolumeFrame,
    instant: usize,
    values: Vec<f32>,
    greatest: f32,
}

impl BrightSurface {
    /// Blurs a volume by the distances and the blur of the settings.
    ///
    /// # Errors
    /// If there is no such volume, settings are out of range, or it is stopped.
    pub fn new(
        image: &Image,
        instant: usize,
        preparation: &Preparation,
        progress: &Progress,
    ) -> Result<Self, PreparationError> {
        let stated = stated_image(image, preparation)?;
        let values = volume(&stated, instant)?;
        let frame = *stated.frame();
        let sigma = frame.spacing().map(|mm| preparation.blur_mm / mm);
        let values = gaussian_blur(frame.size(), values, sigma, Border::default(), progress)?;
        let finite = values.iter().copied().filter(|value| value.is_finite());
        Ok(Self {
            frame,
            instant,
            greatest: finite.fold(f32::NEG_INFINITY, f32::max),
            values,
        })
    }

    /// The threshold in the unit of the values: the set share of the greatest one.
    ///
    /// # Errors
    /// If no value lies above 0.
    pub fn threshold(&self, preparation: &Preparation) -> Result<f64, PreparationError> {
        let greatest = f64::from(self.greatest);
        match greatest > 0.0 {
            true => Ok(greatest * preparation.spect_params().threshold),
            false => Err(PreparationError::Dark(self.instant)),
        }
    }

    /// The surface at the threshold after the edits, in the world of the image.
    ///
    /// # Errors
    /// If nothing lies on one side of the threshold, an edit says no place, or it is stopped.
    pub fn surface(
        &self,
        preparation: &Preparation,
        progress: &Progress,
    ) -> Result<TriMesh, PreparationError> {
        let threshold = self.threshold(preparation)?;
        let values = edited(&self.values, &self.frame, &preparation.edits, threshold)?;
        progress.check()?;
        Ok(isosurface(&self.frame, &values, threshold, progress)?)
    }
}

/// The surface that is shown while settings are made: of a label image that of cavity and wall together, else that of what is
/// brighter than the threshold after blur and edits.
///
/// # Errors
/// If there is no such volume, nothing lies on one side of the threshold, a setting is out of range, or it is stopped.
pub fn preview(
    image: &Image,
    instant: usize,
    preparation: &Preparation,
    progress: &Progress,
) -> Result<TriMesh, PreparationError> {
    let Road::Masks(labels) = preparation.road else {
        let bright = BrightSurface::new(image, instant, preparation, progress)?;
        return bright.surface(preparation, progress);
    };
    let stated = stated_image(image, preparation)?;
    let labels = [labels.cavity, labels.wall];
    let size = stated.frame().size();
    let mask = Mask::of_labels(size, volume(&stated, instant)?, &labels).ok();
    let mask = mask.ok_or(PreparationError::Instant {
        instant,
        instants: stated.volumes().len(),
    })?;
    Ok(mask_surface(stated.frame(), &mask, progress)?)
}

/// The values at an instant.
fn volume(image: &Image, instant: usize) -> Result<&[f32], PreparationError> {
    let instants = image.volumes().len();
    let found = image.volumes().get(instant).map(|volume| &**volume);
    found.ok_or(PreparationError::Instant { instant, instants })
}
