//! How rough surfaces are, told from themselves, and over what length they are smoothed for that.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::connectivity::Connectivity;
use super::smoothing::{Smoothed, smooth, smooth_from};
use crate::mesh::{Point3, Vector3, vertex_normals};

/// Each length that is tried over the one before.
const RATIO: f64 = std::f64::consts::SQRT_2;

/// Times that normals are averaged with those of their neighbours.
const NORMAL_STEPS: usize = 2;

/// Noise, in sides of the square that a vertex has to itself, from which areas and angles are those of noise …
const ROUGH: f64 = 0.15;

/// … and how often at most they are then taken from the surfaces smoothed before.
const PASSES: usize = 8;

/// 1 / Φ⁻¹(¾): standard deviation of a normal distribution over its median absolute value.
const NORMAL_FROM_MEDIAN: f64 = 1.482_602_218_505_602;

/// How the surfaces of all poses are smoothed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plan {
    /// Standard deviation of the noise of each coordinate, in coordinates.
    pub noise: f64,
    /// ℓ, in coordinates.
    pub length: f64,
    /// How often areas and angles are taken from smoothed surfaces.
    pub passes: usize,
}

impl Plan {
    pub fn smooth(&self, connectivity: &Connectivity, points: &[Point3]) -> Smoothed {
        smooth(connectivity, points, self.length, self.passes)
    }
}

/// Tells the noise of surfaces on the same faces.
#[derive(Clone, Debug)]
pub(super) struct Roughness {
    /// Vertices that have no boundary within two edges.
    inside: Vec<u32>,
    /// Standard deviation, for each of them, of the second difference of noise of standard deviation 1.
    of_noise: Vec<f64>,
}

impl Roughness {
    pub fn new(connectivity: &Connectivity) -> Self {
        let rows = &connectivity.rows;
        let free = |vertex: usize| !rows.of(vertex).is_empty() && !connectivity.boundary[vertex];
        let around = |vertex: usize| &rows.neighbours[rows.of(vertex)];
        let inside: Vec<u32> = (0..connectivity.vertex_count())
            .filter(|&vertex| free(vertex) && around(vertex).iter().all(|&v| free(v as usize)))
            .map(|vertex| vertex as u32)
            .collect();
        // One row of (I − A)² after the other.
        let mut row = vec![0.0; connectivity.vertex_count()];
        let mut touched: Vec<usize> = Vec::new();
        let of_noise = (inside.iter())
            .map(|&vertex| {
                let vertex = vertex as usize;
                let share = 1.0 / around(vertex).len() as f64;
                let firsts = around(vertex).iter().map(|&v| (v as usize, -share));
                for (first, weight) in firsts.chain([(vertex, 1.0)]) {
                    row[first] += weight;
                    touched.push(first);
                    let share = weight / around(first).len() as f64;
                    for second in around(first).iter().map(|&v| v as usize) {
                        row[second] -= share;
                        touched.push(second);
                    }
                }
                let mut sum = 0.0;
                for place in touched.drain(..) {
                    sum += row[place] * row[place];
                    row[place] = 0.0;
                }
                sum.sqrt()
            })
            .collect();
        Self { inside, of_noise }
    }

    /// Standard deviation of the noise of each coordinate of a pose, in coordinates.
    ///
    /// What a vertex has apart from its neighbours, and that apart from theirs, along the normal: (I − A)² x · n, A being
    /// the mean of neighbours. The first difference of a smooth surface is its curvature, the second the change of that, which is
    /// small; of noise both are large. Each is counted in what noise makes there, and the median keeps creases out. Noise that
    /// neighbours share is not seen.
    ///
    /// Source: Laplacian of the Laplacian as a measure of noise, Immerkær (1996), Computer Vision and Image Understanding 64(2), 300–302, there of pictures.
    pub fn of(&self, connectivity: &Connectivity, points: &[Point3]) -> f64 {
        let field: Vec<Vector3> = points.iter().map(|p| p.coords).collect();
        let differences = second_differences(connectivity, &field);
        let normals = steady_normals(connectivity, points);
        let sizes = (self.inside.iter().zip(&self.of_noise))
            .map(|(&v, of_noise)| {
                let along = differences[v as usize].dot(&normals[v as usize]);
                along.abs() / of_noise
            })
            .collect();
        NORMAL_FROM_MEDIAN * median(sizes)
    }

    /// ℓ and how to smooth over it: at least `least`, and where noise asks for more, so long as what is left of noise and what is
    /// lost of the shape become less together, up to `most`. Where areas are taken from smoothed surfaces, the poses come back smoothed.
    ///
    /// Both are told without knowing the shape: with K = 2 S − S² the mean of (n·(x − K x))² + 2 σ² tr K / V is, but for a
    /// constant, the expected square of the error. The trace is that of a plane whose vertices have an area a each: waves of up to k² = 4π/a
    /// keep (1 + 2u) / (1 + u)², u = ℓ²k², which over all of them is (2 ln(1 + U) − U / (1 + U)) / U with U = 4πℓ²/a.
    ///
    /// Source: unbiased estimate of risk, Stein (1981), Annals of Statistics 9(6), 1135–1151.
    pub fn plan(
        &self,
        connectivity: &Connectivity,
        poses: &[&[Point3]],
        noise: f64,
        [least, most]: [f64; 2],
    ) -> (Plan, Vec<Smoothed>) {
        let mut plan = Plan {
            noise,
            length: least,
            passes: 0,
        };
        let mut chosen = Vec::new();
        let mut risk = f64::INFINITY;
        let mut length = least;
        while length <= most && length > 0.0 {
            // What came out over one length is nearer to what comes out over the next than the poses are.
            let smoothed: Vec<Smoothed> = (poses.par_iter().enumerate())
                .map(|(pose, &points)| {
                    let shape = chosen.get(pose).map_or(points, |s: &Smoothed| &s.once);
                    smooth_from(connectivity, shape, points, length, PASSES)
                })
                .collect();
            let tried: Vec<[f64; 2]> = (poses.iter().zip(&smoothed))
                .map(|(points, smoothed)| self.risk(connectivity, points, smoothed, noise, length))
                .collect();
            let mean =
                |what: usize| tried.iter().map(|t| t[what]).sum::<f64>() / tried.len() as f64;
            if mean(0) >= risk {
                break;
            }
            risk = mean(0);
            chosen = smoothed;
            plan.length = length;
            plan.passes = if noise > ROUGH * mean(1) { PASSES } else { 0 };
            length *= RATIO;
        }
        if plan.passes == 0 {
            chosen.clear();
        }
        (plan, chosen)
    }

    /// Expected square of the error at a length, and the side of the square that a vertex has to itself.
    fn risk(
        &self,
        connectivity: &Connectivity,
        points: &[Point3],
        smoothed: &Smoothed,
        noise: f64,
        length: f64,
    ) -> [f64; 2] {
        let normals = vertex_normals(&smoothed.once, &connectivity.triangles);
        let mut areas = vec![0.0; points.len()];
        for triangle in &connectivity.triangles {
            let [a, b, c] = triangle.map(|v| smoothed.once[v as usize]);
            let third = (b - a).cross(&(c - a)).norm() / 6.0;
            triangle.iter().for_each(|&v| areas[v as usize] += third);
        }
        let (mut sum, mut area) = (0.0, 0.0);
        for vertex in self.inside.iter().map(|&v| v as usize) {
            let lost = (points[vertex] - smoothed.points[vertex]).dot(&normals[vertex]);
            let waves = 4.0 * PI * length * length / areas[vertex].max(f64::MIN_POSITIVE);
            let kept = (2.0 * waves.ln_1p() - waves / (1.0 + waves)) / waves;
            sum += lost * lost + 2.0 * noise * noise * kept;
            area += areas[vertex];
        }
        let count = self.inside.len().max(1) as f64;
        [sum / count, (area / count).sqrt()]
    }
}

/// (I − A)² x: what is apart from the mean of neighbours, twice over.
fn second_differences(connectivity: &Connectivity, field: &[Vector3]) -> Vec<Vector3> {
    let apart = |field: &[Vector3]| -> Vec<Vector3> {
        (0..field.len())
            .map(|vertex| field[vertex] - mean_around(connectivity, field, vertex))
            .collect()
    };
    apart(&apart(field))
}

fn mean_around(connectivity: &Connectivity, field: &[Vector3], vertex: usize) -> Vector3 {
    let others = &connectivity.rows.neighbours[connectivity.rows.of(vertex)];
    let sum: Vector3 = others.iter().map(|&other| field[other as usize]).sum();
    sum / others.len().max(1) as f64
}

/// Normals that noise turns less: averaged with their neighbours'.
fn steady_normals(connectivity: &Connectivity, points: &[Point3]) -> Vec<Vector3> {
    let mut normals = vertex_normals(points, &connectivity.triangles);
    for _ in 0..NORMAL_STEPS {
        normals = (0..normals.len())
            .map(|vertex| {
                let sum = normals[vertex] + mean_around(connectivity, &normals, vertex);
                sum.try_normalize(0.0).unwrap_or_default()
            })
            .collect();
    }
    normals
}

/// The lower median; 0 without values.
fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = (values.len() - 1) / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}
