//! What is refused, moved by hand, or stopped.

use super::*;

#[test]
fn what_is_no_ventricle_is_refused_with_a_reason() {
    let study = hearts(1_000);
    let template = Template::of_subject(&study.subjects[0]).unwrap();
    let nothing = TriMesh::new(Vec::new(), Faces::new(0, Vec::new()).unwrap()).unwrap();
    let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(Point3::from);
    let one = TriMesh::new(corners, Faces::new(3, vec![[0, 1, 2]]).unwrap()).unwrap();
    let point = TriMesh::new(
        vec![Point3::origin(); 162],
        phantom::sphere(2, 1.0).faces().clone(),
    );
    let ball = phantom::sphere(3, 30.0);
    let ring = phantom::torus(30.0, 8.0, 30, 12);
    for (mesh, reason) in [
        (nothing, "0 faces are too few"),
        (one, "1 faces are too few"),
        (point.unwrap(), "no area"),
        (ball, "mark both"),
        (ring, "mark both"),
    ] {
        let error =
            registered(&template, &alone(SurfaceKind::Endocardium, mesh), None).unwrap_err();
        assert!(error.to_string().contains(reason), "{error}");
        assert!(
            error.to_string().starts_with("endocardium, frame 0"),
            "{error}"
        );
    }
    assert_eq!(
        registered(&template, &[], None).unwrap_err(),
        CorrespondenceError::NoSurface
    );
    let mut uneven = frames_of(&study.subjects[1]);
    uneven[0].frames.pop();
    let error = registered(&template, &uneven, None).unwrap_err();
    assert_eq!(
        error.to_string(),
        "epicardium has 8 frames, but endocardium has 7"
    );
}

#[test]
fn a_template_that_does_not_fit_and_landmarks_that_are_no_numbers_are_refused() {
    let study = hearts(1_000);
    let template = Template::of_subject(&study.subjects[0]).unwrap();
    let own = &study.subjects[1];
    let progress = Progress::default();
    let frames = first(frames_of(own));
    let targets = Targets::new(&template, &frames, own.anatomy.as_ref(), &progress).unwrap();
    let landmarks = propose_landmarks(&targets, &progress).unwrap();
    let strict = CorrespondenceParams {
        max_mean: 1e-6,
        ..CorrespondenceParams::default()
    };
    let refused = correspond(
        &template,
        &targets,
        &landmarks,
        &strict.check().unwrap(),
        &progress,
    );
    assert!(
        refused
            .unwrap_err()
            .to_string()
            .contains("does not fit: mean distance")
    );
    let params = CheckedCorrespondenceParams::default();
    let nowhere = landmarks.moved(
        SurfaceKind::Epicardium,
        0,
        15,
        Point3::new(f64::NAN, 0.0, 0.0),
    );
    let refused = correspond(&template, &targets, &nowhere.unwrap(), &params, &progress);
    let said = refused.unwrap_err().to_string();
    assert_eq!(
        said,
        "epicardium, frame 0: apex has a coordinate that is not a finite number"
    );
    assert!(
        landmarks
            .moved(SurfaceKind::Epicardium, 1, 15, Point3::origin())
            .is_none()
    );
    let mut fewer = landmarks;
    fewer.surfaces.pop();
    let refused = correspond(&template, &targets, &fewer, &params, &progress);
    assert!(matches!(
        refused,
        Err(CorrespondenceError::LandmarkCounts { .. })
    ));
    let wrong = CorrespondenceParams {
        smoothing: f64::NAN,
        ..CorrespondenceParams::default()
    };
    assert!(wrong.check().is_err());
}

#[test]
fn a_landmark_that_is_moved_takes_the_vertices_beside_it_along() {
    let study = hearts(1_000);
    let own = &study.subjects[0];
    let template = Template::of_subject(own).unwrap();
    let progress = Progress::default();
    let frames = first(frames_of(own));
    let targets = Targets::new(&template, &frames, own.anatomy.as_ref(), &progress).unwrap();
    let proposed = propose_landmarks(&targets, &progress).unwrap();
    let kind = SurfaceKind::Epicardium;
    // The middle of the anterior wall, five millimetres towards the septum.
    let at = proposed.at(kind, 0).unwrap().points[7];
    let by = 5.0 * own.anatomy.unwrap().septal;
    let landmarks = proposed.moved(kind, 0, 7, at + by).unwrap();
    let params = CheckedCorrespondenceParams::default();
    let made = correspond(&template, &targets, &landmarks, &params, &progress).unwrap();
    let vertices = |s: &crate::study::MeshSequence| s.surface(kind).unwrap().frames()[0].clone();
    let [before, after] = [vertices(&own.sequence), vertices(&made.sequence)];
    let nearest = |a: &usize, b: &usize| {
        let away = |v: usize| (before.vertices()[v] - at).norm();
        away(*a).total_cmp(&away(*b))
    };
    let beside = (0..before.vertices().len()).min_by(nearest).unwrap();
    let moved = after.vertices()[beside] - before.vertices()[beside];
    assert!(moved.dot(&by) / by.norm() > 2.0, "{moved}");
}

#[test]
fn whoever_asks_to_stop_is_heard() {
    let study = hearts(1_000);
    let template = Template::of_subject(&study.subjects[0]).unwrap();
    let frames = frames_of(&study.subjects[1]);
    let progress = Progress::default();
    let targets = Targets::new(&template, &frames, None, &progress).unwrap();
    let landmarks = propose_landmarks(&targets, &progress).unwrap();
    progress.stop();
    let stopped = CorrespondenceError::Stopped(Stopped);
    let params = CheckedCorrespondenceParams::default();
    let ended = correspond(&template, &targets, &landmarks, &params, &progress);
    assert_eq!(ended.unwrap_err(), stopped);
    assert_eq!(propose_landmarks(&targets, &progress).unwrap_err(), stopped);
    assert_eq!(
        Targets::new(&template, &frames, None, &progress).unwrap_err(),
        stopped
    );
}
