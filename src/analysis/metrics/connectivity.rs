//! What a metric needs to know of the faces, found once for all poses.

use crate::mesh::{Edge, Faces, flat_angles_rad};

/// Edges, the three edges of each face, and the angles that are flat.
#[derive(Clone, Debug)]
pub(super) struct Connectivity {
    pub vertex_count: usize,
    pub triangles: Vec<[u32; 3]>,
    /// Every undirected edge once, ascending.
    pub edges: Vec<Edge>,
    /// Edges ab, bc, ca of each face abc.
    pub face_edges: Vec<[u32; 3]>,
    /// Sum of corner angles at which a vertex is flat.
    pub flat_rad: Vec<f64>,
    /// Whether a vertex has a surrounding of its own: a face, and no boundary.
    pub inside: Vec<bool>,
    /// 1 over the most vertices that are one or beside one.
    shrink: f64,
}

impl Connectivity {
    pub fn new(faces: &Faces) -> Self {
        let edges = faces.edges();
        let index_of = |a: u32, b: u32| {
            let edge = if a < b { [a, b] } else { [b, a] };
            // Every side of a face is among the edges, so the search finds it.
            edges.binary_search(&edge).unwrap_or_default() as u32
        };
        let face_edges = faces
            .triangles()
            .iter()
            .map(|&[a, b, c]| [index_of(a, b), index_of(b, c), index_of(c, a)])
            .collect();
        let flat_rad = flat_angles_rad(faces);
        let mut beside = vec![1_u32; faces.vertex_count()];
        for &end in edges.iter().flatten() {
            beside[end as usize] += 1;
        }
        Self {
            vertex_count: faces.vertex_count(),
            triangles: faces.triangles().to_vec(),
            face_edges,
            inside: flat_rad
                .iter()
                .map(|&flat| flat > std::f64::consts::PI)
                .collect(),
            flat_rad,
            edges,
            shrink: 1.0 / f64::from(beside.into_iter().max().unwrap_or(1)),
        }
    }

    /// Adds to each value those of its neighbours, `rings` times: sums over a neighbourhood that
    /// weigh nearer vertices more. Linear, and the same for every pose.
    ///
    /// Sums shrink by a constant a ring, so that none overflows; only their ratios mean anything.
    pub fn gathered(&self, values: &[f64], rings: u32) -> Vec<f64> {
        let mut sums = values.to_vec();
        for _ in 0..rings {
            let before: Vec<f64> = sums.iter().map(|sum| sum * self.shrink).collect();
            sums.copy_from_slice(&before);
            for &[i, j] in &self.edges {
                sums[i as usize] += before[j as usize];
                sums[j as usize] += before[i as usize];
            }
        }
        sums
    }
}
