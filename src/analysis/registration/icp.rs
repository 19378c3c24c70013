//! Rigid motion onto a surface whose points are not known to correspond: iterated closest points.

use rayon::prelude::*;

use crate::analysis::alignment::{AlignmentError, RigidMotion, rigid_motion};
use crate::mesh::{ClosestPoint, Point3, mean_point};
use crate::progress::{Progress, Stopped};

/// Settings of [`icp`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IcpParams {
    /// Rounds after which the motion is taken as it is.
    pub max_iterations: usize,
    /// Root mean square of what points move in one round below which the motion has settled, as a share of their root mean
    /// square distance from their mean.
    pub tolerance: f64,
    /// Share of the points that count, those closest to the surface; the others have no counterpart or a wrong one.
    pub kept_share: f64,
}

impl Default for IcpParams {
    /// 200 rounds, a millionth, all points.
    fn default() -> Self {
        Self {
            max_iterations: 200,
            tolerance: 1e-6,
            kept_share: 1.0,
        }
    }
}

/// Settings that can be used.
#[derive(Clone, Copy, Debug)]
pub struct CheckedIcpParams(IcpParams);

/// Why there is no motion.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum IcpError {
    /// A setting is out of range.
    #[error("{name} must lie in {range}, but is {value}")]
    Setting {
        /// Which.
        name: &'static str,
        /// Where it must lie.
        range: &'static str,
        /// What it is.
        value: f64,
    },
    /// A coordinate is NaN or infinite.
    #[error("point {} has a coordinate that is not a finite number", .index + 1)]
    NotFinite {
        /// The first such point.
        index: usize,
    },
    /// There is nothing to align.
    #[error(transparent)]
    Alignment(#[from] AlignmentError),
    /// Stopped.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

impl IcpParams {
    /// Checks the settings.
    ///
    /// # Errors
    /// At the first that is out of range.
    pub fn check(self) -> Result<CheckedIcpParams, IcpError> {
        let setting = |name, range, value| Err(IcpError::Setting { name, range, value });
        if !(1..=100_000).contains(&self.max_iterations) {
            return setting(
                "the number of rounds",
                "1 to 100,000",
                self.max_iterations as f64,
            );
        }
        if !(0.0..1.0).contains(&self.tolerance) {
            return setting("the tolerance", "0 to 1 (exclusive)", self.tolerance);
        }
        if !(self.kept_share > 0.0 && self.kept_share <= 1.0) {
            return setting(
                "the share of points that count",
                "0 (exclusive) to 1",
                self.kept_share,
            );
        }
        Ok(CheckedIcpParams(self))
    }
}

/// What iterated closest points found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Icp {
    /// From the moving points onto the surface.
    pub motion: RigidMotion,
    /// Root mean square distance of the points that count, after the motion.
    pub rms: f64,
    /// How many points count.
    pub kept: usize,
    /// Rounds.
    pub iterations: usize,
    /// Whether the motion settled.
    pub converged: bool,
}

/// A cloud of points as what [`icp`] moves onto: the closest point is one of them. `None` without any.
pub fn point_target(points: &[Point3]) -> Option<ClosestPoint> {
    let all: Vec<[u32; 3]> = (0..points.len() as u32).map(|v| [v; 3]).collect();
    ClosestPoint::new(points, &all)
}

/// The rigid motion that lays points onto a surface, searched from `start` on.
///
/// In turns takes the closest point of the surface for each moved point, keeps the pairs that are closest (trimming), and
/// finds the rigid motion of those in closed form. The sum of the squares that are kept never rises; which minimum is found
/// depends on the start.
///
/// Source: Besl and McKay (1992), IEEE TPAMI 14(2), 239–256; trimming: Chetverikov et al. (2002), ICPR 3, 545–548.
///
/// # Errors
/// If there are no points, one of them or of the start is not finite, or it is stopped; that is heard once a round.
pub fn icp(
    moving: &[Point3],
    target: &ClosestPoint,
    start: &RigidMotion,
    params: &CheckedIcpParams,
    progress: &Progress,
) -> Result<Icp, IcpError> {
    let params = params.0;
    if moving.is_empty() {
        return Err(AlignmentError::NoPoints.into());
    }
    let is_finite = |point: &Point3| start.apply(point).iter().all(|x| x.is_finite());
    if let Some(index) = moving.iter().position(|point| !is_finite(point)) {
        return Err(IcpError::NotFinite { index });
    }
    let kept = (params.kept_share * moving.len() as f64).ceil() as usize;
    let kept = kept.clamp(1, moving.len());
    let mean = mean_point(moving.iter().copied());
    let settled =
        params.tolerance * root_mean_square(moving.iter().map(|p| (p - mean).norm_squared()));
    let mut found = Icp {
        motion: *start,
        rms: f64::INFINITY,
        kept,
        iterations: 0,
        converged: false,
    };
    let mut pairs = closest_pairs(moving, target, start, kept);
    progress.expect_steps(params.max_iterations);
    while found.iterations < params.max_iterations && !found.converged {
        progress.step()?;
        let (from, onto): (Vec<Point3>, Vec<Point3>) = pairs
            .iter()
            .map(|pair| (moving[pair.index], pair.closest))
            .unzip();
        let next = rigid_motion(&from, &onto)?;
        let moves = (moving.iter()).map(|p| (next.apply(p) - found.motion.apply(p)).norm_squared());
        found.converged = root_mean_square(moves) <= settled;
        found.motion = next;
        found.iterations += 1;
        pairs = closest_pairs(moving, target, &next, kept);
    }
    found.rms = root_mean_square(pairs.iter().map(|pair| pair.away2));
    Ok(found)
}

/// A moving point with the point of the surface that is closest to where it is moved.
struct Pair {
    index: usize,
    closest: Point3,
    /// Square of their distance.
    away2: f64,
}

/// The `kept` closest pairs; of equally close ones, those that come first. In the order of the points.
fn closest_pairs(
    moving: &[Point3],
    target: &ClosestPoint,
    motion: &RigidMotion,
    kept: usize,
) -> Vec<Pair> {
    let mut pairs: Vec<Pair> = (moving.par_iter().enumerate())
        .map(|(index, point)| {
            let moved = motion.apply(point);
            let closest = target.closest(moved);
            Pair {
                index,
                closest,
                away2: (closest - moved).norm_squared(),
            }
        })
        .collect();
    if kept < pairs.len() {
        let order = |a: &Pair, b: &Pair| a.away2.total_cmp(&b.away2).then(a.index.cmp(&b.index));
        pairs.select_nth_unstable_by(kept, order);
        pairs.truncate(kept);
        // So that sums do not depend on how the closest were chosen.
        pairs.sort_unstable_by_key(|pair| pair.index);
    }
    pairs
}

fn root_mean_square(squares: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = squares.len().max(1) as f64;
    (squares.sum::<f64>() / count).sqrt()
}
