//! Maps of paths whose places are known, laws, and the built-in cohort.

use nalgebra::Rotation3;

use super::*;
use crate::analysis::embedding::MapMethod;
use crate::analysis::measures::measure_subject;
use crate::analysis::medial::{MedialBeat, MedialParams, medial_beat};
use crate::analysis::medial_space::{PoseDescriptor, pose_distance};
use crate::analysis::segments::{LongAxis, long_axis};
use crate::analysis::thickening::{Thickening, ThickeningParams, WallThickening, thickening};
use crate::mesh::{Point3, Vector3};
use crate::progress::{Progress, Stopped};
use crate::study::Subject;
use crate::study::built_in::{BuiltInParams, cohort};

fn pose(position: Point3, normal: Vector3) -> PoseDescriptor {
    PoseDescriptor {
        position,
        log_ratio: 0.0,
        rho: 0.1,
        normal: Some(normal),
    }
}

/// A box of 20 by 30 by 40 around (100, 0, 0).
fn corners() -> Vec<Point3> {
    [-1.0, 1.0]
        .map(|s| Point3::new(100.0 + 10.0 * s, 15.0 * s, 20.0 * s))
        .to_vec()
}

fn heart(steps: &[PoseDescriptor], axis: Option<&LongAxis>) -> SubjectPaths {
    let steps = steps.iter().enumerate();
    SubjectPaths {
        paths: vec![AkineticPath {
            part: AkineticPart::Whole,
            steps: steps
                .map(|(from, &descriptor)| PathStep {
                    from,
                    to: from + 1,
                    descriptor,
                })
                .collect(),
        }],
        placements: Frame::ALL.map(|frame| Placement::new(frame, axis, &corners())),
    }
}

fn mapped(hearts: &[Result<SubjectPaths, String>]) -> Result<MedialMap, MedialMapError> {
    medial_map(hearts, MapMethod::ClassicalMds, &Progress::default())
}

#[test]
fn poses_that_differ_by_place_alone_lie_at_their_distance_in_sizes_of_the_heart() {
    let at = |x, y| pose(Point3::new(100.0 + x, y, 0.0), Vector3::z());
    let first = heart(&[at(0.0, 0.0), at(12.0, 0.0)], None);
    let second = heart(&[at(0.0, 16.0)], None);
    let map = mapped(&[Ok(first), Err("no wall".to_owned()), Ok(second)]).unwrap();
    assert_eq!(map.left_out, [(1, "no wall".to_owned())]);
    assert_eq!(map.frame, Frame::Files);
    let subjects: Vec<usize> = map.poses.iter().map(|pose| pose.subject).collect();
    assert_eq!(subjects, [0, 0, 2]);
    // 3 : 4 : 5, with the box 40 high.
    for (i, j, distance) in [(0, 1, 0.3), (0, 2, 0.4), (1, 2, 0.5)] {
        let [p, q] = [i, j].map(|row| map.embedding.point(row));
        let apart = (p[0] - q[0]).hypot(p[1] - q[1]);
        assert!((apart - distance).abs() < 1e-12, "{apart}");
        assert!((map.distances.get(i, j) - distance).abs() < 1e-12);
    }
    assert!(map.embedding.stress.unwrap() < 1e-9);
    let distances: Vec<_> = map.spreads.iter().map(|s| s.mean_distance).collect();
    assert!((distances[0].unwrap() - 0.3).abs() < 1e-12 && distances[1].is_none());
}

#[test]
fn the_least_known_heart_says_in_which_axes_all_are_compared() {
    let lying = LongAxis::new(Point3::origin(), Point3::new(9.0, 0.0, 0.0), Vector3::z()).unwrap();
    let oriented = LongAxis::oriented(lying.apex, lying.base, Vector3::z(), Vector3::y()).unwrap();
    let steps = [
        pose(Point3::origin(), Vector3::x()),
        pose(Point3::origin(), Vector3::y()),
    ];
    let hearts = |axes: [Option<&LongAxis>; 2]| axes.map(|axis| Ok(heart(&steps, axis)));
    for (axes, frame) in [
        ([Some(&oriented), Some(&oriented)], Frame::Anatomical),
        ([Some(&oriented), Some(&lying)], Frame::LongAxis),
        ([Some(&oriented), None], Frame::Files),
    ] {
        let map = mapped(&hearts(axes)).unwrap();
        assert_eq!(map.frame, frame);
        let normal = map.poses[0].descriptor.normal.unwrap();
        let base = if frame == Frame::Files {
            Vector3::x()
        } else {
            Vector3::z()
        };
        assert!((normal - base).norm() < 1e-12, "{frame:?} {normal}");
    }
    // Septum to x and the anterior wall to y.
    let normal = mapped(&hearts([Some(&oriented); 2])).unwrap().poses[1]
        .descriptor
        .normal;
    assert!((normal.unwrap() - Vector3::y()).norm() < 1e-12);
}

#[test]
fn two_poses_make_no_map_and_a_stopped_one_says_so() {
    let steps = [pose(Point3::origin(), Vector3::x()); 2];
    let error = mapped(&[Ok(heart(&steps, None)), Err(String::new())]);
    let too_few = MedialMapError::TooFewPoses {
        poses: 2,
        hearts: 1,
    };
    assert_eq!(error, Err(too_few));
    let progress = Progress::default();
    progress.stop();
    let hearts = [Ok(heart(&[steps[0]; 5], None))];
    let stopped = medial_map(&hearts, MapMethod::Smacof, &progress);
    assert_eq!(stopped, Err(MedialMapError::Stopped(Stopped)));
}

#[test]
fn a_pose_that_is_not_finite_is_named() {
    let mut wrong = pose(Point3::origin(), Vector3::x());
    wrong.log_ratio = f64::NAN;
    let good = heart(&[pose(Point3::origin(), Vector3::x()); 3], None);
    let error = mapped(&[Ok(good), Ok(heart(&[wrong], None))]);
    assert_eq!(error, Err(MedialMapError::NotFinite { subject: 0 }));
}

/// What is known of one subject of the built-in cohort.
struct Known {
    subject: Subject,
    beat: MedialBeat,
    found: Thickening,
    axis: LongAxis,
}

fn known(subject: &Subject) -> Known {
    let progress = Progress::default();
    let medial = MedialParams::default().check().unwrap();
    let beat = medial_beat(subject, &medial, &progress).unwrap();
    let params = ThickeningParams {
        redraws: 0,
        ..ThickeningParams::default()
    };
    let measures = measure_subject(subject);
    let axis = long_axis(subject, measures.end_diastole.unwrap()).unwrap();
    let params = params.check().unwrap();
    let found = thickening(&beat, &measures, Some(&axis), &params, &progress).unwrap();
    Known {
        subject: subject.clone(),
        beat,
        found,
        axis,
    }
}

fn paths(known: &Known) -> SubjectPaths {
    subject_paths(&known.beat, &known.found, Some(&known.axis)).unwrap()
}

fn hearts_of_the_cohort() -> Vec<Known> {
    let params = BuiltInParams {
        vertices: 600,
        ..BuiltInParams::default()
    };
    let study = cohort(&params).unwrap().study;
    study
        .subjects
        .iter()
        .map(|subject| known(subject))
        .collect()
}

#[test]
fn each_patch_has_its_path_and_hearts_without_one_wander() {
    let hearts = hearts_of_the_cohort();
    let all: Vec<_> = hearts.iter().map(|heart| Ok(paths(heart))).collect();
    let map = mapped(&all).unwrap();
    assert_eq!(map.frame, Frame::Anatomical);
    for (index, heart) in hearts.iter().enumerate() {
        let parts: Vec<AkineticPart> = (map.spreads.iter())
            .filter(|spread| spread.subject == index)
            .map(|spread| spread.part)
            .collect();
        let count = heart.found.patches.len();
        let wanted = match count {
            0 => vec![AkineticPart::Whole],
            _ => (0..count).map(AkineticPart::Patch).collect(),
        };
        assert_eq!(parts, wanted, "{}", heart.subject.id);
    }
    assert!(hearts.iter().any(|heart| heart.found.patches.len() > 1));
    // "The poses of the abnormal subject have roughly the same ANV and MP" (4.7).
    let spreads = |patch: bool| -> Vec<f64> {
        let mut distances: Vec<f64> = (map.spreads.iter())
            .filter(|spread| spread.part.patch().is_some() == patch)
            .filter(|spread| {
                patch || hearts[spread.subject].found.wall_thickening == WallThickening::Everywhere
            })
            .filter_map(|spread| spread.mean_distance)
            .collect();
        distances.sort_by(f64::total_cmp);
        distances
    };
    let (patches, others) = (spreads(true), spreads(false));
    let (widest, middle) = (patches[patches.len() - 1], others[others.len() / 2]);
    assert!(widest < 0.1, "{patches:?}");
    assert!(middle > 3.0 * widest, "{patches:?} {others:?}");
}

#[test]
fn neither_place_nor_size_nor_how_a_heart_lies_changes_the_map() {
    let heart = known(
        &cohort(&BuiltInParams {
            vertices: 600,
            ..BuiltInParams::default()
        })
        .unwrap()
        .study
        .subjects[13],
    );
    let turn = Rotation3::from_euler_angles(0.7, -1.1, 2.0);
    let motion = |p: Point3| Point3::from(3.0 * (turn * p.coords) + Vector3::new(5.0, -80.0, 9.0));
    let mut moved = paths(&heart);
    for step in moved.paths.iter_mut().flat_map(|path| &mut path.steps) {
        step.descriptor.position = motion(step.descriptor.position);
        step.descriptor.normal = step.descriptor.normal.map(|normal| turn * normal);
    }
    let axis = &heart.axis;
    let moved_axis = LongAxis::oriented(
        motion(axis.apex),
        motion(axis.base),
        turn * axis.septal.unwrap(),
        turn * axis.anterior.unwrap(),
    );
    let rest = &heart.beat.frames[heart.found.end_diastole].atoms;
    let centres: Vec<Point3> = rest.iter().map(|atom| motion(atom.position)).collect();
    moved.placements = Frame::ALL.map(|frame| Placement::new(frame, moved_axis.as_ref(), &centres));
    let map = mapped(&[Ok(paths(&heart)), Ok(moved)]).unwrap();
    let (first, second) = map.poses.split_at(map.poses.len() / 2);
    for (a, b) in first.iter().zip(second) {
        assert!(pose_distance(&a.descriptor, &b.descriptor) < 1e-9);
    }
}

#[test]
fn steps_in_which_nothing_is_still_are_left_out_and_a_heart_without_any_says_so() {
    let params = BuiltInParams {
        vertices: 600,
        ..BuiltInParams::default()
    };
    let mut heart = known(&cohort(&params).unwrap().study.subjects[0]);
    assert!(heart.found.patches.is_empty());
    for step in &mut heart.found.steps {
        let still = step.from % 3 == 1;
        step.descriptor = still.then(|| pose(Point3::origin(), Vector3::x()));
    }
    let found = paths(&heart);
    assert_eq!(found.paths[0].part, AkineticPart::Whole);
    let steps = found.paths[0].steps.iter();
    let steps: Vec<(usize, usize)> = steps.map(|step| (step.from, step.to)).collect();
    assert_eq!(steps, [(1, 2), (4, 5), (7, 0)]);
    for step in &mut heart.found.steps {
        step.descriptor = None;
    }
    let reason = subject_paths(&heart.beat, &heart.found, None).unwrap_err();
    assert_eq!(reason, NotMapped::NothingAkinetic { steps: 8 });
}
