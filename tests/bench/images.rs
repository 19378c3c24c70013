//! Benches of images: blur and isosurface of a gated study, thin-plate spline of a whole surface, smoothing and decimation,
//! and, where the real data lie beside the checkout, opening the files of a cine study.
//!
//! `peers/images.py` does the same work with SciPy, scikit-image and pydicom; what is printed here is to equal what it prints.

use std::hint::black_box;
use std::io::Cursor;
use std::path::Path;
use std::time::Duration;
use std::{env, fs};

use cardiomorph::analysis::registration::{ThinPlateSpline, ThinPlateSplineError};
use cardiomorph::analysis::surface_extraction::{TaubinParams, decimated, isosurface, taubin};
use cardiomorph::image::{
    Border, Interpolation, Reorientation, Sampler, VolumeFrame, gaussian_blur,
};
use cardiomorph::io::{Limits, read_dicom};
use cardiomorph::mesh::{Point3, TriMesh, Vector3, phantom, signed_volume};
use cardiomorph::progress::Progress;
use criterion::{Criterion, criterion_group, criterion_main};

/// As a gated SPECT study has it.
const SIZE: [usize; 3] = [128, 128, 47];
const GATES: u32 = 8;
const SPACING_MM: f64 = 3.0;
/// Above the noise, within the wall.
const THRESHOLD: f64 = 60.0;

fn frame() -> Option<VolumeFrame> {
    let steps = [0, 1, 2].map(|axis| Vector3::ith(axis, SPACING_MM));
    VolumeFrame::new(SIZE, Point3::origin(), steps).ok()
}

/// A beating shell, open at the base, with a liver beside it and noise.
fn gate(number: u32) -> Vec<f32> {
    let mut state = 12_345 + u64::from(number);
    let beat = 14.0 - (f64::from(number) * 0.785).sin();
    let mut values = Vec::with_capacity(SIZE.iter().product());
    for voxel in 0..SIZE.iter().product::<usize>() {
        let place = [
            voxel % SIZE[0],
            voxel / SIZE[0] % SIZE[1],
            voxel / SIZE[0] / SIZE[1],
        ];
        let [x, y, z] = [0, 1, 2].map(|axis| place[axis] as f64 - [64.0, 60.0, 23.0][axis]);
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let noise = 30.0 * ((state >> 40) as f64 / f64::from(1 << 24));
        let away = (x * x + 1.21 * y * y + 0.49 * z * z).sqrt() - beat;
        let wall = if z > 14.0 {
            0.0
        } else {
            100.0 * (-away * away / 8.0).exp()
        };
        let liver = Vector3::new(x + 30.0, y - 35.0, z + 5.0).norm() < 18.0;
        values.push((wall + if liver { 80.0 } else { 0.0 } + noise) as f32);
    }
    values
}

fn blurred_surface(frame: &VolumeFrame, values: &[f32], sigma: f64) -> Option<TriMesh> {
    let progress = Progress::default();
    let blurred = gaussian_blur(SIZE, values, [sigma; 3], Border::Reflect, &progress).ok()?;
    isosurface(frame, &blurred, THRESHOLD, &progress).ok()
}

/// All gates of a study, from values to surfaces; the budget is 150 ms on two cores.
fn surfaces(criterion: &mut Criterion) {
    let Some(frame) = frame() else { return };
    let gates: Vec<Vec<f32>> = (0..GATES).map(gate).collect();
    let progress = Progress::default();
    criterion.bench_function("blur_8_gates", |bencher| {
        bencher.iter(|| {
            for values in &gates {
                black_box(gaussian_blur(SIZE, values, [1.0; 3], Border::Reflect, &progress).ok());
            }
        });
    });
    criterion.bench_function("blur_and_isosurface_8_gates", |bencher| {
        bencher.iter(|| {
            for values in &gates {
                black_box(blurred_surface(&frame, values, 1.0));
            }
        });
    });
    let (apex, base) = (
        Point3::new(200.0, 180.0, 10.0),
        Point3::new(180.0, 190.0, 100.0),
    );
    let turned = Reorientation::upright(apex, base, None).ok();
    let Some(turned) = turned.and_then(|turn| turn.turned_frame(&frame).ok()) else {
        return;
    };
    criterion.bench_function("reorient_one_gate", |bencher| {
        bencher.iter(|| {
            let sampler = Sampler::new(&turned, &gates[0])?;
            sampler.resampled(&frame, Interpolation::Linear, 0.0, &progress)
        });
    });
    let (Some(surface), Ok(params)) = (
        blurred_surface(&frame, &gates[0], 1.0),
        TaubinParams::default().check(),
    ) else {
        return;
    };
    let corners = surface.triangles().iter();
    let corners = corners.map(|face| face.map(|vertex| surface.vertices()[vertex as usize]));
    let enclosed_ml = signed_volume(corners, Point3::new(190.0, 180.0, 70.0)) / 1e3;
    eprintln!("isosurface of the first gate: {enclosed_ml:.2} ml");
    criterion.bench_function("taubin_one_gate", |bencher| {
        bencher.iter(|| taubin(&surface, &params, &progress));
    });
    criterion.bench_function("decimate_one_gate_to_2500", |bencher| {
        bencher.iter(|| decimated(&surface, 2_500, &progress));
    });
}

/// 16 landmarks and 40,962 points; the budget is 3 ms on two cores.
fn spline(criterion: &mut Criterion) {
    let sphere = phantom::sphere(6, 40.0);
    // On a spiral over the sphere, each with as much of it as the others.
    let landmark = |number: usize| {
        let z = 1.0 - (2 * number + 1) as f64 / 16.0;
        let angle = number as f64 * std::f64::consts::PI * (3.0 - 5_f64.sqrt());
        let around = (1.0 - z * z).sqrt();
        Point3::new(around * angle.cos(), around * angle.sin(), z) * 40.0
    };
    let landmarks: Vec<Point3> = (0..16).map(landmark).collect();
    let bend = |p: &Point3| Point3::new(p.x + 3.0 * (0.1 * p.y).sin(), p.y, 1.1 * p.z);
    let targets: Vec<Point3> = landmarks.iter().map(bend).collect();
    let moved = || {
        let spline = ThinPlateSpline::new(&landmarks, &targets, 0.0)?;
        Ok::<_, ThinPlateSplineError>(spline.apply_all(sphere.vertices()))
    };
    if let Ok(points) = moved() {
        let ways = points
            .iter()
            .zip(sphere.vertices())
            .map(|(p, q)| (p - q).norm());
        let mean = ways.sum::<f64>() / points.len() as f64;
        eprintln!("thin-plate spline: points are moved by {mean:.9} mm on average");
    }
    criterion.bench_function("thin_plate_spline_16_landmarks_40962_points", |bencher| {
        bencher.iter(moved);
    });
}

/// The files of the archives in a folder, written into another one; how many.
fn unpacked(archives: &Path, to: &Path) -> std::io::Result<usize> {
    let mut count = 0;
    for archive in fs::read_dir(archives)? {
        let bytes = fs::read(archive?.path())?;
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes))?;
        for index in 0..archive.len() {
            let mut file = archive.by_index(index)?;
            if file.is_dir() {
                continue;
            }
            std::io::copy(
                &mut file,
                &mut fs::File::create(to.join(count.to_string()))?,
            )?;
            count += 1;
        }
    }
    Ok(count)
}

/// 150 files of a cine study, one series a slice, to one stack of 25 volumes; the budget is 0.5 s on two cores.
fn opening(criterion: &mut Criterion) {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let shared = env::var_os("CARDIOMORPH_SHARED").map_or_else(beside, Into::into);
    let archives = shared.join("data/images/bivme_cine/sax_full");
    let Ok(folder) = tempfile::tempdir() else {
        return;
    };
    let Ok(150) = unpacked(&archives, folder.path()) else {
        eprintln!("skipped: {} does not hold 150 files", archives.display());
        return;
    };
    let paths = [folder.path().to_owned()];
    criterion.bench_function("open_150_dicom_files", |bencher| {
        bencher.iter(|| {
            let read = read_dicom(&paths, &Limits::default(), &Progress::default());
            read.map(|reading| reading.series.len())
        });
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = surfaces, spline, opening
}
criterion_main!(benches);
