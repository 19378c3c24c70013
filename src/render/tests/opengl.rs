//! Where there is no Vulkan: OpenGL, and drivers too old to read samples, show the same subject.

use super::*;
use crate::render::targets::Capabilities;

const SIDE: u32 = 160;

fn opengl() -> Option<Headless> {
    let mut interfaces = wgpu::InstanceDescriptor::new_without_display_handle();
    interfaces.backends = wgpu::Backends::GL;
    found(Headless::of(interfaces))
}

/// An open wall with an opaque inside, a translucent outside and a marked place.
fn heart() -> Scene {
    let mut outside = surface_of(geometry_of(&phantom::bowl(1.3, 12, 32)));
    outside.opacity = 0.3;
    outside.silhouette = 0.6;
    outside.colour = SurfaceColour::Uniform([0.85, 0.76, 0.65]);
    let mut scene = scene_of(vec![
        surface_of(geometry_of(&phantom::bowl(0.9, 12, 32))),
        outside,
    ]);
    scene.lines.push(Lines {
        strips: Arc::new(vec![vec![[-1.8, -1.0, 1.0], [1.8, 1.4, 0.5]]]),
        colour: [0.9, 0.8, 0.1, 1.0],
        width: 3.0,
    });
    scene.points.push(Points {
        positions: Arc::new(vec![[0.5, -0.5, 1.2]]),
        colours: Arc::new(vec![[0.1, 0.9, 0.2, 0.6]]),
        diameter: 9.0,
    });
    scene
}

fn heart_by(headless: &mut Headless) -> Picture {
    let camera = parallel().look_from(glam::Vec3::new(0.4, 1.0, 0.5), glam::Vec3::Z);
    headless
        .picture(&heart(), &camera, SIDE, SIDE, 1.0)
        .unwrap()
}

/// Mean difference of all bytes, and the share of bytes that differ by more than 32.
fn apart(a: &Picture, b: &Picture) -> (f64, f64) {
    let each = || a.rgba.iter().zip(&b.rgba).map(|(a, b)| a.abs_diff(*b));
    let count = a.rgba.len() as f64;
    let mean = each().map(f64::from).sum::<f64>() / count;
    (
        mean,
        each().filter(|&apart| apart > 32).count() as f64 / count,
    )
}

#[test]
fn opengl_shows_the_heart_that_the_first_adapter_shows() {
    let (Some(mut first), Some(mut opengl)) = (headless(), opengl()) else {
        return;
    };
    assert!(
        opengl.adapter_name().ends_with("(gl)"),
        "{}",
        opengl.adapter_name()
    );
    let (a, b) = (heart_by(&mut first), heart_by(&mut opengl));
    assert!(a.rgba.chunks(4).any(|pixel| pixel != background()));
    let (mean, far) = apart(&a, &b);
    // Older drivers show translucent surfaces without inner order and no occlusion.
    assert!(mean < 6.0 && far < 0.05, "{mean} {far}");
}

#[test]
fn opengl_takes_damaged_and_many_scenes_without_complaint() {
    let Some(mut opengl) = opengl() else { return };
    for opacity in [1.0, 0.5] {
        let mut scene = heart();
        for surface in &mut scene.surfaces {
            surface.opacity = opacity;
            surface.wireframe = Some(Wireframe {
                colour: [0.0, 0.0, 0.0, 0.5],
                width: 1.0,
            });
        }
        scene.surfaces[0].colour = SurfaceColour::Scalars {
            scalars: Arc::new(VertexScalars {
                values: vec![vec![1.0; scene.surfaces[0].geometry.positions[0].len()]],
            }),
            map: Arc::new([[255, 0, 0], [0, 0, 255]]),
            limits: ColourRange {
                low: 0.0,
                high: 1.0,
                logarithmic: false,
            },
            below: [0.0; 3],
            above: [1.0; 3],
        };
        let picture = opengl.picture(&scene, &parallel(), SIDE, SIDE, 1.0);
        let picture = picture.unwrap();
        assert!(picture.rgba.chunks(4).any(|pixel| pixel != background()));
    }
}

#[test]
fn translucent_surfaces_drawn_whole_cover_the_pixels_that_peeled_ones_cover() {
    let (Some(mut peeled), Some(plain)) = (headless(), headless()) else {
        return;
    };
    let mut plain = plain.with_capabilities(Capabilities::Plain);
    let (a, b) = (heart_by(&mut peeled), heart_by(&mut plain));
    let uncovered = |picture: &Picture| {
        let pixels = picture.rgba.chunks(4);
        pixels
            .map(|pixel| pixel == background())
            .collect::<Vec<_>>()
    };
    assert_eq!(uncovered(&a), uncovered(&b));
    let (mean, far) = apart(&a, &b);
    assert!(mean < 6.0 && far < 0.05, "{mean} {far}");
}

#[test]
fn what_the_driver_refuses_is_told_and_ends_nothing() {
    let Some(headless) = headless() else { return };
    let (device, queue) = headless.into_gpu();
    let mut renderer = Renderer::new(&device, wgpu::TextureFormat::Rgba8Unorm);
    let error_scope = error_scope::ErrorScope::begin(&device);
    // No card has a buffer of this size.
    let _ = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: (u64::MAX / 2) & !3,
        usage: wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    let heard = error_scope.end();
    assert!(heard.is_err());
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let (view, camera) = (ViewId(0), parallel());
    assert!(renderer.prepare(
        &device,
        &queue,
        &mut encoder,
        view,
        &heart(),
        &camera,
        Resolution::full([64, 64], 1.0)
    ));
    assert_eq!(renderer.failure(), None);
}
