//! One map of points for poses, deformations and medial poses: places, paths, marks, labels, hover,
//! keyboard and the move from one map to the next. A map supplies its points, words and commands.

mod brush;
mod clusters;
mod data;
mod draw;
pub(crate) mod from_state;
mod ground;
mod hover;
mod input;
mod keys;
mod labels;
mod legend;
mod lens;
mod map;
mod method;
mod morph;
mod orientation;
mod path;
mod point;
mod respond;
mod state;
#[cfg(test)]
mod tests;
mod view;

pub use data::ScatterData;
pub use draw::{Projection, draw_points};
pub use input::{key_zoom, pointer_zoom, pressed_arrows};
pub use lens::bounds;
pub use map::scatter_map_ui;
pub use method::method_choices_ui;
pub use path::{paths, places_between};
pub use point::{PosePhase, ScatterPoint};
pub use respond::{pointed_at, respond_ui};
pub use state::without_map_ui;
pub use view::{MapState, MapSubject, MapWords, ScatterView, play};
