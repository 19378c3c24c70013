//! Masks in planes through the long axis.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::analysis::walls_from_masks::{Masks, Tissue};
use crate::image::VolumeFrame;
use crate::mesh::{Point3, Vector3};

use super::phantom::walls;

/// Half-ellipsoids with their tip near row 0, in 24 planes of 40 rows and 32 columns about column 16.
fn turned(axes: &[[[f64; 2]; 2]]) -> Masks {
    let [rows, columns, planes] = [40_usize, 32, 24];
    let frame = VolumeFrame::new(
        [rows, columns, planes],
        Point3::new(3.0, -5.0, 8.0),
        [Vector3::x(), Vector3::y(), Vector3::z()],
    )
    .unwrap();
    let instants = axes.iter().map(|[endo, epi]| {
        let mut voxels = Vec::new();
        for plane in 0..planes {
            for column in 0..columns {
                for row in 0..rows {
                    let r = column as f64 - 16.0;
                    let angle = PI * plane as f64 / planes as f64;
                    // Not quite round, so that the planes are not all alike.
                    let r = r * (1.0 + 0.05 * (2.0 * angle).cos());
                    let z = row as f64 - 38.5;
                    let inside =
                        |[a, c]: [f64; 2]| z < 0.0 && r * r / (a * a) + z * z / (c * c) <= 1.0;
                    voxels.push(match (inside(*endo), inside(*epi)) {
                        (true, _) => Tissue::Cavity,
                        (false, true) => Tissue::Wall,
                        _ => Tissue::Other,
                    });
                }
            }
        }
        Arc::from(voxels)
    });
    Masks::new(frame, instants.collect()).unwrap()
}

#[test]
fn planes_through_the_axis_are_recognised_and_give_the_volume_of_the_body() {
    let axes = [[[10.0, 30.0], [14.0, 35.0]], [[6.0, 25.0], [13.0, 33.0]]];
    let walls = walls(&turned(&axes));
    assert!(
        walls.notices[0]
            .text
            .contains("planes through the long axis")
    );
    // r is multiplied by 1 + 0.05 cos 2θ: the mean of 1 / that squared is 1.0038.
    for (fit, [a, c]) in walls.fits.iter().zip(axes.iter().flatten()) {
        let truth = 1.0038 * 2.0 / 3.0 * PI * a * a * c / 1000.0;
        assert!(
            (fit.volume_ml / truth - 1.0).abs() < 0.05,
            "{fit:?} {truth}"
        );
        assert!((fit.volume_ml / fit.mask_volume_ml - 1.0).abs() < 1e-3);
        assert_eq!(fit.foldovers, 0);
    }
    // The axis runs along the rows, through column 16, with the base at the last rows.
    let endo = &walls.sequence.surfaces()[0].frames()[0];
    let tip = endo.vertices()[0];
    assert!((tip.y - 11.0).abs() < 0.5 && tip.x < 14.0, "{tip}");
}
