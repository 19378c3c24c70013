//! Values out of bytes: types, orders, scaling, limits, and bytes that end too early.

use std::io::Write;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use super::*;

fn layout(scalar: Scalar, order: ByteOrder, size: [usize; 3], count: usize) -> VoxelLayout {
    VoxelLayout {
        scalar,
        order,
        scaling: Scaling::NONE,
        volumes: VolumeOrder::new(size, count, 3, &Limits::default()).unwrap(),
    }
}

fn read(bytes: &[u8], layout: &VoxelLayout) -> Result<Vec<Vec<f32>>, ReadImageError> {
    let values = read_values(bytes, Packing::Plain, 0, layout)?;
    Ok(values.volumes.iter().map(|v| v.to_vec()).collect())
}

#[test]
fn every_type_is_read_in_both_orders() {
    let cases: [(Scalar, Vec<u8>, f32); 10] = [
        (Scalar::I8, (-3_i8).to_le_bytes().into(), -3.0),
        (Scalar::U8, 200_u8.to_le_bytes().into(), 200.0),
        (Scalar::I16, (-300_i16).to_le_bytes().into(), -300.0),
        (Scalar::U16, 60_500_u16.to_le_bytes().into(), 60_500.0),
        (Scalar::I32, (-70_000_i32).to_le_bytes().into(), -70_000.0),
        (Scalar::U32, 70_000_u32.to_le_bytes().into(), 70_000.0),
        (Scalar::I64, (-5_i64).to_le_bytes().into(), -5.0),
        (Scalar::U64, 5_u64.to_le_bytes().into(), 5.0),
        (Scalar::F32, 1.5_f32.to_le_bytes().into(), 1.5),
        (Scalar::F64, (-0.25_f64).to_le_bytes().into(), -0.25),
    ];
    for (scalar, little, expected) in cases {
        let big: Vec<u8> = little.iter().rev().copied().collect();
        let read_as = |order, bytes: &[u8]| read(bytes, &layout(scalar, order, [1; 3], 1)).unwrap();
        assert_eq!(read_as(ByteOrder::Little, &little), [[expected]]);
        assert_eq!(read_as(ByteOrder::Big, &big), [[expected]]);
    }
}

#[test]
fn volumes_may_be_the_first_a_middle_or_the_last_axis() {
    // Value 10 · volume + voxel.
    let at = |place, bytes: &[u8]| {
        let volumes = VolumeOrder::new([2, 3, 1], 2, place, &Limits::default()).unwrap();
        let layout = VoxelLayout {
            volumes,
            ..layout(Scalar::U8, ByteOrder::Little, [1; 3], 1)
        };
        read(bytes, &layout).unwrap()
    };
    let expected = [
        [0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
        [10.0, 11.0, 12.0, 13.0, 14.0, 15.0],
    ];
    assert_eq!(at(3, &[0, 1, 2, 3, 4, 5, 10, 11, 12, 13, 14, 15]), expected);
    assert_eq!(at(0, &[0, 10, 1, 11, 2, 12, 3, 13, 4, 14, 5, 15]), expected);
    assert_eq!(at(1, &[0, 1, 10, 11, 2, 3, 12, 13, 4, 5, 14, 15]), expected);
}

#[test]
fn scaling_is_that_of_stored_numbers() {
    let mut layout = layout(Scalar::I16, ByteOrder::Little, [2, 1, 1], 1);
    layout.scaling = Scaling {
        slope: 0.5,
        intercept: 10.0,
    };
    assert_eq!(read(&[4, 0, 0xff, 0xff], &layout).unwrap(), [[12.0, 9.5]]);
    assert_eq!(
        read_text_values(b"4 -1", &layout).unwrap().volumes[0][..],
        [12.0, 9.5]
    );
}

#[test]
fn bytes_that_end_too_early_are_told_with_their_numbers() {
    let layout = layout(Scalar::I16, ByteOrder::Little, [2, 2, 1], 3);
    let cut = ReadImageError::Truncated {
        expected: 24,
        present: 15,
    };
    assert_eq!(read(&[0; 15], &layout).unwrap_err(), cut);
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(&[0; 15]).unwrap();
    let packed = encoder.finish().unwrap();
    let error = read_values(&packed, Packing::Zlib, 0, &layout).unwrap_err();
    assert_eq!(error, cut);
    let error = read_values(&packed[..6], Packing::Zlib, 0, &layout).unwrap_err();
    assert!(matches!(error, ReadImageError::Unpack { .. }), "{error}");
    assert!(read_values(&[0; 30], Packing::Plain, 7, &layout).is_err());
    let more = read_values(&[0; 30], Packing::Plain, 5, &layout).unwrap();
    assert!(more.notices[0].text.contains("more bytes"));
}

#[test]
fn memory_is_refused_before_it_is_taken() {
    let limits = Limits::default();
    let refused = |size, count| {
        VolumeOrder::new(size, count, 3, &limits)
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        refused([1 << 10, 1 << 10, 1 << 9], 1),
        "536870912 voxels; the limit is 268435456"
    );
    assert!(refused([usize::MAX; 3], 2).ends_with("voxels; the limit is 268435456"));
    assert!(refused([1, 1, 1], 1001).starts_with("1001 volumes"));
    assert_eq!(refused([4, 0, 1], 1), "size: axis 2 has no voxels");
    // Within the limit, but more than a hundred packed bytes can stand for.
    let layout = layout(Scalar::U8, ByteOrder::Little, [1 << 9, 1 << 9, 1 << 9], 1);
    let error = read_values(&[0; 100], Packing::Zlib, 0, &layout).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("100 packed bytes cannot hold 134217728")
    );
    assert!(read_text_values(b"1 2 3", &layout).is_err());
}

#[test]
fn numbers_with_more_digits_than_are_kept_are_told() {
    let bytes = [16_777_217_i32.to_le_bytes(), 16_777_216_i32.to_le_bytes()].concat();
    let layout32 = layout(Scalar::I32, ByteOrder::Little, [2, 1, 1], 1);
    let values = read_values(&bytes, Packing::Plain, 0, &layout32).unwrap();
    assert!(values.notices[0].text.starts_with("1 whole numbers"));
    let layout64 = layout(Scalar::F64, ByteOrder::Little, [1, 1, 1], 1);
    let values = read_values(&1e300_f64.to_le_bytes(), Packing::Plain, 0, &layout64).unwrap();
    assert!(values.notices[0].text.starts_with("1 values are beyond"));
}

#[test]
fn text_must_hold_numbers_of_the_type_and_enough_of_them() {
    let whole = layout(Scalar::I16, ByteOrder::Little, [3, 1, 1], 1);
    assert_eq!(
        read_text_values(b"1, 2\n-3", &whole).unwrap().volumes[0][..],
        [1.0, 2.0, -3.0]
    );
    let refused = |text: &[u8]| read_text_values(text, &whole).unwrap_err().to_string();
    assert_eq!(
        refused(b"1 2.5 3"),
        "values: value 2 is no number of its type"
    );
    assert_eq!(
        refused(b"1 SEEDED 3"),
        "values: value 2 is no number of its type"
    );
    assert_eq!(
        refused(b"1    2"),
        "values: 3 numbers expected, but only 2 are there"
    );
}
