//! Implicit heat flow, twicing, and areas that settle.

use rayon::prelude::*;

use super::system::{CHUNK, System, sum_of};
use crate::analysis::medial::connectivity::Connectivity;
use crate::mesh::{Point3, Vector3, area};

/// A surface smoothed once, which is smoother but drawn in where it is curved, and with that mended.
#[derive(Clone, Debug)]
pub(in crate::analysis::medial) struct Smoothed {
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
pub(in crate::analysis::medial) fn smooth(
    connectivity: &Connectivity,
    points: &[Point3],
    length: f64,
    passes: usize,
) -> Smoothed {
    smooth_from(connectivity, points, points, length, passes)
}

/// The same with areas and angles from a shape that is nearer to the answer than the points are.
pub(in crate::analysis::medial) fn smooth_from(
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
    // The matrix depends on the shape: factor and field are kept apart so that both can come from different surfaces.
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
        // Noise enlarges areas, and smoothing takes that back: where the area no longer changes, M and L are those of
        // the shape.
        if (now - size).abs() <= SETTLED * size {
            break;
        }
        size = now;
        flow = Flow::new(connectivity, &once, length);
        once = as_points(flow.step(&start, once.iter().map(|p| p.coords).collect()));
    }
    let lost: Vec<Vector3> = points.iter().zip(&once).map(|(x, s)| x - s).collect();
    // Of what is lost the smooth part is kept whole, so that from here no smooth error is left. One that the shape has
    // left in `once` is lost as well, and comes back.
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
        // The rim first: the surface then takes it as given, and an open base does not shrink.
        self.rim.solve(field, &mut found);
        self.inside.solve(field, &mut found);
        found
    }
}
