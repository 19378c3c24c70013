//! Cost of opening one heart of 25 frames × 2 surfaces: built in, written in three formats, and, where the real data
//! lie beside the checkout, from cine MRI.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use cardiomorph::io::{Limits, MeshFormat, Opened, open_paths, write_study};
use cardiomorph::mesh::{Point3, TriMesh};
use cardiomorph::progress::Progress;
use cardiomorph::study::built_in::{BuiltInParams, cohort};
use cardiomorph::study::{MeshSequence, Study, Subject, SurfaceSequence};
use cardiomorph::units::LengthUnit;
use criterion::{Criterion, criterion_group, criterion_main};

const FRAMES: usize = 25;

/// A closed beat at `FRAMES` equal steps, linear between the given ones.
fn resampled(beat: &SurfaceSequence) -> Option<SurfaceSequence> {
    let poses = beat.frames();
    let frames = (0..FRAMES)
        .filter_map(|frame| {
            let position = (frame * poses.len()) as f64 / FRAMES as f64;
            let (from, blend) = (position as usize, position.fract());
            let before = poses[from].vertices();
            let after = poses[(from + 1) % poses.len()].vertices();
            let between = before.iter().zip(after);
            let vertices: Vec<Point3> = between.map(|(p, q)| p + blend * (q - p)).collect();
            TriMesh::new(vertices, Arc::clone(beat.faces())).ok()
        })
        .collect();
    SurfaceSequence::new(beat.kind(), frames).ok()
}

/// The first built-in heart, 25 frames of endo and epi, about as fine as a model fitted to cine MRI.
fn built_in_heart() -> Option<Study> {
    let params = BuiltInParams {
        vertices: 3_200,
        ..BuiltInParams::default()
    };
    let heart = cohort(&params).ok()?.study.subjects.into_iter().next()?;
    let surfaces = heart.sequence.surfaces().iter().filter_map(resampled);
    let sequence = MeshSequence::new(surfaces.collect()).ok()?;
    let subject = Subject::new("built-in", sequence, LengthUnit::Millimetre);
    Some(Study {
        subjects: vec![Arc::new(subject)],
        ..Study::default()
    })
}

fn open(folder: &Path) -> Option<Opened> {
    open_paths(
        &[folder.to_owned()],
        &Limits::default(),
        &Progress::default(),
    )
    .ok()
}

/// A bench that opened less than it says would show a fine figure for nothing.
fn opens_whole(folder: &Path) -> bool {
    open(folder).is_some_and(|opened| {
        let subjects = &opened.study.subjects;
        opened.errors.is_empty()
            && subjects.len() == 1
            && subjects.iter().all(|subject| {
                let sequence = &subject.sequence;
                sequence.frame_count() == FRAMES && sequence.surfaces().len() == 2
            })
    })
}

fn bench(criterion: &mut Criterion, name: &str, folder: &Path) {
    if opens_whole(folder) {
        criterion.bench_function(name, |bencher| bencher.iter(|| open(folder)));
    } else {
        eprintln!("skipped {name}: not {FRAMES} frames of two surfaces");
    }
}

fn read(criterion: &mut Criterion) {
    let (Some(study), Ok(folder)) = (built_in_heart(), tempfile::tempdir()) else {
        eprintln!("skipped: the built-in heart could not be made");
        return;
    };
    for format in MeshFormat::all() {
        let ending = format.extension();
        let folder = folder.path().join(ending);
        if let Err(error) = write_study(&study, &folder, format, &Progress::default()) {
            eprintln!("skipped {ending}: {error}");
            continue;
        }
        bench(
            criterion,
            &format!("open 25 × 2 surfaces, {ending}"),
            &folder,
        );
    }
    let beside = concat!(env!("CARGO_MANIFEST_DIR"), "/../shared");
    let shared =
        std::env::var_os("CARDIOMORPH_SHARED").map_or_else(|| beside.into(), PathBuf::from);
    let real = shared.join("data/cine_mri/bivme_patient1");
    if real.is_dir() {
        bench(criterion, "open 25 × 2 surfaces, cine MRI", &real);
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = read
}
criterion_main!(benches);
