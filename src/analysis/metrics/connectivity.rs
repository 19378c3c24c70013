//! What a metric needs to know of the faces, found once for all poses.

use crate::mesh::{Edge, Faces, flat_angles_rad};
use crate::numeric::Arithmetic;

/// Edges, the three edges of each face, and the angles that are flat.
#[derive(Clone, Debug)]
pub(super) struct Connectivity {
    pub vertex_count: usize,
    pub triangles: Vec<[u32; 3]>,
    /// Every undirected edge once, ascending.
    pub edges: Vec<Edge>,
    /// Edges ab, bc, ca of each face abc.
    pub face_edges: Vec<[u32; 3]>,
    /// How many faces each edge has.
    faces_of_edge: Vec<u32>,
    /// Sum of corner angles at which a vertex is flat.
    pub flat_rad: Vec<f64>,
    /// Whether a vertex has a surrounding of its own: a face, and no boundary.
    pub inside: Vec<bool>,
    /// (1 + number of neighbours)^−½ of each vertex.
    spread: Vec<f64>,
    /// Where the neighbours of each vertex begin in `neighbours`, and where the last ones end.
    first_neighbour: Vec<u32>,
    neighbours: Vec<u32>,
}

impl Connectivity {
    pub fn new(faces: &Faces) -> Self {
        let edges = faces.edges();
        let index_of = |a: u32, b: u32| {
            let edge = if a < b { [a, b] } else { [b, a] };
            // Every side of a face is among the edges, so the search finds it.
            edges.binary_search(&edge).unwrap_or_default() as u32
        };
        let face_edges: Vec<[u32; 3]> = faces
            .triangles()
            .iter()
            .map(|&[a, b, c]| [index_of(a, b), index_of(b, c), index_of(c, a)])
            .collect();
        let mut faces_of_edge = vec![0; edges.len()];
        for &edge in face_edges.iter().flatten() {
            faces_of_edge[edge as usize] += 1;
        }
        let flat_rad = flat_angles_rad(faces);
        let (first_neighbour, neighbours) = neighbours(faces.vertex_count(), &edges);
        let spread = (first_neighbour.windows(2))
            .map(|w| f64::from(1 + w[1] - w[0]).sqrt().recip())
            .collect();
        Self {
            vertex_count: faces.vertex_count(),
            triangles: faces.triangles().to_vec(),
            face_edges,
            faces_of_edge,
            inside: flat_rad
                .iter()
                .map(|&flat| flat > std::f64::consts::PI)
                .collect(),
            flat_rad,
            edges,
            spread,
            first_neighbour,
            neighbours,
        }
    }

    /// What part of each face's weight its sides have: a third where weights are areas, else what makes
    /// each edge count once.
    pub fn side_parts(&self, area_weights: bool) -> impl Iterator<Item = [f64; 3]> {
        self.face_edges.iter().map(move |edges| {
            edges.map(|edge| {
                if area_weights {
                    1.0 / 3.0
                } else {
                    1.0 / f64::from(self.faces_of_edge[edge as usize])
                }
            })
        })
    }

    /// Sums over a neighbourhood that weigh nearer vertices more: `rings` times D^−½ (1 + A) D^−½ with the neighbours A and
    /// D = 1 + their number. Linear, symmetric, and the same for every pose; no eigenvalue exceeds 1, so that none
    /// overflows. Without D a vertex of many neighbours, such as the apex of a mesh of meridians, would after many rings
    /// be all that any vertex sees.
    ///
    /// Each vertex has `width` entries of N values; only ratios of the sums mean anything. `spare` is memory of the same
    /// length.
    #[inline(always)]
    pub fn gather<T: Arithmetic, const N: usize>(
        &self,
        values: &mut Vec<[T; N]>,
        spare: &mut Vec<[T; N]>,
        width: usize,
        rings: u32,
    ) {
        if rings == 0 {
            return;
        }
        let scaled = |values: &mut [[T; N]], factor: &dyn Fn(f64) -> f64| {
            for (of_vertex, spread) in values.chunks_exact_mut(width.max(1)).zip(&self.spread) {
                let factor = T::splat(factor(*spread));
                for value in of_vertex.iter_mut().flatten() {
                    *value = *value * factor;
                }
            }
        };
        scaled(values, &|spread| spread);
        for _ in 0..rings {
            for (v, bounds) in self.first_neighbour.windows(2).enumerate() {
                let neighbours = &self.neighbours[bounds[0] as usize..bounds[1] as usize];
                let shrink = T::splat(self.spread[v] * self.spread[v]);
                for entry in 0..width {
                    let mut sum = values[v * width + entry];
                    for &beside in neighbours {
                        let other = values[beside as usize * width + entry];
                        for k in 0..N {
                            sum[k] += other[k];
                        }
                    }
                    for value in &mut sum {
                        *value = *value * shrink;
                    }
                    spare[v * width + entry] = sum;
                }
            }
            // The old values are the next round's memory: gathering allocates nothing.
            std::mem::swap(values, spare);
        }
        // The last ring has taken one factor too many.
        scaled(values, &|spread| 1.0 / spread);
    }
}

/// For each vertex where its neighbours begin in the list of all, and that list.
fn neighbours(vertex_count: usize, edges: &[Edge]) -> (Vec<u32>, Vec<u32>) {
    let mut first = vec![0_u32; vertex_count + 1];
    for &end in edges.iter().flatten() {
        // Counted one place on, so that the running sum gives where each list begins.
        first[end as usize + 1] += 1;
    }
    for v in 0..vertex_count {
        first[v + 1] += first[v];
    }
    let mut next = first.clone();
    let mut list = vec![0; 2 * edges.len()];
    for &[p, q] in edges {
        for (from, to) in [(p, q), (q, p)] {
            let place = &mut next[from as usize];
            list[*place as usize] = to;
            *place += 1;
        }
    }
    (first, list)
}
