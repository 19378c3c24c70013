//! Gated counts of a patient are the same numbers in the same places, whether they come as NIfTI or as DICOM.

use cardiomorph::analysis::surface_extraction::isosurface;
use cardiomorph::image::{Border, Image, gaussian_blur};
use cardiomorph::io::{ImageSeries, Limits, read_dicom, read_image, read_image_file};
use cardiomorph::mesh::{Point3, TriMesh};
use cardiomorph::progress::Progress;

use crate::shared::shared_data;

const SIZE: usize = 32;
/// Where the axis of the fan of long-axis planes stands among their columns.
const AXIS: f64 = 16.0;

/// A patient: the published fan of planes, the DICOM file made of it, counts of the file for one of the fan, and whether
/// its rows run the other way.
const PATIENTS: [(&str, &str, f64, bool); 4] = [
    ("Patient000164_rest", "p1/IM000003", 20.0, false),
    ("Patient000151_stress", "p2/gated_rle.dcm", 40.0, true),
    ("Patient000151_stress", "p2/gated_timefast.dcm", 40.0, true),
    ("Patient000151_stress", "p2/gated_nogeom.dcm", 40.0, true),
];

fn dicom(place: &str) -> ImageSeries {
    let paths = [shared_data(&format!("images/gated_spect_dicom/{place}"))];
    let mut reading = read_dicom(&paths, &Limits::default(), &Progress::default()).unwrap();
    assert_eq!(reading.series.len(), 1, "{place}");
    reading.series.remove(0)
}

fn nifti(place: &str) -> ImageSeries {
    read_image_file(&shared_data(place), &Limits::default()).unwrap()
}

/// The value of a fan (long axis, column, plane; 180° in 32 planes) at a place in the slice `k`, in voxels from the axis;
/// linear between columns and planes, nothing beyond the columns.
fn of_fan(fan: &[f32], k: usize, [x, y]: [f64; 2]) -> f64 {
    let half = std::f64::consts::PI;
    let angle = y.atan2(x).rem_euclid(2.0 * half);
    let (angle, radius) = match angle >= half {
        true => (angle - half, -x.hypot(y)),
        false => (angle, x.hypot(y)),
    };
    let column = |plane: usize, radius: f64| {
        let at = AXIS + radius;
        let value = |column: f64| f64::from(fan[k + SIZE * (column as usize + SIZE * plane)]);
        let (low, part) = (at.floor(), at - at.floor());
        match (0.0..=31.0).contains(&at) {
            true if part > 0.0 => value(low) * (1.0 - part) + value(low + 1.0) * part,
            true => value(low),
            false => 0.0,
        }
    };
    let plane = angle / (half / SIZE as f64);
    let (low, part) = (
        plane.floor().min(31.0) as usize,
        plane - plane.floor().min(31.0),
    );
    // After the last plane comes the first, turned by 180°.
    let next = match low {
        31 => column(0, -radius),
        low => column(low + 1, radius),
    };
    column(low, radius) * (1.0 - part) + next * part
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn counts_in_dicom_are_those_of_the_published_planes() {
    for (patient, file, times, upside_down) in PATIENTS {
        let planes = nifti(&format!("gated_spect/nifti/{patient}_image.nii.gz"));
        let counts = dicom(file);
        assert_eq!(counts.image.frame().size(), [SIZE; 3], "{file}");
        assert_eq!(counts.image.volumes().len(), planes.image.volumes().len());
        let mut compared = 0;
        for (gate, fan) in planes.image.volumes().iter().enumerate() {
            let volume = &counts.image.volumes()[gate];
            for (voxel, count) in volume.iter().enumerate() {
                let [i, j, k] = [voxel % SIZE, voxel / SIZE % SIZE, voxel / (SIZE * SIZE)];
                let row = if upside_down { SIZE - 1 - j } else { j };
                let place = [i as f64 - AXIS, row as f64 - AXIS];
                // The rim of the fan was cut in its own way.
                if place[0].hypot(place[1]) < 15.0 {
                    let expected = times * of_fan(fan, k, place);
                    // A count is a whole number; the fan is stored in steps of a 255th of its highest.
                    let off = (f64::from(*count) - expected).abs();
                    assert!(off < 0.53, "{file}, gate {gate}: {count}, not {expected}");
                    compared += 1;
                }
            }
        }
        assert!(compared > 8 * 20_000, "{compared}");
    }
}

/// The image as a NIfTI-1 file: 32-bit numbers, its place by the sform, its times in milliseconds.
fn as_nifti(image: &Image) -> Vec<u8> {
    let frame = image.frame();
    let size = frame.size().map(|n| n as i16);
    let gates = image.volumes().len() as i16;
    let times = image.times_ms().unwrap();
    let mut bytes = vec![0; 352];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, &348_i32.to_le_bytes());
    let dim = [4, size[0], size[1], size[2], gates, 1, 1, 1];
    put(40, &dim.map(i16::to_le_bytes).concat());
    put(70, &[16_i16, 32].map(i16::to_le_bytes).concat());
    let [x, y, z] = frame.spacing();
    let pixdim = [1.0, x, y, z, times[1] - times[0], 1.0, 1.0, 1.0];
    put(76, &pixdim.map(|mm| (mm as f32).to_le_bytes()).concat());
    put(108, &352_f32.to_le_bytes());
    put(123, &[2 | 16]);
    put(254, &1_i16.to_le_bytes());
    // To the right and to the front are negative in DICOM.
    for (axis, sign) in [-1.0, -1.0, 1.0].into_iter().enumerate() {
        let steps = frame.steps().map(|step| step[axis]);
        let row = [steps[0], steps[1], steps[2], frame.origin()[axis]];
        let row = row.map(|mm| ((sign * mm) as f32).to_le_bytes());
        put(280 + 16 * axis, &row.concat());
    }
    put(344, b"n+1\0");
    bytes.extend(
        image
            .volumes()
            .iter()
            .flat_map(|volume| volume.iter().flat_map(|v| v.to_le_bytes())),
    );
    bytes
}

fn corners(image: &Image) -> Vec<Point3> {
    let far = (SIZE - 1) as f64;
    let place = |corner: usize, axis: usize| ((corner >> axis) & 1) as f64 * far;
    let corner = |c| {
        image
            .frame()
            .position(Point3::new(place(c, 0), place(c, 1), place(c, 2)))
    };
    (0..8).map(corner).collect()
}

fn surface(image: &Image, gate: usize) -> TriMesh {
    let (progress, values) = (Progress::default(), &image.volumes()[gate]);
    let blurred = gaussian_blur([SIZE; 3], values, [1.0; 3], Border::Reflect, &progress).unwrap();
    let highest = blurred.iter().copied().fold(0.0, f32::max);
    isosurface(image.frame(), &blurred, f64::from(highest) / 2.0, &progress).unwrap()
}

/// Grid, numbers, times, and the surfaces that are made of them.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_gated_study_is_the_same_image_from_dicom_and_written_again_as_nifti() {
    for file in ["p1/IM000003", "p2/gated_rle.dcm", "p2/gated_timefast.dcm"] {
        let ours = dicom(file).image;
        let none = |_: &str| Err("there is no such file".to_owned());
        let again = read_image("again.nii", &as_nifti(&ours), &Limits::default(), &none).unwrap();
        assert!(again.position_known && again.spacing_known() && again.times_known());
        let again = again.image;
        assert_eq!(again.volumes(), ours.volumes(), "{file}");
        for (own, other) in corners(&ours).iter().zip(corners(&again)) {
            assert!((own - other).norm() < 1e-4, "{file}: {own} {other}");
        }
        for (own, other) in ours
            .times_ms()
            .unwrap()
            .iter()
            .zip(again.times_ms().unwrap())
        {
            assert!((own - other).abs() < 1e-3, "{file}: {own} {other}");
        }
        for gate in 0..8 {
            let (own, other) = (surface(&ours, gate), surface(&again, gate));
            assert_eq!(own.triangles(), other.triangles(), "{file}, gate {gate}");
            assert!(own.vertices().len() > 500, "{file}, gate {gate}");
            for (a, b) in own.vertices().iter().zip(other.vertices()) {
                assert!((a - b).norm() < 1e-4, "{file}, gate {gate}: {a} {b}");
            }
        }
    }
}

/// The masks that come as NIfTI lie on the grid of the counts that come as DICOM, and the wall is brighter than the cavity.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn masks_in_nifti_lie_on_the_counts_in_dicom() {
    for (file, folder) in [("p1/IM000003", "p1"), ("p2/gated_rle.dcm", "p2")] {
        let counts = dicom(file).image;
        let mask = |part: &str| {
            nifti(&format!(
                "images/gated_spect_dicom/{folder}/truth_{part}.nii.gz"
            ))
            .image
        };
        let (endo, epi) = (mask("endo"), mask("epi"));
        for (own, other) in corners(&counts).iter().zip(corners(&endo)) {
            assert!((own - other).norm() < 2e-3, "{file}: {own} {other}");
        }
        for (own, other) in counts
            .times_ms()
            .unwrap()
            .iter()
            .zip(endo.times_ms().unwrap())
        {
            assert!((own - other).abs() < 0.01, "{file}: {own} {other}");
        }
        for gate in 0..8 {
            let of = |image: &Image, voxel: usize| image.volumes()[gate][voxel] > 0.0;
            let mean = |cavity: bool| {
                let voxels =
                    (0..SIZE.pow(3)).filter(|&voxel| of(&epi, voxel) && of(&endo, voxel) == cavity);
                let counts: Vec<f64> = voxels
                    .map(|voxel| f64::from(counts.volumes()[gate][voxel]))
                    .collect();
                counts.iter().sum::<f64>() / counts.len() as f64
            };
            let (cavity, wall) = (mean(true), mean(false));
            assert!(wall > 1.5 * cavity, "{file}, gate {gate}: {wall}, {cavity}");
        }
    }
}

/// One study in three files of other codecs and orders, one of them without a place, holds the same numbers.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn orders_and_codecs_of_one_study_change_no_number() {
    let first = dicom("p2/gated_rle.dcm");
    for file in ["p2/gated_timefast.dcm", "p2/gated_nogeom.dcm"] {
        let other = dicom(file);
        assert_eq!(other.image.volumes(), first.image.volumes(), "{file}");
        assert_eq!(other.image.times_ms(), first.image.times_ms(), "{file}");
        let placed = file.contains("timefast");
        assert_eq!(other.position_known, placed, "{file}");
        assert_eq!(other.image.frame() == first.image.frame(), placed, "{file}");
    }
}
