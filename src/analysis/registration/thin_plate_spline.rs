//! The smoothest map that brings landmarks onto landmarks.

use nalgebra::{DMatrix, Matrix3, SymmetricEigen, Vector3};
use rayon::prelude::*;

use crate::mesh::{Point3, mean_point};

/// Landmarks of one spline: its dense system is solved in the cube of their number, less than a second.
const MAX_LANDMARKS: usize = 1_024;

/// Least ratio of the extents (root mean squares) of landmarks along their principal axes: below it the affine part across
/// their plane rests on the rounding of coordinates.
const MIN_FLATNESS: f64 = 1e-6;

/// Distance of landmarks, as a share of the greatest from their mean, at which they are one place.
const ONE_PLACE: f64 = 1e-9;

/// How far landmarks may miss, as a share of the greatest distance of targets from their mean, before the system counts as
/// not solvable; and what rounding adds, as a share of the greatest coordinate.
const MAX_MISS: f64 = 1e-6;
const ROUNDING: f64 = 1e-10;

/// Points that are moved side by side: the arithmetic of each stays the same.
const LANES: usize = 32;

/// Points of one piece of parallel work.
const CHUNK: usize = 1_024;

/// f(x) = a + A x + Σᵢ wᵢ |x − xᵢ|: brings landmarks xᵢ onto their targets with the least bending, and leaves affine maps
/// as they are. In three dimensions the kernel of the thin plate is r, not r² log r.
#[derive(Clone, Debug, PartialEq)]
pub struct ThinPlateSpline {
    landmarks: Vec<Point3>,
    weights: Vec<Vector3<f64>>,
    /// a, in the unit of the targets.
    translation: Vector3<f64>,
    /// A.
    linear: Matrix3<f64>,
}

/// Why there is no spline.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ThinPlateSplineError {
    /// Landmarks must correspond one to one.
    #[error("{source_count} landmarks cannot correspond with {target_count}")]
    CountMismatch {
        /// Landmarks to move.
        source_count: usize,
        /// Landmarks to move them onto.
        target_count: usize,
    },
    /// An affine map needs four landmarks.
    #[error("{count} landmarks are too few: at least 4 are needed, not all in one plane")]
    TooFew {
        /// How many there are.
        count: usize,
    },
    /// More landmarks than a dense system may have.
    #[error("{count} landmarks are too many: the limit is {MAX_LANDMARKS}")]
    TooMany {
        /// How many there are.
        count: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("landmark {} has a coordinate that is not a finite number", .index + 1)]
    NotFinite {
        /// The first such landmark.
        index: usize,
    },
    /// Smoothing is negative or no finite number.
    #[error("smoothing must be a finite number of at least 0, but is {0}")]
    Smoothing(f64),
    /// All landmarks lie in one plane, on a line or in one place.
    #[error("the landmarks lie in one plane: they do not say how space is mapped across it")]
    Coplanar,
    /// Two landmarks lie in one place and without smoothing cannot both be brought onto their targets.
    #[error("landmarks {} and {} lie in one place", .first + 1, .second + 1)]
    Coincident {
        /// The first.
        first: usize,
        /// The other.
        second: usize,
    },
    /// Landmarks are so close to each other or to one plane that rounding decides about the map.
    #[error("the landmarks are too close to each other: landmark {} misses its target", .index + 1)]
    IllConditioned {
        /// The landmark that misses the most.
        index: usize,
    },
}

impl ThinPlateSpline {
    /// The spline that brings `source` onto `target`.
    ///
    /// With smoothing λ = 0 landmarks are met exactly; with λ > 0, in the unit of the coordinates, the sum
    /// Σᵢ ‖f(xᵢ) − yᵢ‖² + λ · bending energy is least, and landmarks are approached. Solves
    /// (K − λ I) W + P B = Y, Pᵀ W = 0, with Kᵢⱼ = |xᵢ − xⱼ| and rows (1, xᵢ) of P.
    ///
    /// Source: Duchon (1977), LNM 571, 85–100; Wahba (1990), Spline Models for Observational Data, section 2.4.
    ///
    /// # Errors
    /// If counts differ, there are fewer than 4 landmarks or more than 1,024, a number is not finite, all landmarks lie in
    /// one plane, or two of them in one place and nothing is smoothed.
    pub fn new(
        source: &[Point3],
        target: &[Point3],
        smoothing: f64,
    ) -> Result<Self, ThinPlateSplineError> {
        let extent = checked_extent(source, target, smoothing)?;
        let (count, centre) = (source.len(), mean_point(source.iter().copied()));
        // In units of their extent around their mean, so that distances, ones and coordinates are of one size.
        let places: Vec<Vector3<f64>> = source.iter().map(|p| (p - centre) / extent).collect();
        let size = count + 4;
        let mut system = DMatrix::zeros(size, size);
        for (row, p) in places.iter().enumerate() {
            for (column, q) in places.iter().enumerate() {
                system[(row, column)] = (p - q).norm();
            }
            system[(row, row)] = -smoothing / extent;
            for (axis, value) in [1.0, p.x, p.y, p.z].into_iter().enumerate() {
                system[(row, count + axis)] = value;
                system[(count + axis, row)] = value;
            }
        }
        let onto = mean_point(target.iter().copied());
        let mut values = DMatrix::zeros(size, 3);
        for (row, y) in target.iter().enumerate() {
            values.row_mut(row).copy_from(&(y - onto).transpose());
        }
        // Not finite where the system is singular, which the check of what landmarks miss then finds.
        let solution =
            (system.lu().solve(&values)).unwrap_or_else(|| DMatrix::repeat(size, 3, f64::NAN));
        let row = |at: usize| Vector3::new(solution[(at, 0)], solution[(at, 1)], solution[(at, 2)]);
        let linear = Matrix3::from_columns(&[1, 2, 3].map(|axis| row(count + axis) / extent));
        let made = Self {
            landmarks: source.to_vec(),
            weights: (0..count).map(|at| row(at) / extent).collect(),
            translation: onto.coords + row(count) - linear * centre.coords,
            linear,
        };
        made.met(target, smoothing)
    }

    /// The point that a point is mapped to.
    pub fn apply(&self, point: &Point3) -> Point3 {
        let bend: Vector3<f64> = (self.landmarks.iter().zip(&self.weights))
            .map(|(landmark, weight)| weight * (point - landmark).norm())
            .sum();
        Point3::from(self.translation + self.linear * point.coords + bend)
    }

    /// The points that points are mapped to, many at once.
    pub fn apply_all(&self, points: &[Point3]) -> Vec<Point3> {
        let mut mapped = vec![Point3::origin(); points.len()];
        (mapped.par_chunks_mut(CHUNK).zip(points.par_chunks(CHUNK))).for_each(|(to, from)| {
            for (to, from) in to.chunks_mut(LANES).zip(from.chunks(LANES)) {
                self.apply_lanes(from, to);
            }
        });
        mapped
    }

    /// The derivative at a point: column j is how the image moves when coordinate j of the point does. At a landmark, where
    /// it jumps, the mean of both sides.
    pub fn derivative(&self, point: &Point3) -> Matrix3<f64> {
        let bend: Matrix3<f64> = (self.landmarks.iter().zip(&self.weights))
            .map(|(landmark, weight)| {
                let away = point - landmark;
                // Zero where there is no direction.
                weight * away.try_normalize(0.0).unwrap_or_default().transpose()
            })
            .sum();
        self.linear + bend
    }

    /// How many of the points lie where the map folds space over: its derivative has no positive determinant.
    pub fn foldovers(&self, points: &[Point3]) -> usize {
        let folds = |point: &&Point3| self.derivative(point).determinant() <= 0.0;
        points.par_iter().filter(folds).count()
    }

    /// What is bent: −Σᵢⱼ wᵢ · wⱼ |xᵢ − xⱼ|, zero for an affine map.
    pub fn bending_energy(&self) -> f64 {
        let all = || self.landmarks.iter().zip(&self.weights);
        let pairs = all().flat_map(|one| all().map(move |other| (one, other)));
        -pairs
            .map(|((p, v), (q, w))| v.dot(w) * (p - q).norm())
            .sum::<f64>()
    }

    /// a of the affine part a + A x.
    pub fn translation(&self) -> Vector3<f64> {
        self.translation
    }

    /// A of the affine part a + A x.
    pub fn linear(&self) -> Matrix3<f64> {
        self.linear
    }

    /// wᵢ, one per landmark.
    pub fn weights(&self) -> &[Vector3<f64>] {
        &self.weights
    }

    /// As [`apply`](Self::apply), for up to [`LANES`] points.
    fn apply_lanes(&self, from: &[Point3], to: &mut [Point3]) {
        let [mut xs, mut ys, mut zs] = [[0.0; LANES]; 3];
        for (lane, point) in from.iter().enumerate() {
            [xs[lane], ys[lane], zs[lane]] = [point.x, point.y, point.z];
        }
        let [mut us, mut vs, mut ws] = [[0.0; LANES]; 3];
        for (landmark, weight) in self.landmarks.iter().zip(&self.weights) {
            // One loop over plain arrays, which the compiler turns into arithmetic side by side.
            for lane in 0..LANES {
                let (x, y, z) = (
                    xs[lane] - landmark.x,
                    ys[lane] - landmark.y,
                    zs[lane] - landmark.z,
                );
                let away = (x * x + y * y + z * z).sqrt();
                us[lane] += weight.x * away;
                vs[lane] += weight.y * away;
                ws[lane] += weight.z * away;
            }
        }
        for (lane, (to, point)) in to.iter_mut().zip(from).enumerate() {
            let bent = Vector3::new(us[lane], vs[lane], ws[lane]);
            *to = Point3::from(self.translation + self.linear * point.coords + bent);
        }
    }

    /// The spline if it does at its landmarks what its system says.
    fn met(self, target: &[Point3], smoothing: f64) -> Result<Self, ThinPlateSplineError> {
        let onto = mean_point(target.iter().copied());
        let size = target.iter().fold(0.0_f64, |m, y| m.max((y - onto).norm()));
        let all = target.iter().chain(&self.landmarks);
        let greatest = all.fold(0.0_f64, |m, p| m.max(p.coords.amax()));
        let allowed = MAX_MISS * size + ROUNDING * greatest;
        // A number that is not finite is no miss that is small.
        let miss = |index: usize| {
            let expected = target[index] + smoothing * self.weights[index];
            let away = (self.apply(&self.landmarks[index]) - expected).norm();
            if away.is_finite() {
                away
            } else {
                f64::INFINITY
            }
        };
        let worst = (0..target.len()).map(|index| (miss(index), index));
        match worst.max_by(|a, b| a.0.total_cmp(&b.0)) {
            Some((miss, index)) if miss > allowed => {
                Err(ThinPlateSplineError::IllConditioned { index })
            }
            _ => Ok(self),
        }
    }
}

/// The greatest distance of source landmarks from their mean, if a spline can be made of landmarks.
fn checked_extent(
    source: &[Point3],
    target: &[Point3],
    smoothing: f64,
) -> Result<f64, ThinPlateSplineError> {
    use ThinPlateSplineError as Error;
    let count = source.len();
    if count != target.len() {
        return Err(Error::CountMismatch {
            source_count: count,
            target_count: target.len(),
        });
    }
    if count < 4 {
        return Err(Error::TooFew { count });
    }
    if count > MAX_LANDMARKS {
        return Err(Error::TooMany { count });
    }
    // Squares of greater numbers overflow.
    let is_usable = |p: &Point3| p.iter().all(|x| x.abs() < 1e100);
    let pairs = source.iter().zip(target);
    let usable = |(p, q): (&Point3, &Point3)| is_usable(p) && is_usable(q);
    if let Some(index) = pairs.map(usable).position(|usable| !usable) {
        return Err(Error::NotFinite { index });
    }
    if !(smoothing.is_finite() && smoothing >= 0.0) {
        return Err(Error::Smoothing(smoothing));
    }
    let centre = mean_point(source.iter().copied());
    let extent = source
        .iter()
        .fold(0.0_f64, |m, p| m.max((p - centre).norm()));
    // Points that differ by rounding of their mean only are one place.
    if extent <= 4.0 * f64::EPSILON * centre.coords.norm() {
        return Err(Error::Coplanar);
    }
    let scatter: Matrix3<f64> = (source.iter().map(|p| (p - centre) / extent))
        .map(|away| away * away.transpose())
        .sum();
    let spread = SymmetricEigen::new(scatter).eigenvalues;
    if spread.min().max(0.0).sqrt() <= MIN_FLATNESS * spread.max().sqrt() {
        return Err(Error::Coplanar);
    }
    if smoothing == 0.0 {
        for second in 1..count {
            let is_there = |p: &Point3| (p - source[second]).norm() <= ONE_PLACE * extent;
            if let Some(first) = source[..second].iter().position(is_there) {
                return Err(Error::Coincident { first, second });
            }
        }
    }
    Ok(extent)
}
