//! Surfaces: colour, order of layers, numbers, opacity, tiles.

use std::sync::Arc;

use glam::Vec3;

use super::*;

const SIDE: u32 = 96;
const MIDDLE: u32 = SIDE / 2;

fn coloured(geometry: Arc<Geometry>, rgb: [f32; 3], opacity: f32) -> Surface {
    Surface {
        colour: SurfaceColour::Uniform(rgb),
        opacity,
        ..surface_of(geometry)
    }
}

/// A square coloured by one number at all corners, red to blue over 1..=100, black below, yellow above.
fn numbered(value: f32, logarithmic: bool) -> Surface {
    Surface {
        colour: SurfaceColour::Scalars {
            scalars: Arc::new(VertexScalars {
                values: vec![vec![value; 4]],
            }),
            map: Arc::new([[255, 0, 0], [0, 255, 0], [0, 0, 255]]),
            limits: ColourRange {
                low: 1.0,
                high: 100.0,
                logarithmic,
            },
            below: [0.0; 3],
            above: [1.0, 1.0, 0.0],
        },
        ..surface_of(square(1.0, 0.0))
    }
}

fn middle_of(headless: &mut Headless, surface: Surface) -> [u8; 4] {
    headless
        .picture(&scene_of(vec![surface]), &parallel(), SIDE, SIDE, 1.0)
        .unwrap()
        .pixel(MIDDLE, MIDDLE)
}

#[test]
fn a_red_ball_is_red_in_the_middle_and_the_background_is_exact() {
    let Some(mut headless) = headless() else {
        return;
    };
    for camera in [
        parallel(),
        Camera {
            half_height: 2.0,
            ..Camera::default()
        },
    ] {
        let scene = scene_of(vec![surface_of(ball(3, 1.0))]);
        let picture = headless.picture(&scene, &camera, SIDE, SIDE, 1.0).unwrap();
        let [r, g, b, a] = picture.pixel(MIDDLE, MIDDLE);
        assert!(r > 120 && g < 90 && b < 90 && a == 255, "{r} {g} {b} {a}");
        for (x, y) in [(0, 0), (SIDE - 1, 0), (3, MIDDLE), (MIDDLE, SIDE - 2)] {
            assert_eq!(picture.pixel(x, y), background());
        }
    }
}

#[test]
fn a_ball_covers_the_pixels_that_its_radius_says() {
    let Some(mut headless) = headless() else {
        return;
    };
    let scene = scene_of(vec![surface_of(ball(4, 1.0))]);
    let picture = headless
        .picture(&scene, &parallel(), SIDE, SIDE, 1.0)
        .unwrap();
    let covered = (0..SIDE)
        .filter(|&x| picture.pixel(x, MIDDLE) != background())
        .count();
    assert!((47..=50).contains(&covered), "{covered} pixels for 48");
}

#[test]
fn translucent_surfaces_look_the_same_in_whatever_order_they_are_listed() {
    let Some(mut headless) = headless() else {
        return;
    };
    let (near, far) = (
        coloured(square(1.0, 0.5), [0.9, 0.2, 0.1], 0.5),
        coloured(square(1.3, -0.5), [0.1, 0.3, 0.9], 0.6),
    );
    let inner = coloured(ball(3, 0.4), [0.2, 0.9, 0.2], 0.7);
    let one = scene_of(vec![near.clone(), far.clone(), inner.clone()]);
    let other = scene_of(vec![inner, far, near]);
    for direction in [Vec3::NEG_Z, Vec3::Z, Vec3::new(1.0, 0.3, 0.5)] {
        let camera = parallel().look_from(direction, Vec3::Y);
        let a = headless.picture(&one, &camera, SIDE, SIDE, 1.0).unwrap();
        let b = headless.picture(&other, &camera, SIDE, SIDE, 1.0).unwrap();
        assert_eq!(greatest_difference(&a, &b), 0);
    }
}

#[test]
fn of_two_translucent_squares_the_nearer_one_colours_more() {
    let Some(mut headless) = headless() else {
        return;
    };
    let scene = scene_of(vec![
        coloured(square(1.0, 0.5), [0.9, 0.0, 0.0], 0.6),
        coloured(square(1.0, -0.5), [0.0, 0.0, 0.9], 0.6),
    ]);
    let mut middle = |direction| {
        let camera = parallel().look_from(direction, Vec3::Y);
        let picture = headless.picture(&scene, &camera, SIDE, SIDE, 1.0).unwrap();
        picture.pixel(MIDDLE, MIDDLE)
    };
    let (from_red, from_blue) = (middle(Vec3::NEG_Z), middle(Vec3::Z));
    assert!(from_red[0] > from_red[2] + 20, "{from_red:?}");
    assert!(from_blue[2] > from_blue[0] + 20, "{from_blue:?}");
}

#[test]
fn layers_are_laid_over_each_other_as_their_opacities_say() {
    let Some(mut headless) = headless() else {
        return;
    };
    let red = coloured(square(1.0, 0.5), [0.9, 0.0, 0.0], 0.6);
    let blue = coloured(square(1.0, -0.5), [0.0, 0.0, 0.9], 0.3);
    let mut over = |surfaces: Vec<Surface>, background: Rgba| {
        let scene = Scene {
            background,
            ..scene_of(surfaces)
        };
        let picture = headless
            .picture(&scene, &parallel(), SIDE, SIDE, 1.0)
            .unwrap();
        picture.pixel(MIDDLE, MIDDLE).map(f32::from)
    };
    let blue_alone = over(vec![blue.clone()], BACKGROUND);
    let behind = [blue_alone[0], blue_alone[1], blue_alone[2]].map(|x| x / 255.0);
    let expected = over(vec![red.clone()], [behind[0], behind[1], behind[2], 1.0]);
    let both = over(vec![red, blue], BACKGROUND);
    for channel in 0..4 {
        // Eight-bit rounding once per layer.
        assert!(
            (both[channel] - expected[channel]).abs() <= 2.0,
            "{both:?} for {expected:?}"
        );
    }
}

#[test]
fn an_opaque_ball_hides_what_is_behind_it_and_shows_through_what_is_before_it() {
    let Some(mut headless) = headless() else {
        return;
    };
    let red = coloured(ball(3, 0.5), [0.9, 0.1, 0.1], 1.0);
    let mut middle = |z: f32| {
        let translucent = coloured(square(1.5, z), [0.1, 0.1, 0.9], 0.5);
        middle_pixel(&mut headless, vec![red.clone(), translucent])
    };
    let (translucent_behind, translucent_before) = (middle(-1.0), middle(1.0));
    let alone = middle_pixel(&mut headless, vec![red]);
    assert_eq!(translucent_behind, alone);
    assert!(
        translucent_before[2] > alone[2] + 40 && translucent_before[0] > 60,
        "{translucent_before:?}"
    );
}

fn middle_pixel(headless: &mut Headless, surfaces: Vec<Surface>) -> [u8; 4] {
    let picture = headless.picture(&scene_of(surfaces), &parallel(), SIDE, SIDE, 1.0);
    picture.unwrap().pixel(MIDDLE, MIDDLE)
}

#[test]
fn what_is_not_a_number_is_grey() {
    let Some(mut headless) = headless() else {
        return;
    };
    let [r, g, b, _] = middle_of(&mut headless, numbered(f32::NAN, false));
    assert!(
        r.abs_diff(g) < 14 && g.abs_diff(b) < 14 && (80..200).contains(&g),
        "{r} {g} {b}"
    );
}

#[test]
fn numbers_beyond_the_limits_have_their_own_colours() {
    let Some(mut headless) = headless() else {
        return;
    };
    let [r, g, b, _] = middle_of(&mut headless, numbered(0.5, false));
    assert!(r < 70 && g < 70 && b < 70, "below: {r} {g} {b}");
    let [r, g, b, _] = middle_of(&mut headless, numbered(101.0, false));
    assert!(r > 150 && g > 150 && b < 90, "above: {r} {g} {b}");
}

#[test]
fn a_logarithmic_map_has_its_middle_at_the_geometric_mean() {
    let Some(mut headless) = headless() else {
        return;
    };
    let [r, g, b, _] = middle_of(&mut headless, numbered(10.0, true));
    assert!(g > 150 && r < 90 && b < 90, "{r} {g} {b}");
    let [r, g, b, _] = middle_of(&mut headless, numbered(10.0, false));
    assert!(r > g && b < 90, "{r} {g} {b}");
}

#[test]
fn a_transparent_picture_laid_over_a_background_is_the_picture_with_that_background() {
    let Some(mut headless) = headless() else {
        return;
    };
    let mut scene = scene_of(vec![
        surface_of(ball(3, 0.6)),
        coloured(ball(3, 1.2), [0.9, 0.8, 0.7], 0.3),
    ]);
    let solid = headless
        .picture(&scene, &parallel(), SIDE, SIDE, 1.0)
        .unwrap();
    scene.background[3] = 0.0;
    let clear = headless
        .picture(&scene, &parallel(), SIDE, SIDE, 1.0)
        .unwrap();
    assert_eq!(clear.pixel(0, 0), [0; 4]);
    assert_eq!(clear.pixel(MIDDLE, MIDDLE)[3], 255);
    for (front, whole) in clear.rgba.chunks(4).zip(solid.rgba.chunks(4)) {
        let opacity = f32::from(front[3]) / 255.0;
        for channel in 0..3 {
            let over = f32::from(front[channel]) * opacity
                + f32::from(background()[channel]) * (1.0 - opacity);
            assert!((over - f32::from(whole[channel])).abs() <= 1.5);
        }
    }
}

#[test]
fn a_picture_in_tiles_is_the_picture_in_one_piece() {
    let Some(whole) = headless() else { return };
    let mut whole = whole.with_largest_tile(1024);
    let Some(tiled) = headless() else { return };
    let mut tiled = tiled.with_largest_tile(128);
    let mut scene = scene_of(vec![
        surface_of(ball(3, 0.9)),
        coloured(ball(3, 1.5), [0.9, 0.8, 0.7], 0.3),
    ]);
    scene.lines.push(Lines {
        strips: Arc::new(vec![vec![[-1.8, -1.0, 1.0], [1.8, 1.4, 0.5]]]),
        colour: [0.9, 0.8, 0.1, 1.0],
        width: 3.0,
    });
    let camera = Camera {
        half_height: 2.0,
        ..Camera::default()
    };
    let a = whole.picture(&scene, &camera, 330, 250, 1.0).unwrap();
    let b = tiled.picture(&scene, &camera, 330, 250, 1.0).unwrap();
    assert!(tiled.renderer().counters().redraws > 6);
    let apart: Vec<u8> = a
        .rgba
        .iter()
        .zip(&b.rgba)
        .map(|(a, b)| a.abs_diff(*b))
        .collect();
    // Occlusion comes from a picture a third as wide: it is softer, but close.
    let far_off = apart.iter().filter(|&&apart| apart > 16).count();
    assert!(far_off < apart.len() / 500, "{far_off} of {}", apart.len());
    let mean = apart.iter().map(|&apart| f64::from(apart)).sum::<f64>() / apart.len() as f64;
    assert!(mean < 0.4, "{mean}");
    // Without occlusion nothing differs but a sample that rounding moves across an edge now and then.
    for scene_surface in &mut scene.surfaces {
        scene_surface.opacity = scene_surface.opacity.min(0.99);
    }
    let a = whole.picture(&scene, &camera, 330, 250, 1.0).unwrap();
    let b = tiled.picture(&scene, &camera, 330, 250, 1.0).unwrap();
    let off = a
        .rgba
        .iter()
        .zip(&b.rgba)
        .filter(|(a, b)| a.abs_diff(**b) > 4)
        .count();
    assert!(off < a.rgba.len() / 1000, "{off} of {}", a.rgba.len());
}

#[test]
fn the_inside_of_an_open_bowl_is_seen_through_its_mouth() {
    let Some(mut headless) = headless() else {
        return;
    };
    let bowl = geometry_of(&phantom::bowl(1.0, 12, 32));
    for direction in [Vec3::Z, Vec3::NEG_Z] {
        let camera = parallel().look_from(direction, Vec3::Y);
        let scene = scene_of(vec![surface_of(Arc::clone(&bowl))]);
        let picture = headless.picture(&scene, &camera, SIDE, SIDE, 1.0).unwrap();
        let [r, g, _, _] = picture.pixel(MIDDLE, MIDDLE);
        assert!(r > 40 && r > 2 * g, "{r} {g}");
    }
}

#[test]
fn flat_shading_gives_a_triangle_one_colour_and_smooth_shading_does_not() {
    let Some(mut headless) = headless() else {
        return;
    };
    let mut colours = |shading| {
        let surface = Surface {
            shading,
            ..surface_of(ball(0, 1.5))
        };
        let picture = headless.picture(&scene_of(vec![surface]), &parallel(), SIDE, SIDE, 1.0);
        let picture = picture.unwrap();
        let mut seen: Vec<_> = picture.rgba.as_chunks::<4>().0.to_vec();
        seen.sort_unstable();
        seen.dedup();
        seen.len()
    };
    assert!(2 * colours(Shading::Flat) < colours(Shading::Smooth));
}

#[test]
fn a_size_of_zero_or_beyond_the_largest_is_refused() {
    let Some(mut headless) = headless() else {
        return;
    };
    let scene = scene_of(vec![]);
    for (width, height) in [(0, 5), (5, 8193)] {
        let refused = headless.picture(&scene, &parallel(), width, height, 1.0);
        assert!(matches!(refused, Err(RenderError::Size { .. })));
    }
}
