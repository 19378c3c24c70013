//! Subjects over the beat.

use super::*;
use crate::progress::Stopped;
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

fn subject(surfaces: Vec<(SurfaceKind, Vec<TriMesh>)>) -> Subject {
    let surfaces = (surfaces.into_iter())
        .map(|(kind, frames)| SurfaceSequence::new(kind, frames).unwrap())
        .collect();
    Subject::new(
        "heart",
        MeshSequence::new(surfaces).unwrap(),
        LengthUnit::Millimetre,
    )
}

fn beat(subject: &Subject) -> Result<MedialBeat, MedialError> {
    medial_beat(subject, &usual(), &Progress::default())
}

#[test]
fn thickening_of_a_shell_is_the_ratio_of_its_radii() {
    let frames = |radii: [f64; 2]| {
        let first = phantom::sphere(3, radii[0]);
        let second = moved(&first, |_, p| Point3::from(radii[1] / radii[0] * p.coords));
        vec![first, second]
    };
    let heart = subject(vec![
        (SurfaceKind::Endocardium, frames([20.0, 15.0])),
        (SurfaceKind::Epicardium, frames([28.0, 26.0])),
    ]);
    let beat = beat(&heart).unwrap();
    assert_eq!(beat.surface, SurfaceKind::Endocardium);
    assert!(beat.regular.iter().all(|&regular| regular));
    for (a, b) in beat.frames[0].atoms.iter().zip(&beat.frames[1].atoms) {
        assert!((b.radius / a.radius / 1.375 - 1.0).abs() < 0.02);
    }
}

#[test]
fn of_rough_surfaces_every_pose_has_its_own_thickness() {
    let outer = [28.0, 30.0, 26.0, 29.0, 27.0];
    let frames = |radii: [f64; 5], seed: f64| -> Vec<TriMesh> {
        let poses = (0..).zip(radii);
        poses
            .map(|(pose, radius)| rough(&phantom::sphere(3, radius), 0.6, seed + f64::from(pose)))
            .collect()
    };
    let heart = subject(vec![
        (SurfaceKind::Endocardium, frames([20.0; 5], 0.3)),
        (SurfaceKind::Epicardium, frames(outer, 40.7)),
    ]);
    let beat = beat(&heart).unwrap();
    for (frame, outer) in beat.frames.iter().zip(outer) {
        let sum: f64 = frame.atoms.iter().map(|atom| atom.radius).sum();
        let mean = sum / frame.atoms.len() as f64;
        let expected = 0.5 * (outer - 20.0);
        assert!((mean / expected - 1.0).abs() < 0.04, "{mean} {expected}");
    }
}

#[test]
fn the_template_of_a_closed_wall_is_its_inner_side() {
    let cup = closed_cup(20.0, 28.0, 20, 40);
    let beat = beat(&subject(vec![(SurfaceKind::Wall, vec![cup.clone(); 2])])).unwrap();
    assert_eq!(beat.surface, SurfaceKind::Wall);
    assert_eq!(beat.vertices, (0..801).collect::<Vec<u32>>());
    assert_eq!(beat.faces.triangles().len(), 40 + 2 * 40 * 19);
    let whole = surface(&cup, &[], &usual()).unwrap();
    for (atom, &vertex) in beat.vertices.iter().enumerate() {
        let (a, b) = (beat.frames[1].atoms[atom], whole.atoms[vertex as usize]);
        assert!((a.position - b.position).norm() < 1e-9);
        assert!((a.position - cup.vertices()[vertex as usize]).norm() < 8.0);
    }
    let regular = beat.regular.iter().filter(|&&regular| regular).count();
    assert!((600..=761).contains(&regular), "{regular}");
}

#[test]
fn built_in_hearts_thicken_but_for_their_patches() {
    let hearts = cohort(&BuiltInParams {
        vertices: 1_200,
        ..BuiltInParams::default()
    })
    .unwrap();
    let (heart, truth) = (&hearts.study.subjects[0], &hearts.truths[0]);
    assert_eq!(truth.patches, 0);
    let found = beat(heart).unwrap();
    assert!(found.frames.iter().all(all_finite));
    let regular: Vec<usize> = (0..found.regular.len())
        .filter(|&a| found.regular[a])
        .collect();
    assert!(regular.len() * 10 > 9 * found.regular.len());
    let mut ratios: Vec<f64> = (regular.iter())
        .map(|&a| {
            let radii = found.frames.iter().map(|f| f.atoms[a].radius);
            radii.fold(0.0, f64::max) / found.frames[0].atoms[a].radius
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    assert!((1.2..2.2).contains(&ratios[ratios.len() / 2]));
}

#[test]
fn the_number_of_threads_does_not_change_a_bit() {
    let hearts = cohort(&BuiltInParams {
        vertices: 1_200,
        ..BuiltInParams::default()
    })
    .unwrap();
    let found = [1, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| beat(&hearts.study.subjects[9]).unwrap())
    });
    assert_eq!(found[0], found[1]);
}

#[test]
fn a_cavity_alone_and_an_open_wall_have_no_atoms() {
    let cavity = subject(vec![(SurfaceKind::Cavity, vec![phantom::bowl(1.0, 5, 12)])]);
    assert_eq!(
        beat(&cavity).unwrap_err().to_string(),
        "no wall: endocardium and epicardium, or a closed wall, are needed, but there is only cavity"
    );
    let open = subject(vec![(SurfaceKind::Wall, vec![phantom::bowl(1.0, 5, 12)])]);
    let error = beat(&open).unwrap_err();
    assert_eq!(
        error.to_string(),
        "wall: one sheet with 1 open ends encloses no myocardium"
    );
}

#[test]
fn a_frame_whose_sides_coincide_is_named() {
    let [endo, epi] = [1.0, 1.4].map(|radius| phantom::sphere(2, radius));
    let collapsed = moved(&endo, |_, p| Point3::from(1.4 * p.coords));
    let heart = subject(vec![
        (
            SurfaceKind::Endocardium,
            vec![endo.clone(), endo, collapsed],
        ),
        (SurfaceKind::Epicardium, vec![epi; 3]),
    ]);
    let error = beat(&heart).unwrap_err().to_string();
    assert!(error.starts_with("frame 2: 162 of 162 vertices"), "{error}");
}

#[test]
fn a_stopped_beat_says_so() {
    let progress = Progress::default();
    progress.stop();
    let frames = |radius: f64| vec![phantom::sphere(2, radius); 3];
    let heart = subject(vec![
        (SurfaceKind::Endocardium, frames(1.0)),
        (SurfaceKind::Epicardium, frames(1.4)),
    ]);
    let stopped = medial_beat(&heart, &usual(), &progress).unwrap_err();
    assert_eq!(stopped, MedialError::Stopped(Stopped));
}

#[test]
fn progress_counts_every_step() {
    let progress = Progress::default();
    let frames = |radius: f64| vec![phantom::sphere(2, radius); 3];
    let heart = subject(vec![
        (SurfaceKind::Endocardium, frames(1.0)),
        (SurfaceKind::Epicardium, frames(1.4)),
    ]);
    medial_beat(&heart, &usual(), &progress).unwrap();
    assert_eq!(progress.fraction(), 1.0);
}
