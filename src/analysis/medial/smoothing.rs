//! Takes roughness off surfaces before balls are laid between them.

use glam::Vec3A;
use rayon::prelude::*;

use super::connectivity::Connectivity;
use crate::mesh::{Point3, Vector3, area};

/// Vertices that one thread takes at a time, so that small surfaces are not handed around and sums are the same on any number
/// of threads.
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

/// Change of the area, of what it was, below which another pass changes nothing.
const SETTLED: f64 = 0.01;

/// Smooths all surfaces over the length ℓ.
///
/// With S = (M + ℓ² L)⁻¹ M, an implicit step of heat flow (L: cotangents, negative ones left out; M: thirds of areas),
/// the answer is (2 S − S²) x. A wave of number k keeps 1 − (ℓ²k² / (1 + ℓ²k²))² of its height:
/// curvature of radius R is lost with the fourth power of ℓ/R only, so that walls do not shrink, while S
/// alone would draw them in by ℓ² times their curvature. Open boundaries are smoothed along themselves, in one dimension, and hold the rest.
///
/// Sources: implicit flow, Desbrun, Meyer, Schröder and Barr (1999), SIGGRAPH, 317–324; 2 S − S² is Tukey's twicing (*Exploratory Data Analysis*, 1977).
///
/// Where noise is so large that areas and angles of the surfaces are those of noise, M and L come from
/// the surfaces smoothed before, until their area settles, `passes` times over at most.
pub(super) fn smooth(
    connectivity: &Connectivity,
    points: &[Point3],
    length: f64,
    passes: usize,
) -> Smoothed {
    smooth_from(connectivity, points, points, length, passes)
}

/// The same with areas and angles from a shape that is nearer to the answer than the points are.
pub(super) fn smooth_from(
    connectivity: &Connectivity,
    shape: &[Point3],
    points: &[Point3],
    length: f64,
    passes: usize,
) -> Smoothed {
    if length <= 0.0 {
        return Smoothed {
            once: points.to_vec(),
            points: points.to_vec(),
        };
    }
    let start: Vec<Vector3> = points.iter().map(|p| p.coords).collect();
    let mut flow = Flow::new(connectivity, shape, length);
    let size_of = |points: &[Point3]| {
        let chunks = connectivity.triangles.par_chunks(CHUNK);
        sum_of(chunks.map(|triangles| area(points, triangles)))
    };
    let mut size = size_of(shape);
    let guess = shape.iter().map(|p| p.coords).collect();
    let mut once = as_points(flow.step(&start, guess));
    for _ in 0..passes {
        let now = size_of(&once);
        if (now - size).abs() <= SETTLED * size {
            break;
        }
        size = now;
        flow = Flow::new(connectivity, &once, length);
        once = as_points(flow.step(&start, once.iter().map(|p| p.coords).collect()));
    }
    let lost: Vec<Vector3> = points.iter().zip(&once).map(|(x, s)| x - s).collect();
    let back = flow.step(&lost, lost.clone());
    Smoothed {
        points: once.iter().zip(back).map(|(s, back)| s + back).collect(),
        once,
    }
}

fn as_points(vectors: Vec<Vector3>) -> Vec<Point3> {
    vectors.into_iter().map(Point3::from).collect()
}

/// S, by the areas and angles of a shape.
struct Flow {
    rim: System,
    inside: System,
}

impl Flow {
    fn new(connectivity: &Connectivity, shape: &[Point3], length: f64) -> Self {
        Self {
            rim: System::of_boundary(connectivity, shape, length),
            inside: System::of_surface(connectivity, shape, length),
        }
    }

    /// S applied to a field, found from a guess.
    fn step(&self, field: &[Vector3], guess: Vec<Vector3>) -> Vec<Vector3> {
        let mut found = guess;
        self.rim.solve(field, &mut found);
        self.inside.solve(field, &mut found);
        found
    }
}

/// (M + ℓ² L) y = M x for the vertices that are free; the others keep what they have.
struct System {
    free: Vec<u32>,
    /// Where the row of each free vertex begins, and the number of all entries at the end.
    starts: Vec<u32>,
    /// Free neighbours, by their places among the free.
    columns: Vec<u32>,
    /// ℓ² times the weight of each entry, over the scales of its row and its column: the diagonal of the matrix is 1.
    weights: Vec<f32>,
    /// Places of free vertices, their neighbours that are not, and ℓ² times the weights.
    held: Vec<(u32, u32, f64)>,
    mass: Vec<f64>,
    /// Root of the diagonal of M + ℓ² L.
    scales: Vec<f64>,
}

impl System {
    fn of_surface(connectivity: &Connectivity, points: &[Point3], length: f64) -> Self {
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
        Self::new(connectivity, &weights, &mass, |vertex| {
            !connectivity.boundary[vertex]
        })
    }

    /// Edges of single faces as a chain: masses are half the lengths, weights their inverses.
    fn of_boundary(connectivity: &Connectivity, points: &[Point3], length: f64) -> Self {
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
        Self::new(connectivity, &weights, &mass, |vertex| {
            connectivity.boundary[vertex]
        })
    }

    /// From weights of all entries and masses of all vertices.
    fn new(
        connectivity: &Connectivity,
        weights: &[f64],
        mass: &[f64],
        may_move: impl Fn(usize) -> bool,
    ) -> Self {
        let rows = &connectivity.rows;
        let diagonal = |vertex: usize| mass[vertex] + weights[rows.of(vertex)].iter().sum::<f64>();
        let free: Vec<u32> = (0..mass.len())
            .filter(|&vertex| may_move(vertex) && diagonal(vertex) > 0.0)
            .map(|vertex| vertex as u32)
            .collect();
        let mut place_of = vec![u32::MAX; mass.len()];
        for (place, &vertex) in (0..).zip(&free) {
            place_of[vertex as usize] = place;
        }
        let scale = |place: u32| diagonal(free[place as usize] as usize).sqrt();
        let mut system = Self {
            starts: vec![0],
            columns: Vec::with_capacity(rows.neighbours.len()),
            weights: Vec::with_capacity(rows.neighbours.len()),
            held: Vec::new(),
            mass: free.iter().map(|&vertex| mass[vertex as usize]).collect(),
            scales: (0..free.len() as u32).map(scale).collect(),
            free,
        };
        for (place, &vertex) in (0..).zip(&system.free) {
            for entry in rows.of(vertex as usize) {
                let (other, weight) = (rows.neighbours[entry], weights[entry]);
                match place_of[other as usize] {
                    _ if weight == 0.0 => {}
                    u32::MAX => system.held.push((place, other, weight)),
                    column => {
                        let scales = [place, column].map(|place| system.scales[place as usize]);
                        system.columns.push(column);
                        system.weights.push((weight / scales[0] / scales[1]) as f32);
                    }
                }
            }
            system.starts.push(system.columns.len() as u32);
        }
        system
    }

    /// Conjugate gradients, the diagonal scaled to 1, for the three coordinates as one system, so that turning
    /// the heart turns every step. Starts from, and holds, what is in `found`; ends where the residual is small against that of `field`.
    ///
    /// What is missing to the answer is found in 32 bits, as the residual of the start is in 64.
    fn solve(&self, field: &[Vector3], found: &mut [Vector3]) {
        let goal = TOLERANCE * TOLERANCE * total(&self.residual(field, field));
        let residual = self.residual(field, found);
        let whole = total(&residual);
        if whole <= goal.max(f64::MIN_POSITIVE) {
            return;
        }
        let (goal, unit) = (goal / whole, whole.sqrt());
        let mut residual: Vec<Vec3A> = (residual.iter()).map(|r| in_32_bits(r / unit)).collect();
        let mut direction = residual.clone();
        let mut image = vec![Vec3A::ZERO; residual.len()];
        let mut missing = image.clone();
        let mut size = 1.0;
        for _ in 0..MOST_STEPS {
            if size <= goal {
                break;
            }
            let bend = self.multiply(&direction, &mut image);
            if bend <= 0.0 {
                break;
            }
            let part = (size / bend) as f32;
            let next_size = sum_of(
                (missing
                    .par_chunks_mut(CHUNK)
                    .zip(residual.par_chunks_mut(CHUNK)))
                .zip(direction.par_chunks(CHUNK).zip(image.par_chunks(CHUNK)))
                .map(|((missing, residual), (direction, image))| {
                    let mut size = 0.0;
                    for ((x, r), (d, i)) in
                        (missing.iter_mut().zip(residual)).zip(direction.iter().zip(image))
                    {
                        *x += part * *d;
                        *r -= part * *i;
                        size += f64::from(r.length_squared());
                    }
                    size
                }),
            );
            let keep = (next_size / size) as f32;
            (direction.par_chunks_mut(CHUNK))
                .zip(residual.par_chunks(CHUNK))
                .for_each(|(direction, residual)| {
                    for (d, r) in direction.iter_mut().zip(residual) {
                        *d = *r + keep * *d;
                    }
                });
            size = next_size;
        }
        for ((&vertex, missing), scale) in self.free.iter().zip(missing).zip(&self.scales) {
            found[vertex as usize] +=
                unit / scale * Vector3::from(missing.to_array().map(f64::from));
        }
    }

    /// M x − (M + ℓ² L) y, over the scales.
    fn residual(&self, x: &[Vector3], y: &[Vector3]) -> Vec<Vector3> {
        let mut residual: Vec<Vector3> = (self.free.par_iter().enumerate())
            .with_min_len(CHUNK)
            .map(|(row, &vertex)| {
                let here = y[vertex as usize];
                let entries = self.starts[row] as usize..self.starts[row + 1] as usize;
                let columns = &self.columns[entries.clone()];
                let start = self.mass[row] / self.scales[row] * (x[vertex as usize] - here);
                (self.weights[entries].iter().zip(columns)).fold(
                    start,
                    |sum, (&weight, &column)| {
                        let there = y[self.free[column as usize] as usize];
                        sum + f64::from(weight) * self.scales[column as usize] * (there - here)
                    },
                )
            })
            .collect();
        for &(row, other, weight) in &self.held {
            let here = y[self.free[row as usize] as usize];
            residual[row as usize] +=
                weight / self.scales[row as usize] * (y[other as usize] - here);
        }
        residual
    }

    /// Lays the scaled matrix times x into `image`; its product with x comes back.
    fn multiply(&self, x: &[Vec3A], image: &mut [Vec3A]) -> f64 {
        let chunk = |(chunk, image): (usize, &mut [Vec3A])| {
            let mut sum = 0.0;
            for (row, image) in (chunk * CHUNK..).zip(image) {
                let entries = self.starts[row] as usize..self.starts[row + 1] as usize;
                let columns = &self.columns[entries.clone()];
                let entries = self.weights[entries].iter().zip(columns);
                *image = entries.fold(x[row], |sum, (&weight, &column)| {
                    sum - weight * x[column as usize]
                });
                sum += f64::from(image.dot(x[row]));
            }
            sum
        };
        sum_of(image.par_chunks_mut(CHUNK).enumerate().map(chunk))
    }
}

fn total(vectors: &[Vector3]) -> f64 {
    vectors.iter().map(Vector3::norm_squared).sum()
}

fn in_32_bits(vector: Vector3) -> Vec3A {
    Vec3A::new(vector.x as f32, vector.y as f32, vector.z as f32)
}

/// The sum in order, the same on any number of threads.
fn sum_of(parts: impl IndexedParallelIterator<Item = f64>) -> f64 {
    parts.collect::<Vec<f64>>().iter().sum()
}
