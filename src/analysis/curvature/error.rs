//! Why the curvature of a surface is not computed.

use crate::progress::Stopped;

use super::rings::RINGS;

/// Why the curvature of a surface is not computed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CurvatureError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// A surroundings of no vertices, or of half a heart.
    #[error("{0} rings of neighbours; {least} to {most} are possible", least = RINGS.start(), most = RINGS.end())]
    Rings(usize),
    /// No triangle.
    #[error("the surface has no faces")]
    NoFaces,
}
