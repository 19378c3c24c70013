//! What all maps share: ground that can be moved and zoomed, its grid, names beside points, whose heart
//! the pointer is on, and what is said while a map is not there.

mod ground;
mod hover;
mod labels;
mod legend;
mod lens;
mod state;

pub use ground::{Ground, ground_ui};
pub use hover::{subject_ui, tooltip_ui};
pub use labels::Labels;
pub use legend::role_counts_ui;
pub use lens::Lens;
pub use state::{MapState, MapWords, over_map_ui, without_map_ui};

use crate::study::LabelRole;

/// How near to a point, in points of the screen, a click counts as on it.
pub const REACH: f32 = 12.0;

/// A subject of a map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapSubject {
    /// Pseudonym.
    pub id: String,
    /// Free text, as the study says it.
    pub label: Option<String>,
    /// What the label counts as.
    pub role: LabelRole,
    /// Ejection fraction as a fraction.
    pub ejection_fraction: Option<f64>,
}
