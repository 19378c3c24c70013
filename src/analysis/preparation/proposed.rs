//! Which road fits an image.

use super::{ImageFacts, Preparation, Road};
use crate::analysis::walls_from_masks::MaskLabels;
use crate::image::Modality;

/// A road for an image, with its settings by default.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    /// The settings.
    pub preparation: Preparation,
    /// Why this road, or why none fits.
    pub reason: String,
    /// Whether a heart can be expected in the image at all; if not, the road is the least wrong one.
    pub suitable: bool,
}

/// Slices that are farther apart than this times their pixels are a stack of cine MR: 5 to 18 mm beside 1 to 2. Voxels of SPECT
/// are cubes.
const STACK: f64 = 2.0;
/// Most voxels along an edge of SPECT.
const SPECT_EDGE: usize = 128;
/// Most volumes of a gated study of SPECT.
const SPECT_GATES: usize = 32;

/// The road that fits what is known of an image, and why.
pub fn proposed(facts: &ImageFacts) -> Proposal {
    let (road, suitable, reason) = road(facts);
    Proposal {
        preparation: Preparation::of_road(road),
        reason,
        suitable,
    }
}

fn road(facts: &ImageFacts) -> (Road, bool, String) {
    let labels = MaskLabels::default();
    if facts.contours > 0 {
        return (
            Road::Contours,
            true,
            format!("{} outlines lie beside the image", facts.contours),
        );
    }
    // What a camera or scanner made is no label image, however few its values are.
    let machine = !matches!(
        facts.modality,
        None | Some(Modality::Segmentation | Modality::Other)
    );
    if let Some(found) = facts.labels.as_ref().filter(|_| !machine) {
        let listed = found.iter().map(i32::to_string).collect::<Vec<_>>();
        let known = found.contains(&labels.cavity) && found.contains(&labels.wall);
        let reason = format!("its values are labels ({})", listed.join(", "));
        return (Road::Masks(labels), known, reason);
    }
    if facts.size.contains(&1) {
        let reason = "one slice is no ventricle".to_owned();
        return (likely(facts), false, reason);
    }
    match facts.modality {
        Some(kind @ (Modality::NuclearMedicine | Modality::PositronEmission)) => {
            let reason = format!("{} is perfusion: the wall is bright", kind.letters());
            (Road::Spect, true, reason)
        }
        Some(kind @ (Modality::MagneticResonance | Modality::ComputedTomography)) => {
            let reason = format!("{}: blood is bright", kind.letters());
            (Road::Cine, true, reason)
        }
        Some(kind) => {
            let reason = format!("no way leads from {} to walls", kind.letters());
            (likely(facts), false, reason)
        }
        None => {
            let road = likely(facts);
            let reason = match road {
                Road::Spect => "voxels are few and cubes, as in SPECT; the file names no machine",
                _ => "slices are far apart, or many, as in cine MR; the file names no machine",
            };
            (road, true, reason.to_owned())
        }
    }
}

/// What an image is by its grid alone.
fn likely(facts: &ImageFacts) -> Road {
    let [i, j, k] = facts.spacing_mm;
    let [least, most] = [i.min(j).min(k), i.max(j).max(k)];
    let few = facts.size.iter().all(|&n| n <= SPECT_EDGE) && facts.instants <= SPECT_GATES;
    match few && most <= STACK * least {
        true => Road::Spect,
        false => Road::Cine,
    }
}
