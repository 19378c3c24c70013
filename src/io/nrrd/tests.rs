//! NRRD by hand: worlds, axes of volumes, encodings, files beside the header, and what is refused.

use std::collections::BTreeMap;

use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::image_samples::{
    changed_lines, counted_up, gzipped, nrrd, numbers, read, read_beside, says, sixteen_bits,
    values,
};
use crate::io::{ImageSeries, Provenance};
use crate::mesh::{Point3, Vector3};

const STILL: [&str; 8] = [
    "type: int16",
    "dimension: 3",
    "space: LPS",
    "sizes: 2 3 2",
    "space directions: (0,2,0) (-3,0,0) (0,0,5)",
    "space origin: (1,2,3)",
    "endian: little",
    "encoding: raw",
];

fn header(changes: &[&'static str]) -> Vec<&'static str> {
    changed_lines(&STILL, ':', changes)
}

fn with(changes: &[&'static str], values: &[u8]) -> ImageSeries {
    read("a.nrrd", &nrrd(&header(changes), values)).unwrap()
}

fn refused(changes: &[&'static str]) -> String {
    read("a.nrrd", &nrrd(&header(changes), &sixteen_bits(24)))
        .unwrap_err()
        .to_string()
}

#[test]
fn every_world_places_the_same_voxels() {
    let expected = with(&[], &sixteen_bits(12));
    assert_eq!(values(&expected), [numbers(0, 12)]);
    let frame = expected.image.frame();
    assert_eq!(frame.origin(), Point3::new(1.0, 2.0, 3.0));
    assert_eq!(frame.steps()[1], Vector3::new(-3.0, 0.0, 0.0));
    assert_eq!(expected.spacing, Provenance::UnitAssumed);
    for changes in [
        [
            "space: left-posterior-superior",
            "space origin: (1,2,3)",
            "space directions: (0,2,0) (-3,0,0) (0,0,5)",
        ],
        [
            "space: RAS",
            "space origin: (-1,-2,3)",
            "space directions: (0,-2,0) (3,0,0) (0,0,5)",
        ],
        [
            "space: right-anterior-superior",
            "space origin: ( -1, -2, 3 )",
            "space directions: ( 0, -2, 0) (3,0,0)(0,0,5)",
        ],
        [
            "space: LAS",
            "space origin: (1,-2,3)",
            "space directions: (0,-2,0) (-3,0,0) (0,0,5)",
        ],
        [
            "space: SLP",
            "space origin: (3,1,2)",
            "space directions: (0,0,2) (0,-3,0) (5,0,0)",
        ],
    ] {
        assert_eq!(
            with(&changes, &sixteen_bits(12)).image,
            expected.image,
            "{changes:?}"
        );
    }
    let centimetres = with(&["space units: \"cm\" \"cm\" \"cm\""], &sixteen_bits(12));
    assert_eq!(
        centimetres.image.frame().origin(),
        Point3::new(10.0, 20.0, 30.0)
    );
    assert_eq!(centimetres.spacing, Provenance::Stated);
    let scanner = with(&["space: 3D-right-handed"], &sixteen_bits(12));
    assert!(!scanner.position_known);
    assert!(!with(&["space origin:"], &sixteen_bits(12)).position_known);
    assert!(refused(&["space: LPP"]).contains("`lpp` is no world"));
}

#[test]
fn an_axis_of_volumes_may_be_first_or_last() {
    let times = ["axis 3 index type:=numeric", "axis 3 index values:=0 300"];
    let last = with(
        &[
            "dimension: 4",
            "sizes: 2 3 2 2",
            "space directions: (0,2,0) (-3,0,0) (0,0,5) none",
            "kinds: domain domain domain list",
            times[0],
            times[1],
        ],
        &sixteen_bits(24),
    );
    assert_eq!(values(&last), [numbers(0, 12), numbers(12, 24)]);
    assert_eq!(last.image.times_ms(), Some(&[0.0, 300.0][..]));
    assert_eq!(last.times, Provenance::UnitAssumed);
    let interleaved: Vec<u8> = (0..12)
        .flat_map(|k| [k, 12 + k])
        .flat_map(i16::to_le_bytes)
        .collect();
    let first = with(
        &[
            "dimension: 4",
            "sizes: 2 2 3 2",
            "space directions: none (0,2,0) (-3,0,0) (0,0,5)",
            "kinds: list domain domain domain",
            "units: \"s\" \"\" \"\" \"\"",
            "axis 0 index values:=0 0.3",
        ],
        &interleaved,
    );
    assert_eq!(first.image, last.image);
    assert_eq!(first.times, Provenance::Stated);
    let multi_volume = with(
        &[
            "dimension: 4",
            "sizes: 2 2 3 2",
            "space directions: (nan,nan,nan) (0,2,0) (-3,0,0) (0,0,5)",
            "kinds: vector domain domain domain",
            "MultiVolume.NumberOfFrames:=2",
            "MultiVolume.FrameLabels:=0,300",
            "MultiVolume.FrameIdentifyingDICOMTagName:=TriggerTime",
            "MultiVolume.FrameIdentifyingDICOMTagUnits:=ms",
        ],
        &interleaved,
    );
    assert_eq!(multi_volume.image, last.image);
    let in_space = with(
        &[
            "dimension: 4",
            "space: LPST",
            "sizes: 2 3 2 2",
            "space directions: (0,2,0,0) (-3,0,0,0) (0,0,5,0) (0,0,0,300)",
            "space origin: (1,2,3,0)",
            "space units: \"mm\" \"mm\" \"mm\" \"ms\"",
        ],
        &sixteen_bits(24),
    );
    assert_eq!(in_space.image, last.image);
}

#[test]
fn times_that_are_not_there_are_not_made_up() {
    let base = [
        "dimension: 4",
        "sizes: 2 3 2 2",
        "space directions: (0,2,0) (-3,0,0) (0,0,5) none",
    ];
    let none = with(&base, &sixteen_bits(24));
    assert!(!none.times_known() && says(&none, "no times"));
    let mut numbered = base.to_vec();
    numbered.push("axis 3 index values:=0 1");
    assert!(says(&with(&numbered, &sixteen_bits(24)), "numbered"));
    let mut words = base.to_vec();
    words.extend(["axis 3 index type:=text", "axis 3 index values:=ED ES"]);
    assert!(says(&with(&words, &sixteen_bits(24)), "words for an index"));
    let mut few = base.to_vec();
    few.push("axis 3 index values:=0 10 20");
    assert!(says(
        &with(&few, &sixteen_bits(24)),
        "one number for each volume"
    ));
}

#[test]
fn spacings_alone_give_no_place_and_their_absence_is_told() {
    let spacings = |line| {
        with(
            &["space directions:", "space origin:", "space:", line],
            &sixteen_bits(12),
        )
    };
    let said = spacings("spacings: 2 3 5");
    assert_eq!(said.image.frame().spacing(), [2.0, 3.0, 5.0]);
    assert!(!said.position_known && said.spacing == Provenance::UnitAssumed);
    let part = spacings("spacings: 2 nan 5");
    assert!(!part.spacing_known() && part.image.frame().spacing() == [2.0, 1.0, 5.0]);
    assert!(!spacings("content: SEEDED").spacing_known());
    let four = with(
        &[
            "dimension: 4",
            "sizes: 2 3 2 2",
            "space directions:",
            "space origin:",
            "space:",
            "spacings: 2 3 5 0.3",
            "units: \"mm\" \"mm\" \"mm\" \"s\"",
        ],
        &sixteen_bits(24),
    );
    assert_eq!(four.image.times_ms(), Some(&[0.0, 300.0][..]));
    assert!(four.spacing == Provenance::Stated && says(&four, "the last one is taken"));
}

#[test]
fn values_are_unpacked_skipped_to_and_read_as_text() {
    let expected = with(&[], &sixteen_bits(12)).image;
    assert_eq!(
        with(&["encoding: gzip"], &gzipped(&sixteen_bits(12))).image,
        expected
    );
    assert_eq!(
        with(
            &["encoding: gz", "byte skip: 3"],
            &gzipped(&[&b"abc"[..], &sixteen_bits(12)].concat())
        )
        .image,
        expected
    );
    assert_eq!(
        with(
            &["line skip: 1", "byteskip: 2"],
            &[&b"a line\nxy"[..], &sixteen_bits(12)].concat()
        )
        .image,
        expected
    );
    assert_eq!(
        with(
            &["byte skip: -1"],
            &[&b"anything"[..], &sixteen_bits(12)].concat()
        )
        .image,
        expected
    );
    assert_eq!(
        with(
            &["encoding: ascii", "endian:"],
            b"0 1 2 3 4 5 6 7 8 9 10 11\n"
        )
        .image,
        expected
    );
    let big = counted_up(12, Scalar::I16, ByteOrder::Big);
    assert_eq!(with(&["endian: big"], &big).image, expected);
    assert!(refused(&["endian:"]).starts_with("endian: missing"));
    for line in ["encoding: bzip2", "encoding: bz2", "encoding: hex"] {
        let name = line.trim_start_matches("encoding: ");
        assert!(refused(&[line]).contains(&format!("packed as {name}, which is not read")));
    }
    let cut = read("a.nrrd", &nrrd(&header(&[]), &sixteen_bits(11)))
        .unwrap_err()
        .to_string();
    assert!(
        cut.contains("take 24 bytes, but only 22 are there"),
        "{cut}"
    );
}

#[test]
fn values_may_stand_in_one_file_or_several() {
    let expected = with(&[], &sixteen_bits(12)).image;
    let all = sixteen_bits(12);
    let others = BTreeMap::from([
        ("a.raw", all.clone()),
        ("s1", all[..12].to_vec()),
        ("s2", all[12..].to_vec()),
    ]);
    for (line, list) in [
        ("data file: a.raw", ""),
        ("datafile: a.raw", ""),
        ("data file: s%d 1 2 1", ""),
        ("data file: LIST", "s1\ns2\n"),
    ] {
        let mut lines = header(&[line]);
        lines.retain(|own| *own != line);
        lines.push(line);
        let mut bytes = nrrd(&lines, b"");
        bytes.truncate(bytes.len() - usize::from(!list.is_empty()));
        bytes.extend_from_slice(list.as_bytes());
        assert_eq!(
            read_beside("a.nhdr", &bytes, &others).unwrap().image,
            expected,
            "{line}"
        );
    }
    let lost = nrrd(&header(&["data file: b.raw"]), b"");
    let text = read_beside("a.nhdr", &lost, &others)
        .unwrap_err()
        .to_string();
    assert_eq!(
        text,
        "data file names a file with the values: there is no such file"
    );
}

#[test]
fn what_is_no_volume_is_refused() {
    let colours = [
        "dimension: 4",
        "sizes: 2 2 3 2",
        "space directions: none (0,2,0) (-3,0,0) (0,0,5)",
        "kinds: RGB-color domain domain domain",
    ];
    assert!(refused(&colours).contains("2 numbers a voxel (kind `rgb-color`)"));
    assert!(
        refused(&[
            "dimension: 2",
            "sizes: 4 6",
            "space directions: (1,0,0) (0,1,0)"
        ])
        .contains("not a volume")
    );
    assert!(
        refused(&["space directions: (0,2,0) (0,2,0) (0,0,5)"])
            .starts_with("space directions: the directions")
    );
    assert!(
        refused(&["space directions: (0,2,0) (0,2,0)"]).contains("2 space directions for 3 axes")
    );
    assert!(
        refused(&["space directions: (0,2) (0,2,0) (0,0,5)"])
            .contains("of 2 numbers in a space of 3")
    );
    assert!(refused(&["sizes: 2 3"]).contains("2 sizes for 3 axes"));
    assert!(refused(&["sizes: 2 x 3"]).contains("`x` is no number"));
    assert!(refused(&["sizes: 0 3 2"]).contains("has no voxels"));
    assert!(refused(&["type: block"]).contains("`block` is no type"));
    assert!(refused(&["type:"]).starts_with("type: missing"));
    assert!(refused(&["nothing at all"]).contains("neither a field"));
}
