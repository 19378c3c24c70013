//! What a blur must and must not do.

use proptest::prelude::*;

use super::*;
use crate::image::VolumeFrame;
use crate::mesh::{Point3, Vector3};

fn blur(size: [usize; 3], values: &[f32], sigma: [f64; 3], border: Border) -> Vec<f32> {
    gaussian_blur(size, values, sigma, border, &Progress::default()).unwrap()
}

fn ramp(size: [usize; 3]) -> Vec<f32> {
    let count: usize = size.iter().product();
    (0..count).map(|v| ((v * 7919) % 101) as f32).collect()
}

/// One voxel after the other, all weights at once.
fn plainly(size: [usize; 3], values: &[f32], sigma: [f64; 3], border: Border) -> Vec<f64> {
    let [nx, ny, nz] = size.map(|n| n as i64);
    let kernels = sigma.map(half_kernel);
    let blur = Blur {
        size,
        kernels: kernels.clone(),
        border,
    };
    let radius = [0, 1, 2].map(|axis| kernels[axis].len() as i64 - 1);
    let mut found = Vec::new();
    for (k, j, i) in
        (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| (k, j, i))))
    {
        let mut sum = 0.0;
        for c in -radius[2]..=radius[2] {
            for b in -radius[1]..=radius[1] {
                for a in -radius[0]..=radius[0] {
                    let [i, j, k] = [
                        blur.source(i + a, size[0]),
                        blur.source(j + b, size[1]),
                        blur.source(k + c, size[2]),
                    ];
                    let weight: f64 = ([a, b, c].iter().zip(&kernels))
                        .map(|(t, kernel)| kernel[t.unsigned_abs() as usize])
                        .product();
                    sum += weight * f64::from(values[i + size[0] * (j + size[1] * k)]);
                }
            }
        }
        found.push(sum);
    }
    found
}

#[test]
fn axis_by_axis_is_the_sum_over_all_neighbours() {
    // Small axes: mirrored more than once.
    for size in [[11, 3, 2], [1, 9, 1], [9, 2, 5]] {
        for border in [Border::Reflect, Border::Nearest] {
            let (values, sigma) = (ramp(size), [1.2, 0.7, 1.0]);
            let expected = plainly(size, &values, sigma, border);
            for (found, expected) in blur(size, &values, sigma, border).iter().zip(expected) {
                assert!(
                    (f64::from(*found) - expected).abs() < 2e-5,
                    "{size:?} {border:?}"
                );
            }
        }
    }
}

#[test]
fn a_mirrored_border_keeps_the_sum_and_a_width_of_zero_everything() {
    let size = [13, 8, 5];
    let values = ramp(size);
    assert_eq!(blur(size, &values, [0.0; 3], Border::Reflect), values);
    let sum = |values: &[f32]| values.iter().map(|&v| f64::from(v)).sum::<f64>();
    let blurred = blur(size, &values, [2.0, 1.0, 3.0], Border::Reflect);
    assert!((sum(&blurred) / sum(&values) - 1.0).abs() < 1e-6);
}

#[test]
fn missing_values_stay_missing_and_are_mixed_into_nothing() {
    let size = [9, 9, 3];
    let mut values = vec![5.0_f32; 243];
    values[120] = f32::NAN;
    values[3] = f32::INFINITY;
    for (voxel, value) in blur(size, &values, [1.5, 1.5, 0.5], Border::Reflect)
        .iter()
        .enumerate()
    {
        match voxel {
            120 => assert!(value.is_nan()),
            3 => assert_eq!(*value, f32::INFINITY),
            _ => assert!((value - 5.0).abs() < 1e-5, "{voxel}: {value}"),
        }
    }
    let nothing = blur([2, 2, 2], &[f32::NAN; 8], [1.0; 3], Border::Nearest);
    assert!(nothing.iter().all(|v| v.is_nan()));
    let greatest = blur([2, 2, 2], &[f32::MAX; 8], [1.0; 3], Border::Nearest);
    assert!(greatest.iter().all(|&v| v >= 0.999_999 * f32::MAX));
}

#[test]
fn widths_that_are_none_are_refused_and_a_stopped_blur_says_so() {
    let values = [0.0; 8];
    let progress = Progress::default();
    let with = |sigma| {
        gaussian_blur(
            [2, 2, 2],
            &values,
            [1.0, sigma, 1.0],
            Border::Reflect,
            &progress,
        )
    };
    for wrong in [-1.0, f64::INFINITY, 256.1] {
        assert_eq!(with(wrong), Err(BlurError::Sigma(wrong)));
    }
    assert!(matches!(with(f64::NAN), Err(BlurError::Sigma(_))));
    assert!(with(256.0).is_ok());
    let count = gaussian_blur(
        [usize::MAX, 2, 2],
        &values,
        [1.0; 3],
        Border::Reflect,
        &progress,
    );
    assert!(matches!(count, Err(BlurError::Count { values: 8, .. })));
    progress.stop();
    assert_eq!(with(1.0), Err(BlurError::Stopped(Stopped)));
}

#[test]
fn millimetres_are_those_of_each_axis_and_times_stay() {
    let steps = [
        Vector3::new(0.0, 2.0, 0.0),
        Vector3::new(1.0, 0.0, 0.0),
        Vector3::new(0.0, 0.0, 8.0),
    ];
    let frame = VolumeFrame::new([7, 6, 5], Point3::origin(), steps).unwrap();
    let volumes: Vec<Arc<[f32]>> = vec![ramp([7, 6, 5]).into(), vec![1.0; 210].into()];
    let image = Image::new(frame, volumes.clone(), Some(vec![0.0, 40.0])).unwrap();
    let progress = Progress::default();
    let blurred = blurred_image(&image, 2.0, Border::Reflect, &progress).unwrap();
    assert_eq!(blurred.times_ms(), image.times_ms());
    let expected = blur([7, 6, 5], &volumes[0], [1.0, 2.0, 0.25], Border::Reflect);
    assert_eq!(blurred.volumes()[0].as_ref(), expected);
    assert!(blurred_image(&image, f64::NAN, Border::Reflect, &progress).is_err());
}

proptest! {
    #[test]
    fn a_blur_stays_between_least_and_greatest_and_threads_change_nothing(
        values in prop::collection::vec(-1e3..1e3_f32, 5 * 4 * 3),
        sigma in prop::array::uniform3(0.0..3.0_f64),
    ) {
        let with = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| blur([5, 4, 3], &values, sigma, Border::Reflect))
        };
        let found = with(1);
        prop_assert_eq!(&found, &with(3));
        let range = |values: &[f32]| values.iter().fold([f32::MAX, f32::MIN], |[a, b], &v| [a.min(v), b.max(v)]);
        let ([low, high], [least, greatest]) = (range(&values), range(&found));
        prop_assert!(least >= low - 1e-3 && greatest <= high + 1e-3);
    }
}
