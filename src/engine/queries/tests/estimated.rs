//! Estimated poses: at a pose that pose, between two of one beat between them, and nothing far outside.

use super::*;
use crate::analysis::embedding::{InverseMapError, PoseMap};

fn estimate(store: &Store, study: &Arc<Study>, at: [f64; 2]) -> Result<EstimatedPose, NoEstimate> {
    let map = PoseMapQuery::default();
    (*ask(store, study, &EstimatedPoseQuery { map, at })).clone()
}

fn place(map: &PoseMap, row: usize) -> [f64; 2] {
    let point = map.embedding.point(row);
    [point[0], point[1]]
}

#[test]
fn at_a_pose_of_the_map_the_estimate_is_that_pose() {
    let (store, study) = (store(), study());
    let map = ask(&store, &study, &PoseMapQuery::default());
    for row in [0, 3, 12, 25] {
        let pose = map.distances.poses[row];
        let estimated = estimate(&store, &study, place(&map, row)).unwrap();
        assert_eq!(estimated.sources, [(pose, 1.0)]);
        let found = estimated.subject.sequence.pose(ESTIMATED_FRAME);
        let own = study.subjects[pose.subject].sequence.pose(pose.frame);
        assert_eq!(found, own);
    }
}

#[test]
fn between_two_poses_of_one_beat_lies_a_pose_between_them() {
    let (store, study) = (store(), of_cohort(|whole| whole[..4].to_vec()));
    let map = ask(&store, &study, &PoseMapQuery::default());
    let volume = |pose: &[crate::mesh::Point3]| {
        let middle = pose
            .iter()
            .map(|p| p.coords)
            .sum::<nalgebra::Vector3<f64>>()
            / pose.len() as f64;
        pose.iter().map(|p| (p.coords - middle).norm()).sum::<f64>() / pose.len() as f64
    };
    let own = |row: usize| {
        let pose = map.distances.poses[row];
        study.subjects[pose.subject]
            .sequence
            .pose(pose.frame)
            .unwrap()
    };
    // The two poses next to each other that lie farthest apart.
    let apart = |row: usize| {
        let (a, b) = (place(&map, row), place(&map, row + 1));
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    let follows = |row: &usize| {
        let [a, b] = [*row, row + 1].map(|row| map.distances.poses[row]);
        a.subject == b.subject
    };
    let rows = (0..map.embedding.len() - 1).filter(follows);
    let row = rows.max_by(|a, b| apart(*a).total_cmp(&apart(*b)));
    let row = row.unwrap();
    let sizes = [volume(&own(row)), volume(&own(row + 1))];
    let [a, b] = [place(&map, row), place(&map, row + 1)];
    let mut last: Option<f64> = None;
    for share in [0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0] {
        let at = [0, 1].map(|axis| a[axis] + share * (b[axis] - a[axis]));
        let estimated = estimate(&store, &study, at).unwrap();
        let frames: Vec<usize> = estimated
            .sources
            .iter()
            .map(|source| source.0.frame)
            .collect();
        let ends = [row, row + 1].map(|row| map.distances.poses[row].frame);
        assert!(
            frames.iter().all(|frame| ends.contains(frame)),
            "{frames:?} of {ends:?}"
        );
        let sum: f64 = estimated.sources.iter().map(|source| source.1).sum();
        assert!((sum - 1.0).abs() < 1e-12);
        let size = volume(&estimated.subject.sequence.pose(ESTIMATED_FRAME).unwrap());
        let [low, high] = [sizes[0].min(sizes[1]), sizes[0].max(sizes[1])];
        assert!(
            (low - 1e-9..=high + 1e-9).contains(&size),
            "{low} {size} {high}"
        );
        if let Some(last) = last.replace(size) {
            let grows = sizes[1] > sizes[0];
            assert!((size > last) == grows, "{last} to {size} at {share}");
        }
    }
}

#[test]
fn far_outside_and_after_transport_nothing_is_estimated_and_the_reason_is_said() {
    let (store, study) = (store(), study());
    let map = ask(&store, &study, &PoseMapQuery::default());
    let far = [0, 1].map(|axis| {
        let values = (0..map.embedding.len()).map(|row| place(&map, row)[axis].abs());
        3.0 * values.fold(0.0, f64::max)
    });
    let refused = estimate(&store, &study, far).unwrap_err();
    assert!(matches!(
        refused,
        NoEstimate::Place(InverseMapError::Outside { .. })
    ));
    let words = refused.to_string();
    assert!(
        words.contains("outside of all points of the map") && words.contains("5 %"),
        "{words}"
    );
    let mut transported = PoseMapQuery::default();
    transported.distances.transport = Some(CohortTransportParams::default());
    let query = EstimatedPoseQuery {
        map: transported,
        at: [0.0; 2],
    };
    let answer = ask(&store, &study, &query);
    assert_eq!(
        *answer.as_ref().as_ref().unwrap_err(),
        NoEstimate::Transported
    );
}
