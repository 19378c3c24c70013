//! How do meshes whose vertices do not correspond become one mesh that moves?
//!
//! One template is laid onto every frame of every subject, so that all have its vertices and faces: sixteen landmarks are
//! found on each surface, a thin-plate spline brings the template's onto them, and what is still apart is closed by moves
//! to the nearest places of the surface that are smooth over the template. From frame to frame the surface that was found is
//! followed on in the same way. Turning around the long axis (torsion) leaves no mark on a bare surface, so none comes out.
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 3.6.2 (sixteen landmarks, constrained thin-plate spline).

mod axis;
mod carrying;
mod correspond;
mod cut;
mod error;
mod landmarks;
mod params;
mod quality;
mod septum;
mod subject_landmarks;
mod surface_frames;
mod target_surface;
mod targets;
mod template;
mod turned_faces;

pub use correspond::{Corresponding, correspond};
pub use error::{CorrespondenceError, TargetError};
pub use landmarks::{LANDMARK_COUNT, LANDMARK_PLACES, LandmarkPlace, SurfaceLandmarks};
pub use params::{CheckedCorrespondenceParams, CorrespondenceParams};
pub use quality::FrameFit;
pub use subject_landmarks::{SubjectLandmarks, propose_landmarks};
pub use surface_frames::SurfaceFrames;
pub use targets::Targets;
pub use template::Template;

#[cfg(test)]
mod tests;
