//! Turns a plain scene into pixels, in a window or in a picture file; knows nothing of hearts.

mod camera;
mod scene;

pub use camera::Camera;
pub use scene::{
    ColourLimits, Geometry, GeometryPose, Lines, Points, Rgba, Scene, Shading, Surface,
    SurfaceColour, VertexScalars, Wireframe,
};
