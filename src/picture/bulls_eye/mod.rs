//! The wall laid flat as plain shapes and numbers: what the bull's-eye of the window and that of figures share.

mod flat_wall;
mod shapes;

pub use flat_wall::{BullsEyeQuantity, FlatValues, FlatWall};
pub use shapes::{
    ink_on, ratio_limits, ratio_share, sector_line, sector_outline, sector_strip, value_text,
};
