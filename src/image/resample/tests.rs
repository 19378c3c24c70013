//! What is read between voxels.

use proptest::prelude::*;

use super::*;

fn tilted(size: [usize; 3]) -> VolumeFrame {
    let steps = [
        Vector3::new(0.1, 1.5, 0.1),
        Vector3::new(-1.2, 0.0, 0.2),
        Vector3::new(0.3, 0.0, 8.0),
    ];
    VolumeFrame::new(size, Point3::new(10.0, -20.0, 30.0), steps).unwrap()
}

/// A linear function of the world.
fn plane(p: Point3) -> f64 {
    0.5 * p.x - 0.25 * p.y + 2.0 * p.z + 3.0
}

fn sampled(frame: &VolumeFrame) -> Vec<f32> {
    let [nx, ny, _] = frame.size();
    let place = |v: usize| Point3::new((v % nx) as f64, (v / nx % ny) as f64, (v / nx / ny) as f64);
    (0..frame.voxel_count())
        .map(|v| plane(frame.position(place(v))) as f32)
        .collect()
}

#[test]
fn a_volume_on_its_own_grid_is_itself() {
    let frame = tilted([5, 4, 3]);
    let values: Vec<f32> = (0..60).map(|v| ((v * 31) % 17) as f32).collect();
    let sampler = Sampler::new(&frame, &values).unwrap();
    for interpolation in [Interpolation::Linear, Interpolation::Nearest] {
        let found = sampler
            .resampled(&frame, interpolation, -1.0, &Progress::default())
            .unwrap();
        for (found, value) in found.iter().zip(&values) {
            assert!((found - value).abs() < 1e-5);
        }
    }
}

#[test]
fn padding_is_mixed_into_nothing() {
    let frame = VolumeFrame::new(
        [3, 2, 1],
        Point3::origin(),
        [Vector3::x(), Vector3::y(), Vector3::z()],
    );
    let frame = frame.unwrap();
    let values = [1.0, 2.0, f32::NAN, 3.0, 4.0, f32::NAN];
    let sampler = Sampler::new(&frame, &values).unwrap();
    let at = |x: f64, y: f64| sampler.at(Point3::new(x, y, 0.0));
    assert_eq!(at(1.0, 0.5), Some(3.0));
    assert_eq!(at(0.5, 0.0), Some(1.5));
    assert!(at(1.0 + 1e-6, 0.5).unwrap().is_nan());
    assert_eq!(at(-0.1, 0.0), None);
    assert_eq!(at(1.0, 1.0 + 1e-12), Some(4.0));
    assert_eq!(sampler.at(Point3::new(0.0, 0.0, 0.1)), None);
    assert_eq!(sampler.at(Point3::new(f64::NAN, 0.0, 0.0)), None);
    let found = sampler
        .resampled(&frame, Interpolation::Linear, 0.0, &Progress::default())
        .unwrap();
    assert_eq!(found[..2], [1.0, 2.0]);
    assert!(found[2].is_nan() && found[5].is_nan());
}

#[test]
fn labels_reach_half_a_voxel_and_are_never_between() {
    let frame = VolumeFrame::new(
        [2, 1, 1],
        Point3::origin(),
        [Vector3::x(), Vector3::y(), Vector3::z() * 8.0],
    );
    let frame = frame.unwrap();
    let fine = VolumeFrame::new(
        [40, 1, 1],
        Point3::new(-0.97, 0.0, 3.0),
        [Vector3::x() * 0.075, Vector3::y(), Vector3::z()],
    );
    let sampler = Sampler::new(&frame, &[2.0, 3.0]).unwrap();
    let found = sampler
        .resampled(
            &fine.unwrap(),
            Interpolation::Nearest,
            0.0,
            &Progress::default(),
        )
        .unwrap();
    assert!(found.iter().all(|v| [0.0, 2.0, 3.0].contains(v)));
    let count = |label| found.iter().filter(|&&v| v == label).count();
    assert_eq!((count(2.0), count(3.0)), (13, 13));
}

#[test]
fn what_is_too_large_or_stopped_says_so() {
    let frame = tilted([2, 2, 2]);
    assert_eq!(
        Sampler::new(&frame, &[0.0; 7]).unwrap_err(),
        ResampleError::Count {
            values: 7,
            voxels: 8
        }
    );
    let values = [0.0; 8];
    let sampler = Sampler::new(&frame, &values).unwrap();
    let progress = Progress::default();
    let huge = tilted([1 << 14, 1 << 14, 2]);
    let error = sampler.resampled(&huge, Interpolation::Linear, 0.0, &progress);
    assert_eq!(error, Err(ResampleError::TooLarge { voxels: 1 << 29 }));
    progress.stop();
    let stopped = sampler.resampled(&frame, Interpolation::Linear, 0.0, &progress);
    assert_eq!(stopped, Err(ResampleError::Stopped(Stopped)));
}

proptest! {
    #[test]
    fn a_linear_function_is_read_exactly_and_on_any_grid(place in prop::array::uniform3(0.0..1.0_f64)) {
        let frame = tilted([6, 5, 4]);
        let values = sampled(&frame);
        let sampler = Sampler::new(&frame, &values).unwrap();
        let position = frame.position(Point3::new(5.0 * place[0], 4.0 * place[1], 3.0 * place[2]));
        prop_assert!((sampler.at(position).unwrap() - plane(position)).abs() < 1e-4);
        let other = VolumeFrame::new([3, 3, 3], position, [Vector3::x(), Vector3::y() * 0.5, Vector3::z()]).unwrap();
        let found = sampler.resampled(&other, Interpolation::Linear, f32::NAN, &Progress::default()).unwrap();
        for (voxel, value) in found.iter().enumerate().filter(|(_, value)| !value.is_nan()) {
            let at = Point3::new((voxel % 3) as f64, (voxel / 3 % 3) as f64, (voxel / 9) as f64);
            prop_assert!((f64::from(*value) - plane(other.position(at))).abs() < 1e-4);
        }
    }
}
