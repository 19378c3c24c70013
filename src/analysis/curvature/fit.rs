//! A polynomial over the tangent plane through the surroundings of one vertex, and how it bends there.

use crate::mesh::{Point3, Vector3};

use super::Curvature;

/// Coefficients of a cubic in two variables.
const CUBIC: usize = 10;
/// Those of a quadric, which come first.
const QUADRIC: usize = 6;
/// Points per coefficient that a fit needs: with as many as coefficients it would pass through noise.
const POINTS_PER_COEFFICIENT: f64 = 1.2;
/// Least pivot, as a share of its diagonal element, at which the points still say all coefficients.
const MIN_PIVOT: f64 = 1e-9;
/// Square of the distance, as a share of that of the farthest point, at which a point's weight has fallen to 1/e. What the
/// polynomial lacks grows with the distance; of two rings, the outer one has some hundredth of the weight and only decides
/// what the inner one leaves open.
const REACH_SQUARED: f64 = 0.135;
/// Points that a cubic is fitted to if the surroundings have them.
pub(super) const ENOUGH_POINTS: usize = 15;

/// How the surface bends at the first of the points, whose others surround it; `None` where they are too few, or lie on a line.
///
/// A cubic, since the error of its second derivatives falls with the square of the edges' length; a quadric, whose error
/// falls with the length alone, where points are too few for it. It is fitted twice: first over the plane at right angles to
/// the given normal, which finds that of the surface, then over the plane of that one.
pub(super) fn fitted(
    points: impl Iterator<Item = Point3> + Clone,
    normal: Vector3,
) -> Option<Curvature> {
    let centre = points.clone().next()?;
    // In parts of the largest distance, so that powers of coordinates are comparable.
    let reach = points
        .clone()
        .map(|point| (point - centre).norm_squared())
        .fold(0.0, f64::max)
        .sqrt();
    if !(reach > 0.0 && reach.is_finite()) {
        return None;
    }
    let steps = points.map(|point| (point - centre) / reach);
    let plane = TangentPlane::of(normal)?;
    let tilted = polynomial(steps.clone().map(|step| plane.projected(step)))?;
    let plane = TangentPlane::of(plane.normal_of(tilted))?;
    let height = polynomial(steps.map(|step| plane.by_chord(step)))?;
    plane.bending(height, reach)
}

/// Slopes p and q and second derivatives r, s and t at the centre of the polynomial through places in a plane and heights over
/// them.
fn polynomial(points: impl Iterator<Item = [f64; 3]>) -> Option<[f64; 5]> {
    let mut matrix = [[0.0; CUBIC]; CUBIC];
    let mut right = [0.0; CUBIC];
    let mut count = 0_usize;
    for [x, y, height] in points {
        let powers = powers(x, y);
        let weight = (-(x * x + y * y) / REACH_SQUARED).exp();
        for row in 0..CUBIC {
            let weighted = weight * powers[row];
            for column in 0..=row {
                matrix[row][column] += weighted * powers[column];
            }
            right[row] += weighted * height;
        }
        count += 1;
    }
    let enough = |coefficients: usize| count as f64 >= POINTS_PER_COEFFICIENT * coefficients as f64;
    let cubic = || enough(CUBIC).then(|| solved::<CUBIC>(&matrix, &right))?;
    let quadric = || enough(QUADRIC).then(|| solved::<QUADRIC>(&matrix, &right))?;
    (cubic().map(|found| second_order(&found)))
        .or_else(|| quadric().map(|found| second_order(&found)))
}

/// An orthonormal frame: two directions in a plane and its normal.
struct TangentPlane {
    u: Vector3,
    v: Vector3,
    normal: Vector3,
}

impl TangentPlane {
    fn of(normal: Vector3) -> Option<Self> {
        // The axis least along the normal is never parallel to it.
        let axis = Vector3::ith(normal.iamin(), 1.0);
        let u = normal.cross(&axis).try_normalize(f64::EPSILON)?;
        let v = normal.cross(&u);
        Some(Self { u, v, normal })
    }

    /// Place in the plane, and height over it.
    fn projected(&self, step: Vector3) -> [f64; 3] {
        [step.dot(&self.u), step.dot(&self.v), step.dot(&self.normal)]
    }

    /// Place in the plane in the direction of a point, but as far away as the point itself, and its height. Over these places
    /// the height of a sphere is a quadric, n·d = |d|² / 2R, however far it reaches; over the projections it has terms of
    /// fourth order, which a cubic takes for more curvature.
    fn by_chord(&self, step: Vector3) -> [f64; 3] {
        let [x, y, height] = self.projected(step);
        let across = x.hypot(y);
        let longer = if across > 0.0 {
            step.norm() / across
        } else {
            0.0
        };
        [x * longer, y * longer, height]
    }

    /// Normal of a height over the plane.
    fn normal_of(&self, [p, q, ..]: [f64; 5]) -> Vector3 {
        (self.normal - self.u * p - self.v * q).normalize()
    }

    /// Principal curvatures and directions of a height over the plane, in parts of `reach`: eigenvalues of the second
    /// fundamental form in an orthonormal basis of the surface's own tangent plane.
    fn bending(&self, height: [f64; 5], reach: f64) -> Option<Curvature> {
        let [p, q, r, s, t] = height;
        let e = 1.0 + p * p;
        let w = (e + q * q).sqrt();
        let first = [1.0 / e.sqrt(), 0.0];
        let second = [-p * q / (e.sqrt() * w), e.sqrt() / w];
        // Minus: a height that falls away from the normal bends as a sphere does.
        let form =
            |[a, b]: [f64; 2], [c, d]: [f64; 2]| -(r * a * c + s * (a * d + b * c) + t * b * d) / w;
        let (xx, xy, yy) = (
            form(first, first),
            form(first, second),
            form(second, second),
        );
        let (mean, half) = (0.5 * (xx + yy), 0.5 * (xx - yy));
        let radius = half.hypot(xy);
        let (sine, cosine) = (0.5 * xy.atan2(half)).sin_cos();
        let lifted =
            |[a, b]: [f64; 2]| (self.u + self.normal * p) * a + (self.v + self.normal * q) * b;
        let curvature = Curvature {
            greatest: (mean + radius) / reach,
            least: (mean - radius) / reach,
            direction: (lifted(first) * cosine + lifted(second) * sine).try_normalize(0.0)?,
            normal: self.normal_of(height),
        };
        (curvature.greatest.is_finite() && curvature.least.is_finite()).then_some(curvature)
    }
}

fn powers(x: f64, y: f64) -> [f64; CUBIC] {
    let (xx, xy, yy) = (x * x, x * y, y * y);
    [1.0, x, y, xx, xy, yy, xx * x, xx * y, x * yy, y * yy]
}

/// Slopes and second derivatives at the centre.
fn second_order(coefficients: &[f64]) -> [f64; 5] {
    let [_, p, q, a, b, c] = [0, 1, 2, 3, 4, 5].map(|n| coefficients[n]);
    [p, q, 2.0 * a, b, 2.0 * c]
}

/// Solves the leading `N` normal equations by Cholesky; `None` where the points do not say all unknowns.
fn solved<const N: usize>(
    matrix: &[[f64; CUBIC]; CUBIC],
    right: &[f64; CUBIC],
) -> Option<[f64; N]> {
    let mut lower = [[0.0; N]; N];
    let mut solution = [0.0; N];
    for row in 0..N {
        for column in 0..=row {
            let mut rest = matrix[row][column];
            for (a, b) in lower[row].iter().zip(&lower[column]).take(column) {
                rest -= a * b;
            }
            if row > column {
                lower[row][column] = rest / lower[column][column];
            } else if rest > MIN_PIVOT * matrix[row][row] {
                lower[row][row] = rest.sqrt();
            } else {
                return None;
            }
        }
        let mut rest = right[row];
        for k in 0..row {
            rest -= lower[row][k] * solution[k];
        }
        solution[row] = rest / lower[row][row];
    }
    for row in (0..N).rev() {
        let mut rest = solution[row];
        for k in row + 1..N {
            rest -= lower[k][row] * solution[k];
        }
        solution[row] = rest / lower[row][row];
    }
    Some(solution)
}
