//! Where is the middle of the wall, and how thick is it there?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.2.

mod beat;
mod connectivity;
mod error;
mod face_tree;
mod length_search;
mod orientation;
mod params;
mod preparation;
mod result;
mod roughness;
mod sheet_ends;
mod smoothing;
mod spheres;
mod surface;
#[cfg(test)]
mod tests;
mod wall_atlas;

pub use beat::medial_beat;
pub use error::MedialError;
pub use params::{CheckedMedialParams, MedialParamError, MedialParams};
pub use result::{Atom, EndSpoke, MedialBeat, MedialSurface};
pub use surface::medial_surface;
