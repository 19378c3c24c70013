//! A thousand seeded mutations of a small image file of every kind: no panic, no more voxels than allowed.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};

use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::image_samples::{Nifti, counted_up, gzipped, metaimage, nrrd, zlibbed};
use crate::io::{Limits, read_image};

const MUTATIONS_OF_EACH_FILE: u64 = 1_000;
const MAX_VOXELS: u64 = 1 << 20;

/// Numbers that a header should not be trusted with.
const BAD_NUMBERS: [&str; 14] = [
    "nan",
    "-inf",
    "1e999",
    "-1",
    "0",
    "65535",
    "4294967296",
    "99999999999999999999",
    "18446744073709551615",
    "-9223372036854775808",
    "2000000000",
    "1e-400",
    "",
    "16777216",
];

struct Sample {
    name: &'static str,
    bytes: Vec<u8>,
    /// Whether its header is text.
    text: bool,
}

fn samples() -> Vec<Sample> {
    let stored = |count| counted_up(count, Scalar::I16, ByteOrder::Little);
    let nifti = |file: Nifti| file.bytes();
    let two = Nifti {
        two: true,
        offset: 544.0,
        ..Nifti::default()
    };
    let turned = Nifti {
        codes: [1, 0],
        quaternion: [0.5, 0.5, 0.5, 1.0, 2.0, 3.0],
        ..Nifti::default()
    };
    let pair = Nifti {
        pair: true,
        offset: 0.0,
        ..Nifti::default()
    };
    let axes = [
        "type: short",
        "dimension: 4",
        "space: RAS",
        "sizes: 2 3 2 2",
    ];
    let directions = "space directions: (1,0,0) (0,1,0) (0,0,5) none";
    let times = ["space origin: (1,2,3)", "axis 3 index values:=0 300"];
    let nrrd_of = |more: &[&str], values: &[u8]| {
        nrrd(&[&axes[..], &[directions], &times, more].concat(), values)
    };
    let meta = [
        "NDims = 4",
        "DimSize = 2 3 2 2",
        "ElementType = MET_SHORT",
        "ElementSpacing = 2 3 5 0.25",
        "TransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1",
        "Offset = 1 2 3 0",
        "BinaryDataByteOrderMSB = False",
    ];
    let packed = [&meta[..], &["CompressedData = True"]].concat();
    let text = [&meta[..], &["BinaryData = False"]].concat();
    let sample = |name, bytes, text| Sample { name, bytes, text };
    vec![
        sample("one.nii", nifti(Nifti::default()), false),
        sample("two.nii", nifti(two), false),
        sample("turned.nii", nifti(turned), false),
        sample("pair.hdr", nifti(pair), false),
        sample("packed.nii.gz", gzipped(&nifti(Nifti::default())), false),
        sample(
            "raw.nrrd",
            nrrd_of(&["endian: little", "encoding: raw"], &stored(24)),
            true,
        ),
        sample(
            "packed.nrrd",
            nrrd_of(&["endian: little", "encoding: gzip"], &gzipped(&stored(24))),
            true,
        ),
        sample(
            "text.nrrd",
            nrrd_of(
                &["encoding: text"],
                b"0 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9 0 1 2 3",
            ),
            true,
        ),
        sample(
            "files.nhdr",
            nrrd_of(
                &["endian: little", "encoding: raw", "data file: s%d 1 2 1"],
                b"",
            ),
            true,
        ),
        sample(
            "skip.nhdr",
            nrrd_of(
                &[
                    "endian: big",
                    "encoding: raw",
                    "line skip: 0",
                    "byte skip: 0",
                    "data file: all",
                ],
                b"",
            ),
            true,
        ),
        sample("raw.mha", metaimage(&meta, "LOCAL", &stored(24)), true),
        sample(
            "packed.mha",
            metaimage(&packed, "LOCAL", &zlibbed(&stored(24))),
            true,
        ),
        sample(
            "text.mha",
            metaimage(
                &text,
                "LOCAL",
                b"0 1 2 3 4 5 6 7 8 9 0 1 2 3 4 5 6 7 8 9 0 1 2 3",
            ),
            true,
        ),
        sample("list.mhd", metaimage(&meta, "LIST", b"s1\ns2\n"), true),
    ]
}

/// Another file from this one: bytes changed, cut, doubled, or numbers of the header replaced.
fn mutated(sample: &Sample, random: &mut ChaCha8Rng) -> Vec<u8> {
    let mut bytes = sample.bytes.clone();
    for _ in 0..random.random_range(1..=3) {
        if bytes.is_empty() {
            break;
        }
        let at = random.random_range(0..bytes.len());
        match random.random_range(0..5) {
            0 => bytes[at] ^= 1 << random.random_range(0..8),
            1 => bytes[at] = *[0, 1, 0x7f, 0x80, 0xff].choose(random).unwrap(),
            2 => bytes.truncate(at),
            3 => {
                let end = random.random_range(at..=bytes.len());
                let part = bytes[at..end].to_vec();
                bytes.splice(at..at, part);
            }
            _ if sample.text => with_bad_number(&mut bytes, random),
            _ => {
                // A field of two, four or eight bytes.
                let size = *[2, 4, 8].choose(random).unwrap();
                let at = at - at % size;
                let words: [[u8; 8]; 5] = [
                    [0xff; 8],
                    [0xff, 0x7f, 0xff, 0x7f, 0xff, 0xff, 0xff, 0x7f],
                    [0, 0, 0xc0, 0x7f, 0, 0, 0xf8, 0x7f],
                    [0, 0, 0x80, 0xff, 0, 0, 0xf0, 0xff],
                    [0; 8],
                ];
                let word = words.choose(random).unwrap();
                for (byte, new) in bytes.iter_mut().skip(at).take(size).zip(word) {
                    *byte = *new;
                }
            }
        }
    }
    bytes
}

/// Replaces one of the numbers of the text.
fn with_bad_number(bytes: &mut Vec<u8>, random: &mut ChaCha8Rng) {
    let is_part = |byte: &u8| byte.is_ascii_digit() || b".-".contains(byte);
    let starts: Vec<usize> = (0..bytes.len())
        .filter(|at| is_part(&bytes[*at]) && (*at == 0 || !is_part(&bytes[at - 1])))
        .collect();
    let Some(&start) = starts.choose(random) else {
        return;
    };
    let length = bytes[start..]
        .iter()
        .take_while(|byte| is_part(byte))
        .count();
    let number = BAD_NUMBERS.choose(random).unwrap();
    bytes.splice(start..start + length, number.bytes());
}

#[test]
fn a_thousand_damaged_copies_of_every_kind_are_read_or_refused() {
    let limits = Limits {
        voxels: MAX_VOXELS,
        ..Limits::default()
    };
    let stored = |from: usize, to: usize| {
        counted_up(to, Scalar::I16, ByteOrder::Little)[2 * from..].to_vec()
    };
    let others: BTreeMap<&str, Vec<u8>> = BTreeMap::from([
        ("pair.img", stored(0, 24)),
        ("all", stored(0, 24)),
        ("s1", stored(0, 12)),
        ("s2", stored(12, 24)),
    ]);
    let sibling = |name: &str| {
        others
            .get(name)
            .cloned()
            .ok_or_else(|| "there is no such file".to_owned())
    };
    for sample in samples() {
        let whole = read_image(sample.name, &sample.bytes, &limits, &sibling).unwrap();
        assert_eq!(whole.image.volumes().len(), 2, "{}", sample.name);
        let (mut read, mut refused) = (0, 0);
        for seed in 0..MUTATIONS_OF_EACH_FILE {
            let mut random = ChaCha8Rng::seed_from_u64(seed);
            let bytes = mutated(&sample, &mut random);
            let outcome = catch_unwind(AssertUnwindSafe(|| {
                read_image(sample.name, &bytes, &limits, &sibling)
            }));
            let outcome =
                outcome.unwrap_or_else(|_| panic!("{} with seed {seed} panics", sample.name));
            match outcome {
                Ok(series) => {
                    let image = &series.image;
                    let voxels = image.frame().voxel_count() * image.volumes().len();
                    assert!(
                        voxels as u64 <= MAX_VOXELS,
                        "{} with seed {seed}",
                        sample.name
                    );
                    read += 1;
                }
                Err(error) => {
                    let text = error.to_string();
                    assert!(!text.is_empty() && !text.contains("SEEDED"), "{text}");
                    refused += 1;
                }
            }
        }
        assert!(
            read > 0 && refused > 100,
            "{}: {read} read, {refused} refused",
            sample.name
        );
    }
}
