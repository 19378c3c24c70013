//! One map of points for poses, deformations and medial poses: places, paths, marks, labels, hover,
//! keyboard and the move from one map to the next. A map supplies its points, words and commands.

mod brush;
mod clusters;
mod data;
mod draw;
mod estimate;
mod figure;
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
mod stress_words;
#[cfg(test)]
mod tests;
mod view;

pub use {data::*, draw::*, input::*, map::*, method::*, orientation::*, path::*, point::*};
pub use {figure::*, respond::*, stress_words::*, view::*};
pub use {lens::bounds, state::without_map_ui};

/// Forgets where on a map the eye, the pointer and the keyboard are: another study has other points there.
pub fn leave_study(ctx: &egui::Context) {
    ctx.data_mut(|data| {
        data.remove_by_type::<lens::Moved>();
        data.remove_by_type::<brush::Brush>();
        data.remove_by_type::<keys::OnKey>();
    });
}
