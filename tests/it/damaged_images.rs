//! Damaged image files: a thousand seeded mutations of a small file of every format and packing are read or refused without
//! a panic, each within 2 s, by processes that get no more than 1 GiB of address space from the system.
//!
//! The reading happens in child processes, this test run once more by itself for each file, so that memory of other tests
//! does not count and an abort is seen as what it is. Where the shell can bound memory (`ulimit -v`), an allocation beyond
//! it ends the child.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::{Command, Output};
use std::time::{Duration, Instant};
use std::{env, fs};

use cardiomorph::io::{Limits, read_dicom_bytes, read_image};
use cardiomorph::progress::Progress;
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::small_images::{SmallImage, small_images};

/// The variable `CARDIOMORPH_MUTATIONS` asks for more.
const MUTATIONS_OF_EACH_FILE: u64 = 1_000;
const LONGEST_READ: Duration = Duration::from_secs(2);
/// All that a child may have, its own code included.
const ADDRESS_SPACE_KIB: u64 = 1 << 20;
/// What the reading of files of a few thousand bytes may add to it: what one thread's allocator keeps, not what headers say.
const MOST_GROWN_KIB: u64 = 16 << 10;
/// Names the file that a child is to damage.
const IN_CHILD: &str = "CARDIOMORPH_DAMAGED_IMAGES_CHILD";

/// Numbers that headers should not be trusted with.
const BAD_NUMBERS: [&str; 12] = [
    "nan",
    "-inf",
    "1e999",
    "-1",
    "0",
    "65535",
    "4294967296",
    "99999999999999999999",
    "-9223372036854775808",
    "2000000000",
    "1e-400",
    "",
];

/// Counts and lengths that headers should not be trusted with, as they are stored.
const BAD_WORDS: [[u8; 8]; 8] = [
    [0xff; 8],
    [0xff, 0xff, 0xff, 0x7f, 0xff, 0xff, 0xff, 0x7f],
    [0xff, 0x7f, 0xff, 0x7f, 0xff, 0x7f, 0xff, 0x7f],
    [0, 0, 0, 0x40, 0, 0, 0, 0x40],
    [0, 0, 1, 0, 0, 0, 0, 0],
    [0, 0, 0xc0, 0x7f, 0, 0, 0xf8, 0x7f],
    [0, 0, 0x80, 0xff, 0, 0, 0xf0, 0xff],
    [0; 8],
];

/// Changes a file in one to four places.
fn mutated(sample: &[u8], other: &[u8], seed: u64) -> Vec<u8> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut bytes = sample.to_vec();
    for _ in 0..*[1, 1, 2, 4].choose(&mut random).unwrap() {
        if bytes.is_empty() {
            break;
        }
        let at = random.random_range(0..bytes.len());
        match random.random_range(0..9) {
            0 | 1 => bytes[at] ^= 1 << random.random_range(0..8),
            2 => bytes[at] = *[0, 1, 0x7f, 0x80, 0xff].choose(&mut random).unwrap(),
            3 => bytes.truncate(at),
            4 => {
                let end = random.random_range(at..=bytes.len());
                let part = bytes[at..end].to_vec();
                bytes.splice(at..at, part);
            }
            5 => {
                let end = random.random_range(at..=bytes.len().min(at + 40));
                let from = random.random_range(0..other.len());
                let part = other[from..].iter().copied().take(40);
                bytes.splice(at..end, part);
            }
            6 => replace_number(&mut bytes, at, &mut random),
            _ => {
                let size = *[2, 4, 8].choose(&mut random).unwrap();
                let word = BAD_WORDS.choose(&mut random).unwrap();
                for (byte, new) in bytes[at - at % 2..].iter_mut().zip(&word[..size]) {
                    *byte = *new;
                }
            }
        }
    }
    bytes
}

fn replace_number(bytes: &mut Vec<u8>, from: usize, random: &mut ChaCha8Rng) {
    let part_of_number = |byte: &u8| byte.is_ascii_digit() || b".-".contains(byte);
    let Some(start) = bytes[from..].iter().position(part_of_number) else {
        return;
    };
    let start = from + start;
    let length = (bytes[start..].iter())
        .take_while(|byte| part_of_number(byte))
        .count();
    let bad = BAD_NUMBERS.choose(random).unwrap();
    bytes.splice(start..start + length, bad.bytes());
}

/// A line of what the system says of this process, in KiB; none where it says nothing.
fn memory_kib(line: &str) -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|text| text.starts_with(line))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

/// Volumes that were read; none if the file was refused, with a reason that quotes no text of it.
fn volumes(image: &SmallImage, bytes: &[u8], what: &str) -> Option<usize> {
    let limits = Limits::default();
    let reason = if image.is_dicom() {
        let progress = Progress::default();
        let reading = read_dicom_bytes(image.name, bytes.into(), &limits, &progress).unwrap();
        let volumes = reading
            .series
            .iter()
            .map(|series| series.image.volumes().len());
        let read = volumes.sum::<usize>() + reading.contours.len();
        if read > 0 {
            return Some(read);
        }
        format!("{:?}", reading.left_out)
    } else {
        let beside: BTreeMap<&str, &Vec<u8>> = (image.beside.iter())
            .map(|(name, bytes)| (*name, bytes))
            .collect();
        let sibling = |name: &str| match beside.get(name) {
            Some(bytes) => Ok((*bytes).clone()),
            None => Err("there is no such file".to_owned()),
        };
        match read_image(image.name, bytes, &limits, &sibling) {
            Ok(series) => return Some(series.image.volumes().len()),
            Err(error) => error.to_string(),
        }
    };
    assert!(
        !reason.is_empty() && reason.chars().count() < 2_000,
        "{what}: {reason}"
    );
    assert!(!reason.contains("SEEDED"), "{what}: {reason}");
    None
}

/// Reads all mutations of one file; panics at the first that breaks a promise.
fn read_all_mutations(name: &str) {
    let images = small_images();
    let index = images.iter().position(|image| image.name == name).unwrap();
    let image = &images[index];
    let mutations = (env::var("CARDIOMORPH_MUTATIONS").ok())
        .and_then(|count| count.parse().ok())
        .unwrap_or(MUTATIONS_OF_EACH_FILE);
    volumes(image, &image.bytes, name).unwrap();
    let before = memory_kib("VmPeak:");
    let (mut read, mut refused) = (0_u64, 0_u64);
    let mut longest = (Duration::ZERO, 0);
    for seed in 0..mutations {
        let other = &images[(index + 1 + seed as usize) % images.len()];
        let bytes = mutated(&image.bytes, &other.bytes, seed);
        let what = format!("{name} with seed {seed}");
        let start = Instant::now();
        let outcome = catch_unwind(AssertUnwindSafe(|| volumes(image, &bytes, &what)));
        longest = longest.max((start.elapsed(), seed));
        assert!(longest.0 < LONGEST_READ, "{what} took {:?}", longest.0);
        match outcome.unwrap_or_else(|_| panic!("{what} panics")) {
            Some(_) => read += 1,
            None => refused += 1,
        }
        if let (Some(before), Some(now)) = (before, memory_kib("VmPeak:")) {
            let grown = now - before;
            assert!(grown < MOST_GROWN_KIB, "{what} took {grown} KiB of memory");
        }
    }
    let grown = before.and_then(|before| Some(memory_kib("VmPeak:")? - before));
    println!(
        "{name}: {read} mutations read, {refused} refused, longest {:?} (seed {}), memory + {} KiB, in all {} KiB",
        longest.0,
        longest.1,
        grown.map_or("?".to_owned(), |kib| kib.to_string()),
        memory_kib("VmHWM:").map_or("?".to_owned(), |kib| kib.to_string())
    );
    // Mutations that always or never break a file would test nothing.
    assert!(
        read > mutations / 50 && refused > mutations / 50,
        "{name}: {read}, {refused}"
    );
}

/// A program that begins with no more address space than is said here; as it is where no shell can bound it.
fn bounded(program: &std::path::Path, arguments: &[&str], variable: (&str, &str)) -> Output {
    let script = format!("ulimit -v {ADDRESS_SPACE_KIB} && exec \"$0\" \"$@\"");
    let bound = Command::new("sh").args(["-c", &script, "true"]).status();
    let mut command = if bound.is_ok_and(|status| status.success()) {
        let mut command = Command::new("sh");
        command.args(["-c", &script]).arg(program);
        command
    } else {
        println!("memory is not bounded: this system has no `ulimit -v`");
        Command::new(program)
    };
    // One reserve of address space for all threads, not one for each.
    let variables = [variable, ("MALLOC_ARENA_MAX", "1"), ("RUST_BACKTRACE", "0")];
    command.args(arguments).envs(variables).output().unwrap()
}

#[test]
fn no_damage_to_an_image_file_panics_hangs_or_takes_what_its_header_says() {
    if let Ok(name) = env::var(IN_CHILD) {
        read_all_mutations(&name);
        return;
    }
    let test =
        "damaged_images::no_damage_to_an_image_file_panics_hangs_or_takes_what_its_header_says";
    for image in small_images() {
        let arguments = [test, "--exact", "--nocapture", "--test-threads=1"];
        let child = bounded(
            &env::current_exe().unwrap(),
            &arguments,
            (IN_CHILD, image.name),
        );
        let out = String::from_utf8_lossy(&child.stdout);
        let err = String::from_utf8_lossy(&child.stderr);
        assert!(
            child.status.success(),
            "{}: {}\n{out}\n{err}",
            image.name,
            child.status
        );
        let summary = out.lines().find(|line| line.contains("mutations read"));
        println!(
            "{}",
            summary.unwrap_or_else(|| panic!("the child ran no test:\n{out}\n{err}"))
        );
    }
}

/// The bound is one: a program that asks for more is ended.
#[test]
#[cfg(target_os = "linux")]
fn a_child_that_asks_for_more_than_the_bound_is_ended() {
    const GREEDY: &str = "greedy";
    if env::var(IN_CHILD).as_deref() == Ok(GREEDY) {
        println!("{}", std::hint::black_box(vec![1_u8; 3 << 29]).len());
        return;
    }
    let test = "damaged_images::a_child_that_asks_for_more_than_the_bound_is_ended";
    let program = env::current_exe().unwrap();
    let child = bounded(
        &program,
        &[test, "--exact", "--nocapture"],
        (IN_CHILD, GREEDY),
    );
    assert!(!child.status.success());
    let err = String::from_utf8_lossy(&child.stderr);
    assert!(
        err.contains("memory allocation of 1610612736 bytes failed"),
        "{err}"
    );
}

/// Undamaged, each is read to the volumes that it holds.
#[test]
fn every_small_image_is_read() {
    let found: Vec<_> = (small_images().iter())
        .map(|image| (image.name, volumes(image, &image.bytes, image.name)))
        .collect();
    let expected: Vec<_> = (small_images().iter())
        .map(|image| (image.name, Some(image.volumes.max(1))))
        .collect();
    assert_eq!(found, expected);
}

/// A folder of damaged files of all formats, as they lie on a disk, is read by the program itself within the bound.
#[test]
fn a_folder_of_damaged_images_is_read_within_the_bound() {
    let folder = tempfile::tempdir().unwrap();
    let images = small_images();
    for (index, image) in images.iter().enumerate() {
        for seed in 0..12 {
            let place = folder.path().join(format!("{index}_{seed}"));
            fs::create_dir(&place).unwrap();
            for (name, bytes) in &image.beside {
                fs::write(place.join(name), bytes).unwrap();
            }
            let other = &images[(index + seed as usize + 1) % images.len()].bytes;
            let bytes = mutated(&image.bytes, other, 5_000 + seed);
            fs::write(place.join(image.name), bytes).unwrap();
        }
    }
    let path = folder.path().to_str().unwrap();
    let program = std::path::Path::new(env!("CARGO_BIN_EXE_cardiomorph"));
    let out = folder.path().join("out");
    for arguments in [
        &["image", path, "--json"][..],
        &["info", path],
        &["mesh", path, "--out", out.to_str().unwrap()],
    ] {
        let begin = Instant::now();
        let child = bounded(program, arguments, ("RAYON_NUM_THREADS", "2"));
        let took = begin.elapsed();
        let err = String::from_utf8_lossy(&child.stderr);
        assert!(
            child.status.code().is_some(),
            "{arguments:?}: {}\n{err}",
            child.status
        );
        assert!(!err.contains("panicked"), "{err}");
        // Each of them within 2 s, were they read one after the other.
        assert!(took < LONGEST_READ * 12 * images.len() as u32, "{took:?}");
        println!("{} took {took:?}", arguments[0]);
    }
}
