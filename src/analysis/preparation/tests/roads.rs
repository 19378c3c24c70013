//! The roads from images to walls.

use std::sync::Arc;

use super::phantom::{AXES, cavity_ml, image, labels};
use crate::analysis::preparation::*;
use crate::image::{Contour, ContourPart, VolumeEdit};
use crate::mesh::Point3;
use crate::progress::Progress;

fn made(image: &crate::image::Image, settings: &Preparation) -> Prepared {
    prepared(image, settings, &Progress::default()).unwrap()
}

/// Volumes of the cavity in millilitres at both instants.
fn cavities(prepared: &Prepared) -> [f64; 2] {
    let fits = &prepared.walls.fits;
    [0, 1].map(|frame| {
        let endo = fits.iter().find(|fit| fit.frame == frame).unwrap();
        endo.volume_ml
    })
}

#[test]
fn labels_become_walls_of_their_volume() {
    let found = made(&labels(), &Preparation::default());
    assert_eq!(found.instants, [0, 1]);
    for (instant, volume) in cavities(&found).into_iter().enumerate() {
        assert!((volume / cavity_ml(instant) - 1.0).abs() < 0.03, "{volume}");
    }
    assert!(found.walls.anatomy.is_none());
}

#[test]
fn a_marked_septum_says_where_the_first_ray_points() {
    let mut settings = Preparation::default();
    for direction in [[0.0, -60.0], [40.0, 40.0]] {
        settings.points.septum = Some(Point3::new(direction[0], direction[1], -20.0));
        let found = made(&labels(), &settings);
        let septal = found.walls.anatomy.unwrap().septal;
        let expected = Point3::new(direction[0], direction[1], 0.0)
            .coords
            .normalize();
        assert!((septal - expected).norm() < 0.03, "{septal}");
    }
}

#[test]
fn volumes_without_a_mask_have_no_frame() {
    let whole = labels();
    let empty: Arc<[f32]> = vec![0.0; whole.frame().voxel_count()].into();
    let [first, second] = [0, 1].map(|instant| Arc::clone(&whole.volumes()[instant]));
    let volumes = vec![empty, first, second];
    let gaps = crate::image::Image::new(*whole.frame(), volumes, None).unwrap();
    let found = made(&gaps, &Preparation::default());
    assert_eq!(found.instants, [1, 2]);
    assert!(
        found.notices[0]
            .text
            .starts_with("2 of 3 volumes have a mask")
    );
}

#[test]
fn edits_take_labels_away() {
    // A second ventricle of the same labels, off the first.
    let doubled = image([1.5, 8.0], |place, instant| {
        let stray = (place - Point3::new(52.0, 52.0, -40.0)).norm() < 9.0;
        match (super::phantom::inside(place, instant), stray) {
            ([true, _], _) => 3.0,
            ([_, true], _) | (_, true) => 2.0,
            _ => 0.0,
        }
    });
    let mut settings = Preparation::default();
    let fit = |found: &Prepared| found.walls.fits[1].mask_volume_ml;
    let with = fit(&made(&doubled, &settings));
    settings.edits = vec![VolumeEdit::LargestComponent];
    let without = fit(&made(&doubled, &settings));
    let clean = fit(&made(&labels(), &Preparation::default()));
    assert!(
        with - without > 2.0 && (without - clean).abs() < 1e-9,
        "{with} {without} {clean}"
    );
}

#[test]
fn drawn_contours_become_walls_of_their_volume() {
    let blank = image([1.5, 8.0], |_, _| 0.0);
    let mut contours = Vec::new();
    for slice in 0..12 {
        let z = -8.0 * (f64::from(slice) + 0.5);
        for (instant, axes) in AXES.iter().enumerate() {
            for (part, [a, c]) in [ContourPart::Endocardium, ContourPart::Epicardium]
                .into_iter()
                .zip(axes)
            {
                let radius = a * (1.0 - (z / c) * (z / c)).max(0.0).sqrt();
                if radius < 3.0 {
                    continue;
                }
                let corner = |n: u32| {
                    let angle = f64::from(n) * std::f64::consts::TAU / 60.0;
                    Point3::new(radius * angle.cos(), radius * angle.sin(), z)
                };
                contours.push(Contour {
                    instant,
                    part,
                    points: (0..60).map(corner).collect(),
                });
            }
        }
    }
    let mut settings = Preparation::of_road(Road::Contours);
    let none = prepared(&blank, &settings, &Progress::default()).unwrap_err();
    assert_eq!(none, PreparationError::Asked(vec![Asked::Outlines]));
    settings.contours = Arc::new(contours);
    let found = made(&blank, &settings);
    for (instant, volume) in cavities(&found).into_iter().enumerate() {
        assert!(
            (volume / cavity_ml(instant) - 1.0).abs() < 0.03,
            "{instant}: {volume}"
        );
    }
    assert_eq!(found.contours.len(), settings.contours.len());
}
