//! A template on hearts whose vertices do not correspond.

mod refused;

use std::sync::Arc;

use rand::seq::SliceRandom;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::analysis::alignment::RigidMotion;
use crate::mesh::{Decimation, Faces, Point3, TriMesh, Vector3, mean_point, phantom};
use crate::progress::{Progress, Stopped};
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{Anatomy, Study, Subject, SurfaceKind};

fn hearts(vertices: usize) -> Study {
    let params = BuiltInParams {
        vertices,
        ..BuiltInParams::default()
    };
    cohort(&params).unwrap().study
}

fn frames_of(subject: &Subject) -> Vec<SurfaceFrames> {
    let surfaces = subject.sequence.surfaces().iter();
    let of = surfaces.map(|surface| SurfaceFrames {
        kind: surface.kind(),
        frames: surface.frames().to_vec(),
    });
    of.collect()
}

/// Other vertices in another order, other faces in another order and winding: nothing corresponds.
fn remeshed(mesh: &TriMesh, vertices: usize, seed: u64) -> TriMesh {
    let coarse = Decimation::new(mesh.vertices(), mesh.faces(), vertices, || true).unwrap();
    let points = coarse.restricted(mesh.vertices());
    shuffled(&points, coarse.faces().triangles(), seed)
}

fn shuffled(points: &[Point3], triangles: &[[u32; 3]], seed: u64) -> TriMesh {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut place: Vec<u32> = (0..points.len() as u32).collect();
    place.shuffle(&mut random);
    let mut moved = vec![Point3::origin(); points.len()];
    for (point, &to) in points.iter().zip(&place) {
        moved[to as usize] = *point;
    }
    let mut turned: Vec<[u32; 3]> = triangles.to_vec();
    turned.shuffle(&mut random);
    let flipped = random.random::<bool>();
    let triangles = turned.into_iter().map(|[a, b, c]| {
        let [a, b, c] = [a, b, c].map(|v| place[v as usize]);
        if flipped { [a, c, b] } else { [a, b, c] }
    });
    let faces = Faces::new(points.len(), triangles.collect()).unwrap();
    TriMesh::new(moved, Arc::new(faces)).unwrap()
}

/// Landmarks as proposed, default settings.
fn registered(
    template: &Template,
    frames: &[SurfaceFrames],
    anatomy: Option<&Anatomy>,
) -> Result<Corresponding, CorrespondenceError> {
    let progress = Progress::default();
    let targets = Targets::new(template, frames, anatomy, &progress)?;
    let landmarks = propose_landmarks(&targets, &progress)?;
    let params = CheckedCorrespondenceParams::default();
    correspond(template, &targets, &landmarks, &params, &progress)
}

/// All vertices at a frame.
fn pose(made: &Corresponding, frame: usize) -> Vec<Point3> {
    made.sequence.pose(frame).unwrap()
}

fn greatest_distance(a: &[Point3], b: &[Point3]) -> f64 {
    assert_eq!(a.len(), b.len());
    let away = a.iter().zip(b).map(|(p, q)| (p - q).norm());
    away.fold(0.0, f64::max)
}

fn moved(frames: &[SurfaceFrames], by: impl Fn(&Point3) -> Point3) -> Vec<SurfaceFrames> {
    let mesh = |mesh: &TriMesh| {
        let points: Vec<Point3> = mesh.vertices().iter().map(&by).collect();
        TriMesh::new(points, Arc::clone(mesh.faces())).unwrap()
    };
    let of = frames.iter().map(|surface| SurfaceFrames {
        kind: surface.kind,
        frames: surface.frames.iter().map(mesh).collect(),
    });
    of.collect()
}

/// One frame of each surface.
fn first(mut frames: Vec<SurfaceFrames>) -> Vec<SurfaceFrames> {
    for surface in &mut frames {
        surface.frames.truncate(1);
    }
    frames
}

fn alone(kind: SurfaceKind, mesh: TriMesh) -> Vec<SurfaceFrames> {
    let frames = vec![mesh];
    vec![SurfaceFrames { kind, frames }]
}

/// A surface with a lid of triangles around the middle of its rim.
fn closed(mesh: &TriMesh) -> TriMesh {
    let mut points = mesh.vertices().to_vec();
    let mut triangles = mesh.triangles().to_vec();
    let rim = &mesh.faces().boundary_loops()[0];
    let middle = points.len() as u32;
    points.push(mean_point(
        rim.iter()
            .map(|&v| points[v as usize])
            .collect::<Vec<_>>()
            .into_iter(),
    ));
    for (index, &from) in rim.iter().enumerate() {
        triangles.push([rim[(index + 1) % rim.len()], from, middle]);
    }
    let faces = Faces::new(points.len(), triangles).unwrap();
    TriMesh::new(points, faces).unwrap()
}

#[test]
fn a_template_lies_on_itself() {
    let study = hearts(1_000);
    let own = &study.subjects[0];
    let template = Template::of_subject(own).unwrap();
    let made = registered(&template, &first(frames_of(own)), own.anatomy.as_ref()).unwrap();
    assert!(greatest_distance(&pose(&made, 0), &own.sequence.pose(0).unwrap()) < 1e-9);
    assert_eq!(
        made.sequence.correspondence(),
        own.sequence.correspondence()
    );
    for fit in &made.fits {
        assert!(
            fit.mean < 1e-9 && fit.p95 < 1e-9 && fit.foldovers == 0,
            "{fit:?}"
        );
        let [volume, wanted] = [fit.volume, fit.surface_volume.unwrap()];
        assert!((volume / wanted - 1.0).abs() < 1e-9);
    }
    let [found, known] = [made.anatomy.unwrap(), own.anatomy.unwrap()];
    assert!((found.base - known.base).norm() < 1.0 && (found.apex - known.apex).norm() < 2.0);
    assert!(found.septal.dot(&known.septal) > 0.999 && found.anterior.dot(&known.anterior) > 0.99);
}

#[test]
fn an_affine_copy_with_its_landmarks_is_met_vertex_by_vertex() {
    let study = hearts(1_000);
    let own = &study.subjects[2];
    let template = Template::of_subject(own).unwrap();
    let map = |p: &Point3| {
        Point3::new(
            1.2 * p.x + 0.1 * p.y,
            0.9 * p.y - 0.2 * p.z,
            1.1 * p.z + 7.0,
        )
    };
    let frames = moved(&first(frames_of(own)), map);
    let progress = Progress::default();
    let targets = Targets::new(&template, &frames, own.anatomy.as_ref(), &progress).unwrap();
    let mut landmarks = propose_landmarks(&targets, &progress).unwrap();
    for (kind, own) in &mut landmarks.surfaces {
        let from = template.landmarks(*kind).unwrap();
        own[0] = SurfaceLandmarks {
            points: from.points.each_ref().map(map),
        };
    }
    let params = CheckedCorrespondenceParams::default();
    let made = correspond(&template, &targets, &landmarks, &params, &progress).unwrap();
    let expected: Vec<Point3> = own.sequence.pose(0).unwrap().iter().map(map).collect();
    assert!(greatest_distance(&pose(&made, 0), &expected) < 1e-6);
}

#[test]
fn meshes_without_correspondence_get_that_of_the_template_at_all_frames() {
    let [fine, plain] = [6_000, 2_500].map(hearts);
    let template = Template::of_subject(&plain.subjects[0]).unwrap();
    for index in [0, 13] {
        let from = &fine.subjects[index];
        let mut frames = frames_of(from);
        for surface in &mut frames {
            for (frame, mesh) in surface.frames.iter_mut().enumerate() {
                *mesh = remeshed(mesh, 1_400 + 150 * frame, frame as u64);
            }
        }
        let made = registered(&template, &frames, from.anatomy.as_ref()).unwrap();
        let real = &plain.subjects[index].sequence;
        assert_eq!(made.sequence.correspondence(), real.correspondence());
        assert_eq!(made.fits.len(), 16);
        for fit in &made.fits {
            assert!(
                fit.mean < 0.05 && fit.p95 < 0.15 && fit.foldovers == 0,
                "{fit:?}"
            );
            let [volume, wanted] = [fit.volume, fit.surface_volume.unwrap()];
            assert!((volume / wanted - 1.0).abs() < 1e-3, "{fit:?}");
        }
        // Vertices are where the model has them, but for torsion, which a bare surface does not show: none at first.
        let away = |frame| greatest_distance(&pose(&made, frame), &real.pose(frame).unwrap());
        assert!(away(0) < 4.0, "{}", away(0));
    }
}

#[test]
fn where_nobody_says_where_the_septum_is_the_form_does_and_a_warning_says_so() {
    let study = hearts(1_000);
    let template = Template::of_subject(&study.subjects[0]).unwrap();
    let own = &study.subjects[4];
    let targets = |anatomy| {
        Targets::new(
            &template,
            &first(frames_of(own)),
            anatomy,
            &Progress::default(),
        )
        .unwrap()
    };
    let [known, found] = [targets(own.anatomy.as_ref()), targets(None)];
    let angle = known.axes[0].septal.angle(&found.axes[0].septal);
    assert!(angle.to_degrees() < 8.0, "{}", angle.to_degrees());
    assert!(known.notices.is_empty());
    assert!(found.notices[0].text.contains("septum"));
    let made = registered(&template, &first(frames_of(own)), None).unwrap();
    assert!(made.anatomy.is_none());
}

#[test]
fn a_subject_that_is_moved_has_moved_vertices() {
    let study = hearts(1_000);
    let template = Template::of_subject(&study.subjects[0]).unwrap();
    let own = &study.subjects[3];
    let mut frames = frames_of(own);
    for surface in &mut frames {
        surface.frames.truncate(2);
    }
    let motion = RigidMotion {
        rotation: *nalgebra::Rotation3::from_euler_angles(0.7, -0.4, 2.0).matrix(),
        translation: Vector3::new(30.0, -80.0, 12.0),
    };
    let anatomy = own.anatomy.map(|a| Anatomy {
        apex: motion.apply(&a.apex),
        base: motion.apply(&a.base),
        septal: motion.rotation * a.septal,
        anterior: motion.rotation * a.anterior,
    });
    let here = registered(&template, &frames, own.anatomy.as_ref()).unwrap();
    let there = moved(&frames, |p| motion.apply(p));
    let there = registered(&template, &there, anatomy.as_ref()).unwrap();
    for frame in 0..2 {
        let expected: Vec<Point3> = pose(&here, frame).iter().map(|p| motion.apply(p)).collect();
        let away = greatest_distance(&pose(&there, frame), &expected);
        assert!(away < 1e-5, "{frame}: {away}");
    }
}

#[test]
fn a_blood_pool_that_is_closed_is_opened_at_its_wider_end() {
    let study = hearts(2_500);
    let template = Template::of_subject(&study.subjects[0]).unwrap();
    let own = &study.subjects[5];
    let surface = &frames_of(own)[0];
    let cavity = alone(SurfaceKind::Cavity, closed(&surface.frames[0]));
    let made = registered(&template, &cavity, None).unwrap();
    assert_eq!(made.sequence.surfaces()[0].kind(), SurfaceKind::Endocardium);
    let fit = made.fits[0];
    assert!(fit.mean < 0.2 && fit.foldovers == 0, "{fit:?}");
    let open = registered(
        &template,
        &alone(surface.kind, surface.frames[0].clone()),
        None,
    );
    let whole = open.unwrap().fits[0].volume;
    assert!(
        (0.9..1.0).contains(&(fit.volume / whole)),
        "{} {whole}",
        fit.volume
    );
    assert!(
        made.notices
            .iter()
            .any(|n| n.text.contains("closed at the base"))
    );
}

#[test]
fn a_wall_in_one_surface_is_split_into_its_sides() {
    let study = hearts(2_500);
    let template = Template::of_subject(&study.subjects[0]).unwrap();
    let own = &study.subjects[6];
    let [endo, epi] = [0, 1].map(|k| own.sequence.surfaces()[k].frames()[0].clone());
    let count = endo.vertices().len() as u32;
    let mut triangles = Faces::joined(&[endo.faces(), epi.faces()])
        .triangles()
        .to_vec();
    let rim = &endo.faces().boundary_loops()[0];
    for (index, &from) in rim.iter().enumerate() {
        let to = rim[(index + 1) % rim.len()];
        triangles.extend([[to, from, from + count], [to, from + count, to + count]]);
    }
    let points: Vec<Point3> = endo
        .vertices()
        .iter()
        .chain(epi.vertices())
        .copied()
        .collect();
    let wall = TriMesh::new(points, Faces::new(2 * count as usize, triangles).unwrap()).unwrap();
    let wall = alone(SurfaceKind::Wall, wall);
    let made = registered(&template, &wall, own.anatomy.as_ref()).unwrap();
    let sides = registered(&template, &first(frames_of(own)), own.anatomy.as_ref()).unwrap();
    assert_eq!(made.fits.len(), 2);
    for (split, given) in made.fits.iter().zip(&sides.fits) {
        assert_eq!(split.kind, given.kind);
        assert!(
            (split.volume / given.volume - 1.0).abs() < 0.02,
            "{split:?} {given:?}"
        );
        assert!(split.mean < 0.3 && split.foldovers == 0, "{split:?}");
    }
}
