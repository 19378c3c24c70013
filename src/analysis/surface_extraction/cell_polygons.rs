//! How a surface runs through one cell of a grid: triangles over the cell's edges, for every pattern of its corners.

use std::sync::LazyLock;

/// Edges of a cell, as axis and lower corner: numbers 0–3 run along i, 4–7 along j, 8–11 along k. Corner c of a cell
/// stands at (c & 1, c >> 1 & 1, c >> 2).
pub(super) const EDGES: [(usize, usize); 12] = [
    (0, 0),
    (0, 2),
    (0, 4),
    (0, 6),
    (1, 0),
    (1, 1),
    (1, 4),
    (1, 5),
    (2, 0),
    (2, 1),
    (2, 2),
    (2, 3),
];

/// Corners of the six faces, counterclockwise as seen from outside the cell.
pub(super) const FACES: [[usize; 4]; 6] = [
    [0, 4, 6, 2],
    [1, 3, 7, 5],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 2, 3, 1],
    [4, 5, 7, 6],
];

/// Costs of a diagonal on a face, beside the area of triangles: more than the area of any polygon in a cell, so that it is
/// avoided before area is saved; and more than all of those together for one that must not be.
const ON_FACE: f64 = 1e2;
const FORBIDDEN: f64 = 1e4;

/// Triangles for every pattern of corners inside and, where a face has two inside on one diagonal and two outside on the
/// other, every choice of which two are connected.
pub(super) struct CellPolygons {
    /// Where the triangles of pattern · 64 + connected faces begin; the next entry is where they end.
    starts: Vec<u32>,
    triangles: Vec<[u8; 3]>,
    /// The faces of each pattern that leave the choice, one bit per face.
    ambiguous: Vec<u8>,
}

/// Made once, when first asked for.
pub(super) static CELL_POLYGONS: LazyLock<CellPolygons> = LazyLock::new(CellPolygons::new);

impl CellPolygons {
    fn new() -> Self {
        let ambiguous: Vec<u8> = (0..256).map(ambiguous_faces).collect();
        let mut made = Self {
            starts: vec![0],
            triangles: Vec::new(),
            ambiguous,
        };
        for pattern in 0..256_usize {
            for connected in 0..64_u8 {
                // Only faces that leave a choice are ever asked about.
                if connected & !made.ambiguous[pattern] == 0 {
                    for polygon in polygons(pattern, connected) {
                        made.triangles.extend(triangulated(&polygon));
                    }
                }
                made.starts.push(made.triangles.len() as u32);
            }
        }
        made
    }

    /// The faces, one bit each, whose two corners inside may be connected across the face or not.
    pub fn ambiguous(&self, pattern: u8) -> u8 {
        self.ambiguous[usize::from(pattern)]
    }

    /// Triangles over numbers of edges, wound so that normals point to the corners outside (of a right-handed grid).
    /// `pattern` has a bit for each corner inside, `connected` one for each ambiguous face whose corners inside are
    /// connected.
    pub fn triangles(&self, pattern: u8, connected: u8) -> &[[u8; 3]] {
        let at = usize::from(pattern) * 64 + usize::from(connected);
        &self.triangles[self.starts[at] as usize..self.starts[at + 1] as usize]
    }
}

fn is_inside(pattern: usize, corner: usize) -> bool {
    pattern >> corner & 1 == 1
}

fn ambiguous_faces(pattern: usize) -> u8 {
    let mut faces = 0;
    for (face, corners) in FACES.iter().enumerate() {
        let [a, b, c, d] = corners.map(|corner| is_inside(pattern, corner));
        faces |= u8::from(a == c && b == d && a != b) << face;
    }
    faces
}

fn edge_between(a: usize, b: usize) -> usize {
    let (lower, axis) = (a.min(b), (a ^ b).trailing_zeros() as usize);
    let at = EDGES.iter().position(|&edge| edge == (axis, lower));
    at.unwrap_or_default()
}

/// The closed polygons over edges in which the surface meets the faces of the cell.
///
/// Walking round a face as seen from outside, every side crosses the surface where one goes in or out; a segment leads from
/// a side where one goes in to one where one goes out. Every edge is gone along once in each direction by its two faces, so
/// that segments join to polygons; and the cell beyond a face has the same segments backwards, so that polygons of
/// neighbours fit.
fn polygons(pattern: usize, connected: u8) -> Vec<Vec<u8>> {
    let mut next = [None; 12];
    for (face, corners) in FACES.iter().enumerate() {
        // The sides of the face in their order, where the walk goes in or out.
        let turns: Vec<(usize, bool)> = (0..4)
            .filter_map(|side| {
                let (from, to) = (corners[side], corners[(side + 1) % 4]);
                let goes_in = is_inside(pattern, to);
                (is_inside(pattern, from) != goes_in).then(|| (edge_between(from, to), goes_in))
            })
            .collect();
        for (place, &(edge, goes_in)) in turns.iter().enumerate() {
            if goes_in {
                // Round the corner inside; or, where both of them are connected, round the one outside before it.
                let across = connected >> face & 1 == 1;
                let other = if across { turns.len() - 1 } else { 1 };
                next[edge] = Some(turns[(place + other) % turns.len()].0);
            }
        }
    }
    let mut found = Vec::new();
    for start in 0..12 {
        let mut polygon = Vec::new();
        let mut edge = start;
        while let Some(following) = next[edge].take() {
            polygon.push(edge as u8);
            edge = following;
        }
        if !polygon.is_empty() {
            found.push(polygon);
        }
    }
    found
}

/// The face that two edges lie on.
fn shared_face(a: u8, b: u8) -> Option<usize> {
    let corners = |edge: u8| {
        let (axis, lower) = EDGES[usize::from(edge)];
        [lower, lower | 1 << axis]
    };
    let all = [corners(a), corners(b)].concat();
    (FACES.iter()).position(|face| all.iter().all(|corner| face.contains(corner)))
}

/// What a diagonal between two edges costs beside area.
///
/// The cell beyond a face could have the same diagonal on it, and four triangles would meet there. Some polygons cannot do
/// without: so diagonals on a face join opposite edges only, on the lower face of a cell those along the first of the two
/// other axes, on the upper face those along the second. No diagonal is then on both sides of a face.
fn diagonal_cost(a: u8, b: u8) -> f64 {
    let Some(face) = shared_face(a, b) else {
        return 0.0;
    };
    let (across, is_upper) = (face / 2, face % 2 == 1);
    let (first, second) = [(1, 2), (0, 2), (0, 1)][across];
    let [along, other] = [a, b].map(|edge| EDGES[usize::from(edge)].0);
    if along == other && along == if is_upper { second } else { first } {
        ON_FACE
    } else {
        FORBIDDEN
    }
}

/// The triangulation of a polygon with the least area where edges are crossed in their middle, with as few diagonals on
/// faces of the cell as can be, see [`diagonal_cost`].
///
/// By dynamic programming over the parts of the polygon that one diagonal cuts off.
fn triangulated(polygon: &[u8]) -> Vec<[u8; 3]> {
    let n = polygon.len();
    let mut cost = vec![vec![0.0_f64; n]; n];
    let mut middle = vec![vec![0; n]; n];
    for width in 2..n {
        for from in 0..n - width {
            let to = from + width;
            let closes = from == 0 && to == n - 1;
            let diagonal = if closes {
                0.0
            } else {
                diagonal_cost(polygon[from], polygon[to])
            };
            let sums = (from + 1..to).map(|at| {
                let own = area([from, at, to].map(|place| polygon[place]));
                (cost[from][at] + cost[at][to] + own, at)
            });
            // By more than rounding, so that the choice does not hang on the order of sums.
            let lower = |best: (f64, usize), next: (f64, usize)| {
                if next.0 < best.0 - 1e-9 { next } else { best }
            };
            let best = sums.fold((f64::INFINITY, from + 1), lower);
            cost[from][to] = best.0 + diagonal;
            middle[from][to] = best.1;
        }
    }
    let mut triangles = Vec::with_capacity(n.saturating_sub(2));
    let mut open = vec![(0, n - 1)];
    while let Some((from, to)) = open.pop() {
        if to - from >= 2 {
            let at = middle[from][to];
            triangles.push([polygon[from], polygon[at], polygon[to]]);
            open.extend([(from, at), (at, to)]);
        }
    }
    triangles
}

/// Area of the triangle between the middles of three edges.
fn area(edges: [u8; 3]) -> f64 {
    let [a, b, c] = edges.map(|edge| {
        let (axis, lower) = EDGES[usize::from(edge)];
        let mut place = [0, 1, 2].map(|a| f64::from((lower >> a & 1) as u8));
        place[axis] += 0.5;
        crate::mesh::Vector3::from(place)
    });
    0.5 * (b - a).cross(&(c - a)).norm()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every pattern with every choice that is asked for.
    fn all() -> impl Iterator<Item = (u8, u8)> {
        (0..=255_u8).flat_map(|pattern| {
            let free = CELL_POLYGONS.ambiguous(pattern);
            let choices = (0..64_u8).filter(move |connected| connected & !free == 0);
            choices.map(move |connected| (pattern, connected))
        })
    }

    #[test]
    fn every_edge_that_is_crossed_lies_on_one_polygon() {
        for (pattern, connected) in all() {
            let mut used: Vec<u8> = polygons(usize::from(pattern), connected).concat();
            used.sort_unstable();
            let crossed: Vec<u8> = (0..12)
                .filter(|&edge| {
                    let (axis, lower) = EDGES[usize::from(edge)];
                    let ends = [lower, lower | 1 << axis];
                    let [a, b] = ends.map(|corner| is_inside(usize::from(pattern), corner));
                    a != b
                })
                .collect();
            assert_eq!(used, crossed, "{pattern:08b} {connected:06b}");
        }
    }

    #[test]
    fn triangles_fill_each_polygon_and_no_diagonal_is_on_both_sides_of_a_face() {
        for (pattern, connected) in all() {
            let polygons = polygons(usize::from(pattern), connected);
            let triangles = CELL_POLYGONS.triangles(pattern, connected);
            let expected: usize = polygons.iter().map(|p| p.len() - 2).sum();
            assert_eq!(triangles.len(), expected);
            for polygon in &polygons {
                let n = polygon.len();
                let sides: Vec<[u8; 2]> =
                    (0..n).map(|m| [polygon[m], polygon[(m + 1) % n]]).collect();
                let own = triangles.iter().filter(|t| polygon.contains(&t[0]));
                for [a, b] in own.flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]) {
                    let is_side = sides.contains(&[a, b]);
                    let may_be = is_side || diagonal_cost(a, b) < FORBIDDEN;
                    assert!(may_be, "{pattern:08b} {connected:06b}: {a} {b}");
                    // A side is wound as the polygon is.
                    assert!(is_side || !sides.contains(&[b, a]));
                }
            }
        }
    }

    #[test]
    fn a_diagonal_that_one_side_of_a_face_may_have_the_other_may_not() {
        for (a, b) in (0..12_u8).flat_map(|a| (0..12_u8).map(move |b| (a, b))) {
            // The same edges on the opposite face of the cell are those of the cell beyond.
            let Some(face) = shared_face(a, b).filter(|_| a != b) else {
                continue;
            };
            let moved = |edge: u8| {
                let (axis, lower) = EDGES[usize::from(edge)];
                let to = (axis, lower ^ 1 << (face / 2));
                EDGES.iter().position(|&edge| edge == to).unwrap() as u8
            };
            let costs = [diagonal_cost(a, b), diagonal_cost(moved(a), moved(b))];
            assert!(costs.contains(&FORBIDDEN), "{a} {b}: {costs:?}");
        }
    }

    #[test]
    fn a_corner_inside_is_cut_off_by_a_triangle_that_faces_away_from_it() {
        assert_eq!(polygons(1, 0), [[0, 4, 8]]);
        // All but the corner: the same triangle the other way round.
        let mut back = polygons(254, 0)[0].clone();
        back.reverse();
        back.rotate_right(1);
        assert_eq!(back, [0, 4, 8]);
        assert!(polygons(0, 0).is_empty() && polygons(255, 0).is_empty());
    }

    #[test]
    fn two_corners_on_the_diagonal_of_a_face_are_apart_or_connected() {
        // Corners 0 and 3 of the face k = 0.
        assert_eq!(CELL_POLYGONS.ambiguous(0b1001), 1 << 4);
        assert_eq!(polygons(0b1001, 0).len(), 2);
        assert_eq!(polygons(0b1001, 1 << 4).len(), 1);
    }
}
