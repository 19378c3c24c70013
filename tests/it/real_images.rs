//! Volume files of the shared folder: one phantom in 25 dialects, and masks and images of other programs, with the values that
//! their sources state.

use std::collections::BTreeMap;
use std::path::PathBuf;

use cardiomorph::io::{FoundImage, ImageSeries, Limits, Provenance, read_image_file, read_images};
use cardiomorph::mesh::{Point3, Vector3};
use cardiomorph::progress::Progress;

use crate::shared::shared_data;

/// All series below a place, by the names of their files; and what could not be read.
fn found(place: &str) -> (BTreeMap<String, ImageSeries>, Vec<String>) {
    let paths = [shared_data(place)];
    let (found, report) = read_images(&paths, &Limits::default(), &Progress::default()).unwrap();
    let named = |found: FoundImage| {
        let path: PathBuf = found.path.unwrap();
        (
            path.file_name().unwrap().to_str().unwrap().to_owned(),
            found.series,
        )
    };
    let errors = report.errors.iter().map(ToString::to_string).collect();
    (found.into_iter().map(named).collect(), errors)
}

fn read(place: &str) -> ImageSeries {
    read_image_file(&shared_data(place), &Limits::default()).unwrap()
}

/// Volume in millilitres and centroid in millimetres of a label.
fn region(series: &ImageSeries, phase: usize, label: f32) -> (f64, Point3) {
    let frame = series.image.frame();
    let [ni, nj, _] = frame.size();
    let (mut count, mut sum) = (0.0, Vector3::zeros());
    for (index, value) in series.image.volumes()[phase].iter().enumerate() {
        if *value == label {
            let (i, j, k) = (index % ni, index / ni % nj, index / (ni * nj));
            sum += frame
                .position(Point3::new(i as f64, j as f64, k as f64))
                .coords;
            count += 1.0;
        }
    }
    (count * frame.voxel_mm3() / 1e3, Point3::from(sum / count))
}

/// The corners of the grid, in whichever order the file stores its axes.
fn corners(series: &ImageSeries) -> Vec<Point3> {
    let frame = series.image.frame();
    let place = |corner: usize, axis: usize| {
        ((corner >> axis) & 1) as f64 * (frame.size()[axis] - 1) as f64
    };
    let corner = |c| frame.position(Point3::new(place(c, 0), place(c, 1), place(c, 2)));
    (0..8).map(corner).collect()
}

fn sums(series: &ImageSeries) -> Vec<f64> {
    let volumes = series.image.volumes().iter();
    volumes
        .map(|values| values.iter().map(|value| f64::from(*value)).sum())
        .collect()
}

fn range(series: &ImageSeries) -> [f32; 2] {
    let values = series
        .image
        .volumes()
        .iter()
        .flat_map(|volume| volume.iter());
    values.fold([f32::MAX, f32::MIN], |[low, high], value| {
        [low.min(*value), high.max(*value)]
    })
}

/// Phase by phase: millilitres of cavity, myocardium and marker, and their centroids.
const PHANTOM: [([f64; 3], [[f64; 3]; 3]); 4] = [
    (
        [75.294, 84.978, 5.220],
        [
            [24.23, -23.01, 46.03],
            [24.28, -23.07, 45.91],
            [55.11, 1.3, 44.47],
        ],
    ),
    (
        [66.456, 83.160, 6.120],
        [
            [24.23, -23.01, 46.05],
            [24.34, -23.14, 45.89],
            [54.54, 0.96, 44.29],
        ],
    ),
    (
        [50.076, 81.162, 7.200],
        [
            [24.23, -23.02, 46.01],
            [24.29, -23.09, 45.97],
            [53.65, 0.17, 44.29],
        ],
    ),
    (
        [42.804, 81.054, 7.560],
        [
            [24.16, -22.94, 46.03],
            [24.34, -23.14, 45.91],
            [53.47, -0.22, 44.54],
        ],
    ),
];

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn one_phantom_in_all_dialects_stands_in_one_place_with_one_volume() {
    let (series, errors) = found("images/volume_quirks");
    assert_eq!(errors.len(), 2, "{errors:?}");
    assert!(
        errors[0]
            .starts_with("the values of the voxels take 147840 bytes, but only 98560 are there")
    );
    assert!(errors[0].ends_with("broken_truncated.nii.gz"));
    assert!(errors[1].starts_with("holds colours, RGB24 (datatype 128)"));
    assert_eq!(series.len(), 23, "{:?}", series.keys());
    let expected_corners = corners(&series["lab_nifti2_i8.nii.gz"]);
    let origin = Point3::new(55.6826, 4.8177, 90.2618);
    assert!((expected_corners[0] - origin).norm() < 1e-3);
    for (name, one) in &series {
        if name == "odd_no_forms.nii.gz" {
            assert!(!one.position_known && one.spacing_known());
            assert!(
                (Vector3::from(one.image.frame().spacing()) - Vector3::new(2.0, 1.8, 5.0)).norm()
                    < 1e-6
            );
            continue;
        }
        assert!(
            one.position_known && one.spacing_known() && one.times_known(),
            "{name}"
        );
        for corner in corners(one) {
            let nearest = expected_corners.iter().map(|other| (corner - other).norm());
            assert!(nearest.fold(f64::MAX, f64::min) < 1e-3, "{name}: {corner}");
        }
        let phases = one.image.volumes().len();
        assert!(
            phases == 6 || (phases == 1 && (name.contains("_p0") || name.contains("_3d"))),
            "{name}"
        );
        if let Some(times) = one.image.times_ms() {
            for (phase, time) in times.iter().enumerate() {
                assert!(
                    (time - 140.0 * phase as f64).abs() < 1e-9,
                    "{name}: {times:?}"
                );
            }
        }
        if name.starts_with("lab_") {
            for phase in 0..phases {
                let (ml, centroids) = PHANTOM[phase.min(6 - phase)];
                for (region_of, label) in [1.0, 2.0, 4.0].into_iter().enumerate() {
                    let (own_ml, centroid) = region(one, phase, label);
                    let expected = Point3::from(centroids[region_of]);
                    assert!(
                        (own_ml - ml[region_of]).abs() < 1e-3,
                        "{name}, phase {phase}: {own_ml} ml"
                    );
                    assert!(
                        (centroid - expected).norm() < 0.01,
                        "{name}, phase {phase}: {centroid}"
                    );
                    let (_, exact) = region(&series["lab_nifti2_i8.nii.gz"], phase, label);
                    assert!(
                        (centroid - exact).norm() < 1e-3,
                        "{name}, phase {phase}: {centroid}"
                    );
                }
            }
            assert_eq!(range(one), [0.0, 4.0], "{name}");
            continue;
        }
        let times = if name.contains("u16") { 250.0 } else { 1.0 };
        let voxels = one.image.frame().voxel_count() as f64;
        let sums = sums(one);
        assert!((sums[0] / voxels / times - 73.7523).abs() < 1e-4, "{name}");
        if phases == 6 {
            let mean = sums.iter().sum::<f64>() / voxels / 6.0 / times;
            assert!((mean - 67.1043).abs() < 1e-4, "{name}: {mean}");
            assert_eq!(range(one), [0.0, 242.0 * times as f32], "{name}");
        } else {
            assert_eq!(range(one), [0.0, 237.0], "{name}");
        }
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn free_text_of_headers_reaches_nothing_that_is_kept() {
    let (series, errors) = found("images/volume_quirks");
    let all = format!(
        "{:?} {errors:?}",
        series
            .values()
            .map(|one| (&one.name, &one.notices))
            .collect::<Vec<_>>()
    );
    assert!(!all.contains("SEEDED"), "{all}");
}

/// One file: where, size, volumes, minimum and maximum, and the sum of each volume.
type Row = (&'static str, [usize; 3], [f32; 2], &'static [f64]);

/// Sums that were computed from the stored numbers and the scaling of each header, by a program of a few lines.
const FILES: [Row; 8] = [
    (
        "acdc/patient090/patient090_4d.nii.gz",
        [154, 224, 7],
        [0.0, 255.0],
        &[
            13418216.0, 13426133.0, 13427034.0, 13404078.0, 13410262.0, 13411742.0, 13405937.0,
            13390947.0, 13368540.0, 13364951.0, 13388746.0, 13413365.0,
        ],
    ),
    (
        "acdc/patient090/patient090_frame04_gt.nii.gz",
        [154, 224, 7],
        [0.0, 3.0],
        &[17889.0],
    ),
    (
        "acdc/patient001/patient001_frame01.nii.gz",
        [216, 256, 10],
        [0.0, 658.0],
        &[43101591.0],
    ),
    (
        "gated_spect/nifti/Patient000151_rest_image.nii.gz",
        [32, 32, 32],
        [0.0, 104.68304],
        &[
            749544.0960693061,
            922904.5430331826,
            1088653.9173846543,
            1061119.4048571885,
            895964.4659503102,
            804979.7170165181,
            788008.749282062,
            495858.5070461631,
        ],
    ),
    (
        "gated_spect/nifti/Patient000164_rest_epi.nii.gz",
        [32, 32, 32],
        [0.0, 1.0],
        &[
            26387.0, 24423.0, 22056.0, 21429.0, 22314.0, 24046.0, 24793.0, 25127.0,
        ],
    ),
    (
        "images/gated_spect_dicom/p1/truth_endo.nii.gz",
        [32, 32, 32],
        [0.0, 1.0],
        &[
            3714.0, 2725.0, 1623.0, 1441.0, 2006.0, 2671.0, 2896.0, 3300.0,
        ],
    ),
    (
        "images/gated_spect_dicom/p2/truth_endo.nii.gz",
        [32, 32, 32],
        [0.0, 1.0],
        &[1581.0, 829.0, 464.0, 464.0, 899.0, 1297.0, 1212.0, 1633.0],
    ),
    (
        "images/acdc_cine_dicom/truth_ed_phase4.nii.gz",
        [88, 88, 7],
        [0.0, 3.0],
        &[17889.0],
    ),
];

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn sizes_ranges_and_sums_are_those_of_the_files() {
    for (place, size, expected_range, expected_sums) in FILES {
        let series = read(place);
        assert_eq!(series.image.frame().size(), size, "{place}");
        assert_eq!(range(&series), expected_range, "{place}");
        let sums = sums(&series);
        assert_eq!(sums.len(), expected_sums.len(), "{place}");
        for (sum, expected) in sums.iter().zip(expected_sums) {
            assert!((sum - expected).abs() <= 1e-6 * expected, "{place}: {sum}");
        }
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn what_files_do_not_say_is_told() {
    let spect = read("gated_spect/nifti/Patient000151_rest_image.nii.gz");
    assert!(!spect.spacing_known() && !spect.times_known() && !spect.position_known);
    let acdc = read("acdc/patient090/patient090_4d.nii.gz");
    assert_eq!(
        (acdc.spacing, acdc.times),
        (Provenance::UnitAssumed, Provenance::Missing)
    );
    assert!(!acdc.position_known);
    assert!((acdc.image.frame().spacing()[2] - 10.0).abs() < 1e-9);
    assert!(
        acdc.notices
            .iter()
            .any(|note| note.text.contains("directions without steps"))
    );
    let wrap = read("images/gated_spect_dicom/p1/truth_endo.nii.gz");
    assert_eq!(
        (wrap.spacing, wrap.times),
        (Provenance::Stated, Provenance::Stated)
    );
    assert!(wrap.position_known);
    let times = wrap.image.times_ms().unwrap();
    assert!((times[7] - 7.0 * 107.1).abs() < 1.0, "{times:?}");
    // Voxels of 3.3 mm, and the first millilitres of the table in SOURCE.md.
    assert!((region(&wrap, 0, 1.0).0 - 133.5).abs() < 0.05);
    let origin = Point3::new(70.321, -98.008, 72.104);
    assert!((wrap.image.frame().origin() - origin).norm() < 1e-3);
}

/// All 100 masks at end-diastole and end-systole: the cavity has the millilitres of `subjects.csv`.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn cavities_of_all_acdc_masks_have_the_volumes_of_the_table() {
    let table = std::fs::read_to_string(shared_data("acdc/subjects.csv")).unwrap();
    let mut lines = table.lines();
    let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
    let mut masks = 0;
    for line in lines {
        let fields: Vec<&str> = line.split(',').collect();
        let field = |name: &str| fields[heads.iter().position(|head| *head == name).unwrap()];
        let patient = field("patient");
        if !shared_data("acdc").join(patient).exists() {
            continue;
        }
        for (frame, ml) in [("ED", "LV_ED_ml"), ("ES", "LV_ES_ml")] {
            let frame: usize = field(frame).parse().unwrap();
            let mask = read(&format!(
                "acdc/{patient}/{patient}_frame{frame:02}_gt.nii.gz"
            ));
            let expected: f64 = field(ml).parse().unwrap();
            let (own, _) = region(&mask, 0, 3.0);
            assert!(
                (own - expected).abs() < 0.051,
                "{patient}, frame {frame}: {own} ml, not {expected}"
            );
            masks += 1;
        }
    }
    assert_eq!(masks, 200);
}
