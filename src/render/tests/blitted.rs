//! Pictures by the way that a window takes, `prepare` and `blit`.

use super::*;
use crate::render::offscreen::read_back;
use crate::render::targets::window;

impl Headless {
    /// What a window of this format shows of a picture, for tests of the way through `prepare` and `blit`.
    pub fn blitted(
        &mut self,
        scene: &Scene,
        camera: &Camera,
        width: u32,
        height: u32,
        format: wgpu::TextureFormat,
    ) -> Result<Picture, RenderError> {
        let full = Resolution::full([width, height], 1.0);
        self.blitted_at(scene, camera, [width, height], format, full)
    }

    /// The same of a picture that may have fewer pixels than the window.
    pub fn blitted_at(
        &mut self,
        scene: &Scene,
        camera: &Camera,
        [width, height]: [u32; 2],
        format: wgpu::TextureFormat,
        resolution: Resolution,
    ) -> Result<Picture, RenderError> {
        let (device, queue) = (&self.device, &self.queue);
        let mut renderer = Renderer::new(device, format);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let view = ViewId(3);
        let size = [width, height];
        renderer.prepare(device, queue, &mut encoder, view, scene, camera, resolution);
        let window = window(device, size, format);
        let target = window.create_view(&wgpu::TextureViewDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })],
            ..wgpu::RenderPassDescriptor::default()
        });
        renderer.blit(&mut pass, view);
        drop(pass);
        let rgba = read_back(device, queue, encoder, &window)?;
        Ok(Picture {
            width,
            height,
            rgba,
        })
    }
}
