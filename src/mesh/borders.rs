//! Where the faces of a surface end, branch, turn over or only touch: what follows from which faces share which edge.

/// An undirected edge, lower vertex first.
pub type Edge = [u32; 2];

/// The edges and vertices at which a surface is no closed, oriented manifold.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Borders {
    /// Sides of faces whose edge no other face has, in the direction of their faces, ascending.
    pub rims: Vec<[u32; 2]>,
    /// Edges of more than two faces, ascending.
    pub branching: Vec<Edge>,
    /// Number of edges along which two faces run in the same direction.
    pub turned: usize,
    /// Number of vertices, on no branching edge, around which the faces form more than one fan.
    pub pinched: usize,
}

impl Borders {
    /// Of triangles over `vertex_count` vertices. Takes as long as sorting the edges of each vertex.
    pub(super) fn of(vertex_count: usize, triangles: &[[u32; 3]]) -> Self {
        // Side k of face f is 3 f + k, from corner k to the next.
        let side = |side: u32| -> [u32; 2] {
            let face = triangles[side as usize / 3];
            let corner = side as usize % 3;
            [face[corner], face[(corner + 1) % 3]]
        };
        let count = 3 * triangles.len() as u32;
        // The sides of each lower vertex, one after the other, each with its higher vertex.
        let mut ends = vec![0_usize; vertex_count + 1];
        for [a, b] in (0..count).map(side) {
            ends[a.min(b) as usize + 1] += 1;
        }
        for vertex in 0..vertex_count {
            ends[vertex + 1] += ends[vertex];
        }
        let mut starts = ends.clone();
        let mut sides = vec![(0_u32, 0_u32); count as usize];
        for number in 0..count {
            let [a, b] = side(number);
            let start = &mut starts[a.min(b) as usize];
            sides[*start] = (a.max(b), number);
            *start += 1;
        }
        let mut found = Self::default();
        let mut fans = Fans::new(count);
        let mut branches = vec![false; vertex_count];
        for lower in 0..vertex_count {
            let around = &mut sides[ends[lower]..ends[lower + 1]];
            around.sort_unstable();
            for run in around.chunk_by(|(a, _), (b, _)| a == b) {
                match *run {
                    [(_, only)] => found.rims.push(side(only)),
                    [(_, first), (_, second)] => {
                        found.turned += usize::from(side(first) == side(second));
                    }
                    _ => {
                        let edge = [lower as u32, run[0].0];
                        found.branching.push(edge);
                        for vertex in edge {
                            branches[vertex as usize] = true;
                        }
                    }
                }
                for &(_, other) in &run[1..] {
                    let turned = side(run[0].1) == side(other);
                    fans.join(run[0].1, other, turned);
                }
            }
        }
        found.rims.sort_unstable();
        found.pinched = fans.pinched(triangles, &branches);
        found
    }
}

/// The corners of faces, joined where their faces share an edge: what is joined around a vertex is a fan.
struct Fans {
    parents: Vec<u32>,
}

impl Fans {
    fn new(corners: u32) -> Self {
        Self {
            parents: (0..corners).collect(),
        }
    }

    /// Joins the corners at both ends of two sides with one edge.
    fn join(&mut self, side: u32, other: u32, same_direction: bool) {
        let next = |side: u32| side / 3 * 3 + (side + 1) % 3;
        let pairs = if same_direction {
            [(side, other), (next(side), next(other))]
        } else {
            [(side, next(other)), (next(side), other)]
        };
        for (a, b) in pairs {
            let (a, b) = (self.root(a), self.root(b));
            self.parents[a.max(b) as usize] = a.min(b);
        }
    }

    fn root(&mut self, mut corner: u32) -> u32 {
        while self.parents[corner as usize] != corner {
            let above = self.parents[self.parents[corner as usize] as usize];
            self.parents[corner as usize] = above;
            corner = above;
        }
        corner
    }

    fn pinched(&self, triangles: &[[u32; 3]], branches: &[bool]) -> usize {
        let mut fans = vec![0_u32; branches.len()];
        for (corner, &parent) in self.parents.iter().enumerate() {
            if parent as usize == corner {
                fans[triangles[corner / 3][corner % 3] as usize] += 1;
            }
        }
        let apart = fans.iter().zip(branches);
        apart
            .filter(|&(&fans, &branches)| fans > 1 && !branches)
            .count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_no_manifold_is_counted() {
        let of = |count: usize, triangles: &[[u32; 3]]| Borders::of(count, triangles);
        let tetrahedron = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        assert_eq!(of(4, &tetrahedron), Borders::default());
        let open = of(4, &tetrahedron[1..]);
        assert_eq!(open.rims, [[0, 1], [1, 2], [2, 0]]);
        let mut turned = tetrahedron;
        turned[0].swap(0, 1);
        assert_eq!(of(4, &turned).turned, 3);
        let book = of(5, &[[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
        assert_eq!(
            (book.branching.as_slice(), book.pinched),
            (&[[0, 1]][..], 0)
        );
        assert_eq!(of(5, &[[0, 1, 2], [0, 3, 4]]).pinched, 1);
        // Two tetrahedra that share a vertex: two closed fans.
        let other = tetrahedron.map(|t| t.map(|v| if v == 0 { 0 } else { v + 3 }));
        assert_eq!(of(7, &[tetrahedron, other].concat()).pinched, 1);
        assert_eq!(of(0, &[]), Borders::default());
    }
}
