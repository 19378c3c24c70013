//! Directions perpendicular to a surface.

use super::{Point3, Vector3};

/// Unit normal of each face, by the right-hand rule; zero where a face has no area.
pub fn face_normals(vertices: &[Point3], triangles: &[[u32; 3]]) -> Vec<Vector3> {
    triangles
        .iter()
        .map(|triangle| unit_or_zero(doubled_area_vector(vertices, triangle)))
        .collect()
}

/// Unit normal at each vertex: the area-weighted mean of its faces' normals; zero at a vertex
/// of no face.
pub fn vertex_normals(vertices: &[Point3], triangles: &[[u32; 3]]) -> Vec<Vector3> {
    let mut sums = vec![Vector3::zeros(); vertices.len()];
    for triangle in triangles {
        let area_vector = doubled_area_vector(vertices, triangle);
        for &corner in triangle {
            sums[corner as usize] += area_vector;
        }
    }
    sums.into_iter().map(unit_or_zero).collect()
}

/// (b − a) × (c − a): twice the area, along the normal.
fn doubled_area_vector(vertices: &[Point3], triangle: &[u32; 3]) -> Vector3 {
    let [a, b, c] = triangle.map(|index| vertices[index as usize]);
    (b - a).cross(&(c - a))
}

fn unit_or_zero(vector: Vector3) -> Vector3 {
    let length = vector.norm();
    if length > 0.0 {
        vector / length
    } else {
        vector
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    #[test]
    fn normals_of_a_sphere_point_outwards() {
        let sphere = phantom::sphere(3, 2.0);
        for (point, normal) in sphere
            .vertices()
            .iter()
            .zip(vertex_normals(sphere.vertices(), sphere.triangles()))
        {
            // 1°: facets of a three times subdivided icosahedron are some 8° apart.
            assert!(normal.dot(&point.coords.normalize()) > 0.9998);
        }
    }

    #[test]
    fn a_face_without_area_has_no_normal() {
        let points = vec![Point3::origin(); 3];
        assert_eq!(face_normals(&points, &[[0, 1, 2]]), [Vector3::zeros()]);
    }
}
