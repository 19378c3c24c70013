//! Places on phantoms and on the built-in cohort.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use nalgebra::{Rotation3, Unit};
use proptest::prelude::*;

use super::*;
use crate::mesh::{Faces, Point3, TriMesh, Vector3, area, phantom, vertex_areas};
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{Anatomy, MeshSequence, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

fn subject(surfaces: Vec<(SurfaceKind, Vec<TriMesh>)>) -> Subject {
    let surfaces = (surfaces.into_iter())
        .map(|(kind, frames)| SurfaceSequence::new(kind, frames).unwrap())
        .collect();
    let sequence = MeshSequence::new(surfaces).unwrap();
    Subject::new("phantom", sequence, LengthUnit::Millimetre)
}

/// Half shells of 20 and 28 mm, open at z = 0, apex below.
fn shells() -> Subject {
    subject(vec![
        (
            SurfaceKind::Endocardium,
            vec![phantom::bowl(20.0, 12, 24); 2],
        ),
        (
            SurfaceKind::Epicardium,
            vec![phantom::bowl(28.0, 12, 24); 2],
        ),
    ])
}

/// Septum to +x, anterior wall to +y.
fn landmarks() -> Anatomy {
    Anatomy::from_landmarks(
        Point3::new(0.0, 0.0, -28.0),
        Point3::origin(),
        Point3::new(1.0, 0.0, 0.0),
        Point3::new(0.0, 1.0, 0.0),
    )
    .unwrap()
}

fn near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-9, "{a} where {b} is expected");
}

#[test]
fn the_axis_of_a_shell_runs_from_the_outer_tip_to_the_inner_rim() {
    let axis = long_axis(&shells(), 0).unwrap();
    assert!((axis.apex - Point3::new(0.0, 0.0, -28.0)).norm() < 1e-12);
    assert!((axis.base - Point3::origin()).norm() < 1e-9);
    near(axis.cavity_share, 20.0 / 28.0);
    assert!(!axis.is_oriented());
    near(axis.depth(Point3::new(5.0, 0.0, -20.0)), 1.0);
    // The rim's first vertex lies at +x, which is drawn to the left.
    near(axis.left.x, 1.0);
}

#[test]
fn with_landmarks_septum_is_left_and_anterior_up() {
    let mut heart = shells();
    heart.anatomy = Some(landmarks());
    let axis = long_axis(&heart, 1).unwrap();
    near(axis.angle_rad(Point3::new(0.0, 9.0, -3.0)), FRAC_PI_2);
    near(axis.angle_rad(Point3::new(9.0, 0.0, -3.0)).abs(), PI);
    near(axis.angle_rad(Point3::new(-9.0, 0.0, -3.0)), 0.0);
    let at = |x: f64, y: f64, z: f64| {
        segment(&axis, Point3::new(x, y, z)).map(|segment| segment.number())
    };
    assert_eq!(at(0.0, 20.0, -2.0), Some(1));
    assert_eq!(at(20.0, 9.0, -2.0), Some(2));
    assert_eq!(at(20.0, -9.0, -2.0), Some(3));
    assert_eq!(at(-20.0, -9.0, -10.0), Some(11));
    assert_eq!(at(9.0, 0.0, -17.0), Some(14));
    assert_eq!(at(3.0, 0.0, -19.5), Some(17));
    assert_eq!(at(0.0, 3.0, -26.0), Some(17));
    assert_eq!(at(20.0, 0.0, 4.1), None);
}

#[test]
fn without_directions_only_levels_are_told() {
    let places = inner_places(&shells(), 0).unwrap();
    assert!(places.segments.iter().all(Option::is_none));
    assert!(places.levels.iter().all(Option::is_some));
    let mut heart = shells();
    heart.anatomy = Some(landmarks());
    let named = inner_places(&heart, 0).unwrap();
    for (segment, level) in named.segments.iter().zip(&named.levels) {
        assert_eq!(segment.map(Segment::level), *level);
    }
    let numbers: std::collections::BTreeSet<_> = named.segments.iter().flatten().collect();
    assert_eq!(numbers.len(), Segment::COUNT);
}

#[test]
fn landmarks_move_with_the_heart() {
    let shift = Vector3::new(3.0, -2.0, 7.0);
    let moved = |mesh: TriMesh| {
        let points: Vec<Point3> = mesh.vertices().iter().map(|p| p + shift).collect();
        let later = TriMesh::new(points, Arc::clone(mesh.faces())).unwrap();
        vec![mesh, later]
    };
    let mut heart = subject(vec![
        (SurfaceKind::Endocardium, moved(phantom::bowl(20.0, 12, 24))),
        (SurfaceKind::Epicardium, moved(phantom::bowl(28.0, 12, 24))),
    ]);
    heart.anatomy = Some(landmarks());
    let [first, later] = [0, 1].map(|frame| long_axis(&heart, frame).unwrap());
    assert!((later.apex - first.apex - shift).norm() < 1e-12);
    assert!((later.base - first.base - shift).norm() < 1e-9);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn a_rigid_motion_changes_no_place(
        angle in -3.0..3.0_f64, x in -1.0..1.0_f64, y in -1.0..1.0_f64, z in 0.1..1.0_f64,
        shift in -200.0..200.0_f64, stated in any::<bool>(),
    ) {
        let turn = Rotation3::from_axis_angle(&Unit::new_normalize(Vector3::new(x, y, z)), angle);
        let to = |p: Point3| turn * p + Vector3::new(shift, -shift, 0.3 * shift);
        let moved = |radius: f64| {
            let mesh = phantom::bowl(radius, 11, 25);
            let points: Vec<Point3> = mesh.vertices().iter().map(|&p| to(p)).collect();
            vec![TriMesh::new(points, Arc::clone(mesh.faces())).unwrap()]
        };
        let still = |radius: f64| vec![phantom::bowl(radius, 11, 25)];
        let [mut before, mut after] = [0, 1].map(|k| {
            let make = |radius| if k == 0 { still(radius) } else { moved(radius) };
            subject(vec![
                (SurfaceKind::Endocardium, make(20.0)),
                (SurfaceKind::Epicardium, make(28.0)),
            ])
        });
        if stated {
            let marks = landmarks();
            before.anatomy = Some(marks);
            after.anatomy = Some(Anatomy {
                apex: to(marks.apex),
                base: to(marks.base),
                septal: turn * marks.septal,
                anterior: turn * marks.anterior,
            });
        }
        let [a, b] = [before, after].map(|heart| inner_places(&heart, 0).unwrap());
        for (a, b) in a.polar.iter().zip(&b.polar) {
            let [a, b] = [a, b].map(|place| plot_point(*place));
            prop_assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-6, "{a:?} {b:?}");
        }
    }
}

#[test]
fn a_quantity_that_is_constant_has_that_mean_and_gaps_do_not_count() {
    let bowl = phantom::bowl(20.0, 30, 60);
    let axis = LongAxis::oriented(
        Point3::new(0.0, 0.0, -20.0),
        Point3::origin(),
        Vector3::x(),
        Vector3::y(),
    )
    .unwrap();
    let places = places(&axis, bowl.vertices());
    let weights = vertex_areas(bowl.vertices(), bowl.triangles());
    near(
        weights.iter().sum(),
        area(bowl.vertices(), bowl.triangles()),
    );
    let mut values = vec![7.5; weights.len()];
    values[40] = f64::NAN;
    for mean in segment_means(&places.segments, &weights, &values) {
        near(mean.unwrap(), 7.5);
    }
    // On a sphere area is even in z, so that the mean height of a third is its middle.
    let heights: Vec<f64> = bowl.vertices().iter().map(|p| -p.z / 20.0).collect();
    let levels = level_means(&places.levels, &weights, &heights);
    for (level, middle) in levels
        .iter()
        .zip([1.0 / 6.0, 0.5, 0.5 * (2.0 / 3.0 + 0.94), 0.97])
    {
        assert!((level.unwrap() - middle).abs() < 0.03, "{levels:?}");
    }
    let none = segment_means(&places.segments, &vec![0.0; weights.len()], &values);
    assert!(none.iter().all(Option::is_none));
}

#[test]
fn thickening_of_a_segment_is_that_of_its_means_over_what_both_phases_tell() {
    let one = Segment::new(1);
    let thickening = segment_thickening(
        &[one, one, one, None],
        &[1.0, 3.0, 5.0, 1.0],
        &[Some(8.0), Some(4.0), None, Some(1.0)],
        &[Some(12.0), Some(8.0), Some(99.0), Some(9.0)],
    );
    let found = thickening[0].unwrap();
    near(found.end_diastole, 5.0);
    near(found.end_systole, 9.0);
    near(found.percent().unwrap(), 80.0);
    assert!(thickening[1..].iter().all(Option::is_none));
    let level = Some(Level::Mid);
    let of_levels = level_thickening(&[level], &[2.0], &[Some(0.0)], &[Some(3.0)]);
    assert_eq!(of_levels[1].unwrap().percent(), None);
}

#[test]
fn a_bowl_fills_the_disc_and_no_face_is_dropped() {
    let bowl = phantom::bowl(20.0, 60, 120);
    let axis = LongAxis::new(Point3::new(0.0, 0.0, -20.0), Point3::origin(), Vector3::x()).unwrap();
    let places = places(&axis, bowl.vertices());
    let map = flat_map(&places.polar, bowl.vertices(), bowl.triangles());
    assert!(map.dropped.is_empty());
    let flat: Vec<Point3> = (map.points.iter())
        .map(|p| Point3::new(p[0], p[1], 0.0))
        .collect();
    let covered = area(&flat, &map.faces);
    assert!((covered / PI - 1.0).abs() < 2e-3, "{covered}");
    // Wound the other way, the same faces are drawn.
    let turned: Vec<_> = bowl
        .triangles()
        .iter()
        .map(|&[a, b, c]| [a, c, b])
        .collect();
    assert!(
        flat_map(&places.polar, bowl.vertices(), &turned)
            .dropped
            .is_empty()
    );
}

#[test]
fn a_face_folded_over_its_neighbours_is_dropped() {
    let bowl = phantom::bowl(20.0, 10, 20);
    let axis = LongAxis::new(Point3::new(0.0, 0.0, -20.0), Point3::origin(), Vector3::x()).unwrap();
    let mut places = places(&axis, bowl.vertices());
    // A vertex of the fifth ring is drawn at the base on the other side.
    places.polar[100].angle_rad += PI;
    places.polar[100].radius = 1.0;
    let map = flat_map(&places.polar, bowl.vertices(), bowl.triangles());
    assert!(!map.dropped.is_empty() && map.dropped.len() <= 6);
    assert_eq!(map.dropped.len() + map.faces.len(), bowl.triangles().len());
}

#[test]
fn rings_of_the_plot_are_borders_of_levels() {
    for (level, [inner, outer]) in Level::ALL.map(|level| (level, ring(level))) {
        let middle = height_at(0.5 * (inner + outer));
        let depth = 1.0 - middle;
        let depth = if depth >= 1.0 - CAP_SHARE { 1.0 } else { depth };
        assert_eq!(Level::at_depth(depth), level);
    }
    for step in 0..=100 {
        let radius = f64::from(step) / 100.0;
        near(plot_radius(height_at(radius)), radius);
    }
    near(plot_radius(1.1), 1.0);
}

#[test]
fn the_middle_of_a_drawn_sector_is_its_segment() {
    for segment in Segment::all() {
        let [inner, outer] = ring(segment.level());
        let [middle, half] = segment.sector_rad();
        for angle in [middle, middle + 0.9 * half, middle - 0.9 * half] {
            let radius = 0.5 * (inner + outer);
            let drawn = segment_on_plot([radius * angle.cos(), radius * angle.sin()]);
            assert_eq!(drawn, Some(segment));
        }
    }
    assert_eq!(segment_on_plot([0.8, -0.7]), None);
}

#[test]
fn segments_of_the_built_in_cohort_are_those_of_its_truth() {
    let built = cohort(&BuiltInParams::default()).unwrap();
    let (mut agree, mut named) = (0, 0);
    for (heart, truth) in built.study.subjects.iter().zip(&built.truths) {
        let places = inner_places(heart, 0).unwrap();
        let mut counts = [[0_usize; 2]; Segment::COUNT];
        for (segment, &patch) in places.segments.iter().zip(&truth.surfaces[0].patch) {
            let count = &mut counts[segment.unwrap().index()];
            count[0] += 1;
            count[1] += usize::from(patch > 0);
        }
        for (segment, [all, ill]) in Segment::all().zip(counts) {
            assert!(all > 0, "{}: {} is empty", heart.id, segment.name());
            let (found, stated) = (3 * ill >= all, truth.segments.contains(&segment.number()));
            named += usize::from(found || stated);
            agree += usize::from(found && stated);
        }
    }
    // The axis through rim and tip is not quite that of the model, which the waves of the wall tilt.
    assert!(named > 40 && 20 * agree >= 19 * named, "{agree} of {named}");
}

#[test]
fn what_has_no_base_is_refused_and_damage_does_no_harm() {
    let closed = subject(vec![(SurfaceKind::Cavity, vec![phantom::sphere(2, 20.0)])]);
    assert_eq!(
        long_axis(&closed, 0),
        Err(SegmentError::NoRim { kind: "cavity" })
    );
    let horse = subject(vec![(SurfaceKind::Other, vec![phantom::bowl(1.0, 3, 8)])]);
    assert_eq!(long_axis(&horse, 0), Err(SegmentError::NoHeart));
    assert_eq!(
        long_axis(&shells(), 2),
        Err(SegmentError::NoFrame {
            frame: 2,
            frames: 2
        })
    );
    let faces = || Faces::new(3, vec![[0, 1, 2]]).unwrap();
    let points = vec![
        Point3::origin(),
        Point3::new(3.0, 0.0, 0.0),
        Point3::new(0.0, 4.0, 0.0),
    ];
    let single = TriMesh::new(points, faces()).unwrap();
    let single = subject(vec![(SurfaceKind::Endocardium, vec![single])]);
    let places = inner_places(&single, 0).unwrap();
    assert!(
        places
            .polar
            .iter()
            .all(|p| p.radius.is_finite() && p.angle_rad.is_finite())
    );
    let point = TriMesh::new(vec![Point3::origin(); 3], faces()).unwrap();
    let point = subject(vec![(SurfaceKind::Endocardium, vec![point])]);
    assert!(long_axis(&point, 0).is_err());
    assert!(LongAxis::new(Point3::origin(), Point3::new(0.0, 0.0, 1.0), Vector3::z()).is_none());
    let map = flat_map(&places.polar, &[Point3::origin(); 3], &[[0, 1, 2]]);
    assert_eq!(map.faces.len() + map.dropped.len(), 1);
}
