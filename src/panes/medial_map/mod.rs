//! The medial map: a point is a step of the beat, as the akinetic region of the wall has it.

mod map;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub(crate) mod view;

pub use map::{
    MEDIAL_MAP, MedialMapView, medial_facts, medial_map_choosers_ui, medial_map_header_ui,
    medial_map_note, medial_map_ui,
};
