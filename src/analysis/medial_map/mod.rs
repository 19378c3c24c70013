//! Where do the poses of all subjects lie in the shape space of the medial surface?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.5, 4.5.1, 4.6.2 and figure 4.16.

mod map;
mod paths;
mod placement;
mod result;
#[cfg(test)]
mod tests;

pub use map::medial_map;
pub use paths::subject_paths;
pub use placement::{Frame, Placement};
pub use result::{
    AkineticPart, AkineticPath, MedialMap, MedialMapError, MedialPose, NotMapped, PathStep, Spread,
    SubjectPaths,
};
