//! How steady the akinetic region is over the beat: spread of ANV and MP, and how far MP lies off the wall.

use crate::analysis::medial_space::{PoseDescriptor, angle, mean_direction, pose_distance};
use crate::mesh::{Point3, Vector3};

use super::result::TemporalConsistency;

/// How steady a path of descriptors is, with the gaps of their MP, both in coordinates, of a subject of
/// this size.
///
/// "Does not change so much over time" and "close to the medial surface" (4.4.1, 4.4.2) in numbers: root mean square
/// distances from the mean over the poses, and mean gap.
pub(super) fn temporal_consistency(
    path: &[Option<PoseDescriptor>],
    gaps: &[Option<f64>],
    size: f64,
) -> TemporalConsistency {
    let poses: Vec<PoseDescriptor> = (path.iter().flatten())
        // In sizes of the subject, so that positions can be added to angles and compared between subjects.
        .map(|pose| pose.relative_to(&Point3::origin(), size))
        .collect();
    let normals: Vec<Vector3> = poses.iter().filter_map(|pose| pose.normal).collect();
    let middle = mean_direction(&normals).map(|(direction, _)| direction);
    let centre: Vector3 = poses
        .iter()
        .map(|pose| pose.position.coords)
        .sum::<Vector3>()
        / poses.len().max(1) as f64;
    TemporalConsistency {
        poses: poses.len(),
        normal_spread_rad: middle
            .and_then(|middle| root_mean(normals.iter().map(|n| angle(n, &middle).powi(2)))),
        position_spread: root_mean(
            poses
                .iter()
                .map(|p| (p.position.coords - centre).norm_squared()),
        ),
        gap: mean(gaps.iter().flatten().map(|gap| gap / size)),
        pose_distance: mean((0..poses.len()).flat_map(|i| {
            let poses = &poses;
            (0..i).map(move |j| pose_distance(&poses[i], &poses[j]))
        })),
    }
}

fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values.fold((0.0, 0), |(sum, count), x| (sum + x, count + 1));
    (count > 0).then(|| sum / f64::from(count))
}

fn root_mean(squares: impl Iterator<Item = f64>) -> Option<f64> {
    mean(squares).map(f64::sqrt)
}

/// Distance of a point from the nearest of some triangles; infinite without any.
pub(super) fn gap(
    point: &Point3,
    positions: impl Fn(u32) -> Point3,
    triangles: &[[u32; 3]],
) -> f64 {
    (triangles.iter())
        // Of all triangles: a mean position lies inside the cup, far from any one of them.
        .map(|triangle| (nearest(point, triangle.map(&positions)) - point).norm_squared())
        .fold(f64::INFINITY, f64::min)
        .sqrt()
}

/// Nearest point of a triangle: its foot in the plane, or on the nearest side.
fn nearest(point: &Point3, [a, b, c]: [Point3; 3]) -> Point3 {
    let normal = (b - a).cross(&(c - a));
    let inside = |from: Point3, to: Point3| normal.cross(&(to - from)).dot(&(point - from)) >= 0.0;
    if normal.norm_squared() > 0.0 && inside(a, b) && inside(b, c) && inside(c, a) {
        return point - normal * (normal.dot(&(point - a)) / normal.norm_squared());
    }
    let on_side = |from: Point3, to: Point3| {
        let side = to - from;
        let length2 = side.norm_squared().max(f64::MIN_POSITIVE);
        from + side * (side.dot(&(point - from)) / length2).clamp(0.0, 1.0)
    };
    // Outside of all three sides the nearest point lies on one of them.
    let mut best = on_side(a, b);
    for other in [on_side(b, c), on_side(c, a)] {
        if (other - point).norm_squared() < (best - point).norm_squared() {
            best = other;
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gap_is_that_to_face_side_or_corner() {
        let corners = [[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        let at = |x, y, z| gap(&Point3::new(x, y, z), |i| corners[i as usize], &[[0, 1, 2]]);
        assert_eq!(at(1.0, 1.0, -2.0), 2.0);
        assert_eq!(at(1.0, -3.0, 4.0), 5.0);
        assert_eq!(at(-3.0, -4.0, 0.0), 5.0);
        assert!((at(4.0, 3.0, 0.0) - 2.4).abs() < 1e-12);
        assert!(gap(&corners[0], |i| corners[i as usize], &[]).is_infinite());
    }

    #[test]
    fn a_path_that_stays_is_steady() {
        let pose = PoseDescriptor {
            position: Point3::new(3.0, 0.0, 0.0),
            log_ratio: 0.0,
            rho: 0.1,
            normal: Some(Vector3::x()),
        };
        let moved = PoseDescriptor {
            position: Point3::new(5.0, 0.0, 0.0),
            normal: Some(Vector3::y()),
            ..pose
        };
        let akinetic = temporal_consistency(
            &[Some(pose), None, Some(pose)],
            &[Some(1.0), None, Some(3.0)],
            10.0,
        );
        assert_eq!(akinetic.poses, 2);
        assert_eq!(akinetic.normal_spread_rad, Some(0.0));
        assert_eq!(akinetic.position_spread, Some(0.0));
        assert_eq!(akinetic.gap, Some(0.2));
        let wandering = temporal_consistency(&[Some(pose), Some(moved)], &[], 10.0);
        let quarter = std::f64::consts::FRAC_PI_4;
        assert!((wandering.normal_spread_rad.unwrap() - quarter).abs() < 1e-12);
        assert!((wandering.position_spread.unwrap() - 0.1).abs() < 1e-12);
        assert_eq!(wandering.gap, None);
        assert_eq!(
            temporal_consistency(&[], &[], 1.0),
            TemporalConsistency::default()
        );
    }
}
