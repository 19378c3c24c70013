//! Pipelines of everything that is drawn into the scene's depth, made when first needed.

use super::shaders::{CORNERS, DISCS, Kind, RIM, SEGMENTS, shader_text};
use super::targets::{COLOUR, DEPTH, SAMPLES};

/// What it is drawn for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Stage {
    /// The nearest opaque depth.
    OpaqueDepth,
    /// The nearest depth of translucent surfaces before what is opaque.
    FirstDepth,
    /// The nearest depth behind the layer taken before.
    PeelDepth,
    /// Light where the depth is the one found before, under what is already there.
    Colour,
    /// Light of a whole translucent surface before what is opaque, under what is already there; needs no depths but those.
    Translucent,
    /// Depth and light at once, of one sample a pixel: what is opaque, in a picture that another follows.
    Moving,
    /// The same of translucent surfaces, over what is opaque before them.
    MovingFilm,
}

impl Stage {
    fn samples(self) -> u32 {
        match self {
            Self::Moving | Self::MovingFilm => 1,
            _ => SAMPLES,
        }
    }

    fn writes_depth(self) -> bool {
        !matches!(self, Self::Colour | Self::Translucent | Self::MovingFilm)
    }
}

const KINDS: usize = 5;
const STAGES: usize = 7;

/// Bind group layouts shared by the passes.
pub(super) struct Layouts {
    /// Group 0: the view.
    pub view: wgpu::BindGroupLayout,
    /// Group 1 of surfaces.
    pub surface: wgpu::BindGroupLayout,
    /// Group 1 of lines and points.
    pub mark: wgpu::BindGroupLayout,
    /// Group 2 while peeling.
    pub peel: wgpu::BindGroupLayout,
    /// Group 2 while colouring.
    pub occlusion: wgpu::BindGroupLayout,
}

/// A uniform block, whose place is given with each draw if `dynamic`.
pub(super) fn uniform_entry(binding: u32, dynamic: bool) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: dynamic,
            min_binding_size: None,
        },
        count: None,
    }
}

/// A texture read texel by texel.
pub(super) fn texture_entry(
    binding: u32,
    sample_type: wgpu::TextureSampleType,
    multisampled: bool,
) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled,
        },
        count: None,
    }
}

/// A texture of numbers that are not filtered.
pub(super) const PLAIN: wgpu::TextureSampleType =
    wgpu::TextureSampleType::Float { filterable: false };

pub(super) fn layout(
    device: &wgpu::Device,
    label: &str,
    entries: &[wgpu::BindGroupLayoutEntry],
) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some(label),
        entries,
    })
}

impl Layouts {
    pub fn new(device: &wgpu::Device) -> Self {
        let whole = wgpu::TextureSampleType::Uint;
        Self {
            view: layout(device, "view", &[uniform_entry(0, false)]),
            surface: layout(
                device,
                "surface",
                &[
                    uniform_entry(0, true),
                    texture_entry(1, whole, false),
                    texture_entry(2, whole, false),
                    texture_entry(3, PLAIN, false),
                ],
            ),
            mark: layout(device, "mark", &[uniform_entry(0, true)]),
            peel: layout(
                device,
                "peel",
                &[texture_entry(0, PLAIN, true), texture_entry(1, PLAIN, true)],
            ),
            occlusion: layout(device, "occlusion", &[texture_entry(2, whole, false)]),
        }
    }
}

/// All pipelines made so far.
#[derive(Default)]
pub(super) struct Pipelines {
    modules: [Option<wgpu::ShaderModule>; KINDS],
    made: [[Option<wgpu::RenderPipeline>; STAGES]; KINDS],
}

impl Pipelines {
    /// Makes a pipeline if there is none yet.
    pub fn prepare(&mut self, device: &wgpu::Device, layouts: &Layouts, kind: Kind, stage: Stage) {
        if self.made[kind as usize][stage as usize].is_some() {
            return;
        }
        let module = self.modules[kind as usize].get_or_insert_with(|| {
            device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: None,
                source: wgpu::ShaderSource::Wgsl(shader_text(kind).into()),
            })
        });
        self.made[kind as usize][stage as usize] =
            Some(scene_pipeline(device, layouts, module, kind, stage));
    }

    /// A pipeline that was prepared.
    pub fn get(&self, kind: Kind, stage: Stage) -> Option<&wgpu::RenderPipeline> {
        self.made[kind as usize][stage as usize].as_ref()
    }
}

/// Front to back: what is there already stays in front.
const UNDER: wgpu::BlendComponent = wgpu::BlendComponent {
    src_factor: wgpu::BlendFactor::OneMinusDstAlpha,
    dst_factor: wgpu::BlendFactor::One,
    operation: wgpu::BlendOperation::Add,
};

fn scene_pipeline(
    device: &wgpu::Device,
    layouts: &Layouts,
    module: &wgpu::ShaderModule,
    kind: Kind,
    stage: Stage,
) -> wgpu::RenderPipeline {
    let own = match kind {
        Kind::Surface | Kind::EdgedSurface | Kind::Rim => &layouts.surface,
        Kind::Lines | Kind::Points => &layouts.mark,
    };
    let moving = matches!(stage, Stage::Moving | Stage::MovingFilm);
    let (entry, buffers) = match kind {
        Kind::Surface if moving => ("vs_moving", vec![]),
        Kind::Surface => ("vs_indexed", vec![]),
        Kind::EdgedSurface if moving => ("vs_moving_corners", vec![Some(CORNERS)]),
        Kind::EdgedSurface => ("vs_corners", vec![Some(CORNERS)]),
        Kind::Rim => ("vs_rim", vec![Some(RIM)]),
        Kind::Lines => ("vs_segment", vec![Some(SEGMENTS)]),
        Kind::Points => ("vs_disc", DISCS.map(Some).to_vec()),
    };
    let groups: &[Option<&wgpu::BindGroupLayout>] = match stage {
        Stage::OpaqueDepth | Stage::Moving | Stage::MovingFilm => &[Some(&layouts.view), Some(own)],
        Stage::FirstDepth | Stage::PeelDepth => {
            &[Some(&layouts.view), Some(own), Some(&layouts.peel)]
        }
        Stage::Colour | Stage::Translucent => {
            &[Some(&layouts.view), Some(own), Some(&layouts.occlusion)]
        }
    };
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: groups,
        immediate_size: 0,
    });
    let blend = match stage {
        Stage::Moving => None,
        Stage::MovingFilm => Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING),
        _ => Some(wgpu::BlendState {
            color: UNDER,
            alpha: UNDER,
        }),
    };
    let colour = [Some(wgpu::ColorTargetState {
        format: COLOUR,
        blend,
        write_mask: wgpu::ColorWrites::ALL,
    })];
    let fragment = |entry_point, targets| wgpu::FragmentState {
        module,
        entry_point: Some(entry_point),
        compilation_options: wgpu::PipelineCompilationOptions::default(),
        targets,
    };
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(entry),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(entry),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &buffers,
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH,
            depth_write_enabled: Some(stage.writes_depth()),
            depth_compare: Some(match stage {
                Stage::Colour => wgpu::CompareFunction::Equal,
                _ => wgpu::CompareFunction::Greater,
            }),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState {
            count: stage.samples(),
            ..wgpu::MultisampleState::default()
        },
        fragment: match stage {
            Stage::OpaqueDepth => None,
            Stage::FirstDepth => Some(fragment("fs_first", &[])),
            Stage::PeelDepth => Some(fragment("fs_peel", &[])),
            _ => {
                let entry_point = match kind {
                    Kind::Rim => "fs_rim",
                    Kind::Surface if moving => "fs_moving",
                    Kind::EdgedSurface if moving => "fs_moving_edged",
                    _ => "fs_colour",
                };
                Some(fragment(entry_point, &colour))
            }
        },
        multiview_mask: None,
        cache: None,
    })
}
