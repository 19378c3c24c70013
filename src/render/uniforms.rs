//! What the shaders are told, in the layout of their structs.

use bytemuck::{Pod, Zeroable};

use super::uploads::{GeometryUpload, ScalarsUpload};
use super::{Camera, Rgba, Shading, Surface, SurfaceColour};

/// Draw uniforms lie this far apart: the largest alignment that WebGPU allows a device to ask for.
pub(super) const UNIFORM_STRIDE: u64 = 256;

/// The part of a whole picture that a target holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tile {
    /// Size of the whole picture in pixels.
    pub whole: [u32; 2],
    /// First pixel of the tile in it.
    pub first: [u32; 2],
    /// Size of the tile.
    pub size: [u32; 2],
}

impl Tile {
    /// A picture in one piece.
    pub fn all(size: [u32; 2]) -> Self {
        Self {
            whole: size,
            first: [0, 0],
            size,
        }
    }
}

/// How much is done for a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Quality {
    /// Four samples a pixel, occlusion, translucency exact layer by layer.
    #[default]
    Full,
    /// For pictures that another follows at once: one sample a pixel, plain light, translucent surfaces laid over what
    /// is opaque in one pass.
    Moving,
}

/// How large and how well a picture is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolution {
    /// Width and height of the picture.
    pub pixels: [u32; 2],
    /// Widths in the scene are multiplied by this.
    pub pixels_per_point: f32,
    /// What is done for it.
    pub quality: Quality,
}

impl Resolution {
    /// As well as it can be.
    pub fn full(pixels: [u32; 2], pixels_per_point: f32) -> Self {
        Self {
            pixels,
            pixels_per_point,
            quality: Quality::Full,
        }
    }

    /// The same view with fewer pixels, `scale` (0 to 1) of them along each side, for a picture that another follows.
    pub fn moving(self, scale: f32) -> Self {
        Self {
            pixels: self
                .pixels
                .map(|n| ((n as f32 * scale).round() as u32).max(1)),
            pixels_per_point: self.pixels_per_point * scale,
            quality: Quality::Moving,
        }
    }
}

/// What is taken of a scene: which part, how dense, and where its occlusion comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Shot {
    pub tile: Tile,
    pub quality: Quality,
    /// Physical pixels per logical pixel.
    pub pixels_per_point: f32,
    /// Whether a layer more than usual is taken of translucent surfaces, for folds.
    pub folds: bool,
    /// Size of the smaller picture of the whole whose occlusion is used; `None` to find it anew for this tile.
    pub occlusion_of: Option<[u32; 2]>,
}

impl Shot {
    /// Occlusion texels per pixel, and the place of the first texel. A texel stands for the first of two pixels,
    /// whose middle is at 0.5.
    fn occlusion_place(&self) -> [f32; 4] {
        match self.occlusion_of {
            None => {
                let [x, y] = self.tile.first.map(|n| n as f32 + 0.5);
                [0.5, 0.5, x, y]
            }
            Some(small) => {
                let scale = |axis: usize| small[axis] as f32 / self.tile.whole[axis] as f32;
                let (x, y) = (scale(0), scale(1));
                [0.5 * x, 0.5 * y, 0.5 / x, 0.5 / y]
            }
        }
    }
}

/// `struct View` of common.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct ViewUniform {
    rotation: [[f32; 4]; 4],
    target: [f32; 4],
    projection: [f32; 4],
    crop: [f32; 4],
    size: [f32; 4],
    options: [f32; 4],
    occlusion: [f32; 4],
}

impl ViewUniform {
    pub fn new(camera: &Camera, shot: Shot, occlusion_reach: f32, background: Rgba) -> Self {
        let tile = shot.tile;
        let [width, height] = tile.whole.map(|n| n as f32);
        let (scale, depth) = camera.lens(width / height);
        let parallel = f32::from(u8::from(camera.is_parallel()));
        // In −1..=1 the tile's middle moves to 0 and its half size becomes 1.
        let part = |axis: usize, whole: f32, downwards: f32| {
            let size = tile.size[axis] as f32;
            let middle = (tile.first[axis] as f32 + 0.5 * size) / whole * 2.0 - 1.0;
            (whole / size, -middle * downwards * whole / size)
        };
        let (scale_x, shift_x) = part(0, width, 1.0);
        let (scale_y, shift_y) = part(1, height, -1.0);
        Self {
            rotation: glam::Mat4::from_quat(camera.world_from_camera.inverse()).to_cols_array_2d(),
            target: camera.target.extend(camera.eye_distance()).into(),
            projection: [scale.x, scale.y, depth, parallel],
            crop: [scale_x, scale_y, shift_x, shift_y],
            size: [width, height, tile.first[0] as f32, tile.first[1] as f32],
            options: [
                shot.pixels_per_point,
                occlusion_reach,
                f32::from(u8::from(occlusion_reach > 0.0)),
                f32::from(u8::from(is_dark(background))),
            ],
            occlusion: shot.occlusion_place(),
        }
    }
}

/// Whether light edges stand out better than dark ones; a transparent background counts as light, as paper is.
fn is_dark([r, g, b, a]: Rgba) -> bool {
    // Luma of Rec. 709 on encoded values, against mid grey.
    a > 0.5 && 0.2126 * r + 0.7152 * g + 0.0722 * b < 0.5
}

/// `struct Surface` of surface.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct SurfaceUniform {
    colour: [f32; 4],
    below: [f32; 4],
    above: [f32; 4],
    wire: [f32; 4],
    limits: [f32; 4],
    options: [f32; 4],
    texels: [u32; 4],
    scalar_texels: [u32; 4],
}

impl SurfaceUniform {
    pub fn new(
        surface: &Surface,
        geometry: &GeometryUpload,
        scalars: Option<&ScalarsUpload>,
        map_length: u32,
    ) -> Self {
        let mut uniform = Self::zeroed();
        let first = |pose: usize, count: u32, vertices: u32| {
            (pose as u32).min(count.saturating_sub(1)) * vertices
        };
        uniform.colour = [0.5, 0.5, 0.5, surface.opacity.clamp(0.0, 1.0)];
        match &surface.colour {
            SurfaceColour::Uniform([r, g, b]) => uniform.colour[..3].copy_from_slice(&[*r, *g, *b]),
            SurfaceColour::Scalars {
                limits,
                below,
                above,
                ..
            } => {
                uniform.below[..3].copy_from_slice(below);
                uniform.above[..3].copy_from_slice(above);
                let logarithmic = limits.logarithmic && limits.low > 0.0;
                uniform.limits = [
                    limits.low,
                    limits.high,
                    f32::from(u8::from(logarithmic)),
                    0.0,
                ];
            }
        }
        if let Some((scalars, texels)) = scalars.and_then(|s| Some((s, s.texels.as_ref()?)))
            && scalars.vertex_count >= geometry.vertex_count
            && map_length > 0
        {
            let at = |pose| first(pose, scalars.pose_count, scalars.vertex_count);
            uniform.scalar_texels = [at(surface.pose.from), at(surface.pose.to), texels.width, 0];
            uniform.limits[3] = 1.0;
        }
        let wire = surface.wireframe.map_or([0.0; 4], |wire| wire.colour);
        uniform.wire = wire;
        let blend = surface.pose.blend;
        uniform.options = [
            surface.wireframe.map_or(0.0, |wire| wire.width.max(0.0)),
            surface.silhouette.clamp(0.0, 1.0),
            f32::from(u8::from(surface.shading == Shading::Flat)),
            if blend.is_finite() {
                blend.clamp(0.0, 1.0)
            } else {
                0.0
            },
        ];
        let at = |pose| first(pose, geometry.pose_count, geometry.vertex_count);
        let width = geometry.shape.as_ref().map_or(1, |shape| shape.width);
        uniform.texels = [
            at(surface.pose.from),
            at(surface.pose.to),
            width,
            map_length,
        ];
        uniform
    }
}

/// `struct Lines` of lines.wgsl and `struct Points` of points.wgsl: one colour and some options.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct MarkUniform {
    pub first: [f32; 4],
    pub second: [f32; 4],
}

/// `struct Blit` of blit.wgsl.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
pub(super) struct BlitUniform {
    pub background: [f32; 4],
    pub options: [f32; 4],
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tiles_of_a_picture_show_what_the_whole_shows() {
        let camera = Camera::default();
        let tile = Tile {
            whole: [100, 60],
            first: [40, 20],
            size: [20, 30],
        };
        let shot = Shot {
            tile,
            quality: Quality::Full,
            pixels_per_point: 1.0,
            folds: true,
            occlusion_of: None,
        };
        let view = ViewUniform::new(&camera, shot, 0.0, [1.0; 4]);
        // Pixel (45, 41) of the whole is pixel (5, 21) of the tile.
        let whole = [45.0 / 50.0 - 1.0, 1.0 - 41.0 / 30.0];
        let part = [5.0 / 10.0 - 1.0, 1.0 - 21.0 / 15.0];
        for axis in 0..2 {
            let cropped = whole[axis] * view.crop[axis] + view.crop[axis + 2];
            assert!((cropped - part[axis]).abs() < 1e-5);
        }
    }
}
