//! A thousand seeded mutations of a small file of every format: no panic, no more points than allowed.

use std::panic::{AssertUnwindSafe, catch_unwind};

use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::samples::{Sample, samples};
use crate::io::Limits;
use crate::io::contours::formats::ContourFormat;
use crate::io::contours::outline::{OutlineFile, OutlinePlace};

const MUTATIONS_OF_EACH_FILE: u64 = 1_000;
const MAX_POINTS: usize = 1_000;
/// Words that a file should not be trusted with.
const BAD_WORDS: [&str; 12] = [
    "nan",
    "-inf",
    "1e999",
    "-1",
    "0",
    "4294967296",
    "99999999999999999999",
    "1e-400",
    "",
    "<",
    "{",
    "\"",
];

fn mutated(sample: &Sample, random: &mut ChaCha8Rng) -> Vec<u8> {
    let mut bytes = sample.bytes.clone();
    for _ in 0..random.random_range(1..=3) {
        if bytes.is_empty() {
            break;
        }
        let at = random.random_range(0..bytes.len());
        match random.random_range(0..6) {
            0 => bytes[at] ^= 1 << random.random_range(0..8),
            1 => bytes[at] = *[0, 1, 0x7f, 0x80, 0xff, b'\n'].choose(random).unwrap(),
            2 => bytes.truncate(at),
            3 => {
                let end = random.random_range(at..=bytes.len());
                let part = bytes[at..end].to_vec();
                bytes.splice(at..at, part);
            }
            4 if sample.text => with_bad_word(&mut bytes, at, random),
            _ => {
                let size = *[2, 4, 8].choose(random).unwrap();
                let new = *[0, 0x7f, 0xff].choose(random).unwrap();
                bytes
                    .iter_mut()
                    .skip(at)
                    .take(size)
                    .for_each(|byte| *byte = new);
            }
        }
    }
    bytes
}

/// Replaces the number that comes next.
fn with_bad_word(bytes: &mut Vec<u8>, from: usize, random: &mut ChaCha8Rng) {
    let Some(start) = bytes[from..].iter().position(u8::is_ascii_digit) else {
        return;
    };
    let start = from + start;
    let is_part = |byte: &&u8| byte.is_ascii_digit() || **byte == b'.';
    let length = bytes[start..].iter().take_while(is_part).count();
    let word = BAD_WORDS.choose(random).unwrap();
    bytes.splice(start..start + length, word.bytes());
}

fn points(file: &OutlineFile) -> usize {
    let each = file.outlines.iter().map(|outline| match &outline.place {
        OutlinePlace::InImage { corners, .. } => {
            assert!(corners.iter().flatten().all(|place| place.is_finite()));
            corners.len()
        }
        OutlinePlace::InWorld { points, .. } => {
            assert!(points.iter().all(|p| p.iter().all(|x| x.is_finite())));
            points.len()
        }
    });
    each.sum()
}

#[test]
fn a_thousand_damaged_copies_of_every_format_are_read_or_refused() {
    let limits = Limits {
        vertices: MAX_POINTS,
        ..Limits::default()
    };
    for sample in samples() {
        let format = ContourFormat::of(sample.name, &sample.bytes);
        assert_eq!(format, Some(sample.format), "{}", sample.name);
        let read = |bytes: Vec<u8>| sample.format.read(sample.name, bytes, &limits);
        assert!(
            points(&read(sample.bytes.clone()).unwrap()) >= 4,
            "{}",
            sample.name
        );
        let mut refused = 0;
        for seed in 0..MUTATIONS_OF_EACH_FILE {
            let bytes = mutated(&sample, &mut ChaCha8Rng::seed_from_u64(seed));
            let outcome = catch_unwind(AssertUnwindSafe(|| read(bytes)));
            let outcome = outcome.unwrap_or_else(|_| panic!("{} with seed {seed}", sample.name));
            match outcome {
                Ok(file) => assert!(points(&file) <= MAX_POINTS),
                Err(error) => {
                    assert!(!error.to_string().is_empty());
                    refused += 1;
                }
            }
        }
        assert!(refused > 50, "{}: {refused} refused", sample.name);
    }
}

#[test]
fn files_that_would_fill_the_memory_are_refused() {
    let limits = Limits::default();
    let error = |format: ContourFormat, text: String| {
        let read = format.read("endo", text.into_bytes(), &limits);
        read.unwrap_err().to_string()
    };
    let objects = format!("{{\"markups\": [{}]}}", "{},".repeat(600_000));
    assert!(error(ContourFormat::Markups, objects).starts_with("600001 points or more"));
    let deep = format!("{{\"markups\": {}", "[".repeat(200_000));
    assert!(error(ContourFormat::Markups, deep).contains("line 1"));
    let nodes = format!("<ImageStates>{}</ImageStates>", "<a/>".repeat(3_100_000));
    assert!(error(ContourFormat::Cvi42, nodes).contains("too large"));
    let attributes: String = (0..300).map(|k| format!(" a{k}=''")).collect();
    let text = error(ContourFormat::Cvi42, format!("<a{attributes}/>"));
    assert_eq!(text, "300 XML attributes of one element; the limit is 256");
    let spaces: String = (0..40).map(|k| format!("<a xmlns:b{k}='c'>")).collect();
    assert!(error(ContourFormat::Cvi42, spaces).starts_with("40 XML name spaces"));
    let small = Limits {
        file_bytes: 3,
        ..limits
    };
    let read = ContourFormat::Sunnybrook.read("a", vec![b'1'; 4], &small);
    assert_eq!(read.unwrap_err().to_string(), "4 bytes; the limit is 3");
}
