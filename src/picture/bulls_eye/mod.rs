//! The bull's-eye of the window and of figures: polar map, colour scale, shapes.

mod patches;
mod polar_map;
mod scale;
mod shapes;

pub use patches::PolarPatch;
pub use polar_map::{PolarMap, PolarValues};
pub use scale::{BullsEyeQuantity, BullsEyeScale};
pub use shapes::{ink_on, sector_line, sector_outline, sector_strip};
