//! The mesh of synthetic medial surfaces: a hemisphere of rings around its pole, open at the base.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use crate::mesh::{Faces, MeshError, Point3, TriMesh};

/// Rings, as a share of all, that grow by six atoms each; later ones have as many as the last of these. So triangles
/// near the apex are no needles, on which noise would pile up.
const CAP_SHARE: f64 = 1.0 / 3.0;

/// The lower half of the unit sphere, pole at −z, normals outwards: the pole, then ring after ring.
pub(super) fn hemisphere(rings: usize) -> Result<TriMesh, MeshError> {
    let cap = ((rings as f64 * CAP_SHARE).round() as usize).max(1);
    let mut points = vec![Point3::new(0.0, 0.0, -1.0)];
    let mut triangles = Vec::new();
    let mut inner = Ring {
        first: 0,
        count: 1,
        offset: 0.0,
    };
    for ring in 1..=rings {
        let past_cap = ring.saturating_sub(cap);
        let outer = Ring {
            first: points.len(),
            // Six more per ring keeps triangles even near the pole; past the cap rings hardly grow.
            count: 6 * ring.min(cap),
            // Every other ring is turned by half a step, or triangles would lean the same way all around.
            offset: if past_cap % 2 == 1 { 0.5 } else { 0.0 },
        };
        let (sin_polar, cos_polar) = (FRAC_PI_2 * ring as f64 / rings as f64).sin_cos();
        points.extend((0..outer.count).map(|step| {
            let (sin, cos) = (TAU * outer.turn(step)).sin_cos();
            Point3::new(sin_polar * cos, sin_polar * sin, -cos_polar)
        }));
        join(&inner, &outer, &mut triangles);
        inner = outer;
    }
    let faces = Faces::new(points.len(), triangles)?;
    TriMesh::new(points, Arc::new(faces))
}

struct Ring {
    first: usize,
    count: usize,
    /// Of the first atom, in steps.
    offset: f64,
}

impl Ring {
    /// Where an atom is on the way around, in turns.
    fn turn(&self, step: usize) -> f64 {
        (step as f64 + self.offset) / self.count as f64
    }

    fn atom(&self, step: usize) -> u32 {
        (self.first + step % self.count) as u32
    }

    /// Steps around; none on the pole.
    fn steps(&self) -> usize {
        // The pole is one point: there is nowhere to go along it.
        if self.count == 1 { 0 } else { self.count }
    }
}

/// Goes around both rings at once, on the one whose next atom comes first.
fn join(inner: &Ring, outer: &Ring, triangles: &mut Vec<[u32; 3]>) {
    let (mut i, mut j) = (0, 0);
    while i < inner.steps() || j < outer.steps() {
        // Whichever ring lags behind in angle goes on, so that no triangle becomes a sliver.
        let outer_first = j < outer.steps() && outer.turn(j + 1) <= inner.turn(i + 1);
        if i == inner.steps() || outer_first {
            triangles.push([inner.atom(i), outer.atom(j + 1), outer.atom(j)]);
            j += 1;
        } else {
            triangles.push([inner.atom(i), inner.atom(i + 1), outer.atom(j)]);
            i += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::vertex_normals;

    #[test]
    fn the_mesh_is_a_disc_with_normals_outwards_and_no_needles() {
        let mesh = hemisphere(24).unwrap();
        let (points, triangles) = (mesh.vertices(), mesh.triangles());
        let edges = mesh.faces().edge_valences();
        assert!(edges.iter().all(|&(_, faces)| faces <= 2));
        assert_eq!(points.len() + triangles.len() - edges.len(), 1);
        assert_eq!(mesh.faces().boundary_loops().len(), 1);
        let normals = vertex_normals(points, triangles);
        assert!((points.iter().zip(normals)).all(|(p, n)| n.dot(&p.coords) > 0.9));
        let of = |t: &[u32; 3], k: usize| points[t[k] as usize] - points[t[(k + 1) % 3] as usize];
        let aspect = |t: &[u32; 3]| {
            let lengths = [0, 1, 2].map(|k| of(t, k).norm());
            lengths.iter().fold(0.0_f64, |a, &b| a.max(b))
                / lengths.iter().fold(9.0_f64, |a, &b| a.min(b))
        };
        assert!(triangles.iter().all(|t| aspect(t) < 3.0));
    }
}
