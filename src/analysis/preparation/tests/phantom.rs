//! A ventricle between half-ellipsoids, as labels and as counts.

use std::sync::Arc;

use crate::image::{Image, VolumeFrame};
use crate::mesh::{Point3, Vector3};

/// Half-axes across and along of endocardium and epicardium in millimetres at each instant; the base lies at z = 0, the apex below.
pub const AXES: [[[f64; 2]; 2]; 2] = [[[25.0, 70.0], [34.0, 79.0]], [[18.0, 60.0], [31.0, 74.0]]];

/// Its volume in millilitres.
pub fn cavity_ml(instant: usize) -> f64 {
    let [a, c] = AXES[instant][0];
    2.0 / 3.0 * std::f64::consts::PI * a * a * c / 1000.0
}

/// A grid with slices from the base to the apex.
fn frame([across, along]: [f64; 2]) -> VolumeFrame {
    let n = (120.0 / across) as usize;
    let slices = (96.0 / along) as usize;
    let first = -0.5 * across * (n - 1) as f64;
    let steps = [
        Vector3::x() * across,
        Vector3::y() * across,
        -Vector3::z() * along,
    ];
    VolumeFrame::new(
        [n, n, slices],
        Point3::new(first, first, -0.5 * along),
        steps,
    )
    .unwrap()
}

/// Values by place and instant.
pub fn image(spacing: [f64; 2], value: impl Fn(Point3, usize) -> f32) -> Image {
    let frame = frame(spacing);
    let [ni, nj, _] = frame.size();
    let volume = |instant| -> Arc<[f32]> {
        let at = |n: usize| Point3::from([n % ni, n / ni % nj, n / ni / nj].map(|i| i as f64));
        (0..frame.voxel_count())
            .map(|n| value(frame.position(at(n)), instant))
            .collect()
    };
    Image::new(frame, vec![volume(0), volume(1)], None).unwrap()
}

/// Whether a place is in the cavity, and in the ventricle.
pub fn inside(place: Point3, instant: usize) -> [bool; 2] {
    AXES[instant].map(|[a, c]| {
        (place.x * place.x + place.y * place.y) / (a * a) + place.z * place.z / (c * c) <= 1.0
            && place.z <= 0.0
    })
}

/// Labels of ACDC without a right ventricle, slices of 8 mm.
pub fn labels() -> Image {
    image([1.5, 8.0], |place, instant| match inside(place, instant) {
        [true, _] => 3.0,
        [_, true] => 2.0,
        _ => 0.0,
    })
}

/// Counts: a bright wall, with a brighter liver beside it.
pub fn counts() -> Image {
    image([4.0, 4.0], |place, instant| {
        let liver = (place - Point3::new(52.0, 0.0, -70.0)).norm() < 10.0;
        match (inside(place, instant), liver) {
            (_, true) => 120.0,
            ([false, true], _) => 100.0,
            _ => 5.0,
        }
    })
}
