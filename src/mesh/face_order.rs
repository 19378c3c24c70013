//! Are two lists of faces the same surface, listed in another way?

use std::collections::{HashMap, HashSet};

use super::Faces;

/// How one list of faces differs from another over the same vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaceOrder {
    /// Face for face and corner for corner the same.
    Same,
    /// The same faces, in another order or beginning with another corner.
    Reordered,
    /// The same corners, but some faces wind the other way round.
    Rewound,
    /// The same polygons, but some are cut into triangles along another diagonal, as where a face of four corners begins with another one.
    Recut,
    /// Other faces, or another number of vertices.
    Different,
}

impl FaceOrder {
    /// Compares `other` with `faces`.
    pub fn of(faces: &Faces, other: &Faces) -> Self {
        if faces == other {
            return Self::Same;
        }
        let counts = |faces: &Faces| (faces.vertex_count(), faces.triangles().len());
        if counts(faces) != counts(other) {
            return Self::Different;
        }
        if faces.in_one_order() == other.in_one_order() {
            return Self::Reordered;
        }
        let (ours, theirs) = (listed(faces, ascending), listed(other, ascending));
        if ours == theirs {
            Self::Rewound
        } else if same_quadrilaterals(&ours, &theirs) {
            Self::Recut
        } else {
            Self::Different
        }
    }

    /// Whether vertices that correspond make the same surface.
    pub fn is_same_surface(self) -> bool {
        self != Self::Different
    }
}

impl Faces {
    /// The faces in the order of their corners, each from its lowest corner on: the same for every list of the same
    /// faces wound the same way.
    pub fn in_one_order(&self) -> Vec<[u32; 3]> {
        listed(self, lowest_first)
    }
}

fn listed(faces: &Faces, key: fn([u32; 3]) -> [u32; 3]) -> Vec<[u32; 3]> {
    let mut keys: Vec<[u32; 3]> = faces.triangles().iter().map(|&t| key(t)).collect();
    keys.sort_unstable();
    keys
}

/// Whether triangles that only one list has make up, in pairs, the same quadrilaterals as those of the other. Both lists
/// are ascending, and so are the corners of each triangle.
fn same_quadrilaterals(ours: &[[u32; 3]], theirs: &[[u32; 3]]) -> bool {
    let only = |list: &[[u32; 3]], other: &[[u32; 3]]| -> Vec<[u32; 3]> {
        let missing = list.iter().filter(|t| other.binary_search(t).is_err());
        missing.copied().collect()
    };
    let (ours, theirs) = (only(ours, theirs), only(theirs, ours));
    if ours.len() != theirs.len() || ours.len() % 2 == 1 {
        return false;
    }
    let mut left: HashSet<[u32; 3]> = theirs.into_iter().collect();
    // Each side with the third corner of the triangles on it.
    let mut apexes: HashMap<[u32; 2], Vec<u32>> = HashMap::new();
    for &[a, b, c] in &ours {
        for (side, apex) in [([a, b], c), ([a, c], b), ([b, c], a)] {
            apexes.entry(side).or_default().push(apex);
        }
    }
    let mut paired: HashSet<[u32; 3]> = HashSet::new();
    for &[a, b, c] in &ours {
        if paired.contains(&[a, b, c]) {
            continue;
        }
        let sides = [([a, b], c), ([a, c], b), ([b, c], a)];
        let partner = sides.into_iter().find_map(|([p, q], r)| {
            let others = apexes.get(&[p, q])?.iter().filter(|&&s| s != r);
            others.copied().find_map(|s| {
                let two = ascending([p, q, s]);
                // The two triangles that the other diagonal makes of the four corners.
                let cut = [[p, r, s], [q, r, s]].map(ascending);
                let fits = !paired.contains(&two) && cut.iter().all(|t| left.contains(t));
                fits.then_some((two, cut))
            })
        });
        let Some((two, cut)) = partner else {
            return false;
        };
        paired.extend([[a, b, c], two]);
        cut.iter().for_each(|triangle| {
            left.remove(triangle);
        });
    }
    left.is_empty()
}

/// The same face in the same direction, from its lowest corner on.
fn lowest_first(mut triangle: [u32; 3]) -> [u32; 3] {
    let lowest = (0..3).min_by_key(|&corner| triangle[corner]).unwrap_or(0);
    triangle.rotate_left(lowest);
    triangle
}

fn ascending(mut triangle: [u32; 3]) -> [u32; 3] {
    triangle.sort_unstable();
    triangle
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    fn compared(change: impl Fn(&mut Vec<[u32; 3]>)) -> FaceOrder {
        let ball = phantom::sphere(2, 1.0);
        let mut triangles = ball.triangles().to_vec();
        change(&mut triangles);
        let other = Faces::new(ball.vertices().len(), triangles).unwrap();
        FaceOrder::of(ball.faces(), &other)
    }

    #[test]
    fn order_and_first_corner_of_faces_do_not_matter_and_other_faces_do() {
        assert_eq!(compared(|_| ()), FaceOrder::Same);
        assert_eq!(compared(|faces| faces.reverse()), FaceOrder::Reordered);
        assert_eq!(
            compared(|faces| faces.iter_mut().for_each(|f| f.rotate_left(1))),
            FaceOrder::Reordered
        );
        assert_eq!(compared(|faces| faces[7].swap(0, 1)), FaceOrder::Rewound);
        assert_eq!(
            compared(|faces| faces.iter_mut().for_each(|f| f.swap(1, 2))),
            FaceOrder::Rewound
        );
        assert_eq!(compared(|faces| faces.truncate(9)), FaceOrder::Different);
        let quadrilaterals = |first: usize| {
            let corners = [[0, 1, 2, 3], [1, 4, 5, 2], [4, 6, 7, 5]];
            let fans = corners
                .into_iter()
                .enumerate()
                .flat_map(|(face, mut corners)| {
                    corners.rotate_left(if face == 1 { 0 } else { first });
                    let [a, b, c, d] = corners;
                    [[a, b, c], [a, c, d]]
                });
            Faces::new(8, fans.collect()).unwrap()
        };
        let order = |first| FaceOrder::of(&quadrilaterals(0), &quadrilaterals(first));
        assert_eq!(
            [1, 2, 3].map(order),
            [FaceOrder::Recut, FaceOrder::Reordered, FaceOrder::Recut]
        );
        assert_eq!(compared(|faces| faces[3] = faces[4]), FaceOrder::Different);
    }
}
