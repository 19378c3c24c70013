//! The outline of a surface in a slice.

use crate::image::VolumeFrame;
use crate::mesh::Point3;

/// Where triangles cross the slice at `depth` voxels along an axis of the grid: ends of straight pieces, in voxels.
///
/// A corner exactly in the slice counts as beyond it, so that a triangle has two crossings or none.
pub fn section(
    frame: &VolumeFrame,
    vertices: &[Point3],
    triangles: &[[u32; 3]],
    normal: usize,
    depth: f64,
) -> Vec<[Point3; 2]> {
    let voxels: Vec<Point3> = vertices.iter().map(|point| frame.voxel(*point)).collect();
    let mut pieces = Vec::new();
    for triangle in triangles {
        let corners = triangle.map(|corner| voxels.get(corner as usize));
        let [Some(a), Some(b), Some(c)] = corners else {
            continue;
        };
        let edges = [(a, b), (b, c), (c, a)];
        let mut crossings = edges
            .into_iter()
            .filter_map(|(from, to)| crossing(from, to, normal, depth));
        if let (Some(from), Some(to)) = (crossings.next(), crossings.next()) {
            pieces.push([from, to]);
        }
    }
    pieces
}

fn crossing(from: &Point3, to: &Point3, normal: usize, depth: f64) -> Option<Point3> {
    let [near, far] = [from, to].map(|corner| corner[normal] - depth);
    if (near < 0.0) == (far < 0.0) {
        return None;
    }
    Some(from + (to - from) * (near / (near - far)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Vector3, phantom};

    #[test]
    fn a_sphere_is_cut_in_a_closed_circle_of_its_radius() {
        let steps = [
            Vector3::new(0.0, 2.0, 0.0),
            Vector3::new(-1.0, 0.0, 0.0),
            Vector3::new(0.0, 0.0, 4.0),
        ];
        let frame = VolumeFrame::new([64, 64, 16], Point3::new(5.0, -6.0, 7.0), steps).unwrap();
        let sphere = phantom::sphere(4, 30.0);
        let triangles = sphere.faces().triangles();
        let depth = frame.voxel(Point3::new(0.0, 0.0, 12.0))[2];
        let pieces = section(&frame, sphere.vertices(), triangles, 2, depth);
        let radius = (30.0_f64.powi(2) - 12.0_f64.powi(2)).sqrt();
        assert!(pieces.len() > 40);
        let mut length = 0.0;
        for [from, to] in &pieces {
            let at = frame.position(*from);
            assert!((at.z - 12.0).abs() < 1e-9);
            assert!((at.x.hypot(at.y) - radius).abs() < 0.3, "{at}");
            length += (frame.position(*to) - at).norm();
        }
        let around = std::f64::consts::TAU * radius;
        assert!(
            (length / around - 1.0).abs() < 0.01,
            "{length} is not {around}"
        );
        assert!(section(&frame, sphere.vertices(), triangles, 2, 60.0).is_empty());
    }
}
