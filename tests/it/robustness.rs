//! Damaged mesh files: a thousand seeded mutations of a small file of every format are read
//! without panic, each within 2 s, and without ever taking 1 GiB of memory.
//!
//! The reading happens in a child process, this test run once more by itself, so that memory of
//! other tests does not count and an abort is seen as what it is.

use std::panic::catch_unwind;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use std::{env, fs};

use cardiomorph::io::{Limits, ReadMeshError, read_mesh};
use rand::seq::IndexedRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The variable `CARDIOMORPH_MUTATIONS` asks for more.
const MUTATIONS_OF_EACH_FILE: u64 = 1_000;
const LONGEST_READ: Duration = Duration::from_secs(2);
const MAX_MEMORY_KIB: u64 = 1 << 20;
const IN_CHILD: &str = "CARDIOMORPH_ROBUSTNESS_CHILD";

/// Numbers that headers and data should not be trusted with.
const BAD_NUMBERS: &[&str] = &[
    "nan",
    "-inf",
    "1e999",
    "-1",
    "0",
    "4294967295",
    "4294967296",
    "99999999999999999999",
    "18446744073709551615",
    "-9223372036854775808",
    "2000000000",
    "1e-400",
    "",
    "0x10",
    "1,5",
];

struct Sample {
    name: String,
    bytes: Vec<u8>,
}

/// One file of every format and variant, written by other programs, and two by hand.
fn samples() -> Vec<Sample> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/formats");
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    let mut samples: Vec<Sample> = paths
        .into_iter()
        .map(|path| Sample {
            name: path.file_name().unwrap().to_str().unwrap().to_owned(),
            bytes: fs::read(path).unwrap(),
        })
        .filter(|sample| read_mesh(&sample.name, &sample.bytes, &Limits::default()).is_ok())
        .collect();
    let by_hand = [
        (
            "points_faces.csv",
            "v,0,0,0\nv,1,0,0\nv,0,1,0\nv,0,0,1\nf,0,1,2\nf,0,1,3\n",
        ),
        (
            "mixed.obj",
            "o a\nv 0 0 0\nv 1 0 0 1\nv 0 \\\n1 0\nv 1 1 0\nvt 0 0\nf 1/1 2/1 4 3\nf -1 -2 -3\n",
        ),
    ];
    samples.extend(by_hand.map(|(name, text)| Sample {
        name: name.to_owned(),
        bytes: text.as_bytes().to_vec(),
    }));
    for ending in cardiomorph::io::mesh_file_endings() {
        assert!(
            samples.iter().any(|s| s.name.ends_with(ending)),
            "no sample of {ending}"
        );
    }
    samples
}

/// Changes a file in one to four places.
fn mutated(sample: &[u8], other: &[u8], seed: u64) -> Vec<u8> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut bytes = sample.to_vec();
    for _ in 0..*[1, 1, 2, 4].choose(&mut random).unwrap() {
        if bytes.is_empty() {
            break;
        }
        match random.random_range(0..8) {
            0 | 1 => {
                let at = random.random_range(0..bytes.len());
                bytes[at] ^= 1 << random.random_range(0..8);
            }
            2 => bytes.truncate(random.random_range(0..=bytes.len())),
            3 => splice(&mut bytes, other, &mut random),
            4 | 5 => replace_number(&mut bytes, &mut random),
            6 => duplicate_line(&mut bytes, &mut random),
            _ => {
                // four bytes of a binary count
                let at = random.random_range(0..bytes.len());
                let value = *[0, 1, 0x7fff_ffff, 0xffff_ffff_u32]
                    .choose(&mut random)
                    .unwrap();
                for (to, from) in bytes[at..].iter_mut().zip(value.to_le_bytes()) {
                    *to = from;
                }
            }
        }
    }
    bytes
}

fn range(length: usize, random: &mut ChaCha8Rng) -> std::ops::Range<usize> {
    let start = random.random_range(0..=length);
    start..random.random_range(start..=length)
}

fn splice(bytes: &mut Vec<u8>, other: &[u8], random: &mut ChaCha8Rng) {
    let (to, from) = (range(bytes.len(), random), range(other.len(), random));
    bytes.splice(to, other[from].iter().copied());
}

fn replace_number(bytes: &mut Vec<u8>, random: &mut ChaCha8Rng) {
    let part_of_number = |b: &u8| b.is_ascii_digit() || b".-+".contains(b);
    let start = random.random_range(0..bytes.len());
    let Some(start) = bytes[start..]
        .iter()
        .position(part_of_number)
        .map(|at| start + at)
    else {
        return;
    };
    let length = bytes[start..]
        .iter()
        .take_while(|b| part_of_number(b))
        .count();
    let bad = BAD_NUMBERS.choose(random).unwrap();
    bytes.splice(start..start + length, bad.bytes());
}

fn duplicate_line(bytes: &mut Vec<u8>, random: &mut ChaCha8Rng) {
    // the memory of the mutations themselves must not count
    if bytes.len() > 100_000 {
        return;
    }
    let lines: Vec<Vec<u8>> = bytes
        .split_inclusive(|&b| b == b'\n')
        .map(<[u8]>::to_vec)
        .collect();
    let line = lines.choose(random).unwrap().clone();
    let times = *[1, 2, 30].choose(random).unwrap();
    let at = random.random_range(0..=lines.len());
    let before: usize = lines[..at].iter().map(Vec::len).sum();
    bytes.splice(before..before, line.repeat(times));
}

/// The most address space this process ever had, in KiB; none where the system does not say.
fn greatest_memory_kib() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmPeak:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

/// Reads all mutations of all files; panics at the first that breaks a promise.
fn read_all_mutations() {
    let samples = samples();
    let mutations = env::var("CARDIOMORPH_MUTATIONS")
        .ok()
        .and_then(|count| count.parse().ok())
        .unwrap_or(MUTATIONS_OF_EACH_FILE);
    let memory_before = greatest_memory_kib();
    let (mut read, mut refused) = (0_u64, 0_u64);
    let mut longest = (Duration::ZERO, String::new());
    let mut greatest = (0, String::new());
    for (index, sample) in samples.iter().enumerate() {
        for mutation in 0..mutations {
            let seed = mutation * samples.len() as u64 + index as u64;
            let other = &samples[(index + mutation as usize) % samples.len()];
            let bytes = mutated(&sample.bytes, &other.bytes, seed);
            let what = format!("{} with seed {seed}", sample.name);
            let start = Instant::now();
            let outcome = catch_unwind(|| read_mesh(&sample.name, &bytes, &Limits::default()));
            let took = start.elapsed();
            assert!(took < LONGEST_READ, "{what} took {took:?}");
            if took > longest.0 {
                longest = (took, what.clone());
            }
            match outcome.unwrap_or_else(|_| panic!("{what} panics")) {
                Ok(file) => {
                    read += 1;
                    check_mesh(&file.frames, &what);
                }
                Err(error) => {
                    refused += 1;
                    check_error(&error, bytes.len(), &what);
                }
            }
            if let (Some(before), Some(now)) = (memory_before, greatest_memory_kib()) {
                let grown = now - before;
                if grown > greatest.0 {
                    greatest = (grown, what.clone());
                }
                assert!(grown < MAX_MEMORY_KIB, "{what} took {grown} KiB of memory");
            }
        }
    }
    println!(
        "{} files, {read} mutations read, {refused} refused, longest {:?} ({}), memory + {} KiB ({})",
        samples.len(),
        longest.0,
        longest.1,
        greatest.0,
        greatest.1
    );
    // mutations that always or never break a file would test nothing
    assert!(read > refused / 20 && refused > read / 20);
}

fn check_mesh(frames: &[cardiomorph::mesh::TriMesh], what: &str) {
    assert!(!frames.is_empty(), "{what}");
    for mesh in frames {
        assert!(!mesh.triangles().is_empty(), "{what}");
        assert!(
            mesh.vertices()
                .iter()
                .all(|p| p.iter().all(|x| x.is_finite())),
            "{what}"
        );
    }
}

/// An error says something, on one short line, about a place that exists.
fn check_error(error: &ReadMeshError, bytes: usize, what: &str) {
    let text = error.to_string();
    assert!(
        !text.is_empty() && text.chars().count() < 600 && !text.contains('\n'),
        "{what}: {text}"
    );
    match error {
        ReadMeshError::AtByte { byte, .. } => assert!(*byte <= bytes, "{what}: {text}"),
        ReadMeshError::AtLine { line, .. } => {
            assert!((1..=bytes + 1).contains(line), "{what}: {text}");
        }
        _ => {}
    }
}

#[test]
fn no_damage_to_a_mesh_file_panics_hangs_or_takes_a_gibibyte() {
    if env::var_os(IN_CHILD).is_some() {
        read_all_mutations();
        return;
    }
    let test = "robustness::no_damage_to_a_mesh_file_panics_hangs_or_takes_a_gibibyte";
    let child = Command::new(env::current_exe().unwrap())
        .args([test, "--exact", "--nocapture", "--test-threads=1"])
        .env(IN_CHILD, "1")
        .env("RUST_BACKTRACE", "0")
        .output()
        .unwrap();
    let (out, err) = (
        String::from_utf8_lossy(&child.stdout),
        String::from_utf8_lossy(&child.stderr),
    );
    assert!(child.status.success(), "{}\n{out}\n{err}", child.status);
    assert!(
        out.contains("mutations read"),
        "the child ran no test:\n{out}\n{err}"
    );
    let summary = out.lines().find(|line| line.contains("mutations read"));
    println!("{}", summary.unwrap_or_default());
    if greatest_memory_kib().is_none() {
        println!("memory was not measured: this system has no /proc/self/status");
    }
}
