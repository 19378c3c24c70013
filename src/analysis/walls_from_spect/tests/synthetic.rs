//! A gated SPECT study of a wall that is known: blurred counts, a liver beside the heart, noise.
//!
//! Tests within the crate and beside it include this file: whatever includes it brings the names of the crate.

use std::sync::Arc;

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::{
    Border, CappedSheet, Image, MeshSequence, Point3, Progress, ScanGrid, Vector3, VolumeFrame,
    gaussian_blur, scan_lines, sheets,
};

/// What is beside the heart and how it is recorded.
#[derive(Clone, Copy, Debug)]
pub struct Scene {
    /// Side of the voxels.
    pub voxel_mm: f64,
    /// Standard deviation of the camera's blur: 5 mm are 12 mm at half height.
    pub blur_mm: f64,
    /// Counts of the liver where those of the wall are 1; 0 for none.
    pub liver: f64,
    /// Counts of a voxel of the wall before the blur; 0 for no noise.
    pub counts: f64,
    pub seed: u64,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            voxel_mm: 4.0,
            blur_mm: 5.0,
            liver: 1.2,
            counts: 200.0,
            seed: 14,
        }
    }
}

/// Room around the heart.
const MARGIN_MM: f64 = 36.0;
/// Counts of blood and of everything else, where those of the wall are 1.
const BLOOD: f64 = 0.12;
const AROUND: f64 = 0.06;
/// Radius of the liver, and the room between it and the epicardium.
const LIVER_MM: f64 = 32.0;
const GAP_MM: f64 = 6.0;
/// Lines across a voxel, in either direction.
const LINES: usize = 2;

/// A study with its liver.
pub struct Study {
    pub image: Image,
    pub liver_centre: Point3,
    pub liver_radius_mm: f64,
}

/// The study of a wall: the first surface is the endocardium, the second the epicardium.
pub fn gated_spect(sequence: &MeshSequence, scene: &Scene) -> Study {
    let [endo, epi] = sequence.surfaces() else {
        panic!("two surfaces are needed");
    };
    let points = epi.frames().iter().flat_map(|mesh| mesh.vertices());
    let (mut low, mut high) = ([f64::MAX; 3], [f64::MIN; 3]);
    for point in points {
        for axis in 0..3 {
            low[axis] = low[axis].min(point[axis] - MARGIN_MM);
            high[axis] = high[axis].max(point[axis] + MARGIN_MM);
        }
    }
    let liver_centre = Point3::new(
        0.5 * (low[0] + high[0]),
        high[1] - MARGIN_MM + GAP_MM + LIVER_MM,
        0.5 * (low[2] + high[2]),
    );
    high[1] += MARGIN_MM;
    let size = [0, 1, 2].map(|n| ((high[n] - low[n]) / scene.voxel_mm).ceil() as usize);
    let steps = [0, 1, 2].map(|n| Vector3::ith(n, scene.voxel_mm));
    let frame = VolumeFrame::new(size, Point3::from(low), steps).unwrap();
    let liver = liver(&frame, liver_centre);
    let mut random = ChaCha8Rng::seed_from_u64(scene.seed);
    let volumes = endo.frames().iter().zip(epi.frames()).map(|(endo, epi)| {
        let [cavity, heart] = [endo, epi].map(|mesh| {
            let sheet = sheets(mesh.faces()).unwrap().remove(0);
            let capped = CappedSheet::new(mesh.vertices().len(), &sheet).unwrap();
            shares(&frame, &capped.closed(mesh.vertices()))
        });
        let counts = cavity.iter().zip(&heart).zip(&liver);
        let counts = counts.map(|((cavity, heart), liver)| {
            let wall = (heart - cavity).max(0.0);
            let others = AROUND * (1.0 - heart) + BLOOD * cavity;
            (wall + others + liver * scene.liver * (1.0 - heart)) as f32
        });
        let counts: Vec<f32> = counts.collect();
        let sigma = [scene.blur_mm / scene.voxel_mm; 3];
        let stop = Progress::default();
        let blurred = gaussian_blur(size, &counts, sigma, Border::Nearest, &stop).unwrap();
        let noisy = blurred.iter().map(|&mean| match scene.counts > 0.0 {
            true => poisson(f64::from(mean) * scene.counts, &mut random) as f32,
            false => mean,
        });
        Arc::from(noisy.collect::<Vec<f32>>())
    });
    Study {
        image: Image::new(frame, volumes.collect(), None).unwrap(),
        liver_centre,
        liver_radius_mm: LIVER_MM,
    }
}

/// The share of each voxel that lies within a closed surface.
fn shares(frame: &VolumeFrame, triangles: &[[Point3; 3]]) -> Vec<f64> {
    let (size, voxel) = (frame.size(), frame.spacing()[0]);
    let fine = voxel / LINES as f64;
    let grid = ScanGrid {
        origin: [0, 1].map(|axis| frame.origin()[axis] - 0.5 * voxel + 0.5 * fine),
        spacing: [fine; 2],
        lines: [size[0] * LINES, size[1] * LINES],
    };
    let bottom = frame.origin().z - 0.5 * voxel;
    let mut shares = vec![0.0; frame.voxel_count()];
    for (line, crossings) in scan_lines(triangles, &grid).iter().enumerate() {
        let (i, j) = (line % grid.lines[0] / LINES, line / grid.lines[0] / LINES);
        for pair in crossings.chunks_exact(2) {
            let [from, to] = [pair[0], pair[1]].map(|z| (z - bottom) / voxel);
            for k in from.max(0.0) as usize..(to.max(0.0).ceil() as usize).min(size[2]) {
                let length = to.min(k as f64 + 1.0) - from.max(k as f64);
                shares[i + size[0] * (j + size[1] * k)] += length / (LINES * LINES) as f64;
            }
        }
    }
    shares
}

/// 1 within the liver.
fn liver(frame: &VolumeFrame, centre: Point3) -> Vec<f64> {
    let [nx, ny, _] = frame.size();
    let inside = |voxel: usize| {
        let place = [voxel % nx, voxel / nx % ny, voxel / nx / ny].map(|n| n as f64);
        (frame.position(Point3::from(place)) - centre).norm() <= LIVER_MM
    };
    (0..frame.voxel_count())
        .map(|voxel| f64::from(u8::from(inside(voxel))))
        .collect()
}

/// A draw with a mean, by Knuth's products; of large means a normal one.
fn poisson(mean: f64, random: &mut ChaCha8Rng) -> f64 {
    if mean > 40.0 {
        let (a, b): (f64, f64) = (random.random(), random.random());
        let normal = (-2.0 * (1.0 - a).ln()).sqrt() * (std::f64::consts::TAU * b).cos();
        return (mean + mean.sqrt() * normal).round().max(0.0);
    }
    let (limit, mut product, mut count) = ((-mean).exp(), 1.0, -1.0);
    while product > limit {
        product *= random.random::<f64>();
        count += 1.0;
    }
    f64::max(count, 0.0)
}
