//! Cost of the wall: atoms, thickening and verdict, a moved slider, and Laplace thickness beside its peer.

use std::cell::LazyCell;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

use cardiomorph::analysis::experiments::{Noise, NoiseFamily, NoiseReference, noisy_study};
use cardiomorph::analysis::measures::measure_subject;
use cardiomorph::analysis::medial::{MedialParams, medial_beat, medial_surface};
use cardiomorph::analysis::segments::long_axis;
use cardiomorph::analysis::thickening::{ThickeningParams, ThickeningSettings, thickening};
use cardiomorph::analysis::thickness_methods::{
    LabelGrid, ThicknessMethod, ThicknessParams, VoxelLabel, laplace_field, thickness,
};
use cardiomorph::analysis::verdicts::{
    Examined, NotAssessed, VerdictInput, VerdictParams, examine, verdicts,
};
use cardiomorph::engine::{
    MeasuresQuery, MedialSurfacesQuery, Store, StoreOptions, WallThickeningQuery,
};
use cardiomorph::io::{Limits, open_paths};
use cardiomorph::mesh::{Faces, TriMesh, phantom};
use cardiomorph::progress::Progress;
use cardiomorph::study::built_in::{BuiltInParams, cohort};
use cardiomorph::study::{Study, Subject};
use criterion::{Criterion, criterion_group, criterion_main};

/// The noise of the built-in cohort's test: 5 % of the mean square displacement from rest.
const NOISE_PERCENT: f64 = 5.0;

/// Voxels along each side of the shell that the peer measures as well, and its radii in voxels.
const SHELL_VOXELS: usize = 64;
const SHELL_RADII: [f64; 2] = [14.0, 25.0];

/// What benches on [`cohorts`] are called.
const NOISE_NAMES: [&str; 2] = ["clean", "noisy"];

/// The built-in cohort with about this many vertices per heart, as it is and noisy.
fn cohorts(vertices: usize, hearts: usize) -> Option<[Study; 2]> {
    let params = BuiltInParams {
        vertices,
        ..BuiltInParams::default()
    };
    let mut clean = cohort(&params).ok()?.study;
    clean.subjects.truncate(hearts);
    let noise = Noise {
        family: NoiseFamily::Gaussian,
        percent: NOISE_PERCENT,
        reference: NoiseReference::Displacement,
        seed: 1,
    };
    let noisy = noisy_study(&clean, &noise).ok()?;
    Some([clean, noisy])
}

/// Both sheets of a heart and the band between their rims: one closed wall.
fn closed_wall(inner: &TriMesh, outer: &TriMesh) -> Option<TriMesh> {
    let first = inner.vertices().len() as u32;
    let turned = inner.triangles().iter().map(|&[a, b, c]| [a, c, b]);
    let shifted = (outer.triangles().iter()).map(|triangle| triangle.map(|v| v + first));
    let mut triangles: Vec<[u32; 3]> = turned.chain(shifted).collect();
    // Sheets of the cohort have the same connectivity.
    for rim in inner.faces().boundary_loops() {
        for (place, &a) in rim.iter().enumerate() {
            let b = rim[(place + 1) % rim.len()];
            triangles.extend([[a, b, b + first], [a, b + first, a + first]]);
        }
    }
    let points = [inner.vertices(), outer.vertices()].concat();
    let faces = Faces::new(points.len(), triangles).ok()?;
    TriMesh::new(points, faces).ok()
}

/// One pose: 20,000 atoms between two sheets of 20,000 vertices; 40,000 atoms of the same wall as one closed surface; and
/// 40,962 atoms between two spheres.
fn atoms(criterion: &mut Criterion) {
    let Ok(params) = MedialParams::default().check() else {
        return;
    };
    let progress = Progress::default();
    // Made when a bench asks for it.
    let made = LazyCell::new(|| cohorts(40_000, 1));
    for (noise, noise_name) in NOISE_NAMES.into_iter().enumerate() {
        for (name, is_closed) in [("endo_and_epi_40000", false), ("closed_wall_40000", true)] {
            let name = format!("atoms_{name}_{noise_name}");
            criterion.bench_function(&name, |bencher| {
                let Some(studies) = &*made else { return };
                let surfaces = studies[noise].subjects[0].sequence.surfaces();
                let [endo, epi] = [0, 1].map(|surface| &surfaces[surface].frames()[0]);
                let Some(closed) = closed_wall(endo, epi) else {
                    return;
                };
                let outer = [epi];
                let (template, others) = if is_closed {
                    (&closed, &outer[..0])
                } else {
                    (endo, &outer[..])
                };
                match medial_surface(template, others, &params, &progress) {
                    Ok(found) => eprintln!(
                        "{name}: {} atoms, {} of them ends",
                        found.atoms.len(),
                        found.end.iter().flatten().count()
                    ),
                    Err(error) => eprintln!("{name}: {error}"),
                }
                bencher.iter(|| medial_surface(template, others, &params, &progress));
            });
        }
    }
    criterion.bench_function("atoms_spheres_40962", |bencher| {
        let [inner, outer] = [20.0, 28.0].map(|radius| phantom::sphere(6, radius));
        bencher.iter(|| medial_surface(&inner, &[&outer], &params, &progress));
    });
}

/// From surfaces to what a verdict reads.
fn assessed(subject: &Subject) -> Option<Examined> {
    let (progress, measures) = (Progress::default(), measure_subject(subject));
    let medial = MedialParams::default().check().ok()?;
    let params = ThickeningParams::default().check().ok()?;
    let beat = medial_beat(subject, &medial, &progress).ok()?;
    let axis = long_axis(subject, measures.end_diastole?).ok();
    let found = thickening(&beat, &measures, axis.as_ref(), &params, &progress).ok()?;
    let heart = VerdictInput {
        beat: &beat,
        thickening: &found,
    };
    examine(&heart, &VerdictParams::default().check().ok()?).ok()
}

/// One heart of 8 poses from its surfaces to its verdict: by the rule that stands without a cohort, and by that of 23 hearts
/// that were assessed before. 2,500 vertices on both sides together, and on each.
fn hearts(criterion: &mut Criterion) {
    // The tenth heart has a patch.
    const ILL: usize = 9;
    let Ok(params) = VerdictParams::default().check() else {
        return;
    };
    for vertices in [2_500, 5_000] {
        let made = LazyCell::new(|| cohorts(vertices, 23));
        for (noise, noise_name) in NOISE_NAMES.into_iter().enumerate() {
            let name = format!("{vertices}_{noise_name}");
            criterion.bench_function(&format!("surfaces_to_verdict_{name}"), |bencher| {
                let Some(studies) = &*made else { return };
                let subject = &studies[noise].subjects[ILL];
                let alone = Study {
                    subjects: vec![Arc::clone(subject)],
                    ..studies[noise].clone()
                };
                bencher.iter(|| {
                    let examined = assessed(subject)?;
                    verdicts(&alone, &[Ok(examined)], &params, None, &Progress::default()).ok()
                });
            });
            criterion.bench_function(
                &format!("surfaces_to_verdict_in_cohort_{name}"),
                |bencher| {
                    let Some(studies) = &*made else { return };
                    let study = &studies[noise];
                    let mut hearts: Vec<Result<Examined, NotAssessed>> = (study.subjects.iter())
                        .map(|subject| {
                            let nothing = || NotAssessed::NoThickening(String::new());
                            assessed(subject).ok_or_else(nothing)
                        })
                        .collect();
                    bencher.iter(|| {
                        hearts[ILL] = Ok(assessed(&study.subjects[ILL])?);
                        verdicts(study, &hearts, &params, None, &Progress::default()).ok()
                    });
                },
            );
        }
    }
}

/// A place of the shared data, if it is there.
fn shared(place: &str) -> Option<PathBuf> {
    let shared = std::env::var_os("CARDIOMORPH_SHARED").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared"),
        PathBuf::from,
    );
    let path = shared.join("data").join(place);
    if !path.exists() {
        eprintln!("skipped: {} is absent", path.display());
        return None;
    }
    Some(path)
}

/// One heart of the shared data alone.
fn shared_heart(place: &str, id: &str) -> Option<Study> {
    let opened = open_paths(&[shared(place)?], &Limits::default(), &Progress::default()).ok()?;
    let index = opened.study.index_of(id)?;
    Some(Study {
        subjects: vec![Arc::clone(&opened.study.subjects[index])],
        ..opened.study
    })
}

/// The last of the first ten built-in hearts alone; it has a patch.
fn built_in_heart(vertices: usize) -> Option<Study> {
    let [clean, _] = cohorts(vertices, 10)?;
    Some(Study {
        subjects: vec![Arc::clone(clean.subjects.last()?)],
        ..clean
    })
}

/// What the engine does when the slider of the tolerance moves: atoms and measures are known, thickening is not.
fn slider(criterion: &mut Criterion) {
    const ACDC: &str = "acdc_walls/study.toml";
    const CINE: &str = "cine_mri";
    type Heart = fn() -> Option<Study>;
    let mut hearts: Vec<(&str, Heart)> = vec![
        ("built_in_2500", || built_in_heart(2_500)),
        ("built_in_40000", || built_in_heart(40_000)),
    ];
    if shared(ACDC).is_some() && shared(CINE).is_some() {
        hearts.push(("acdc", || shared_heart(ACDC, "patient042")));
        hearts.push(("cine_25_frames", || shared_heart(CINE, "bivme_patient1")));
    }
    for (name, heart) in hearts {
        criterion.bench_function(&format!("slider_{name}"), |bencher| {
            let Some(study) = heart().map(Arc::new) else {
                return;
            };
            let Ok(store) = Store::start(StoreOptions::default()) else {
                return;
            };
            let progress = Progress::default();
            let known = MedialSurfacesQuery {
                subject: 0,
                params: MedialParams::default(),
            };
            if store.answer(&study, &MeasuresQuery, &progress).is_err()
                || store.answer(&study, &known, &progress).is_err()
            {
                eprintln!("{name}: no medial surface");
            }
            let mut moved = 0_u32;
            bencher.iter(|| {
                moved += 1;
                let mut settings = ThickeningSettings::default();
                // Never twice the same, so that no answer is known.
                settings.patches.tolerance = Some(0.05 + 1e-7 * f64::from(moved));
                let query = WallThickeningQuery {
                    subject: 0,
                    settings,
                };
                store.answer(&study, &query, &progress)
            });
        });
    }
}

/// A spherical shell of voxels: the mask that the peer is given.
fn shell() -> Option<LabelGrid> {
    let middle = 0.5 * (SHELL_VOXELS - 1) as f64;
    let square = |voxel: usize| (voxel as f64 - middle).powi(2);
    let labels = (0..SHELL_VOXELS.pow(3))
        .map(|voxel| {
            let [x, y, z] = [1, SHELL_VOXELS, SHELL_VOXELS * SHELL_VOXELS]
                .map(|stride| voxel / stride % SHELL_VOXELS);
            let away = (square(x) + square(y) + square(z)).sqrt();
            match away {
                _ if away < SHELL_RADII[0] => VoxelLabel::Cavity,
                _ if away < SHELL_RADII[1] => VoxelLabel::Wall,
                _ => VoxelLabel::Outside,
            }
        })
        .collect();
    LabelGrid::new([SHELL_VOXELS; 3], [1.0; 3], labels).ok()
}

/// Laplace's equation on voxels, and every method on a heart.
fn laplace(criterion: &mut Criterion) {
    let progress = Progress::default();
    criterion.bench_function("laplace_shell_64", |bencher| {
        let Some(grid) = shell() else { return };
        if let Ok(field) = laplace_field(&grid, &progress) {
            let told = field.thickness.iter().filter(|value| value.is_finite());
            let mean = told.clone().sum::<f64>() / told.count() as f64;
            // The peer prints its own beside it: so both are seen to do the same work.
            eprintln!(
                "Laplace on a shell of {} voxels: mean thickness {mean:.6}",
                field.voxels.len()
            );
        }
        bencher.iter(|| laplace_field(&grid, &progress));
    });
    let Ok(params) = ThicknessParams::default().check() else {
        return;
    };
    for (name, method) in [
        ("laplace", ThicknessMethod::Laplace),
        ("centreline", ThicknessMethod::Centreline),
        ("volume_over_area", ThicknessMethod::VolumeOverArea),
        ("nearest", ThicknessMethod::Nearest),
    ] {
        criterion.bench_function(&format!("thickness_{name}_2500"), |bencher| {
            let Some(study) = built_in_heart(2_500) else {
                return;
            };
            bencher.iter(|| thickness(&study.subjects[0], 0, method, &params, &progress));
        });
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default()
        .sample_size(20)
        .warm_up_time(Duration::from_millis(500))
        .measurement_time(Duration::from_secs(3));
    targets = atoms, hearts, slider, laplace
}
criterion_main!(benches);
