//! What is to be drawn, as plain values: no handles of the graphics card.
//!
//! Large arrays are behind `Arc`. The renderer keeps what it uploaded as long as the same `Arc`
//! is drawn, so playing a beat and turning the camera upload nothing: the scene of the next
//! picture holds the same arrays and another [`GeometryPose`].

use std::sync::Arc;

/// A colour as red, green, blue and opacity in `0..=1`, gamma-encoded (sRGB) as on screen.
pub type Rgba = [f32; 4];

/// A surface's shape at every pose it can take.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Geometry {
    /// Three vertex indices per face.
    pub triangles: Vec<[u32; 3]>,
    /// Positions at each pose, one list per pose, all of the same length.
    pub positions: Vec<Vec<[f32; 3]>>,
    /// Unit normals at each pose, in the shape of `positions`.
    pub normals: Vec<Vec<[f32; 3]>>,
}

/// A pose between two given ones: (1 − blend) · from + blend · to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GeometryPose {
    /// Index of a pose.
    pub from: usize,
    /// Index of a pose, often the next.
    pub to: usize,
    /// Share of `to`, in `0..=1`.
    pub blend: f32,
}

/// Numbers on vertices that colours stand for; NaN is shown grey.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VertexScalars {
    /// One list per pose, or a single one for all poses.
    pub values: Vec<Vec<f32>>,
}

/// Which numbers the ends of a colour map stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColourRange {
    /// Value of the first colour.
    pub low: f32,
    /// Value of the last colour.
    pub high: f32,
    /// Whether colours divide the range by ratios instead of differences.
    pub logarithmic: bool,
}

/// Where a surface's colour comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum SurfaceColour {
    /// One colour everywhere.
    Uniform([f32; 3]),
    /// Looked up from numbers.
    Scalars {
        /// The numbers.
        scalars: Arc<VertexScalars>,
        /// Colours from low to high, sRGB, evenly spaced; usually 256.
        map: Arc<[[u8; 3]]>,
        /// Which numbers the ends stand for.
        limits: ColourRange,
        /// Colour of values below the range.
        below: [f32; 3],
        /// Colour of values above the range.
        above: [f32; 3],
    },
}

/// How light falls on faces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shading {
    /// Normals vary over a face.
    #[default]
    Smooth,
    /// One normal per face.
    Flat,
}

/// Edges drawn on a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wireframe {
    /// Colour of the edges.
    pub colour: Rgba,
    /// Width in logical pixels.
    pub width: f32,
}

/// A surface to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Shape at every pose.
    pub geometry: Arc<Geometry>,
    /// Which pose.
    pub pose: GeometryPose,
    /// Where its colour comes from.
    pub colour: SurfaceColour,
    /// 1 is opaque; anything less is blended in the right order from every direction.
    pub opacity: f32,
    /// Smooth or flat.
    pub shading: Shading,
    /// Edges on top, if any.
    pub wireframe: Option<Wireframe>,
    /// Strength of the line where the surface turns away and of the one where it ends, `0..=1`.
    pub silhouette: f32,
    /// Whether a click can hit it.
    pub pickable: bool,
}

/// Line strips with one width and colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Lines {
    /// Each strip's corners.
    pub strips: Arc<Vec<Vec<[f32; 3]>>>,
    /// Colour of all strips.
    pub colour: Rgba,
    /// Width in logical pixels.
    pub width: f32,
}

/// Points drawn as shaded discs.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    /// Centres.
    pub positions: Arc<Vec<[f32; 3]>>,
    /// One colour each, or a single one for all.
    pub colours: Arc<Vec<Rgba>>,
    /// Diameter in logical pixels.
    pub diameter: f32,
}

/// Everything in one picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scene {
    /// Surfaces, opaque and translucent.
    pub surfaces: Vec<Surface>,
    /// Lines.
    pub lines: Vec<Lines>,
    /// Points.
    pub points: Vec<Points>,
    /// What is behind everything; opacity 0 for a transparent picture.
    pub background: Rgba,
}
