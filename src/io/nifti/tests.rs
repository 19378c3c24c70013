//! NIfTI by hand: layouts, orders, codes, units, scaling, axes, and what is refused.

use std::collections::BTreeMap;

use crate::io::Provenance;
use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::image_samples::{Nifti, counted_up, gzipped, read, read_beside, says, values};
use crate::mesh::{Point3, Vector3};

fn numbers(from: usize, to: usize) -> Vec<f32> {
    (from..to).map(|number| number as f32).collect()
}

#[test]
fn both_layouts_in_both_orders_hold_one_image() {
    let expected = Nifti::default().read().unwrap();
    assert_eq!(values(&expected), [numbers(0, 12), numbers(12, 24)]);
    assert_eq!(expected.image.times_ms(), Some(&[0.0, 250.0][..]));
    assert_eq!(expected.image.frame().size(), [2, 3, 2]);
    // RAS to LPS: x and y change their sign.
    assert_eq!(
        expected.image.frame().origin(),
        Point3::new(-10.0, -20.0, 30.0)
    );
    assert_eq!(
        expected.image.frame().steps()[0],
        Vector3::new(0.0, -2.0, 0.0)
    );
    assert_eq!(
        expected.image.frame().steps()[1],
        Vector3::new(3.0, 0.0, 0.0)
    );
    assert!(
        expected.position_known && expected.notices.is_empty(),
        "{:?}",
        expected.notices
    );
    for (two, order) in [
        (false, ByteOrder::Big),
        (true, ByteOrder::Little),
        (true, ByteOrder::Big),
    ] {
        let file = Nifti {
            two,
            order,
            offset: if two { 544.0 } else { 352.0 },
            values: counted_up(24, Scalar::I16, order),
            ..Nifti::default()
        };
        let own = file.read().unwrap();
        assert_eq!(own.image, expected.image, "{two} {order:?}");
        assert_eq!(own.format, if two { "NIfTI-2" } else { "NIfTI-1" });
        assert!(!format!("{own:?}").contains("SEEDED"));
    }
}

#[test]
fn packing_is_seen_by_content_and_not_by_name() {
    let file = Nifti::default();
    let expected = file.read().unwrap();
    assert_eq!(read("a.nii.gz", &file.bytes()).unwrap(), expected);
    assert_eq!(read("a.nii", &gzipped(&file.bytes())).unwrap(), expected);
    assert_eq!(read("a", &gzipped(&file.bytes())).unwrap(), expected);
}

#[test]
fn a_pair_is_read_with_the_file_beside_it() {
    let file = Nifti {
        pair: true,
        offset: 0.0,
        ..Nifti::default()
    };
    let expected = Nifti::default().read().unwrap();
    let header = file.bytes();
    for (name, values) in [
        ("a.img", file.values.clone()),
        ("a.img.gz", gzipped(&file.values)),
        ("a.IMG", file.values.clone()),
    ] {
        let others = BTreeMap::from([(name, values)]);
        assert_eq!(
            read_beside("a.hdr", &header, &others).unwrap(),
            expected,
            "{name}"
        );
    }
    let text = read("a.hdr", &header).unwrap_err().to_string();
    assert!(text.ends_with("there is no such file"), "{text}");
    let text = read("a.nii", &header).unwrap_err().to_string();
    assert!(text.ends_with("does not end in .hdr"), "{text}");
}

#[test]
fn codes_choose_the_matrix() {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    // A quarter turn about z, and an offset.
    let both = Nifti {
        codes: [1, 2],
        quaternion: [0.0, 0.0, half, 1.0, 2.0, 3.0],
        ..Nifti::default()
    };
    let sform = both.read().unwrap();
    assert_eq!(
        sform.image.frame().origin(),
        Point3::new(-10.0, -20.0, 30.0)
    );
    assert!(says(&sform, "mm from where the sform does"));
    let qform = Nifti {
        codes: [1, 0],
        ..both.clone()
    };
    for (qfac, third) in [(1.0, 5.0), (0.0, 5.0), (-1.0, -5.0)] {
        let mut qform = qform.clone();
        qform.pixdim[0] = qfac;
        let qform = qform.read().unwrap();
        let frame = qform.image.frame();
        assert_eq!(frame.origin(), Point3::new(-1.0, -2.0, 3.0));
        let expected = [
            Vector3::new(0.0, -2.0, 0.0),
            Vector3::new(3.0, 0.0, 0.0),
            Vector3::new(0.0, 0.0, third),
        ];
        for (step, expected) in frame.steps().iter().zip(expected) {
            assert!((step - expected).norm() < 1e-6, "{step} {expected}");
        }
        assert!(qform.position_known);
    }
    let neither = Nifti {
        codes: [0, 0],
        ..both
    };
    let neither = neither.read().unwrap();
    assert!(!neither.position_known && neither.spacing == Provenance::Stated);
    assert_eq!(neither.image.frame().spacing(), [2.0, 3.0, 5.0]);
}

#[test]
fn a_matrix_that_spans_nothing_is_an_error_whatever_else_is_there() {
    let file = Nifti {
        codes: [1, 1],
        srow: [0.0; 12],
        ..Nifti::default()
    };
    assert!(
        file.refused()
            .starts_with("sform: the directions of the voxels span no volume")
    );
    let file = Nifti {
        codes: [1, 0],
        quaternion: [1.0, 1.0, 0.0, 0.0, 0.0, 0.0],
        ..Nifti::default()
    };
    assert_eq!(file.refused(), "qform: its quaternion is no rotation");
    let file = Nifti {
        srow: [f64::NAN; 12],
        ..Nifti::default()
    };
    assert!(file.refused().contains("not finite"));
    let mut file = Nifti {
        codes: [1, 0],
        ..Nifti::default()
    };
    file.pixdim[2] = 0.0;
    assert!(file.refused().starts_with("qform: the directions"));
}

#[test]
fn lengths_and_times_are_in_the_units_of_the_file() {
    let with = |units| {
        Nifti {
            units,
            ..Nifti::default()
        }
        .read()
        .unwrap()
    };
    let near = |a: f64, b: f64| (a - b).abs() < 1e-9 * b.abs();
    assert!(near(with(1 | 8).image.frame().spacing()[2], 5e3));
    assert!(near(with(3 | 8).image.frame().origin().z, 0.03));
    assert_eq!(with(2 | 16).image.times_ms(), Some(&[0.0, 0.25][..]));
    assert!(near(with(2 | 24).image.times_ms().unwrap()[1], 0.25e-3));
    let unknown = with(0);
    assert_eq!(
        (unknown.spacing, unknown.times),
        (Provenance::UnitAssumed, Provenance::UnitAssumed)
    );
    assert!(says(&unknown, "millimetres assumed") && says(&unknown, "taken as seconds"));
    let hertz = with(2 | 32);
    assert!(!hertz.times_known() && says(&hertz, "not one of time"));
}

#[test]
fn spacing_that_no_one_gave_is_told() {
    let mut file = Nifti {
        srow: [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
        units: 0,
        ..Nifti::default()
    };
    file.pixdim = [1.0; 8];
    let ones = file.read().unwrap();
    assert!(!ones.spacing_known() && !ones.position_known && !ones.times_known());
    file.units = 2;
    assert_eq!(file.read().unwrap().spacing, Provenance::Stated);
    // Directions where steps should be.
    file.pixdim = [1.0, 1.5, 1.5, 10.0, 1.0, 1.0, 1.0, 1.0];
    let directions = file.read().unwrap();
    assert_eq!(directions.image.frame().spacing(), [1.5, 1.5, 10.0]);
    assert!(says(&directions, "directions without steps"));
    file.srow[0] = 2.0;
    let differ = file.read().unwrap();
    assert_eq!(differ.image.frame().spacing(), [2.0, 1.0, 1.0]);
    assert!(says(
        &differ,
        "2 × 1 × 1 by the sform, which is used, and 1.5 × 1.5 × 10 by pixdim"
    ));
    file.codes = [0, 0];
    file.pixdim[3] = 0.0;
    let missing = file.read().unwrap();
    assert!(!missing.spacing_known() && missing.image.frame().spacing()[2] == 1.0);
}

#[test]
fn slope_and_intercept_hold_only_together() {
    let with = |scaling| Nifti {
        scaling,
        ..Nifti::default()
    };
    assert_eq!(values(&with([0.5, 10.0]).read().unwrap())[0][3], 11.5);
    assert_eq!(values(&with([0.0, 7.0]).read().unwrap())[0][3], 3.0);
    assert_eq!(values(&with([f64::NAN, 7.0]).read().unwrap())[0][3], 3.0);
    assert!(
        with([1.0, f64::INFINITY])
            .refused()
            .starts_with("scl_slope")
    );
}

#[test]
fn every_type_of_numbers_is_read_and_every_other_refused_by_name() {
    let types = [
        (2, Scalar::U8),
        (4, Scalar::I16),
        (8, Scalar::I32),
        (16, Scalar::F32),
        (64, Scalar::F64),
        (256, Scalar::I8),
        (512, Scalar::U16),
        (768, Scalar::U32),
        (1024, Scalar::I64),
        (1280, Scalar::U64),
    ];
    for (datatype, scalar) in types {
        let file = Nifti {
            datatype,
            bitpix: 8 * scalar.size() as i64,
            values: counted_up(24, scalar, ByteOrder::Little),
            ..Nifti::default()
        };
        let series = file.read().unwrap();
        assert_eq!(values(&series)[1], numbers(12, 24), "{datatype}");
        assert!(series.notices.is_empty(), "{datatype}");
    }
    for (datatype, words) in [
        (1, "one bit"),
        (32, "complex"),
        (128, "RGB24"),
        (1536, "128 bits"),
        (1792, "complex"),
        (2048, "complex"),
        (2304, "RGBA32"),
        (3, "no type of numbers"),
    ] {
        let file = Nifti {
            datatype,
            ..Nifti::default()
        };
        assert!(file.refused().contains(words), "{}", file.refused());
    }
    let odd = Nifti {
        bitpix: 8,
        ..Nifti::default()
    };
    assert!(says(&odd.read().unwrap(), "bitpix is 8"));
}

#[test]
fn one_axis_of_volumes_is_read_wherever_it_stands() {
    let with = |dim: &[i64], intent| Nifti {
        dim: dim.to_vec(),
        intent,
        ..Nifti::default()
    };
    let fifth = with(&[5, 2, 3, 2, 1, 2, 1, 1], 0).read().unwrap();
    assert_eq!(values(&fifth), [numbers(0, 12), numbers(12, 24)]);
    assert!(!fifth.times_known());
    let still = with(&[5, 2, 3, 4, 1, 1, 1, 1], 0).read().unwrap();
    assert!(still.times_known() && still.image.volumes().len() == 1);
    let flat = with(&[2, 4, 6, 9, 9, 9, 9, 9], 0).read().unwrap();
    assert_eq!(flat.image.frame().size(), [4, 6, 1]);
    assert!(
        with(&[5, 2, 3, 2, 1, 2, 1, 1], 1007)
            .refused()
            .contains("2 numbers a voxel")
    );
    assert!(
        with(&[5, 1, 3, 2, 2, 2, 1, 1], 0)
            .refused()
            .contains("only one axis of volumes")
    );
}

#[test]
fn headers_that_say_what_cannot_be_are_refused_at_the_byte() {
    let dim = |dim: &[i64]| {
        Nifti {
            dim: dim.to_vec(),
            ..Nifti::default()
        }
        .refused()
    };
    assert_eq!(dim(&[3, 2, 0, 2]), "byte 44: axis 2 has 0 voxels");
    assert_eq!(dim(&[3, 2, -3, 2]), "byte 44: axis 2 has -3 voxels");
    let offset = |offset| Nifti {
        offset,
        ..Nifti::default()
    };
    assert!(
        offset(100.0)
            .refused()
            .starts_with("byte 108: the values cannot begin at byte 100")
    );
    assert!(offset(-4.0).refused().starts_with("byte 108"));
    let mut at_zero = Nifti::default().bytes();
    at_zero[108..112].fill(0);
    assert!(read("a.nii", &at_zero).is_ok());
    let extended = offset(400.0).read().unwrap();
    assert_eq!(values(&extended)[0], numbers(0, 12));
    let bytes = Nifti::default().bytes();
    let cut = read("a.nii", &bytes[..bytes.len() - 5])
        .unwrap_err()
        .to_string();
    assert!(
        cut.contains("take 48 bytes, but only 43 are there"),
        "{cut}"
    );
    let cut = read("a.nii", &gzipped(&bytes[..bytes.len() - 5]))
        .unwrap_err()
        .to_string();
    assert!(
        cut.contains("take 48 bytes, but only 43 are there"),
        "{cut}"
    );
    let packed = gzipped(&bytes);
    let cut = read("a.nii", &packed[..packed.len() - 12])
        .unwrap_err()
        .to_string();
    assert!(cut.contains("cannot be unpacked"), "{cut}");
    let mut analyze = bytes;
    analyze[344..348].fill(0);
    assert!(
        read("a.hdr", &analyze)
            .unwrap_err()
            .to_string()
            .contains("ANALYZE 7.5")
    );
    assert!(
        read("a.nii", b"no image")
            .unwrap_err()
            .to_string()
            .contains("NIfTI, NRRD, MetaImage")
    );
}
