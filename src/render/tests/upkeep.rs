//! Nothing is sent or drawn twice, and damaged scenes give pictures all the same.

use std::sync::Arc;

use super::*;

const SIZE: [u32; 2] = [64, 48];

/// Prepares as a window does; returns whether it redrew.
fn prepare(
    renderer: &mut Renderer,
    gpu: &(wgpu::Device, wgpu::Queue),
    view: u32,
    scene: &Scene,
    camera: &Camera,
) -> bool {
    let (device, queue) = gpu;
    let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
    let view = ViewId(view);
    let size = Resolution::full(SIZE, 1.0);
    let redrawn = renderer.prepare(device, queue, &mut encoder, view, scene, camera, size);
    queue.submit([encoder.finish()]);
    redrawn
}

fn renderer() -> Option<(Renderer, (wgpu::Device, wgpu::Queue))> {
    let gpu = headless()?.into_gpu();
    Some((Renderer::new(&gpu.0, wgpu::TextureFormat::Rgba8Unorm), gpu))
}

fn two_poses() -> Scene {
    let mut geometry = Geometry::clone(&ball(2, 1.0));
    geometry.positions.push(ball(2, 1.3).positions[0].clone());
    geometry.normals.push(geometry.normals[0].clone());
    let mut surface = surface_of(Arc::new(geometry));
    surface.pose.to = 1;
    let mut scene = scene_of(vec![surface]);
    scene.points.push(Points {
        positions: Arc::new(vec![[0.0; 3]]),
        colours: Arc::new(vec![[1.0; 4]]),
        diameter: 3.0,
    });
    scene
}

#[test]
fn the_same_scene_is_neither_sent_nor_drawn_again() {
    let Some((mut renderer, gpu)) = renderer() else {
        return;
    };
    let scene = two_poses();
    assert!(prepare(&mut renderer, &gpu, 0, &scene, &parallel()));
    let first = renderer.counters();
    assert_eq!((first.uploads, first.redraws), (3, 1));
    assert!(!prepare(
        &mut renderer,
        &gpu,
        0,
        &scene.clone(),
        &parallel()
    ));
    assert_eq!(renderer.counters(), first);
}

#[test]
fn marks_that_are_made_anew_are_drawn_again_only_where_they_differ() {
    let Some((mut renderer, gpu)) = renderer() else {
        return;
    };
    let mut scene = two_poses();
    scene.lines.push(Lines {
        strips: Arc::new(vec![vec![[0.0; 3], [0.5; 3]]]),
        colour: [1.0; 4],
        width: 2.0,
    });
    assert!(prepare(&mut renderer, &gpu, 0, &scene, &parallel()));
    let mut anew = scene.clone();
    anew.lines[0].strips = Arc::new(anew.lines[0].strips.to_vec());
    for points in &mut anew.points {
        points.positions = Arc::new(points.positions.to_vec());
        points.colours = Arc::new(points.colours.to_vec());
    }
    assert!(!prepare(&mut renderer, &gpu, 0, &anew, &parallel()));
    let mut strips = anew.lines[0].strips.to_vec();
    strips[0][0][0] += 0.1;
    anew.lines[0].strips = Arc::new(strips);
    assert!(prepare(&mut renderer, &gpu, 0, &anew, &parallel()));
}

#[test]
fn playing_and_turning_draw_but_send_nothing() {
    let Some((mut renderer, gpu)) = renderer() else {
        return;
    };
    let mut scene = two_poses();
    prepare(&mut renderer, &gpu, 0, &scene, &parallel());
    let sent = renderer.counters().uploads;
    scene.surfaces[0].pose.blend = 0.5;
    assert!(prepare(&mut renderer, &gpu, 0, &scene, &parallel()));
    let turned = parallel().turned(glam::Vec3::Y, 0.1, 0.0);
    assert!(prepare(&mut renderer, &gpu, 0, &scene, &turned));
    assert!(prepare(&mut renderer, &gpu, 1, &scene, &turned));
    assert_eq!(renderer.counters().uploads, sent);
    assert_eq!(renderer.counters().redraws, 4);
}

#[test]
fn a_new_array_is_sent_and_only_that() {
    let Some((mut renderer, gpu)) = renderer() else {
        return;
    };
    let mut scene = two_poses();
    prepare(&mut renderer, &gpu, 0, &scene, &parallel());
    let sent = renderer.counters().uploads;
    scene.points[0].colours = Arc::new(vec![[0.5; 4]]);
    assert!(prepare(&mut renderer, &gpu, 0, &scene, &parallel()));
    assert_eq!(renderer.counters().uploads, sent + 1);
}

#[test]
fn a_blended_pose_is_drawn_between_its_poses() {
    let Some(mut headless) = headless() else {
        return;
    };
    let mut scene = two_poses();
    scene.points.clear();
    scene.surfaces[0].geometry = {
        let mut geometry = Geometry::clone(&ball(4, 1.0));
        geometry.positions.push(ball(4, 1.5).positions[0].clone());
        Arc::new(geometry)
    };
    let mut width = |blend: f32| {
        scene.surfaces[0].pose.blend = blend;
        let picture = headless
            .picture(&scene, &parallel(), 200, 200, 1.0)
            .unwrap();
        (0..200)
            .filter(|&x| picture.pixel(x, 100) != background())
            .count() as f32
    };
    assert!((width(0.0) - 100.0).abs() <= 2.0);
    assert!((width(0.5) - 125.0).abs() <= 2.0);
    assert!((width(1.0) - 150.0).abs() <= 2.0);
}

#[test]
fn the_window_sees_the_very_pixels_of_the_headless_picture() {
    let Some(mut headless) = headless() else {
        return;
    };
    let scene = scene_of(vec![surface_of(ball(3, 1.0))]);
    let expected = headless.picture(&scene, &parallel(), 64, 48, 1.0).unwrap();
    for format in [
        wgpu::TextureFormat::Rgba8Unorm,
        wgpu::TextureFormat::Rgba8UnormSrgb,
    ] {
        let shown = headless
            .blitted(&scene, &parallel(), 64, 48, format)
            .unwrap();
        // An sRGB window decodes what was encoded: one step of eight bits.
        let slack = u8::from(format.is_srgb());
        assert!(
            greatest_difference(&shown, &expected) <= slack,
            "{format:?}"
        );
    }
}

#[test]
fn damaged_and_empty_scenes_show_the_background() {
    let Some(mut headless) = headless() else {
        return;
    };
    let damaged = Geometry {
        triangles: vec![[0, 1, 9]],
        positions: vec![vec![[0.0; 3]; 3], vec![]],
        normals: vec![],
    };
    let mut scene = scene_of(vec![
        surface_of(Arc::new(Geometry::default())),
        surface_of(Arc::new(damaged)),
    ]);
    scene.surfaces[0].pose.from = 7;
    scene.surfaces[1].opacity = 0.5;
    scene.lines.push(Lines {
        strips: Arc::new(vec![vec![], vec![[0.0; 3]]]),
        colour: [1.0; 4],
        width: 2.0,
    });
    scene.points.push(Points {
        positions: Arc::new(vec![]),
        colours: Arc::new(vec![]),
        diameter: 4.0,
    });
    let picture = headless.picture(&scene, &parallel(), 32, 32, 1.0).unwrap();
    assert!(picture.rgba.chunks(4).all(|pixel| pixel == background()));
}
