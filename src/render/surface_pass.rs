//! Surfaces as draws: morphed on the card, coloured evenly or by numbers, with or without edges.

use super::drawn::Drawn;
use super::pipelines::Layouts;
use super::shaders::Kind;
use super::uniforms::{SurfaceUniform, UNIFORM_STRIDE};
use super::uploads::{Gpu, Uploads};
use super::{Surface, SurfaceColour};

/// Stand-ins for numbers and colours that a surface does not have.
pub(super) struct Nothing {
    numbers: wgpu::TextureView,
    colours: wgpu::TextureView,
}

impl Nothing {
    pub fn new(device: &wgpu::Device) -> Self {
        let view = |format| {
            device
                .create_texture(&wgpu::TextureDescriptor {
                    label: Some("nothing"),
                    size: wgpu::Extent3d::default(),
                    mip_level_count: 1,
                    sample_count: 1,
                    dimension: wgpu::TextureDimension::D2,
                    format,
                    usage: wgpu::TextureUsages::TEXTURE_BINDING,
                    view_formats: &[],
                })
                .create_view(&wgpu::TextureViewDescriptor::default())
        };
        Self {
            numbers: view(wgpu::TextureFormat::R32Uint),
            colours: view(wgpu::TextureFormat::Rgba8Unorm),
        }
    }
}

/// What a surface needs to be drawn; `None` if nothing of it can be seen.
pub(super) fn drawn(
    gpu: Gpu<'_>,
    uploads: &mut Uploads,
    (layouts, nothing): (&Layouts, &Nothing),
    surface: &Surface,
    (uniforms, offset): (&wgpu::Buffer, u32),
) -> Option<(Vec<Drawn>, SurfaceUniform)> {
    if surface.opacity.is_nan() || surface.opacity <= 0.0 {
        return None;
    }
    let geometry = uploads.geometry(gpu, &surface.geometry);
    let (shape, indices) = (geometry.shape.as_ref()?, geometry.indices.as_ref()?);
    let coloured = match &surface.colour {
        SurfaceColour::Uniform(_) => None,
        SurfaceColour::Scalars { scalars, map, .. } => {
            Some((uploads.scalars(gpu, scalars), uploads.map(gpu, map)))
        }
    };
    let (scalars, map) = coloured.as_ref().map_or((None, None), |(scalars, map)| {
        (Some(&**scalars), Option::as_ref(map))
    });
    let uniform = SurfaceUniform::new(surface, &geometry, scalars, map.map_or(0, |map| map.width));
    let numbers = scalars.and_then(|scalars| scalars.texels.as_ref());
    let entry = |binding, view| wgpu::BindGroupEntry {
        binding,
        resource: wgpu::BindingResource::TextureView(view),
    };
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("surface"),
        layout: &layouts.surface,
        entries: &[
            block::<SurfaceUniform>(uniforms),
            entry(1, &shape.view),
            entry(2, numbers.map_or(&nothing.numbers, |texels| &texels.view)),
            entry(3, map.map_or(&nothing.colours, |texels| &texels.view)),
        ],
    });
    let edged = surface.wireframe.is_some();
    let translucent = surface.opacity < 1.0;
    let rim = geometry
        .rim
        .buffer
        .clone()
        .filter(|_| surface.silhouette > 0.0);
    let rim = rim.map(|edges| Drawn {
        kind: Kind::Rim,
        group: group.clone(),
        offset,
        indices: None,
        buffers: vec![edges],
        vertices: 6,
        instances: geometry.rim.count,
        translucent,
        bounds: geometry.bounds,
        layers: 0,
    });
    let draw = Drawn {
        kind: if edged {
            Kind::EdgedSurface
        } else {
            Kind::Surface
        },
        group,
        offset,
        indices: (!edged).then(|| indices.clone()),
        buffers: if edged { vec![indices.clone()] } else { vec![] },
        vertices: geometry.index_count,
        instances: 1,
        translucent,
        bounds: geometry.bounds,
        // An open sheet is met in front and at the back; a closed wall has an outer and an inner side at each.
        layers: if geometry.rim.count > 0 { 2 } else { 4 },
    };
    Some((std::iter::once(draw).chain(rim).collect(), uniform))
}

/// One draw's block in the view's uniform buffer, placed by its offset.
pub(super) fn block<T>(uniforms: &wgpu::Buffer) -> wgpu::BindGroupEntry<'_> {
    debug_assert!(size_of::<T>() as u64 <= UNIFORM_STRIDE);
    wgpu::BindGroupEntry {
        binding: 0,
        resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
            buffer: uniforms,
            offset: 0,
            size: std::num::NonZeroU64::new(size_of::<T>() as u64),
        }),
    }
}
