//! Edits of label images: what is taken away is no tissue.

use std::sync::Arc;

use super::PreparationError;
use crate::analysis::walls_from_masks::{Masks, Tissue};
use crate::image::{Mask, VolumeEdit, edited};

/// Masks after edits in their order. Components are those of cavity and wall together; holes that are filled become wall.
///
/// # Errors
/// If an edit says no place.
pub(super) fn edited_tissues(
    masks: Masks,
    edits: &[VolumeEdit],
) -> Result<Masks, PreparationError> {
    if edits.is_empty() {
        return Ok(masks);
    }
    let frame = *masks.frame();
    let mut instants = Vec::with_capacity(masks.instants().len());
    for tissues in masks.instants() {
        let is_ventricle = |tissue: &Tissue| matches!(tissue, Tissue::Cavity | Tissue::Wall);
        let inside = tissues.iter().map(is_ventricle).collect();
        let values = match Mask::new(frame.size(), inside) {
            Ok(mask) => mask.values(),
            Err(_) => Vec::new(),
        };
        let values = edited(&values, &frame, edits, 0.5)?;
        let tissue = |(&before, value): (&Tissue, f32)| match (is_ventricle(&before), value > 0.5) {
            (true, false) => Tissue::Other,
            (false, true) => Tissue::Wall,
            _ => before,
        };
        let edited: Arc<[Tissue]> = tissues.iter().zip(values).map(tissue).collect();
        instants.push(edited);
    }
    Ok(Masks::new(frame, instants)?)
}
