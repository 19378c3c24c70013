//! How rough surfaces are, estimated from themselves.

use super::connectivity::Connectivity;
use crate::mesh::{Point3, Vector3, vertex_normals};
use crate::numeric::lower_median;

/// Times that normals are averaged with those of their neighbours.
const NORMAL_STEPS: usize = 2;

/// 1 / Φ⁻¹(¾): standard deviation of a normal distribution over its median absolute value.
const NORMAL_FROM_MEDIAN: f64 = 1.482_602_218_505_602;

/// Tells the noise of surfaces on the same faces.
#[derive(Clone, Debug)]
pub(super) struct Roughness {
    /// Vertices that have no boundary within two edges.
    pub inside: Vec<u32>,
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
        // The median, since creases and rims are large second differences without noise.
        NORMAL_FROM_MEDIAN * lower_median(sizes)
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
pub(super) fn steady_normals(connectivity: &Connectivity, points: &[Point3]) -> Vec<Vector3> {
    let mut normals = vertex_normals(points, &connectivity.triangles);
    // Noise turns normals more than it moves vertices; neighbours average it out.
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
