//! The surroundings of vertices along the edges of a mesh.

use std::ops::RangeInclusive;

use crate::mesh::Faces;

/// Rings of neighbours that can be asked for: one is what a fit needs at least, more than eight are a fifth of a heart.
pub(super) const RINGS: RangeInclusive<usize> = 1..=8;

/// Neighbours of every vertex, one list after another.
pub(super) struct Neighbours {
    starts: Vec<u32>,
    lists: Vec<u32>,
}

impl Neighbours {
    pub fn of(faces: &Faces) -> Self {
        let edges = faces.edges();
        let mut starts = vec![0_u32; faces.vertex_count() + 1];
        for &vertex in edges.iter().flatten() {
            starts[vertex as usize + 1] += 1;
        }
        for vertex in 1..starts.len() {
            starts[vertex] += starts[vertex - 1];
        }
        let mut next = starts.clone();
        let mut lists = vec![0; 2 * edges.len()];
        for &[a, b] in &edges {
            for [from, to] in [[a, b], [b, a]] {
                let place = &mut next[from as usize];
                lists[*place as usize] = to;
                *place += 1;
            }
        }
        Self { starts, lists }
    }

    fn of_vertex(&self, vertex: u32) -> &[u32] {
        let [from, to] = [0, 1].map(|end| self.starts[vertex as usize + end] as usize);
        &self.lists[from..to]
    }
}

/// Vertices around one, gathered ring by ring; kept from vertex to vertex so that nothing is allocated.
pub(super) struct Surroundings {
    /// For which vertex each one was last met.
    met: Vec<u32>,
    gathered: Vec<u32>,
}

impl Surroundings {
    pub fn new(vertex_count: usize) -> Self {
        Self {
            met: vec![u32::MAX; vertex_count],
            gathered: Vec::new(),
        }
    }

    /// The vertex itself and those up to `rings` edges away, or further if they are fewer than `min_count`, but never beyond
    /// `max_rings`.
    pub fn gather(
        &mut self,
        neighbours: &Neighbours,
        vertex: u32,
        rings: usize,
        min_count: usize,
        max_rings: usize,
    ) -> &[u32] {
        self.gathered.clear();
        self.gathered.push(vertex);
        self.met[vertex as usize] = vertex;
        let mut ring_start = 0;
        for ring in 0..max_rings {
            if ring >= rings && self.gathered.len() >= min_count {
                break;
            }
            let ring_end = self.gathered.len();
            for place in ring_start..ring_end {
                for &neighbour in neighbours.of_vertex(self.gathered[place]) {
                    if self.met[neighbour as usize] != vertex {
                        self.met[neighbour as usize] = vertex;
                        self.gathered.push(neighbour);
                    }
                }
            }
            ring_start = ring_end;
        }
        &self.gathered
    }
}
