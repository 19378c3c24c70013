//! Surfaces that are deformed: spheres and tori, closed or with one or two holes.

use std::collections::VecDeque;

use crate::mesh::{Faces, Point3, TriMesh, Vector3, phantom};

/// The closed surface that an object is made from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Solid {
    /// Of radius 1; genus 0.
    Sphere,
    /// Of radii 1 and 0.4, around the third axis; genus 1.
    Torus,
}

/// A surface with as many boundaries.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ObjectKind {
    /// What it is cut from.
    pub solid: Solid,
    /// Holes: 0, 1 or 2.
    pub boundaries: u8,
}

impl ObjectKind {
    /// Genus 0 and 1 with 0, 1 and 2 boundaries, as in section 3.4.4.
    pub const ALL: [Self; 6] = [
        Self::new(Solid::Sphere, 0),
        Self::new(Solid::Sphere, 1),
        Self::new(Solid::Sphere, 2),
        Self::new(Solid::Torus, 0),
        Self::new(Solid::Torus, 1),
        Self::new(Solid::Torus, 2),
    ];

    const fn new(solid: Solid, boundaries: u8) -> Self {
        Self { solid, boundaries }
    }

    /// What tables call it.
    pub fn name(self) -> &'static str {
        match (self.solid, self.boundaries) {
            (Solid::Sphere, 0) => "sphere",
            (Solid::Sphere, 1) => "sphere, 1 boundary",
            (Solid::Sphere, _) => "sphere, 2 boundaries",
            (Solid::Torus, 0) => "torus",
            (Solid::Torus, 1) => "torus, 1 boundary",
            (Solid::Torus, _) => "torus, 2 boundaries",
        }
    }
}

/// How fine the meshes of objects are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Fineness {
    /// 162 vertices a sphere, 200 a torus, less the holes: the meshes of the oracles.
    #[default]
    Coarse,
    /// 642 and 800.
    Fine,
}

/// The long axis of an undeformed object lies along x, its top is towards z, and the origin in its
/// middle. Holes are discs around its ends along y (of the torus) or x (of the sphere).
pub fn object(kind: ObjectKind, fineness: Fineness) -> TriMesh {
    let (closed, ends, rings) = match (kind.solid, fineness) {
        (Solid::Sphere, Fineness::Coarse) => (lying_sphere(2), Vector3::x(), 1),
        (Solid::Sphere, Fineness::Fine) => (lying_sphere(3), Vector3::x(), 3),
        (Solid::Torus, Fineness::Coarse) => (phantom::torus(1.0, 0.4, 20, 10), Vector3::y(), 0),
        (Solid::Torus, Fineness::Fine) => (phantom::torus(1.0, 0.4, 40, 20), Vector3::y(), 1),
    };
    [ends, -ends]
        .iter()
        .take(usize::from(kind.boundaries))
        .fold(closed, |mesh, end| with_hole(&mesh, end, rings))
}

/// A sphere with a vertex at either end of the x axis, so that holes there are alike.
fn lying_sphere(subdivisions: u32) -> TriMesh {
    let ball = phantom::sphere(subdivisions, 1.0);
    let pole = ball.vertices()[0].coords;
    let turn = nalgebra::Rotation3::rotation_between(&pole, &Vector3::x())
        .unwrap_or_else(nalgebra::Rotation3::identity);
    let points: Vec<Point3> = ball.vertices().iter().map(|p| turn * p).collect();
    TriMesh::new(points, ball.faces().clone()).unwrap_or(ball)
}

/// The mesh without the vertex that lies farthest along `direction` and those within so many
/// rings of it.
fn with_hole(mesh: &TriMesh, direction: &Vector3, rings: u32) -> TriMesh {
    let along = |v: usize| mesh.vertices()[v].coords.dot(direction);
    let count = mesh.vertices().len();
    // The vertex farthest along the direction; of equals the first, so that the mesh is always the same.
    let centre = (0..count).reduce(|best, v| if along(v) > along(best) { v } else { best });
    let mut ring_of: Vec<Option<u32>> = vec![None; count];
    let mut queue: VecDeque<usize> = centre.into_iter().collect();
    if let Some(centre) = centre {
        ring_of[centre] = Some(0);
    }
    let edges = mesh.faces().edges();
    while let Some(at) = queue.pop_front() {
        let next = ring_of[at].map_or(0, |ring| ring + 1);
        // A hole of so many rings of vertices around its centre.
        if next > rings {
            continue;
        }
        for &[a, b] in edges.iter().filter(|edge| edge.contains(&(at as u32))) {
            let other = if a as usize == at { b } else { a } as usize;
            if ring_of[other].is_none() {
                ring_of[other] = Some(next);
                queue.push_back(other);
            }
        }
    }
    let mut place: Vec<Option<u32>> = Vec::with_capacity(count);
    let mut kept: Vec<Point3> = Vec::new();
    for (ring, point) in ring_of.iter().zip(mesh.vertices()) {
        place.push(ring.is_none().then_some(kept.len() as u32));
        if ring.is_none() {
            kept.push(*point);
        }
    }
    let triangles = (mesh.triangles().iter())
        .filter_map(|corners| {
            let [a, b, c] = corners.map(|v| place[v as usize]);
            Some([a?, b?, c?])
        })
        .collect();
    Faces::new(kept.len(), triangles)
        .and_then(|faces| TriMesh::new(kept, faces))
        .unwrap_or_else(|_| mesh.clone())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn objects_have_the_boundaries_and_the_genus_of_their_kind() {
        for fineness in [Fineness::Coarse, Fineness::Fine] {
            for kind in ObjectKind::ALL {
                let mesh = object(kind, fineness);
                let loops = mesh.faces().boundary_loops().len();
                assert_eq!(loops, usize::from(kind.boundaries), "{}", kind.name());
                let euler = mesh.vertices().len() as i64 - mesh.faces().edges().len() as i64
                    + mesh.triangles().len() as i64;
                let closed = if kind.solid == Solid::Sphere { 2 } else { 0 };
                assert_eq!(
                    euler,
                    closed - i64::from(kind.boundaries),
                    "{}",
                    kind.name()
                );
            }
        }
    }

    #[test]
    fn coarse_objects_have_the_vertices_of_the_oracles() {
        let vertices = |solid| object(ObjectKind::new(solid, 0), Fineness::Coarse);
        assert_eq!(vertices(Solid::Sphere).vertices().len(), 162);
        assert_eq!(vertices(Solid::Torus).vertices().len(), 200);
    }
}
