//! Collapsing one vertex after another into a neighbour, the cheapest first.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use rayon::prelude::*;

use crate::mesh::{Faces, Point3, Vector3};

/// How much more leaving the surface counts than the length of the collapsed edge, both squared:
/// faces stay of even size on smooth parts and follow bends.
const SURFACE_WEIGHT: f64 = 4.0;

/// Least cosine between the normals of a face before and after: faces must not flip.
const MIN_COSINE: f64 = 0.3;

/// Least quality 4√3 A / Σ l² (1 for equal sides) of a new face, unless the old were as bad.
const MIN_QUALITY: f64 = 0.25;

/// Faces around a vertex, up to which no two of its neighbours may be joined: two faces would be folded onto each other.
const FEW: usize = 3;

/// A collapse of `vertex` into `into`, as good as it was when `version` was the vertex's.
struct Candidate {
    cost: f64,
    vertex: u32,
    into: u32,
    version: u32,
}

impl Ord for Candidate {
    /// The cheapest is the greatest; equal costs by number, so that the order is always the same.
    fn cmp(&self, other: &Self) -> Ordering {
        other
            .cost
            .total_cmp(&self.cost)
            .then_with(|| other.vertex.cmp(&self.vertex))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Candidate {}

/// Kept vertices, faces over them, and three of them with weights for every vertex.
pub(super) type Finished = (Vec<u32>, Vec<[u32; 3]>, Vec<([u32; 3], [f64; 3])>);

/// A mesh that loses vertices.
pub(super) struct Collapsing<'a> {
    points: &'a [Point3],
    triangles: Vec<[u32; 3]>,
    alive: Vec<bool>,
    /// Living faces around each vertex.
    around: Vec<Vec<u32>>,
    on_boundary: Vec<bool>,
    locked: Vec<bool>,
    removed: Vec<bool>,
    /// Removed vertices that each face holds.
    residents: Vec<Vec<u32>>,
    /// Face and weights of each removed vertex.
    place: Vec<(u32, [f64; 3])>,
    /// Whether it is kept where removed vertices lie.
    places: bool,
    version: Vec<u32>,
    /// The other end of each vertex's best collapse, or no vertex.
    best_into: Vec<u32>,
    queue: BinaryHeap<Candidate>,
}

impl<'a> Collapsing<'a> {
    /// With `places`, the way back from the coarse mesh is kept, too.
    pub fn new(points: &'a [Point3], faces: &Faces, places: bool) -> Self {
        let count = faces.vertex_count();
        let mut around = vec![Vec::new(); count];
        for (face, triangle) in faces.triangles().iter().enumerate() {
            for &v in triangle {
                around[v as usize].push(face as u32);
            }
        }
        let mut on_boundary = vec![false; count];
        let mut locked: Vec<bool> = around.iter().map(Vec::is_empty).collect();
        for ([a, b], valence) in faces.edge_valences() {
            for v in [a, b] {
                on_boundary[v as usize] |= valence == 1;
                locked[v as usize] |= valence > 2;
            }
        }
        let mut state = Self {
            points,
            triangles: faces.triangles().to_vec(),
            alive: vec![true; faces.triangles().len()],
            around,
            on_boundary,
            locked,
            removed: vec![false; count],
            residents: vec![Vec::new(); faces.triangles().len()],
            place: vec![(0, [0.0; 3]); count],
            places,
            version: vec![0; count],
            best_into: vec![u32::MAX; count],
            queue: BinaryHeap::new(),
        };
        let vertices = (0..count as u32).into_par_iter();
        let offers: Vec<Candidate> = vertices.filter_map(|v| state.best(v)).collect();
        for offer in &offers {
            state.best_into[offer.vertex as usize] = offer.into;
        }
        state.queue = offers.into();
        state
    }

    /// Does the cheapest collapse; false if none is left.
    pub fn collapse_cheapest(&mut self) -> bool {
        while let Some(candidate) = self.queue.pop() {
            let v = candidate.vertex as usize;
            if !self.removed[v] && self.version[v] == candidate.version {
                self.collapse(candidate.vertex, candidate.into);
                return true;
            }
        }
        false
    }

    pub fn finished(self) -> Finished {
        let kept: Vec<u32> = (0..self.removed.len() as u32)
            .filter(|&v| !self.removed[v as usize])
            .collect();
        let mut coarse = vec![0_u32; self.removed.len()];
        for (index, &v) in kept.iter().enumerate() {
            coarse[v as usize] = index as u32;
        }
        let renamed = |triangle: [u32; 3]| triangle.map(|v| coarse[v as usize]);
        let triangles = (self.triangles.iter().zip(&self.alive))
            .filter(|(_, alive)| **alive)
            .map(|(&triangle, _)| renamed(triangle))
            .collect();
        let supports = (0..self.removed.len())
            .map(|v| {
                if self.removed[v] {
                    let (face, weights) = self.place[v];
                    (renamed(self.triangles[face as usize]), weights)
                } else {
                    ([coarse[v]; 3], [1.0, 0.0, 0.0])
                }
            })
            .collect();
        (kept, triangles, supports)
    }

    /// Puts the best collapse of a vertex, if any, into the queue; older offers lapse.
    fn offer(&mut self, vertex: u32) {
        self.version[vertex as usize] += 1;
        let best = self.best(vertex);
        self.best_into[vertex as usize] = best.as_ref().map_or(u32::MAX, |best| best.into);
        self.queue.extend(best);
    }

    /// The cheapest collapse of a vertex, if any.
    fn best(&self, vertex: u32) -> Option<Candidate> {
        let v = vertex as usize;
        if self.locked[v] || self.removed[v] {
            return None;
        }
        let beside = self.neighbours(vertex);
        let length2 = |into: u32| (self.points[into as usize] - self.points[v]).norm_squared();
        let mut by_length: Vec<(f64, u32)> = beside.iter().map(|&n| (length2(n), n)).collect();
        by_length.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut best: Option<(f64, u32)> = None;
        for (length2, into) in by_length {
            // A collapse costs no less than the length of its edge.
            if best.is_some_and(|(cost, _)| length2 > cost) {
                break;
            }
            let Some(cost) = self.cost(vertex, into, &beside, length2) else {
                continue;
            };
            let cheaper = |(known, other): (f64, u32)| {
                cost.total_cmp(&known).then(into.cmp(&other)) == Ordering::Less
            };
            if best.is_none_or(cheaper) {
                best = Some((cost, into));
            }
        }
        best.map(|(cost, into)| Candidate {
            cost,
            vertex,
            into,
            version: self.version[v],
        })
    }

    fn neighbours(&self, vertex: u32) -> Vec<u32> {
        let mut found = Vec::with_capacity(2 * self.around[vertex as usize].len());
        for &face in &self.around[vertex as usize] {
            let others = self.triangles[face as usize].into_iter();
            found.extend(others.filter(|&other| other != vertex));
        }
        found.sort_unstable();
        found.dedup();
        found
    }

    /// What the collapse along an edge of this squared length costs, between a vertex with these neighbours and one of them;
    /// `None` where it would change topology, flip or squeeze a face.
    fn cost(&self, vertex: u32, into: u32, beside: &[u32], length2: f64) -> Option<f64> {
        let shared = (self.around[vertex as usize].iter())
            .filter(|&&face| self.triangles[face as usize].contains(&into))
            .count();
        if self.on_boundary[vertex as usize] && !(self.on_boundary[into as usize] && shared == 1) {
            return None;
        }
        if shared > 2 {
            return None;
        }
        let mut common = [0; 2];
        let mut count = 0;
        for &face in &self.around[into as usize] {
            for other in self.triangles[face as usize] {
                let is_new = other != into && !common[..count].contains(&other);
                if is_new && beside.binary_search(&other).is_ok() {
                    if count == shared {
                        return None;
                    }
                    common[count] = other;
                    count += 1;
                }
            }
        }
        if count != shared {
            return None;
        }
        // A vertex that two faces are left of would fold them onto each other.
        let folds =
            |&v: &u32| !self.on_boundary[v as usize] && self.around[v as usize].len() <= FEW;
        if common[..count].iter().any(folds) {
            return None;
        }
        let point = self.points[vertex as usize];
        let mut off_surface = f64::INFINITY;
        for &face in &self.around[vertex as usize] {
            let triangle = self.triangles[face as usize];
            if triangle.contains(&into) {
                continue;
            }
            let before = self.corners(triangle);
            let after = self.corners(triangle.map(|v| if v == vertex { into } else { v }));
            if !stays_upright(&before, &after) {
                return None;
            }
            let (nearest, _) = closest(&after, &point);
            off_surface = off_surface.min((nearest - point).norm_squared());
        }
        let cost = length2 + SURFACE_WEIGHT * off_surface;
        cost.is_finite().then_some(cost)
    }

    fn corners(&self, triangle: [u32; 3]) -> [Point3; 3] {
        triangle.map(|v| self.points[v as usize])
    }

    fn collapse(&mut self, vertex: u32, into: u32) {
        let ring = self.neighbours(vertex);
        let few_before = self.around[into as usize].len() <= FEW;
        let mut homeless = vec![vertex];
        let mut homes = Vec::new();
        for face in std::mem::take(&mut self.around[vertex as usize]) {
            let f = face as usize;
            homeless.append(&mut self.residents[f]);
            if self.triangles[f].contains(&into) {
                self.alive[f] = false;
                for v in self.triangles[f] {
                    self.around[v as usize].retain(|&other| other != face);
                }
            } else {
                self.triangles[f] = self.triangles[f].map(|v| if v == vertex { into } else { v });
                self.around[into as usize].push(face);
                homes.push(face);
            }
        }
        self.removed[vertex as usize] = true;
        if self.places {
            self.house(&homeless, &homes);
        }
        let few = |&v: &u32| self.around[v as usize].len() <= FEW;
        let all = few_before || ring.iter().any(few);
        // Beside the ring only the link of `into` grew: collapses into it may be off, others are as good as before.
        let beside = self.neighbours(into).into_iter();
        let lapsed = |&v: &u32| all || self.best_into[v as usize] == into;
        let mut touched: Vec<u32> = beside.filter(lapsed).collect();
        touched.extend(ring);
        touched.sort_unstable();
        touched.dedup();
        for v in touched {
            self.offer(v);
        }
    }

    /// Gives each vertex a place in the nearest of these faces.
    fn house(&mut self, homeless: &[u32], homes: &[u32]) {
        for &lodger in homeless {
            let point = self.points[lodger as usize];
            let nearest = (homes.iter())
                .map(|&face| {
                    let corners = self.corners(self.triangles[face as usize]);
                    let (at, weights) = closest(&corners, &point);
                    ((at - point).norm_squared(), face, weights)
                })
                .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            // A collapse that leaves no face is never offered: see `cost`.
            if let Some((_, face, weights)) = nearest {
                self.place[lodger as usize] = (face, weights);
                self.residents[face as usize].push(lodger);
            }
        }
    }
}

fn stays_upright(before: &[Point3; 3], after: &[Point3; 3]) -> bool {
    let normal = |[a, b, c]: &[Point3; 3]| (b - a).cross(&(c - a));
    let (old, new) = (normal(before), normal(after));
    let cosine_enough = old.dot(&new) >= MIN_COSINE * old.norm() * new.norm();
    let shape = quality(after, new.norm());
    new.norm() > 0.0
        && cosine_enough
        && (shape >= MIN_QUALITY || shape >= quality(before, old.norm()))
}

fn quality([a, b, c]: &[Point3; 3], doubled_area: f64) -> f64 {
    let sides: f64 = [b - a, c - b, a - c]
        .iter()
        .map(Vector3::norm_squared)
        .sum();
    2.0 * 3.0_f64.sqrt() * doubled_area / sides
}

/// Point of a triangle nearest to another point, with its barycentric weights.
///
/// Source: C. Ericson (2005), *Real-Time Collision Detection*, section 5.1.5.
fn closest(&[a, b, c]: &[Point3; 3], p: &Point3) -> (Point3, [f64; 3]) {
    let (ab, ac) = (b - a, c - a);
    let to = |from: &Point3| [ab.dot(&(p - from)), ac.dot(&(p - from))];
    let [[d1, d2], [d3, d4], [d5, d6]] = [to(&a), to(&b), to(&c)];
    let (va, vb, vc) = (d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2);
    let along = |part: f64, whole: f64| {
        if whole > 0.0 {
            (part / whole).clamp(0.0, 1.0)
        } else {
            0.0
        }
    };
    let weights = if d1 <= 0.0 && d2 <= 0.0 {
        [1.0, 0.0, 0.0]
    } else if d3 >= 0.0 && d4 <= d3 {
        [0.0, 1.0, 0.0]
    } else if d6 >= 0.0 && d5 <= d6 {
        [0.0, 0.0, 1.0]
    } else if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let t = along(d1, d1 - d3);
        [1.0 - t, t, 0.0]
    } else if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let t = along(d2, d2 - d6);
        [1.0 - t, 0.0, t]
    } else if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let t = along(d4 - d3, (d4 - d3) + (d5 - d6));
        [0.0, 1.0 - t, t]
    } else {
        let whole = va + vb + vc;
        let (v, w) = (along(vb, whole), along(vc, whole));
        [(1.0 - v - w).max(0.0), v, w]
    };
    (a + ab * weights[1] + ac * weights[2], weights)
}
