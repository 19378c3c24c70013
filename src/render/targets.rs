//! The pictures that passes draw into: four samples a pixel, depth from 1 (near) to 0 (far).

use super::uniforms::Tile;

/// How translucent surfaces are drawn, by what the device can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Capabilities {
    /// Layer by layer, which reads the samples of depths; with occlusion.
    Peeled,
    /// Whole, without occlusion: for OpenGL before 4.0, OpenGL ES before 3.2.
    Plain,
}

/// Samples a pixel. WebGPU promises 4 for all formats used here.
pub(super) const SAMPLES: u32 = 4;
/// Premultiplied, gamma-encoded.
pub(super) const COLOUR: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Reverse-Z keeps its precision at all distances.
pub(super) const DEPTH: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// Bits of a distance with occlusion in the lowest eight (occlusion_texel.wgsl): unlike pairs of floats,
/// whole numbers can be drawn into on OpenGL too.
pub(super) const OCCLUSION: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;

/// Textures needed only while a picture is drawn; views of the same size share them.
pub(super) struct Scratch {
    pub size: [u32; 2],
    pub colour: wgpu::TextureView,
    pub depth: wgpu::TextureView,
    pub occlusion: [wgpu::TextureView; 2],
    layers: Option<[wgpu::TextureView; 2]>,
    pub last_used: u64,
}

impl Scratch {
    pub fn new(device: &wgpu::Device, size: [u32; 2], capabilities: Capabilities) -> Self {
        let half = size.map(|n| n.div_ceil(2));
        let occlusion = || target(device, half, OCCLUSION, 1);
        Self {
            size,
            colour: unread_target(device, size, COLOUR, SAMPLES),
            depth: match capabilities {
                Capabilities::Peeled => target(device, size, DEPTH, SAMPLES),
                Capabilities::Plain => unread_target(device, size, DEPTH, SAMPLES),
            },
            occlusion: [occlusion(), occlusion()],
            layers: None,
            last_used: 0,
        }
    }

    /// Depths of the layer being taken and the one before, made when a first translucent thing appears.
    pub fn layers(&mut self, device: &wgpu::Device) -> [wgpu::TextureView; 2] {
        let size = self.size;
        self.layers
            .get_or_insert_with(|| [0; 2].map(|_| target(device, size, DEPTH, SAMPLES)))
            .clone()
    }
}

/// Depths of a picture that another follows.
pub(super) fn moving_depth(device: &wgpu::Device, size: [u32; 2]) -> wgpu::TextureView {
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
    texture(device, size, DEPTH, 1, usage).create_view(&wgpu::TextureViewDescriptor::default())
}

/// A finished picture without its background.
pub(super) struct Resolved {
    pub texture: wgpu::Texture,
    pub view: wgpu::TextureView,
    pub size: [u32; 2],
}

impl Resolved {
    pub fn new(device: &wgpu::Device, tile: Tile) -> Self {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT
            | wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_SRC;
        let texture = texture(device, tile.size, COLOUR, 1, usage);
        Self {
            view: texture.create_view(&wgpu::TextureViewDescriptor::default()),
            texture,
            size: tile.size,
        }
    }
}

/// What stands for a window in tests.
#[cfg(test)]
pub(super) fn window(
    device: &wgpu::Device,
    size: [u32; 2],
    format: wgpu::TextureFormat,
) -> wgpu::Texture {
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
    texture(device, size, format, 1, usage)
}

fn target(
    device: &wgpu::Device,
    size: [u32; 2],
    format: wgpu::TextureFormat,
    samples: u32,
) -> wgpu::TextureView {
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
    texture(device, size, format, samples, usage)
        .create_view(&wgpu::TextureViewDescriptor::default())
}

fn unread_target(
    device: &wgpu::Device,
    size: [u32; 2],
    format: wgpu::TextureFormat,
    samples: u32,
) -> wgpu::TextureView {
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
    texture(device, size, format, samples, usage)
        .create_view(&wgpu::TextureViewDescriptor::default())
}

fn texture(
    device: &wgpu::Device,
    [width, height]: [u32; 2],
    format: wgpu::TextureFormat,
    sample_count: u32,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}
