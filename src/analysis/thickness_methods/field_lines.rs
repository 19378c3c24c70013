//! Lengths of the field lines of the potential from each voxel to both sides of the wall.

use crate::progress::{Progress, Stopped};

use super::label_grid::{Link, WallGraph};

/// Sweeps in order of the potential. One suffices where the potential rises along every upwind link,
/// as nearly everywhere; the rest is for voxels at which central and one-sided differences disagree.
const MAX_SWEEPS: usize = 60;

/// Lengths that change by less than this share of the spacing have settled.
const SETTLED: f64 = 1e-9;

/// A gradient below this share of 1 over the voxels of the wall has no direction: rounding of the
/// potential, which ends near 1e-9.
const NO_GRADIENT: f64 = 1e-7;

/// Which side the lengths run to.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Towards {
    Inner,
    Outer,
}

/// Length of the field line through each voxel from the inner side to the outer one: L₀ + L₁; not a
/// number where it reaches no side.
///
/// With T = ∇u / |∇u|, ∇L₀ · T = 1 and L₀ = 0 at the inner side, −∇L₁ · T = 1 and L₁ = 0 at the outer one.
/// Upwind differences: L = (1 + Σ wₐ Lₐ) / Σ wₐ, where a runs over the axes, wₐ = |Tₐ| / hₐ, and Lₐ
/// is that of the neighbour against (for L₁ along) T. Voxels are visited in order of the potential, so
/// that a neighbour is known before it is needed.
///
/// Source: Yezzi and Prince (2003), IEEE Trans Med Imaging 22(10), 1332–1339, eqs. 8–11.
pub(super) fn line_lengths(
    graph: &WallGraph,
    potential: &[f64],
    progress: &Progress,
) -> Result<Vec<f64>, Stopped> {
    let tangents: Vec<[f64; 3]> = (0..potential.len())
        .map(|node| tangent(graph, potential, node))
        .collect();
    progress.check()?;
    // Along the potential, so that one sweep carries a length across the whole wall.
    let mut order: Vec<u32> = (0..potential.len() as u32).collect();
    order.sort_by(|&a, &b| potential[a as usize].total_cmp(&potential[b as usize]));
    let (inner, outer) = rayon::join(
        || {
            let up = order.iter().copied();
            lengths(graph, &tangents, &up, Towards::Inner, progress)
        },
        || {
            let down = order.iter().rev().copied();
            lengths(graph, &tangents, &down, Towards::Outer, progress)
        },
    );
    Ok((inner?.iter().zip(outer?)).map(|(a, b)| a + b).collect())
}

/// Unit gradient by central differences, one-sided at ends; zero where it has no direction.
fn tangent(graph: &WallGraph, potential: &[f64], node: usize) -> [f64; 3] {
    let here = potential[node];
    let gradient: [f64; 3] = std::array::from_fn(|axis| {
        let h = graph.spacing[axis];
        let side = |link: Link| match link {
            Link::Wall(next) => (potential[next as usize], h),
            Link::Inner(border) => (0.0, border.share * h),
            Link::Outer(border) => (1.0, border.share * h),
            // Nothing flows through the end of the wall: the difference there is zero.
            Link::End => (here, 0.0),
        };
        let [low, high] = [0, 1].map(|k| side(graph.links[node][2 * axis + k]));
        let width = low.1 + high.1;
        if width > 0.0 {
            (high.0 - low.0) / width
        } else {
            0.0
        }
    });
    let norm = gradient.iter().map(|g| g * g).sum::<f64>().sqrt();
    let spacing = graph.spacing.iter().copied().fold(f64::INFINITY, f64::min);
    // Relative to the spacing: a direction of round-off would send the line anywhere.
    if norm * spacing < NO_GRADIENT {
        return [0.0; 3];
    }
    gradient.map(|g| g / norm)
}

fn lengths(
    graph: &WallGraph,
    tangents: &[[f64; 3]],
    order: &(impl Iterator<Item = u32> + Clone),
    towards: Towards,
    progress: &Progress,
) -> Result<Vec<f64>, Stopped> {
    let settled = SETTLED * graph.spacing.iter().copied().fold(f64::INFINITY, f64::min);
    let mut lengths = vec![f64::NAN; tangents.len()];
    for _ in 0..MAX_SWEEPS {
        let mut largest = 0.0_f64;
        for (visit, node) in order.clone().enumerate() {
            // A check takes longer than a voxel.
            if visit % 65_536 == 0 {
                progress.check()?;
            }
            let node = node as usize;
            let found = length(graph, &lengths, tangents[node], node, towards);
            let change = (found - lengths[node]).abs();
            // A first value is a change, too.
            if found.is_finite() && (change.is_nan() || change > settled) {
                largest = f64::INFINITY;
            }
            lengths[node] = found;
        }
        if largest == 0.0 {
            break;
        }
    }
    Ok(lengths)
}

/// Length at a node from its upwind neighbours; those not yet known do not count.
fn length(
    graph: &WallGraph,
    lengths: &[f64],
    tangent: [f64; 3],
    node: usize,
    towards: Towards,
) -> f64 {
    let (mut above, mut below) = (1.0, 0.0);
    for (axis, along) in tangent.into_iter().enumerate() {
        // Upwind: a length is built from where its line comes from, or the sweep would not settle.
        let up = (along > 0.0) == (towards == Towards::Outer);
        let mut weight = along.abs() / graph.spacing[axis];
        let next = match graph.links[node][2 * axis + usize::from(up)] {
            Link::Wall(next) => lengths[next as usize],
            Link::Inner(border) if towards == Towards::Inner => {
                weight /= border.share;
                border.beyond
            }
            Link::Outer(border) if towards == Towards::Outer => {
                weight /= border.share;
                border.beyond
            }
            _ => continue,
        };
        if next.is_finite() {
            above += weight * next;
            below += weight;
        }
    }
    if below > 0.0 { above / below } else { f64::NAN }
}
