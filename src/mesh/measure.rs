//! Areas, enclosed volumes, and whether a point lies inside.

use std::f64::consts::PI;

use super::{Point3, Vector3};

/// Area of triangles, in square coordinates: Σ ½ |(b − a) × (c − a)|.
pub fn area(vertices: &[Point3], triangles: &[[u32; 3]]) -> f64 {
    triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|v| vertices[v as usize]);
            0.5 * (b - a).cross(&(c - a)).norm()
        })
        .sum()
}

/// Area that each vertex stands for: a third of that of each of its faces, in square coordinates. Sums are taken in the
/// order of the faces.
pub fn vertex_areas<'a>(
    vertices: &[Point3],
    triangles: impl IntoIterator<Item = &'a [u32; 3]>,
) -> Vec<f64> {
    let mut areas = vec![0.0; vertices.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|v| vertices[v as usize]);
        // The cross product is twice the area, and each corner has a third of it.
        let third = (b - a).cross(&(c - a)).norm() / 6.0;
        for &vertex in triangle {
            areas[vertex as usize] += third;
        }
    }
    areas
}

/// Volume enclosed by triangles, in cubic coordinates; positive where normals point outwards.
///
/// By the divergence theorem on x / 3: V = ⅙ Σ (a − o) · ((b − o) × (c − o)), exact for the closed
/// polyhedron; `origin` o is arbitrary there, and near the surface keeps rounding small. Of an
/// open surface this is the volume of the cone to `origin`, which is seldom what is wanted:
/// see [`super::CappedSheet`].
pub fn signed_volume(triangles: impl IntoIterator<Item = [Point3; 3]>, origin: Point3) -> f64 {
    let six_volumes: f64 = triangles
        .into_iter()
        .map(|corners| {
            let [a, b, c] = corners.map(|corner| corner - origin);
            a.dot(&b.cross(&c))
        })
        .sum();
    six_volumes / 6.0
}

/// How often triangles wind around a point: 1 inside a closed surface whose normals point
/// outwards, 0 outside, between for an open one or on the surface.
///
/// (1 / 4π) Σ Ω, with tan(Ω/2) = a·(b × c) / (|a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|).
/// Source: van Oosterom and Strackee (1983), IEEE Trans Biomed Eng 30(2), 125–126.
pub fn winding_number(triangles: impl IntoIterator<Item = [Point3; 3]>, point: Point3) -> f64 {
    let half_angles: f64 = triangles
        .into_iter()
        .map(|corners| half_solid_angle(corners.map(|corner| corner - point)))
        .sum();
    half_angles / (2.0 * PI)
}

fn half_solid_angle([a, b, c]: [Vector3; 3]) -> f64 {
    let (na, nb, nc) = (a.norm(), b.norm(), c.norm());
    let below = na * nb * nc + a.dot(&b) * nc + b.dot(&c) * na + c.dot(&a) * nb;
    a.dot(&b.cross(&c)).atan2(below)
}

/// Mean of points; the origin if there are none.
pub fn mean_point(points: impl ExactSizeIterator<Item = Point3>) -> Point3 {
    let count = points.len().max(1) as f64;
    let sum: Vector3 = points.map(|point| point.coords).sum();
    Point3::from(sum / count)
}

/// Lowest and highest coordinates; `None` without points.
pub fn bounding_box<'a>(points: impl IntoIterator<Item = &'a Point3>) -> Option<[Point3; 2]> {
    let mut points = points.into_iter();
    let first = *points.next()?;
    Some(points.fold([first, first], |[low, high], point| {
        [low.inf(point), high.sup(point)]
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom};
    use std::f64::consts::TAU;

    fn corners(mesh: &TriMesh) -> impl Iterator<Item = [Point3; 3]> + '_ {
        mesh.triangles()
            .iter()
            .map(|t| t.map(|v| mesh.vertices()[v as usize]))
    }

    fn volume(mesh: &TriMesh) -> f64 {
        signed_volume(corners(mesh), Point3::origin())
    }

    #[test]
    fn volume_and_area_of_a_sphere_converge_with_the_square_of_the_edge() {
        let (true_volume, true_area) = (4.0 / 3.0 * PI * 8.0, 4.0 * PI * 4.0);
        let errors: Vec<[f64; 2]> = (2..5)
            .map(|level| {
                let sphere = phantom::sphere(level, 2.0);
                [
                    true_volume - volume(&sphere),
                    true_area - area(sphere.vertices(), sphere.triangles()),
                ]
            })
            .collect();
        for pair in errors.windows(2) {
            for (coarse, fine) in pair[0].iter().zip(&pair[1]) {
                // Edges halve with each level, so that errors fall by 4.
                let ratio = coarse / fine;
                assert!((3.8..4.2).contains(&ratio), "{ratio}");
            }
        }
    }

    #[test]
    fn areas_of_vertices_sum_to_the_whole_and_are_equal_where_all_look_alike() {
        let octahedron = phantom::sphere(0, 1.0);
        let areas = vertex_areas(octahedron.vertices(), octahedron.triangles());
        let whole = area(octahedron.vertices(), octahedron.triangles());
        let each = whole / areas.len() as f64;
        assert!(areas.iter().all(|area| (area - each).abs() < 1e-12));
        // A vertex of no face stands for nothing.
        assert!(
            vertex_areas(octahedron.vertices(), [])
                .iter()
                .all(|&area| area == 0.0)
        );
    }

    #[test]
    fn a_torus_has_the_volume_of_its_straightened_tube() {
        let torus = phantom::torus(3.0, 1.0, 400, 200);
        let exact = TAU * 3.0 * PI;
        // Faceting error of 200 sides around: (2π/200)²/6 = 1.6e-4.
        assert!((volume(&torus) / exact - 1.0).abs() < 3e-4);
    }

    #[test]
    fn the_origin_of_the_cones_does_not_matter() {
        let sphere = phantom::sphere(3, 2.0);
        let far = signed_volume(corners(&sphere), Point3::new(300.0, -50.0, 7.0));
        assert!((far - volume(&sphere)).abs() < 1e-9);
    }

    #[test]
    fn winding_is_one_inside_and_zero_outside() {
        let torus = phantom::torus(3.0, 1.0, 40, 20);
        let at = |x: f64| winding_number(corners(&torus), Point3::new(x, 0.0, 0.0));
        assert!((at(3.2) - 1.0).abs() < 1e-12);
        assert!(at(0.0).abs() < 1e-12);
        assert!(at(9.0).abs() < 1e-12);
    }

    #[test]
    fn a_box_holds_all_points() {
        let points = [Point3::new(1.0, -2.0, 3.0), Point3::new(-1.0, 5.0, 0.0)];
        assert_eq!(
            bounding_box(&points),
            Some([Point3::new(-1.0, -2.0, 0.0), Point3::new(1.0, 5.0, 3.0)])
        );
        assert_eq!(bounding_box(&[]), None);
    }
}
