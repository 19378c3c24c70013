//! What lies on the graphics card: every array once, shared by all views and poses.
//!
//! Positions and numbers are textures, not storage buffers, because OpenGL with the limits that the window asks for has none.

use std::sync::Arc;

use super::cache::Cache;
use super::packing::{rim_edges, scalar_texels, shape_texels, sound_triangles, vertex_count};
use super::{Bounds, Geometry, Lines, Points, Rgba, VertexScalars};

/// Texels in rows.
pub(super) struct Texels {
    pub view: wgpu::TextureView,
    pub width: u32,
}

/// A geometry on the card.
pub(super) struct GeometryUpload {
    /// All poses; `None` if there is nothing to draw.
    pub shape: Option<Texels>,
    /// Read as indices, or corner by corner when edges are drawn.
    pub indices: Option<wgpu::Buffer>,
    pub index_count: u32,
    pub vertex_count: u32,
    pub pose_count: u32,
    pub bounds: Option<Bounds>,
    /// Edges where the surface ends.
    pub rim: InstancesUpload,
}

/// Numbers on the card.
pub(super) struct ScalarsUpload {
    pub texels: Option<Texels>,
    pub vertex_count: u32,
    pub pose_count: u32,
}

/// A buffer drawn once per instance.
pub(super) struct InstancesUpload {
    pub buffer: Option<wgpu::Buffer>,
    pub count: u32,
    /// Whether a colour among them is translucent.
    pub translucent: bool,
}

/// Everything uploaded.
#[derive(Default)]
pub(super) struct Uploads {
    geometries: Cache<Geometry, GeometryUpload>,
    scalars: Cache<VertexScalars, ScalarsUpload>,
    maps: Cache<[[u8; 3]], Option<Texels>>,
    strips: Cache<Vec<Vec<[f32; 3]>>, InstancesUpload>,
    centres: Cache<Vec<[f32; 3]>, InstancesUpload>,
    colours: Cache<Vec<Rgba>, InstancesUpload>,
    /// Arrays sent to the card so far.
    pub count: u64,
    /// Redraws so far: the clock by which unused uploads age.
    pub now: u64,
}

/// The device and its queue.
#[derive(Clone, Copy)]
pub(super) struct Gpu<'a> {
    pub device: &'a wgpu::Device,
    pub queue: &'a wgpu::Queue,
}

impl Uploads {
    /// Lets go of everything.
    pub fn forget(&mut self) {
        *self = Self {
            count: self.count,
            ..Self::default()
        };
    }

    pub fn geometry(&mut self, gpu: Gpu<'_>, geometry: &Arc<Geometry>) -> Arc<GeometryUpload> {
        let count = &mut self.count;
        self.geometries.get(geometry, self.now, |geometry| {
            *count += 1;
            upload_geometry(gpu, geometry)
        })
    }

    pub fn scalars(&mut self, gpu: Gpu<'_>, scalars: &Arc<VertexScalars>) -> Arc<ScalarsUpload> {
        let count = &mut self.count;
        self.scalars.get(scalars, self.now, |scalars| {
            *count += 1;
            let (texels, vertex_count) = scalar_texels(scalars);
            ScalarsUpload {
                texels: texture(gpu, &texels, wgpu::TextureFormat::R32Uint),
                vertex_count: vertex_count as u32,
                pose_count: scalars.values.len() as u32,
            }
        })
    }

    pub fn map(&mut self, gpu: Gpu<'_>, map: &Arc<[[u8; 3]]>) -> Arc<Option<Texels>> {
        let count = &mut self.count;
        self.maps.get(map, self.now, |map| {
            *count += 1;
            // One row: the shader reads colours by their number.
            let most = gpu.device.limits().max_texture_dimension_2d as usize;
            let row: Vec<[u8; 4]> = map[..map.len().min(most)]
                .iter()
                .map(|&[r, g, b]| [r, g, b, 255])
                .collect();
            let width = row.len() as u32;
            texture_of_width(gpu, &row, wgpu::TextureFormat::Rgba8Unorm, width)
        })
    }

    pub fn lines(&mut self, gpu: Gpu<'_>, lines: &Lines) -> Arc<InstancesUpload> {
        let count = &mut self.count;
        self.strips.get(&lines.strips, self.now, |strips| {
            *count += 1;
            let segments: Vec<[[f32; 3]; 2]> = strips
                .iter()
                .flat_map(|strip| strip.windows(2).map(|ends| [ends[0], ends[1]]))
                .collect();
            instances(gpu, &segments, false)
        })
    }

    pub fn centres(&mut self, gpu: Gpu<'_>, points: &Points) -> Arc<InstancesUpload> {
        let count = &mut self.count;
        self.centres.get(&points.positions, self.now, |positions| {
            *count += 1;
            // Four numbers each, so that the same buffer can stand in for colours that are not there.
            let padded: Vec<[f32; 4]> = positions.iter().map(|&[x, y, z]| [x, y, z, 1.0]).collect();
            instances(gpu, &padded, false)
        })
    }

    pub fn colours(&mut self, gpu: Gpu<'_>, points: &Points) -> Arc<InstancesUpload> {
        let count = &mut self.count;
        self.colours.get(&points.colours, self.now, |colours| {
            *count += 1;
            instances(gpu, colours, colours.iter().any(|colour| colour[3] < 1.0))
        })
    }

    /// Ends a redraw: ages what was not used.
    pub fn evict(&mut self) {
        self.now += 1;
        self.geometries.evict(self.now);
        self.scalars.evict(self.now);
        self.maps.evict(self.now);
        self.strips.evict(self.now);
        self.centres.evict(self.now);
        self.colours.evict(self.now);
    }
}

fn upload_geometry(gpu: Gpu<'_>, geometry: &Geometry) -> GeometryUpload {
    let triangles = sound_triangles(geometry);
    let texels = shape_texels(geometry, &triangles);
    let shape = texture(gpu, &texels, wgpu::TextureFormat::Rgba32Uint);
    let drawable = shape.is_some();
    let usage = wgpu::BufferUsages::INDEX | wgpu::BufferUsages::VERTEX;
    GeometryUpload {
        shape,
        indices: buffer(gpu, bytemuck::cast_slice(&triangles), usage),
        index_count: if drawable {
            triangles.len() as u32 * 3
        } else {
            0
        },
        vertex_count: vertex_count(geometry) as u32,
        pose_count: geometry.positions.len() as u32,
        bounds: Bounds::of_geometry(geometry),
        rim: instances(gpu, &rim_edges(&triangles), false),
    }
}

fn instances<T: bytemuck::NoUninit>(
    gpu: Gpu<'_>,
    list: &[T],
    translucent: bool,
) -> InstancesUpload {
    InstancesUpload {
        buffer: buffer(gpu, bytemuck::cast_slice(list), wgpu::BufferUsages::VERTEX),
        count: list.len() as u32,
        translucent,
    }
}

fn buffer(gpu: Gpu<'_>, bytes: &[u8], usage: wgpu::BufferUsages) -> Option<wgpu::Buffer> {
    if bytes.is_empty() || bytes.len() as u64 > gpu.device.limits().max_buffer_size {
        return None;
    }
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: bytes.len() as u64,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, bytes);
    Some(buffer)
}

/// Texels in as square a texture as holds them; `None` if there are none or more than the card can hold.
fn texture<T: bytemuck::NoUninit + bytemuck::Zeroable>(
    gpu: Gpu<'_>,
    texels: &[T],
    format: wgpu::TextureFormat,
) -> Option<Texels> {
    let width = (texels.len() as f64).sqrt().ceil() as u32;
    texture_of_width(gpu, texels, format, width.next_multiple_of(64))
}

fn texture_of_width<T: bytemuck::NoUninit + bytemuck::Zeroable>(
    gpu: Gpu<'_>,
    texels: &[T],
    format: wgpu::TextureFormat,
    width: u32,
) -> Option<Texels> {
    let most = gpu.device.limits().max_texture_dimension_2d;
    let height = (texels.len() as u32).div_ceil(width.max(1));
    if texels.is_empty() || width > most || height > most {
        return None;
    }
    let size = wgpu::Extent3d {
        width,
        height,
        depth_or_array_layers: 1,
    };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let mut whole = texels.to_vec();
    whole.resize(width as usize * height as usize, T::zeroed());
    let row = width * size_of::<T>() as u32;
    gpu.queue.write_texture(
        texture.as_image_copy(),
        bytemuck::cast_slice(&whole),
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(row),
            rows_per_image: None,
        },
        size,
    );
    Some(Texels {
        view: texture.create_view(&wgpu::TextureViewDescriptor::default()),
        width,
    })
}
