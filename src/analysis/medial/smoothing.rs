//! Takes roughness off surfaces before balls are laid between them.

use rayon::prelude::*;

use super::connectivity::Connectivity;
use crate::mesh::{Point3, Vector3, area};

/// Vertices whose products one thread takes at least, so that small surfaces are not handed around.
const CHUNK: usize = 4096;

/// Residual, of what it was, at which a solution is good: a five-hundredth of the roughness, which leaves less than the
/// smoothing itself does.
const TOLERANCE: f64 = 2e-3;

/// The system's condition is some 1 + 12 ℓ²/h² with edges h, so that ℓ = 10 h needs fewer. At the pole of a grid, where
/// edges are far shorter, what is left after these is less smooth than it might be, and nothing else.
const MOST_STEPS: usize = 64;

/// Greatest cotangent that counts: that of 3°. Flatter corners, whose sides lie on each other, would tie vertices
/// together without bound.
const MOST_COTANGENT: f64 = 20.0;

/// A surface smoothed once, which is smoother but drawn in where it is curved, and with that mended.
#[derive(Clone, Debug)]
pub(super) struct Smoothed {
    pub once: Vec<Point3>,
    pub points: Vec<Point3>,
}

/// Smooths all surfaces over the length ℓ.
///
/// With S = (M + ℓ² L)⁻¹ M, an implicit step of heat flow (L: cotangents, negative ones left out; M: thirds of areas),
/// the answer is (2 S − S²) x. A wave of number k keeps 1 − (ℓ²k² / (1 + ℓ²k²))² of its height:
/// curvature of radius R is lost with the fourth power of ℓ/R only, so that walls do not shrink, while S
/// alone would draw them in by ℓ² times their curvature. Open boundaries are smoothed along themselves, in one dimension, and hold the rest.
///
/// Sources: implicit flow, Desbrun, Meyer, Schröder and Barr (1999), SIGGRAPH, 317–324; 2 S − S² is Tukey's twicing (*Exploratory Data Analysis*, 1977).
pub(super) fn smooth(connectivity: &Connectivity, points: &[Point3], length: f64) -> Smoothed {
    if length <= 0.0 {
        return Smoothed {
            once: points.to_vec(),
            points: points.to_vec(),
        };
    }
    smooth_by(connectivity, points, points, length)
}

/// Change of the area, of what it was, below which another pass changes nothing.
const SETTLED: f64 = 0.01;

/// The same where noise is so large that areas and angles of the surfaces are those of noise: M and L come from
/// the surfaces smoothed before, until their area settles, `passes` times over at most.
pub(super) fn smooth_rough(
    connectivity: &Connectivity,
    points: &[Point3],
    length: f64,
    passes: usize,
) -> Smoothed {
    let size = |points: &[Point3]| area(points, &connectivity.triangles);
    let mut smoothed = smooth(connectivity, points, length);
    if passes == 0 || length <= 0.0 {
        return smoothed;
    }
    let mut before = size(points);
    for _ in 0..passes {
        let now = size(&smoothed.once);
        if (now - before).abs() <= SETTLED * before {
            break;
        }
        before = now;
        smoothed = smooth_by(connectivity, &smoothed.once, points, length);
    }
    smoothed
}

/// With areas and angles of another shape.
fn smooth_by(
    connectivity: &Connectivity,
    shape: &[Point3],
    points: &[Point3],
    length: f64,
) -> Smoothed {
    let rim = System::of_boundary(connectivity, shape, length);
    let inside = System::of_surface(connectivity, shape, length);
    let step = |field: &[Vector3]| inside.solve(field, &rim.solve(field, field));
    let start: Vec<Vector3> = points.iter().map(|p| p.coords).collect();
    let once = step(&start);
    let lost: Vec<Vector3> = start.iter().zip(&once).map(|(x, s)| x - s).collect();
    let mended = once.iter().zip(step(&lost));
    Smoothed {
        points: mended.map(|(s, back)| Point3::from(s + back)).collect(),
        once: once.into_iter().map(Point3::from).collect(),
    }
}

/// (M + ℓ² L) y = M x for the vertices that are free; the others keep what they have.
struct System<'a> {
    connectivity: &'a Connectivity,
    /// ℓ² times the weight of each entry of the rows.
    weights: Vec<f64>,
    mass: Vec<f64>,
    /// M + ℓ² L on the diagonal; 0 for vertices that are not free.
    diagonal: Vec<f64>,
}

impl<'a> System<'a> {
    fn of_surface(connectivity: &'a Connectivity, points: &[Point3], length: f64) -> Self {
        let rows = &connectivity.rows;
        let mut weights = vec![0.0; rows.neighbours.len()];
        let mut mass = vec![0.0; points.len()];
        for (triangle, sides) in connectivity.triangles.iter().zip(&rows.sides) {
            let corners = triangle.map(|v| points[v as usize]);
            let doubled_area = (corners[1] - corners[0])
                .cross(&(corners[2] - corners[0]))
                .norm();
            for (k, entries) in sides.iter().enumerate() {
                mass[triangle[k] as usize] += doubled_area / 6.0;
                let far = corners[(k + 2) % 3];
                let dot = (corners[k] - far).dot(&(corners[(k + 1) % 3] - far));
                let flattest = (dot.abs() / MOST_COTANGENT).max(f64::MIN_POSITIVE);
                let cotangent = (dot / doubled_area.max(flattest)).max(0.0);
                for &entry in entries {
                    weights[entry as usize] += 0.5 * length * length * cotangent;
                }
            }
        }
        Self::new(connectivity, weights, mass, |vertex| {
            !connectivity.boundary[vertex]
        })
    }

    /// Edges of single faces as a chain: masses are half the lengths, weights their inverses.
    fn of_boundary(connectivity: &'a Connectivity, points: &[Point3], length: f64) -> Self {
        let rows = &connectivity.rows;
        let mut weights = vec![0.0; rows.neighbours.len()];
        let mut mass = vec![0.0; points.len()];
        for vertex in (0..points.len()).filter(|&vertex| connectivity.boundary[vertex]) {
            for entry in rows.of(vertex).filter(|&entry| rows.single[entry]) {
                let side = (points[rows.neighbours[entry] as usize] - points[vertex]).norm();
                mass[vertex] += 0.5 * side;
                if side > 0.0 {
                    weights[entry] = length * length / side;
                }
            }
        }
        Self::new(connectivity, weights, mass, |vertex| {
            connectivity.boundary[vertex]
        })
    }

    fn new(
        connectivity: &'a Connectivity,
        weights: Vec<f64>,
        mass: Vec<f64>,
        free: impl Fn(usize) -> bool,
    ) -> Self {
        let diagonal = (0..mass.len())
            .map(|vertex| {
                let ties: f64 = weights[connectivity.rows.of(vertex)].iter().sum();
                if free(vertex) {
                    mass[vertex] + ties
                } else {
                    0.0
                }
            })
            .collect();
        Self {
            connectivity,
            weights,
            mass,
            diagonal,
        }
    }

    /// Conjugate gradients with the diagonal as preconditioner, for the three coordinates as one system, so that turning
    /// the heart turns every step. Starts from, and holds, `start`.
    fn solve(&self, field: &[Vector3], start: &[Vector3]) -> Vec<Vector3> {
        let mut found = start.to_vec();
        let mut residual = self.multiplied(&found);
        for ((r, x), &m) in residual.iter_mut().zip(field).zip(&self.mass) {
            *r = m * x - *r;
        }
        let inverse: Vec<f64> = (self.diagonal.iter())
            .map(|&d| if d > 0.0 { d.recip() } else { 0.0 })
            .collect();
        let mut direction: Vec<Vector3> =
            residual.iter().zip(&inverse).map(|(r, &w)| w * r).collect();
        let mut size = dot(&residual, &direction);
        let goal = TOLERANCE * TOLERANCE * size;
        for _ in 0..MOST_STEPS {
            if size <= goal || size <= f64::MIN_POSITIVE {
                break;
            }
            let image = self.multiplied(&direction);
            let bend = dot(&direction, &image);
            if bend <= 0.0 {
                break;
            }
            let part = size / bend;
            let mut next_size = 0.0;
            for (x, d) in found.iter_mut().zip(&direction) {
                *x += part * d;
            }
            for ((r, i), w) in residual.iter_mut().zip(&image).zip(&inverse) {
                *r -= part * i;
                next_size += w * r.norm_squared();
            }
            let keep = next_size / size;
            for ((d, r), &w) in direction.iter_mut().zip(&residual).zip(&inverse) {
                *d = w * r + keep * *d;
            }
            size = next_size;
        }
        found
    }

    /// (M + ℓ² L) x; 0 where vertices are not free.
    fn multiplied(&self, field: &[Vector3]) -> Vec<Vector3> {
        let rows = &self.connectivity.rows;
        let row = |vertex: usize| {
            let diagonal = self.diagonal[vertex];
            if diagonal <= 0.0 {
                return Vector3::zeros();
            }
            let entries = rows.of(vertex);
            let neighbours = &rows.neighbours[entries.clone()];
            (self.weights[entries].iter().zip(neighbours))
                .fold(diagonal * field[vertex], |sum, (&weight, &other)| {
                    sum - weight * field[other as usize]
                })
        };
        (0..field.len())
            .into_par_iter()
            .with_min_len(CHUNK)
            .map(row)
            .collect()
    }
}

fn dot(a: &[Vector3], b: &[Vector3]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x.dot(y)).sum()
}
