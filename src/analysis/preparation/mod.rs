//! Preparation of an image: which walls come of it, by all settings of an import in one value?
//!
//! Begin with [`Preparation`], what somebody sets, and [`prepared()`], what comes of it. In stages: [`stated_image()`] gives the
//! image the distances and times that were typed, [`segmented()`] finds the tissues, [`walls()`] makes the surfaces.
//! [`preview()`] shows at once what a threshold and edits leave. [`facts()`] says what is known of an image, [`proposed()`] which
//! road fits it, and [`asked()`] what somebody must say before it gives walls.

mod asked;
mod error;
mod facts;
mod lids;
mod overrides;
mod preview;
mod proposed;
mod road;
mod segmented;
mod settings;
mod settings_file;
mod stated_image;
#[cfg(test)]
mod tests;
mod tissue_edits;
mod walls;

pub use asked::{Asked, asked};
pub use error::PreparationError;
pub use facts::{ImageFacts, facts};
pub use overrides::Overrides;
pub use preview::{BrightSurface, preview};
pub use proposed::{Proposal, proposed};
pub use road::Road;
pub use segmented::{Segmented, segmented, segmented_masks};
pub use settings::{BaseEnd, Preparation, SettingsError, TypedTimes};
pub use stated_image::stated_image;
pub use walls::{Prepared, prepared, walls};
