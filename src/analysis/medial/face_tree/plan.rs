//! In which order a tree holds faces.

use crate::mesh::Point3;

/// Most faces of a leaf; more cost more tests of faces, fewer more cylinders.
const LEAF: usize = 3;

/// Faces from which a part is handed to another thread.
pub(super) const WORTH_HANDING: usize = 2048;

/// In which order a tree holds faces, made once for all poses.
#[derive(Clone, Debug)]
pub(in crate::analysis::medial) struct TreePlan {
    /// Faces in the order of the leaves.
    pub(super) order: Vec<u32>,
    /// Leaves are four to the power of this.
    pub(super) levels: usize,
}

impl TreePlan {
    /// Plans a tree for faces about where they are at one pose.
    pub fn new(points: &[Point3], triangles: &[[u32; 3]]) -> Self {
        let mut levels = 0;
        while triangles.len().div_ceil(1 << (2 * levels)) > LEAF {
            levels += 1;
        }
        let mut centres: Vec<(u32, Point3)> = (0..)
            .zip(triangles)
            .map(|(face, triangle)| {
                let [a, b, c] = triangle.map(|vertex| points[vertex as usize].coords);
                (face, Point3::from((a + b + c) / 3.0))
            })
            .collect();
        let halving = Halving {
            faces: centres.len(),
            levels: 2 * levels,
        };
        halving.order(&mut centres, 0, 0);
        Self {
            order: centres.into_iter().map(|(face, _)| face).collect(),
            levels,
        }
    }

    /// Faces in an order in which neighbours mostly follow each other.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The faces of a node, by its level and its place there.
    pub(super) fn members(&self, level: usize, place: usize) -> &[u32] {
        let [from, to] = [place, place + 1].map(|place| start(self.order.len(), 2 * level, place));
        &self.order[from..to]
    }

    /// The faces of a leaf.
    pub(super) fn leaf(&self, leaf: usize) -> &[u32] {
        self.members(self.levels, leaf)
    }
}

/// Where a part begins that is at this place among the parts of faces halved so many times.
fn start(faces: usize, halvings: usize, place: usize) -> usize {
    (place * faces) >> halvings
}

/// Puts faces in order: the nearer half along the longest side of their box, then the other, and so on down.
struct Halving {
    faces: usize,
    levels: usize,
}

impl Halving {
    fn order(&self, part: &mut [(u32, Point3)], level: usize, place: usize) {
        let Some(&(_, first)) = part.first() else {
            return;
        };
        if level == self.levels {
            return;
        }
        let (low, high) = (part.iter()).fold((first, first), |(low, high), (_, centre)| {
            (low.inf(centre), high.sup(centre))
        });
        // The longest side: parts stay compact, and so do the cylinders around them.
        let axis = (high - low).imax();
        let half = start(self.faces, level + 1, 2 * place + 1) - start(self.faces, level, place);
        // A half that takes all needs no order; the parts of a tree may be empty.
        if half < part.len() {
            part.select_nth_unstable_by(half, |a, b| {
                // Ties by number, so that the order is the same on every run.
                a.1[axis].total_cmp(&b.1[axis]).then(a.0.cmp(&b.0))
            });
        }
        let is_large = part.len() > WORTH_HANDING;
        let (left, right) = part.split_at_mut(half);
        let (level, places) = (level + 1, [2 * place, 2 * place + 1]);
        if is_large {
            rayon::join(
                || self.order(left, level, places[0]),
                || self.order(right, level, places[1]),
            );
        } else {
            self.order(left, level, places[0]);
            self.order(right, level, places[1]);
        }
    }
}
