//! One step of heat flow as a system of equations, and its solution.

use glam::Vec3A;
use rayon::prelude::*;

use crate::analysis::medial::connectivity::Connectivity;
use crate::mesh::{Point3, Vector3};

/// Vertices that one thread takes at a time, so that small surfaces are not handed around and sums are the same on any number
/// of threads.
pub(super) const CHUNK: usize = 4096;

/// Residual, of what it was, at which a solution is good: a five-hundredth of the roughness, which leaves less than the
/// smoothing itself does.
const TOLERANCE: f64 = 2e-3;

/// The system's condition is some 1 + 12 ℓ²/h² with edges h, so that ℓ = 10 h needs fewer. At the pole of a grid, where
/// edges are far shorter, what is left after these is less smooth than it might be, and nothing else.
const MAX_STEPS: usize = 64;

/// Greatest cotangent that counts: that of 3°. Flatter corners, whose sides lie on each other, would tie vertices
/// together without bound.
const MAX_COTANGENT: f64 = 20.0;

/// (M + ℓ² L) y = M x for the vertices that are free; the others keep what they have.
pub(super) struct System {
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
    pub fn of_surface(connectivity: &Connectivity, points: &[Point3], length: f64) -> Self {
        let rows = &connectivity.rows;
        let mut weights = vec![0.0; rows.neighbours.len()];
        let mut mass = vec![0.0; points.len()];
        for (triangle, sides) in connectivity.triangles.iter().zip(&rows.sides) {
            let corners = triangle.map(|v| points[v as usize]);
            let doubled_area = (corners[1] - corners[0])
                .cross(&(corners[2] - corners[0]))
                .norm();
            for (k, entries) in sides.iter().enumerate() {
                // As `mesh::vertex_areas` sums them, in the one pass over the faces that the weights need anyway.
                mass[triangle[k] as usize] += doubled_area / 6.0;
                let far = corners[(k + 2) % 3];
                let dot = (corners[k] - far).dot(&(corners[(k + 1) % 3] - far));
                let min_doubled_area = (dot.abs() / MAX_COTANGENT).max(f64::MIN_POSITIVE);
                // Negative cotangents, of obtuse corners, could make the system indefinite.
                let cotangent = (dot / doubled_area.max(min_doubled_area)).max(0.0);
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
    pub fn of_boundary(connectivity: &Connectivity, points: &[Point3], length: f64) -> Self {
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
    /// the subject turns every step. Starts from, and holds, what is in `found`; ends where the residual is small against that of `field`.
    ///
    /// What is missing to the answer is found in 32 bits, as the residual of the start is in 64.
    pub fn solve(&self, field: &[Vector3], found: &mut [Vector3]) {
        // Relative to the roughness of the field itself, so that smooth surfaces, which have little to lose, are not
        // solved to excess.
        let goal = TOLERANCE * TOLERANCE * total(&self.residual(field, field));
        let residual = self.residual(field, found);
        let whole = total(&residual);
        if whole <= goal.max(f64::MIN_POSITIVE) {
            return;
        }
        // Scaled to length 1, residuals of any unit of coordinates fit 32 bits.
        let (goal, unit) = (goal / whole, whole.sqrt());
        let mut residual: Vec<Vec3A> = (residual.iter()).map(|r| in_32_bits(r / unit)).collect();
        let mut direction = residual.clone();
        let mut image = vec![Vec3A::ZERO; residual.len()];
        let mut missing = image.clone();
        let mut size = 1.0;
        for _ in 0..MAX_STEPS {
            if size <= goal {
                break;
            }
            let bend = self.multiply(&direction, &mut image);
            // Only rounding makes this happen: the direction has no length left.
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
pub(super) fn sum_of(parts: impl IndexedParallelIterator<Item = f64>) -> f64 {
    parts.collect::<Vec<f64>>().iter().sum()
}
