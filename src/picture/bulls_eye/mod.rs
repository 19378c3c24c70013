//! The wall laid flat as plain shapes and numbers: what the bull's-eye of the window and that of figures share.

mod flat_wall;
mod scale;
mod shapes;

pub use flat_wall::{FlatValues, FlatWall};
pub use scale::{BullsEyeQuantity, BullsEyeScale};
pub use shapes::{ink_on, sector_line, sector_outline, sector_strip};
