//! Pictures that another follows show what pictures at rest show.

use super::*;
use crate::render::Quality;

const SIDE: u32 = 160;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// An opaque ball within a film.
fn wall() -> Scene {
    let inner = surface_of(ball(4, 0.6));
    let mut film = surface_of(ball(4, 0.9));
    film.opacity = 0.35;
    film.colour = SurfaceColour::Uniform([0.8, 0.7, 0.6]);
    scene_of(vec![inner, film])
}

fn picture(headless: &mut Headless, scene: &Scene, resolution: Resolution) -> Picture {
    let size = [SIDE, SIDE];
    let drawn = headless.blitted_at(scene, &parallel(), size, FORMAT, resolution);
    drawn.unwrap()
}

/// Mean difference of all bytes, of 255.
fn mean_difference(a: &Picture, b: &Picture) -> f64 {
    let pairs = a.rgba.iter().zip(&b.rgba);
    pairs.map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / a.rgba.len() as f64
}

#[test]
fn with_as_many_pixels_a_moving_picture_differs_by_edges_and_light_only() {
    let Some(mut headless) = headless() else {
        return;
    };
    let full = Resolution::full([SIDE, SIDE], 1.0);
    let rest = picture(&mut headless, &wall(), full);
    let moving = picture(&mut headless, &wall(), full.moving(1.0));
    let difference = mean_difference(&rest, &moving);
    assert!(difference < 6.0, "{difference}");
    let empty = picture(&mut headless, &scene_of(vec![]), full);
    assert!(mean_difference(&rest, &empty) > 5.0 * difference);
}

#[test]
fn with_fewer_pixels_it_fills_the_same_place() {
    let Some(mut headless) = headless() else {
        return;
    };
    let full = Resolution::full([SIDE, SIDE], 1.0);
    let rest = picture(&mut headless, &wall(), full);
    let coarse = picture(&mut headless, &wall(), full.moving(0.5));
    let covered = |picture: &Picture| {
        let pixels = picture.rgba.chunks(4);
        // An edge that is spread over two pixels counts once.
        let far = |pixel: &[u8]| {
            pixel
                .iter()
                .zip(background())
                .any(|(a, b)| a.abs_diff(b) > 30)
        };
        pixels.filter(|pixel| far(pixel)).count() as f64
    };
    let share = covered(&coarse) / covered(&rest);
    assert!((share - 1.0).abs() < 0.05, "{share}");
}

#[test]
fn an_opaque_surface_hides_the_film_behind_it_and_not_the_one_before_it() {
    let Some(mut headless) = headless() else {
        return;
    };
    let full = Resolution::full([SIDE, SIDE], 1.0);
    let middle = |headless: &mut Headless, z: f32| {
        let mut film = surface_of(square(0.5, z));
        film.opacity = 0.5;
        film.colour = SurfaceColour::Uniform([0.0, 0.0, 1.0]);
        let mut wall = surface_of(square(0.5, 0.0));
        wall.colour = SurfaceColour::Uniform([1.0, 0.0, 0.0]);
        // Listed first, so that the order of the list alone would be wrong.
        let picture = picture(headless, &scene_of(vec![film, wall]), full.moving(1.0));
        let at = ((SIDE / 2 * SIDE + SIDE / 2) * 4) as usize;
        [picture.rgba[at], picture.rgba[at + 2]]
    };
    let ([red_behind, blue_behind], [red_before, blue_before]) =
        (middle(&mut headless, -0.3), middle(&mut headless, 0.3));
    assert!(
        blue_behind < 60 && blue_before > blue_behind + 40,
        "{blue_behind} {blue_before}"
    );
    assert!(red_before < red_behind, "{red_before} {red_behind}");
}

#[test]
fn a_view_says_in_which_quality_it_shows_something() {
    let Some(headless) = headless() else { return };
    let (device, queue) = headless.into_gpu();
    let mut renderer = Renderer::new(&device, FORMAT);
    let (view, scene, camera) = (ViewId(0), wall(), parallel());
    let full = Resolution::full([64, 64], 1.0);
    assert_eq!(renderer.shows(view, &scene, &camera), None);
    for (resolution, quality) in [(full.moving(0.5), Quality::Moving), (full, Quality::Full)] {
        let descriptor = wgpu::CommandEncoderDescriptor::default();
        let mut encoder = device.create_command_encoder(&descriptor);
        let drawn = renderer.prepare(
            &device,
            &queue,
            &mut encoder,
            view,
            &scene,
            &camera,
            resolution,
        );
        queue.submit([encoder.finish()]);
        assert!(drawn);
        assert_eq!(renderer.shows(view, &scene, &camera), Some(quality));
    }
    assert_eq!(
        renderer.counters().uploads,
        2,
        "both qualities read the same arrays"
    );
    assert_eq!(renderer.shows(view, &scene_of(vec![]), &camera), None);
}
