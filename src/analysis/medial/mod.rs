//! Where is the middle of the wall, and how thick is it there?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.2.

mod error;
mod params;
mod result;

pub use error::MedialError;
pub use params::{CheckedMedialParams, MedialParamError, MedialParams};
pub use result::{Atom, EndSpoke, MedialBeat, MedialSurface};
