//! What is drawn, by which shader, from which vertex buffers.

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// A surface by its indices.
    Surface,
    /// A surface corner by corner, with edges.
    EdgedSurface,
    /// Where a surface ends.
    Rim,
    /// Line segments.
    Lines,
    /// Discs.
    Points,
}

/// What every scene shader begins with.
pub(super) const COMMON: &str = include_str!("shaders/common.wgsl");
const PEEL: &str = include_str!("shaders/peel.wgsl");

/// The part of the shader that is only for surfaces.
const SURFACES_SHADER: &str = concat!(
    include_str!("shaders/occlusion_texel.wgsl"),
    include_str!("shaders/occlusion_read.wgsl"),
    include_str!("shaders/surface.wgsl")
);

/// Indices read corner by corner, for edges.
pub(super) const CORNERS: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: 4,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Uint32],
};

/// Both vertices of an edge where the surface ends.
pub(super) const RIM: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: 8,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &wgpu::vertex_attr_array![0 => Uint32, 1 => Uint32],
};

/// The part of the shader that is only for lines.
const LINES_SHADER: &str = include_str!("shaders/lines.wgsl");

/// Both ends of a segment.
pub(super) const SEGMENTS: wgpu::VertexBufferLayout<'static> = wgpu::VertexBufferLayout {
    array_stride: 24,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3],
};

/// The part of the shader that is only for points.
const POINTS_SHADER: &str = include_str!("shaders/points.wgsl");

/// Centres (padded to four numbers) and colours.
pub(super) const DISCS: [wgpu::VertexBufferLayout<'static>; 2] = [
    wgpu::VertexBufferLayout {
        array_stride: 16,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![0 => Float32x3],
    },
    wgpu::VertexBufferLayout {
        array_stride: 16,
        step_mode: wgpu::VertexStepMode::Instance,
        attributes: &wgpu::vertex_attr_array![1 => Float32x4],
    },
];

/// The whole shader text of a kind.
pub(super) fn shader_text(kind: Kind) -> String {
    let own = match kind {
        Kind::Surface | Kind::EdgedSurface | Kind::Rim => SURFACES_SHADER,
        Kind::Lines => LINES_SHADER,
        Kind::Points => POINTS_SHADER,
    };
    [COMMON, PEEL, own].join("\n")
}
