//! Turns a plain scene into pixels, in a window or in a picture file; knows nothing of subjects.

mod blit_pass;
mod bounds;
mod cache;
mod camera;
mod camera_moves;
mod drawn;
mod driver_probe;
mod error_scope;
mod frame;
mod identity;
mod line_pass;
mod occlusion_pass;
mod offscreen;
mod packing;
mod pick;
mod pipelines;
mod point_pass;
mod renderer;
mod scene;
mod shaders;
mod surface_pass;
mod targets;
#[cfg(test)]
mod tests;
mod uniforms;
mod uploads;
mod view;
mod whole_picture;

pub use bounds::Bounds;
pub use camera::{Camera, Projected, Ray};
#[cfg(test)]
pub(crate) use offscreen::read_back;
pub use offscreen::{Headless, LARGEST_PICTURE, Picture, RenderError};
pub use pick::{Hit, pick, pick_along};
pub use renderer::{Counters, Renderer, ViewId};
pub use scene::{
    ColourRange, Geometry, GeometryPose, Lines, Points, Rgba, Scene, Shading, Surface,
    SurfaceColour, VertexScalars, Wireframe,
};
pub use uniforms::{Quality, Resolution};
pub use whole_picture::whole_picture_pipeline;
