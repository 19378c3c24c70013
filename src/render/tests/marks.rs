//! Lines, points and edges are as wide as they say.

use std::sync::Arc;

use super::*;

const SIDE: u32 = 100;

/// Pixels of a column that the mark covers, partly covered ones by their opacity; for a transparent background.
fn covered_in_column(picture: &Picture, x: u32) -> f32 {
    (0..picture.height)
        .map(|y| f32::from(picture.pixel(x, y)[3]) / 255.0)
        .sum()
}

/// Nothing on nothing.
fn transparent() -> Scene {
    Scene {
        background: [0.0; 4],
        ..scene_of(vec![])
    }
}

fn line_scene(width: f32, colour: Rgba) -> Scene {
    let mut scene = transparent();
    scene.lines.push(Lines {
        strips: Arc::new(vec![vec![
            [-1.5, 0.013, 0.0],
            [0.1, 0.013, 0.0],
            [1.5, 0.013, 0.0],
        ]]),
        colour,
        width,
    });
    scene
}

#[test]
fn a_line_is_as_many_pixels_wide_as_it_says_at_any_density() {
    let Some(mut headless) = headless() else {
        return;
    };
    for (width, pixels_per_point) in [(1.0, 1.0), (2.0, 1.0), (5.0, 1.0), (3.0, 2.0)] {
        let scene = line_scene(width, [1.0, 0.9, 0.0, 1.0]);
        let picture = headless
            .picture(&scene, &parallel(), SIDE, SIDE, pixels_per_point)
            .unwrap();
        let measured = covered_in_column(&picture, 30);
        // Four samples a pixel resolve a quarter of a pixel on either side.
        assert!(
            (measured - width * pixels_per_point).abs() <= 0.5,
            "{measured} for {width}"
        );
        assert_eq!(covered_in_column(&picture, 2), 0.0);
    }
}

#[test]
fn a_translucent_line_is_blended_with_the_background() {
    let Some(mut headless) = headless() else {
        return;
    };
    let scene = line_scene(8.0, [1.0, 0.9, 0.0, 0.5]);
    let picture = headless
        .picture(&scene, &parallel(), SIDE, SIDE, 1.0)
        .unwrap();
    let measured = covered_in_column(&picture, 30);
    assert!(
        (measured - 4.0).abs() <= 0.5,
        "{measured} for 8 at one half"
    );
}

#[test]
fn a_line_keeps_its_width_in_perspective_and_is_cut_at_the_eye() {
    let Some(mut headless) = headless() else {
        return;
    };
    let camera = Camera {
        half_height: 2.0,
        ..Camera::default()
    };
    let mut scene = line_scene(4.0, [1.0, 0.9, 0.0, 1.0]);
    // Runs past the eye, below it.
    let behind = camera.eye_distance() + 5.0;
    scene.lines[0].strips = Arc::new(vec![
        vec![[-0.9, 0.0, 0.0], [0.9, 0.0, 0.0]],
        vec![[0.0, -1.0, 0.0], [0.0, -1.0, behind]],
    ]);
    let picture = headless.picture(&scene, &camera, SIDE, SIDE, 1.0).unwrap();
    let measured = covered_in_column(&picture, 35);
    assert!((measured - 4.0).abs() <= 0.5, "{measured}");
    let column: Vec<_> = (0..SIDE).map(|y| picture.pixel(50, y)[3] > 0).collect();
    assert!(column[80] && column[98] && !column[20]);
}

#[test]
fn a_disc_has_the_diameter_and_area_that_it_says() {
    let Some(mut headless) = headless() else {
        return;
    };
    for (diameter, pixels_per_point) in [(9.0, 1.0), (16.0, 1.0), (12.0, 2.0)] {
        let mut scene = transparent();
        scene.points.push(Points {
            positions: Arc::new(vec![[0.0, 0.0, 0.0]]),
            colours: Arc::new(vec![[1.0, 1.0, 0.0, 1.0]]),
            diameter,
        });
        let picture = headless
            .picture(&scene, &parallel(), SIDE, SIDE, pixels_per_point)
            .unwrap();
        let wide = diameter * pixels_per_point;
        let across = covered_in_column(&picture, SIDE / 2);
        assert!((across - wide).abs() <= 1.0, "{across} for {wide}");
        let area: f32 = (0..SIDE).map(|x| covered_in_column(&picture, x)).sum();
        let expected = std::f32::consts::PI * wide * wide / 4.0;
        assert!(
            (area / expected - 1.0).abs() < 0.06,
            "{area} for {expected}"
        );
    }
}

#[test]
fn points_have_their_own_colours_and_are_hidden_by_what_is_before_them() {
    let Some(mut headless) = headless() else {
        return;
    };
    let mut scene = scene_of(vec![surface_of(square(0.3, 0.0))]);
    scene.points.push(Points {
        positions: Arc::new(vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]),
        colours: Arc::new(vec![
            [0.0, 1.0, 0.0, 1.0],
            [1.0, 1.0, 0.0, 1.0],
            [0.0, 1.0, 1.0, 1.0],
        ]),
        diameter: 10.0,
    });
    let picture = headless
        .picture(&scene, &parallel(), SIDE, SIDE, 1.0)
        .unwrap();
    let [r, g, b, _] = picture.pixel(25, 50);
    assert!(g > 120 && r < 60 && b < 60);
    let [r, g, b, _] = picture.pixel(75, 50);
    assert!(g > 120 && r > 120 && b < 60);
    let [r, g, b, _] = picture.pixel(50, 50);
    assert!(r > 90 && g < 60 && b < 60, "{r} {g} {b}");
}

#[test]
fn edges_are_drawn_where_triangles_meet_and_nowhere_else() {
    let Some(mut headless) = headless() else {
        return;
    };
    let surface = Surface {
        wireframe: Some(Wireframe {
            colour: [0.0, 1.0, 0.0, 1.0],
            width: 2.0,
        }),
        ..surface_of(square(1.5, 0.0))
    };
    let picture = headless
        .picture(&scene_of(vec![surface]), &parallel(), SIDE, SIDE, 1.0)
        .unwrap();
    let green = |x: u32, y: u32| {
        let [r, g, ..] = picture.pixel(x, y);
        g > r
    };
    // The diagonal from lower left to upper right, and no other.
    assert!(green(50, 49) && green(30, 69) && green(65, 34));
    assert!(!green(30, 30) && !green(65, 65) && !green(50, 70));
    let along_row = (20..80).filter(|&x| green(x, 60)).count();
    assert!((2..=4).contains(&along_row), "{along_row} pixels for 2 √2");
}
