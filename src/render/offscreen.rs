//! Pictures without a window, at any size up to 8192 × 8192.

use super::error_scope::{ErrorScope, finished};
use super::renderer::{Renderer, ViewId};
use super::targets::COLOUR;
use super::uniforms::{Quality, Shot, Tile};
use super::uploads::Gpu;
use super::{Camera, Rgba, Scene};

/// Greatest width and height of a picture, in pixels.
pub const LARGEST_PICTURE: u32 = 8192;
/// Greatest side of a piece drawn at once: its textures need as much as 420 MB with four samples and translucent layers.
const LARGEST_TILE: u32 = 2560;
/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// No driver at all.
    #[error(
        "no graphics adapter found ({0}); without a graphics card install Mesa's software Vulkan driver: \
         `apt install mesa-vulkan-drivers libvulkan1`, `dnf install mesa-vulkan-drivers vulkan-loader` or \
         `pacman -S vulkan-swrast vulkan-icd-loader`"
    )]
    NoAdapter(String),
    /// A driver that gives no device.
    #[error("graphics adapter {adapter} gives no device: {reason}")]
    NoDevice {
        /// Name of the adapter.
        adapter: String,
        /// What the driver said.
        reason: String,
    },
    /// A size that is not supported.
    #[error("a picture of {width} × {height} pixels: both sides must be 1 to {LARGEST_PICTURE}")]
    Size {
        /// Pixels across.
        width: u32,
        /// Pixels down.
        height: u32,
    },
    /// The driver refused a part of it.
    #[error("the graphics adapter could not draw the picture: {0}")]
    Draw(String),
    /// The picture could not be fetched from the card.
    #[error("the picture could not be read back from the graphics adapter: {0}")]
    ReadBack(String),
}

/// A finished picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels across.
    pub width: u32,
    /// Pixels down.
    pub height: u32,
    /// Four bytes a pixel, row by row from the top: sRGB and straight (not premultiplied) opacity.
    pub rgba: Vec<u8>,
}

impl Picture {
    /// Colour and opacity of a pixel; transparent black outside.
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        if x >= self.width || y >= self.height {
            return [0; 4];
        }
        let place = (y as usize * self.width as usize + x as usize) * 4;
        std::array::from_fn(|i| self.rgba[place + i])
    }
}

/// A renderer with a device of its own.
pub struct Headless {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    renderer: Renderer,
    adapter_name: String,
    largest_tile: u32,
}

impl Headless {
    /// Takes the first adapter that can draw, a software one if there is no other.
    ///
    /// # Errors
    /// If there is no adapter (the text says what to install), or it gives no device.
    pub fn new() -> Result<Self, RenderError> {
        Self::of(wgpu::InstanceDescriptor::new_without_display_handle_from_env())
    }

    pub(super) fn of(interfaces: wgpu::InstanceDescriptor) -> Result<Self, RenderError> {
        let instance = wgpu::Instance::new(interfaces);
        let adapter = finished(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
            .map_err(|reason| RenderError::NoAdapter(reason.to_string()))?;
        let info = adapter.get_info();
        let adapter_name = format!("{} ({})", info.name, info.backend);
        let limits = if info.backend == wgpu::Backend::Gl {
            wgpu::Limits::downlevel_webgl2_defaults()
        } else {
            wgpu::Limits::default()
        };
        let descriptor = wgpu::DeviceDescriptor {
            required_limits: limits.using_resolution(adapter.limits()),
            ..wgpu::DeviceDescriptor::default()
        };
        let (device, queue) = finished(adapter.request_device(&descriptor)).map_err(|reason| {
            RenderError::NoDevice {
                adapter: adapter_name.clone(),
                reason: reason.to_string(),
            }
        })?;
        let renderer = Renderer::new(&device, COLOUR);
        let largest_tile = LARGEST_TILE.min(device.limits().max_texture_dimension_2d);
        Ok(Self {
            device,
            queue,
            renderer,
            adapter_name,
            largest_tile,
        })
    }

    /// Name and interface of the adapter, for the status line and reports.
    pub fn adapter_name(&self) -> &str {
        &self.adapter_name
    }

    /// The renderer, for its counters.
    pub fn renderer(&self) -> &Renderer {
        &self.renderer
    }

    /// Draws larger pictures in pieces of at most this side (at least 64 pixels); pieces do not show.
    #[must_use]
    pub fn with_largest_tile(mut self, pixels: u32) -> Self {
        self.largest_tile = pixels.clamp(64, self.device.limits().max_texture_dimension_2d);
        self
    }

    /// Draws a scene; widths in it are multiplied by `pixels_per_point`.
    ///
    /// # Errors
    /// If the size is 0 or beyond [`LARGEST_PICTURE`], or the driver fails.
    pub fn picture(
        &mut self,
        scene: &Scene,
        camera: &Camera,
        width: u32,
        height: u32,
        pixels_per_point: f32,
    ) -> Result<Picture, RenderError> {
        let allowed = 1..=LARGEST_PICTURE;
        if !allowed.contains(&width) || !allowed.contains(&height) {
            return Err(RenderError::Size { width, height });
        }
        let mut picture = Picture {
            width,
            height,
            rgba: vec![0; width as usize * height as usize * 4],
        };
        let whole = [width, height];
        let shot = |tile, occlusion_of| Shot {
            tile,
            quality: Quality::Full,
            pixels_per_point,
            folds: true,
            occlusion_of,
        };
        if whole.iter().all(|&side| side <= self.largest_tile) {
            let rows = self.draw(scene, camera, shot(Tile::all(whole), None))?;
            keep(&mut picture, &rows, Tile::all(whole), scene.background);
            return Ok(picture);
        }
        // Occlusion looks far around each pixel: it is found once for the whole, on a smaller picture.
        let small = smaller(whole, self.largest_tile);
        self.draw(scene, camera, shot(Tile::all(small), None))?;
        self.renderer.keep_occlusion(small);
        for tile in tiles(whole, self.largest_tile) {
            let rows = self.draw(scene, camera, shot(tile, Some(small)))?;
            keep(&mut picture, &rows, tile, scene.background);
        }
        Ok(picture)
    }

    /// Gives the device and queue away, for a renderer driven as a window drives it.
    pub fn into_gpu(self) -> (wgpu::Device, wgpu::Queue) {
        (self.device, self.queue)
    }

    /// Draws one tile and reads it back: premultiplied rows without gaps.
    fn draw(&mut self, scene: &Scene, camera: &Camera, shot: Shot) -> Result<Vec<u8>, RenderError> {
        let error_scope = ErrorScope::begin(&self.device);
        let mut encoder = self
            .device
            .create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let gpu = Gpu {
            device: &self.device,
            queue: &self.queue,
        };
        let view = ViewId::default();
        self.renderer
            .draw(gpu, &mut encoder, view, (scene, camera), shot)
            .map_err(RenderError::Draw)?;
        let Some(texture) = self.renderer.picture(view) else {
            return Err(RenderError::ReadBack("nothing was drawn".into()));
        };
        let texture = texture.clone();
        let rows = read_back(&self.device, &self.queue, encoder, &texture);
        error_scope.end().map_err(RenderError::Draw)?;
        rows
    }

    /// The same with translucent surfaces drawn by these capabilities.
    #[cfg(test)]
    pub(super) fn with_capabilities(mut self, capabilities: super::targets::Capabilities) -> Self {
        self.renderer = self.renderer.with_capabilities(capabilities);
        self
    }
}

/// Submits the work and fetches a texture of four bytes a pixel: rows without gaps.
pub(crate) fn read_back(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    mut encoder: wgpu::CommandEncoder,
    texture: &wgpu::Texture,
) -> Result<Vec<u8>, RenderError> {
    let (width, height) = (texture.width(), texture.height());
    let row = (width * 4).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("read back"),
        size: u64::from(row) * u64::from(height),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    encoder.copy_texture_to_buffer(
        texture.as_image_copy(),
        wgpu::TexelCopyBufferInfo {
            buffer: &buffer,
            layout: wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row),
                rows_per_image: None,
            },
        },
        texture.size(),
    );
    queue.submit([encoder.finish()]);
    read_rows(device, &buffer, row as usize, width as usize * 4)
}

fn read_rows(
    device: &wgpu::Device,
    buffer: &wgpu::Buffer,
    padded_row: usize,
    row: usize,
) -> Result<Vec<u8>, RenderError> {
    let failed = |reason: &dyn std::fmt::Display| RenderError::ReadBack(reason.to_string());
    let (sender, receiver) = std::sync::mpsc::channel();
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        // A receiver that is gone has already given up.
        let _ = sender.send(result);
    });
    device
        .poll(wgpu::PollType::wait_indefinitely())
        .map_err(|error| failed(&error))?;
    receiver
        .recv()
        .map_err(|error| failed(&error))?
        .map_err(|error| failed(&error))?;
    let mapped = buffer
        .get_mapped_range(..)
        .map_err(|error| failed(&error))?;
    Ok(mapped
        .chunks(padded_row)
        .flat_map(|padded| &padded[..row])
        .copied()
        .collect())
}

/// Tiles that cover a picture. They start at even pixels, so that the two-by-two blocks of derivatives fall alike.
fn tiles(whole: [u32; 2], largest: u32) -> Vec<Tile> {
    let step = (largest & !1).max(2);
    let starts = |side: u32| (0..side).step_by(step as usize);
    let mut tiles = Vec::new();
    for y in starts(whole[1]) {
        for x in starts(whole[0]) {
            let first = [x, y];
            let size = [0, 1].map(|axis: usize| step.min(whole[axis] - first[axis]));
            tiles.push(Tile { whole, first, size });
        }
    }
    tiles
}

/// A size of the same shape whose longer side is `largest`.
fn smaller(whole: [u32; 2], largest: u32) -> [u32; 2] {
    let longest = u64::from(whole[0].max(whole[1]));
    whole.map(|side| (u64::from(side) * u64::from(largest) / longest).max(1) as u32)
}

/// Copies a tile into the picture, over the background.
fn keep(picture: &mut Picture, rows: &[u8], tile: Tile, background: Rgba) {
    let row = tile.size[0] as usize * 4;
    for (y, source) in rows.chunks_exact(row).enumerate() {
        let first = (tile.first[1] as usize + y) * picture.width as usize + tile.first[0] as usize;
        let target = &mut picture.rgba[first * 4..first * 4 + row];
        let pixels = target.as_chunks_mut::<4>().0.iter_mut();
        for (target, source) in pixels.zip(source.as_chunks::<4>().0) {
            *target = over_background(*source, background);
        }
    }
}

/// A premultiplied pixel over a background, with straight opacity.
fn over_background(front: [u8; 4], background: Rgba) -> [u8; 4] {
    let front = front.map(|n| f32::from(n) / 255.0);
    let behind = (1.0 - front[3]) * background[3].clamp(0.0, 1.0);
    let opacity = front[3] + behind;
    if opacity <= 0.0 {
        return [0; 4];
    }
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0).round() as u8;
    let part = |i: usize| byte((front[i] + behind * background[i]) / opacity);
    [part(0), part(1), part(2), byte(opacity)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_every_pixel_once_and_are_no_larger_than_allowed() {
        for (whole, largest) in [([301, 77], 64), ([64, 64], 64), ([1000, 1000], 300)] {
            let mut covered = vec![0; (whole[0] * whole[1]) as usize];
            for tile in tiles(whole, largest) {
                assert!(tile.size.iter().all(|&side| side <= largest));
                assert!(tile.first.iter().all(|first| first % 2 == 0));
                let [x0, y0] = tile.first;
                let [x1, y1] = [x0 + tile.size[0], y0 + tile.size[1]];
                for (y, x) in (y0..y1).flat_map(|y| (x0..x1).map(move |x| (y, x))) {
                    covered[(y * whole[0] + x) as usize] += 1;
                }
            }
            assert!(covered.iter().all(|&times| times == 1));
        }
    }

    #[test]
    fn a_translucent_pixel_over_a_transparent_background_keeps_its_own_colour() {
        assert_eq!(
            over_background([64, 32, 0, 128], [0.0; 4]),
            [128, 64, 0, 128]
        );
        assert_eq!(
            over_background([0; 4], [1.0, 0.0, 0.0, 1.0]),
            [255, 0, 0, 255]
        );
        assert_eq!(over_background([0; 4], [1.0, 0.0, 0.0, 0.0]), [0; 4]);
    }
}
