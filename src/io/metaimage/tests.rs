//! MetaImage by hand: places, encodings, files beside the header, and what is refused.

use std::collections::BTreeMap;

use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::image_samples::{
    changed_lines, counted_up, gzipped, metaimage, numbers, read, read_beside, says, sixteen_bits,
    values, zlibbed,
};
use crate::io::{ImageSeries, Modality, Provenance};
use crate::mesh::{Point3, Vector3};

const STILL: [&str; 7] = [
    "NDims = 3",
    "DimSize = 2 3 2",
    "ElementType = MET_SHORT",
    "ElementSpacing = 2 3 5",
    "TransformMatrix = 0 1 0 -1 0 0 0 0 1",
    "Offset = 1 2 3",
    "BinaryDataByteOrderMSB = False",
];

fn header(changes: &[&'static str]) -> Vec<&'static str> {
    changed_lines(&STILL, '=', changes)
}

fn with(changes: &[&'static str], values: &[u8]) -> ImageSeries {
    read("a.mha", &metaimage(&header(changes), "LOCAL", values)).unwrap()
}

fn refused(changes: &[&'static str]) -> String {
    read(
        "a.mha",
        &metaimage(&header(changes), "LOCAL", &sixteen_bits(24)),
    )
    .unwrap_err()
    .to_string()
}

#[test]
fn a_volume_stands_where_its_header_says() {
    let series = with(
        &["Modality = MET_MOD_MR", "Comment = SEEDED"],
        &sixteen_bits(12),
    );
    assert_eq!(values(&series), [numbers(0, 12)]);
    let frame = series.image.frame();
    assert_eq!(frame.origin(), Point3::new(1.0, 2.0, 3.0));
    assert_eq!(
        frame.steps(),
        [
            Vector3::new(0.0, 2.0, 0.0),
            Vector3::new(-3.0, 0.0, 0.0),
            Vector3::new(0.0, 0.0, 5.0)
        ]
    );
    assert_eq!(
        (series.modality, series.spacing),
        (Some(Modality::MagneticResonance), Provenance::Stated)
    );
    assert!(
        series.position_known && series.notices.is_empty(),
        "{:?}",
        series.notices
    );
    assert!(!format!("{series:?}").contains("SEEDED"));
    let other_names = [
        "TransformMatrix =",
        "Offset =",
        "Rotation = 0 1 0 -1 0 0 0 0 1",
        "Position = 1 2 3",
        "ElementSpacing =",
        "ElementSize = 2 3 5",
    ];
    assert_eq!(with(&other_names, &sixteen_bits(12)).image, series.image);
    let centimetres = with(&["DistanceUnits = cm"], &sixteen_bits(12));
    assert_eq!(centimetres.image.frame().spacing(), [20.0, 30.0, 50.0]);
}

#[test]
fn what_the_header_does_not_say_is_told() {
    let bare = with(
        &["TransformMatrix =", "Offset =", "ElementSpacing ="],
        &sixteen_bits(12),
    );
    assert!(!bare.position_known && !bare.spacing_known());
    assert_eq!(bare.image.frame().spacing(), [1.0; 3]);
    let order = with(&["BinaryDataByteOrderMSB ="], &sixteen_bits(12));
    assert!(says(&order, "which byte comes first"));
}

#[test]
fn a_fourth_axis_is_one_of_time_whose_unit_is_assumed() {
    let four = |step: &'static str| {
        with(
            &[
                "NDims = 4",
                "DimSize = 2 3 2 2",
                "TransformMatrix = 0 1 0 0 -1 0 0 0 0 0 1 0 0 0 0 1",
                "Offset = 1 2 3 0",
                step,
            ],
            &sixteen_bits(24),
        )
    };
    let seconds = four("ElementSpacing = 2 3 5 0.25");
    assert_eq!(values(&seconds), [numbers(0, 12), numbers(12, 24)]);
    assert_eq!(seconds.image.times_ms(), Some(&[0.0, 250.0][..]));
    assert_eq!(seconds.times, Provenance::UnitAssumed);
    assert_eq!(
        seconds.image.frame(),
        with(&[], &sixteen_bits(12)).image.frame()
    );
    assert!(!four("ElementSpacing = 2 3 5 1").times_known());
}

#[test]
fn values_are_unpacked_turned_scaled_and_read_as_text() {
    let expected = with(&[], &sixteen_bits(12)).image;
    assert_eq!(
        with(&["CompressedData = True"], &zlibbed(&sixteen_bits(12))).image,
        expected
    );
    assert_eq!(
        with(&["CompressedData = True"], &gzipped(&sixteen_bits(12))).image,
        expected
    );
    let big = counted_up(12, Scalar::I16, ByteOrder::Big);
    assert_eq!(
        with(&["BinaryDataByteOrderMSB = True"], &big).image,
        expected
    );
    assert_eq!(
        with(
            &["BinaryDataByteOrderMSB =", "ElementByteOrderMSB = True"],
            &big
        )
        .image,
        expected
    );
    assert_eq!(
        with(&["BinaryData = False"], b"0 1 2 3 4 5 6 7 8 9 10 11").image,
        expected
    );
    let scaled = with(
        &[
            "ElementToIntensityFunctionSlope = 0.5",
            "ElementToIntensityFunctionOffset = 10",
        ],
        &sixteen_bits(12),
    );
    assert_eq!(values(&scaled)[0][3], 11.5);
    assert!(says(&scaled, "0.5 × stored number + 10"));
}

#[test]
fn values_may_stand_in_one_file_or_several() {
    let expected = with(&[], &sixteen_bits(12)).image;
    let all = sixteen_bits(12);
    let others = BTreeMap::from([
        ("a.raw", all.clone()),
        ("b.raw", [&b"head"[..], &all].concat()),
        ("s01.raw", all[..12].to_vec()),
        ("s02.raw", all[12..].to_vec()),
        ("a.zraw", zlibbed(&all)),
    ]);
    for (changes, place, list) in [
        (&[][..], "a.raw", &b""[..]),
        (&["HeaderSize = 4"], "b.raw", b""),
        (&["HeaderSize = -1"], "b.raw", b""),
        (&["CompressedData = True"], "a.zraw", b""),
        (&[], "s%02d.raw 1 2 1", b""),
        (&[], "LIST", b"s01.raw\r\ns02.raw\r\n"),
    ] {
        let bytes = metaimage(&header(changes), place, list);
        let series = read_beside("a.mhd", &bytes, &others).unwrap();
        assert_eq!(series.image, expected, "{changes:?} {place}");
    }
    let lost = metaimage(&header(&[]), "c.raw", b"");
    let text = read_beside("a.mhd", &lost, &others)
        .unwrap_err()
        .to_string();
    assert_eq!(
        text,
        "ElementDataFile names a file with the values: there is no such file"
    );
}

#[test]
fn what_is_no_volume_is_refused() {
    assert!(refused(&["ElementNumberOfChannels = 3"]).contains("several numbers a voxel"));
    assert!(refused(&["ElementType = MET_UCHAR_ARRAY"]).contains("several numbers a voxel"));
    assert!(refused(&["ElementType = MET_STRANGE"]).contains("`MET_STRANGE` is no type"));
    assert!(
        refused(&[
            "NDims = 2",
            "DimSize = 4 6",
            "TransformMatrix =",
            "Offset =",
            "ElementSpacing ="
        ])
        .contains("2 axes")
    );
    assert!(refused(&["DimSize = 2 3"]).contains("DimSize: 2 numbers, not 3"));
    assert!(refused(&["DimSize = 2 3 99"]).contains("the file is cut short"));
    assert!(refused(&["TransformMatrix = 0 1 0 0 1 0 0 0 1"]).contains("span no volume"));
    assert!(refused(&["HeaderSize = -2"]).starts_with("HeaderSize"));
    let scene = String::from_utf8_lossy(&metaimage(&header(&[]), "LOCAL", b""))
        .replace("= Image", "= Scene");
    assert!(
        read("a.mha", scene.as_bytes())
            .unwrap_err()
            .to_string()
            .contains("no image (`Scene`)")
    );
    assert!(
        read("a.mha", b"ObjectType = Image\nNDims = 3\n")
            .unwrap_err()
            .to_string()
            .starts_with("ElementDataFile: missing")
    );
}
