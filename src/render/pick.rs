//! What lies under a place on the picture: the nearest pickable surface at its blended pose.

use glam::{DVec3, Vec2, Vec3};

use super::{Camera, Geometry, GeometryPose, Ray, Scene};

/// Where a ray first meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Index of the surface in the scene.
    pub surface: usize,
    /// Index of the triangle in its geometry.
    pub triangle: usize,
    /// The triangle's corner nearest to the point.
    pub vertex: u32,
    /// Shares of the three corners in the point; they sum to 1.
    pub barycentric: [f32; 3],
    /// The point, in coordinates.
    pub point: Vec3,
    /// Distance from the ray's origin, in coordinates.
    pub distance: f32,
}

/// The nearest pickable surface under a place on the picture.
pub fn pick(scene: &Scene, camera: &Camera, pixel: Vec2, size: Vec2) -> Option<Hit> {
    pick_along(scene, &camera.ray(pixel, size))
}

/// The nearest pickable surface along a ray. Both sides of a surface can be hit.
///
/// Positions are turned so that the ray is the z axis; a triangle is hit where it holds the origin of the plane:
/// with e₀ = x₁ y₂ − y₁ x₂ (cyclic) all of one sign, the shares are eᵢ / Σ e. Neighbours compute a shared edge
/// with the same products, so no ray slips between them.
///
/// Source: Woop, Benthin, Wald (2013), "Watertight ray/triangle intersection", JCGT 2(1), section 3.
pub fn pick_along(scene: &Scene, ray: &Ray) -> Option<Hit> {
    let mut nearest: Option<Hit> = None;
    for (index, surface) in scene.surfaces.iter().enumerate() {
        if !surface.pickable || surface.opacity <= 0.0 {
            continue;
        }
        let seen = along_ray(&surface.geometry, surface.pose, ray);
        if let Some((triangle, shares, distance)) = first_triangle(&surface.geometry, &seen)
            && nearest.is_none_or(|hit| distance < f64::from(hit.distance))
        {
            nearest = Some(hit_at(
                index,
                &surface.geometry,
                triangle,
                shares,
                (ray, &seen),
            ));
        }
    }
    nearest
}

/// Positions at the blended pose, seen along the ray: x and y across it, z along it.
fn along_ray(geometry: &Geometry, pose: GeometryPose, ray: &Ray) -> Vec<DVec3> {
    let Some(last) = geometry.positions.len().checked_sub(1) else {
        return Vec::new();
    };
    let from = &geometry.positions[pose.from.min(last)];
    let to = &geometry.positions[pose.to.min(last)];
    let blend = f64::from(pose.blend).clamp(0.0, 1.0);
    let origin = ray.origin.as_dvec3();
    let forward = ray.direction.as_dvec3().normalize_or_zero();
    let (right, up) = forward.any_orthonormal_pair();
    from.iter()
        .zip(to)
        .map(|(&a, &b)| {
            let p = Vec3::from(a)
                .as_dvec3()
                .lerp(Vec3::from(b).as_dvec3(), blend)
                - origin;
            DVec3::new(right.dot(p), up.dot(p), forward.dot(p))
        })
        .collect()
}

/// The nearest triangle in front of the origin that holds it, with its corners' shares and its distance.
fn first_triangle(geometry: &Geometry, seen: &[DVec3]) -> Option<(usize, [f64; 3], f64)> {
    let mut nearest: Option<(usize, [f64; 3], f64)> = None;
    for (index, &[i, j, k]) in geometry.triangles.iter().enumerate() {
        let (Some(a), Some(b), Some(c)) = (
            seen.get(i as usize),
            seen.get(j as usize),
            seen.get(k as usize),
        ) else {
            continue;
        };
        let e = [
            b.x * c.y - b.y * c.x,
            c.x * a.y - c.y * a.x,
            a.x * b.y - a.y * b.x,
        ];
        let all_positive = e.iter().all(|&e| e >= 0.0);
        let all_negative = e.iter().all(|&e| e <= 0.0);
        let sum: f64 = e.iter().sum();
        if !(all_positive || all_negative) || sum == 0.0 {
            continue;
        }
        let shares = e.map(|e| e / sum);
        let distance = shares[0] * a.z + shares[1] * b.z + shares[2] * c.z;
        if distance > 0.0 && nearest.is_none_or(|(.., best)| distance < best) {
            nearest = Some((index, shares, distance));
        }
    }
    nearest
}

fn hit_at(
    surface: usize,
    geometry: &Geometry,
    triangle: usize,
    shares: [f64; 3],
    (ray, seen): (&Ray, &[DVec3]),
) -> Hit {
    let corners = geometry.triangles[triangle];
    let places = corners.map(|i| seen[i as usize]);
    let place: DVec3 = (0..3).map(|i| places[i] * shares[i]).sum();
    let apart = |i: usize| places[i].distance_squared(place);
    let vertex = (0..3)
        .min_by(|&a, &b| apart(a).total_cmp(&apart(b)))
        .map_or(corners[0], |i| corners[i]);
    let direction = ray.direction.as_dvec3().normalize_or_zero();
    Hit {
        surface,
        triangle,
        vertex,
        barycentric: shares.map(|share| share as f32),
        point: (ray.origin.as_dvec3() + direction * place.z).as_vec3(),
        distance: place.z as f32,
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::render::tests::{ball, scene_of, surface_of};

    const SIZE: Vec2 = Vec2::new(400.0, 400.0);

    fn camera() -> Camera {
        Camera {
            half_height: 3.0,
            ..Camera::default()
        }
    }

    #[test]
    fn a_ray_through_the_middle_meets_the_front_of_a_ball() {
        let scene = scene_of(vec![surface_of(ball(4, 1.0))]);
        let hit = pick(&scene, &camera(), 0.5 * SIZE, SIZE).unwrap();
        assert!((hit.point - Vec3::Z).length() < 0.01);
        assert!((hit.distance - (camera().eye_distance() - 1.0)).abs() < 0.01);
        assert!((hit.barycentric.iter().sum::<f32>() - 1.0).abs() < 1e-5);
        let corner = scene.surfaces[0].geometry.positions[0][hit.vertex as usize];
        assert!(Vec3::from(corner).distance(hit.point) < 0.1);
    }

    #[test]
    fn every_vertex_that_faces_the_eye_is_found_where_it_appears() {
        let scene = scene_of(vec![surface_of(ball(2, 1.0))]);
        let camera = camera().look_from(Vec3::new(0.3, -1.0, -0.5), Vec3::Z);
        let mut found = 0;
        for (vertex, &position) in scene.surfaces[0].geometry.positions[0].iter().enumerate() {
            let position = Vec3::from(position);
            if position.dot((camera.eye() - position).normalize()) < 0.3 {
                continue;
            }
            let pixel = camera.project(position, SIZE).unwrap().pixel;
            let hit = pick(&scene, &camera, pixel, SIZE).unwrap();
            assert_eq!(hit.vertex as usize, vertex);
            found += 1;
        }
        assert!(found > 30);
    }

    #[test]
    fn no_ray_slips_between_the_triangles_of_a_ball() {
        let scene = scene_of(vec![surface_of(ball(3, 1.0))]);
        for i in 0..2000 {
            let angle = i as f32 * 2.399_963;
            let radius = 0.9 * (i as f32 / 2000.0).sqrt();
            let ray = Ray {
                origin: Vec3::new(radius * angle.cos(), radius * angle.sin(), 5.0),
                direction: Vec3::NEG_Z,
            };
            assert!(pick_along(&scene, &ray).is_some());
        }
    }

    #[test]
    fn the_nearer_surface_wins_unless_it_cannot_be_picked() {
        let mut scene = scene_of(vec![surface_of(ball(3, 1.0)), surface_of(ball(3, 2.0))]);
        let at = |scene: &Scene| pick(scene, &camera(), 0.5 * SIZE, SIZE).unwrap().surface;
        assert_eq!(at(&scene), 1);
        scene.surfaces[1].pickable = false;
        assert_eq!(at(&scene), 0);
        scene.surfaces[0].pickable = false;
        assert_eq!(pick(&scene, &camera(), 0.5 * SIZE, SIZE), None);
    }

    #[test]
    fn a_pose_between_two_is_hit_between_them() {
        let small = ball(4, 1.0);
        let mut geometry = Geometry::clone(&small);
        geometry.positions.push(ball(4, 2.0).positions[0].clone());
        let mut surface = surface_of(Arc::new(geometry));
        surface.pose = GeometryPose {
            from: 0,
            to: 1,
            blend: 0.25,
        };
        let hit = pick(&scene_of(vec![surface]), &camera(), 0.5 * SIZE, SIZE).unwrap();
        assert!((hit.point.z - 1.25).abs() < 0.01);
    }

    #[test]
    fn a_damaged_geometry_is_missed_and_not_fatal() {
        let geometry = Geometry {
            triangles: vec![[0, 1, 7], [0, 0, 0]],
            positions: vec![vec![[f32::NAN; 3], [0.0; 3]]],
            normals: vec![],
        };
        let scene = scene_of(vec![
            surface_of(Arc::new(geometry)),
            surface_of(Arc::new(Geometry::default())),
        ]);
        assert_eq!(pick(&scene, &camera(), 0.5 * SIZE, SIZE), None);
    }
}
