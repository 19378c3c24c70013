//! The potential between the sides of the wall: Laplace's equation on the voxels of the wall.

use rayon::prelude::*;

use crate::progress::{Progress, Stopped};

use super::label_grid::{Link, WallGraph};

/// The residual's norm falls to this share of the right side's: the potential is then right to some
/// 1e-9, below what its gradient needs and what peers are compared to.
const RESIDUAL: f64 = 1e-10;

/// More steps than any wall needs: they grow with the voxels across it, some 8 for each.
const MAX_STEPS: usize = 4_000;

/// Nodes of a piece of work. Sums are formed piece by piece in order, whatever the threads.
const PIECE: usize = 4_096;

/// Solves Δu = 0 in the wall with u = 0 at the inner and 1 at the outer side, and no flux through its ends.
///
/// Seven-point Laplacian: Σ (uₙ − u) / h² over the neighbours n, where a side that a link crosses after
/// the share θ of its length counts with (value − u) / (θ h²), which keeps the matrix symmetric.
/// Conjugate gradients, preconditioned by the diagonal.
///
/// Source of the border: Gibou, Fedkiw, Cheng and Kang (2002), J Comput Phys 176, 205–227.
pub(super) fn potential(graph: &WallGraph, progress: &Progress) -> Result<Vec<f64>, Stopped> {
    let system = System::new(graph);
    let count = graph.links.len();
    // Half-way between both sides is the best guess without knowing where a voxel lies.
    let mut u = vec![0.5; count];
    let mut ap = vec![0.0; count];
    system.apply(&u, &mut ap);
    let mut r: Vec<f64> = system.right.iter().zip(&ap).map(|(b, a)| b - a).collect();
    let mut z = vec![0.0; count];
    system.precondition(&r, &mut z);
    let mut p = z.clone();
    let mut rz = dot(&r, &z);
    // Squared, so that no root is taken in the loop.
    let goal = RESIDUAL * RESIDUAL * dot(&system.right, &system.right).max(f64::MIN_POSITIVE);
    for _ in 0..MAX_STEPS {
        progress.check()?;
        if dot(&r, &r) <= goal {
            break;
        }
        system.apply(&p, &mut ap);
        let curvature = dot(&p, &ap);
        // Round-off has taken over: the matrix itself is positive.
        if curvature <= 0.0 {
            break;
        }
        let step = rz / curvature;
        advance(&mut u, step, &p);
        advance(&mut r, -step, &ap);
        system.precondition(&r, &mut z);
        let next = dot(&r, &z);
        let share = next / rz;
        rz = next;
        p.par_chunks_mut(PIECE)
            .zip(z.par_chunks(PIECE))
            .for_each(|(p, z)| {
                for (p, z) in p.iter_mut().zip(z) {
                    *p = z + share * *p;
                }
            });
    }
    Ok(u)
}

/// Rows of the matrix, sorted for reading in one sweep.
struct System {
    diagonal: Vec<f64>,
    right: Vec<f64>,
    /// Neighbours, the node itself where there is none.
    neighbours: Vec<[u32; 6]>,
    /// Weight of each axis, 1/h².
    weights: [f64; 3],
    /// How many of a node's neighbours along each axis are itself.
    missing: Vec<[f64; 3]>,
}

impl System {
    fn new(graph: &WallGraph) -> Self {
        let weights = graph.spacing.map(|h| 1.0 / (h * h));
        let mut system = Self {
            diagonal: Vec::with_capacity(graph.links.len()),
            right: Vec::with_capacity(graph.links.len()),
            neighbours: Vec::with_capacity(graph.links.len()),
            weights,
            missing: Vec::with_capacity(graph.links.len()),
        };
        for (node, links) in graph.links.iter().enumerate() {
            let (mut diagonal, mut right, mut missing) = (0.0, 0.0, [0.0; 3]);
            // A missing neighbour is the voxel itself, whose part `missing` takes out again: no branch in the loop.
            let mut neighbours = [node as u32; 6];
            for (direction, link) in links.iter().enumerate() {
                let weight = weights[direction / 2];
                match *link {
                    Link::Wall(next) => {
                        neighbours[direction] = next;
                        diagonal += weight;
                        continue;
                    }
                    Link::Inner(border) => diagonal += weight / border.share,
                    Link::Outer(border) => {
                        diagonal += weight / border.share;
                        right += weight / border.share;
                    }
                    Link::End => {}
                }
                missing[direction / 2] += 1.0;
            }
            // A voxel alone with ends has no equation; 1 keeps it where it starts.
            system
                .diagonal
                .push(if diagonal > 0.0 { diagonal } else { 1.0 });
            system.right.push(if diagonal > 0.0 { right } else { 0.5 });
            system.neighbours.push(neighbours);
            system.missing.push(missing);
        }
        system
    }

    fn apply(&self, x: &[f64], out: &mut [f64]) {
        let [wx, wy, wz] = self.weights;
        out.par_chunks_mut(PIECE)
            .enumerate()
            .for_each(|(piece, out)| {
                for (node, out) in (piece * PIECE..).zip(out) {
                    let [a, b, c, d, e, f] = self.neighbours[node].map(|n| x[n as usize]);
                    let [mx, my, mz] = self.missing[node];
                    let here = x[node];
                    *out = self.diagonal[node] * here
                        - wx * (a + b - mx * here)
                        - wy * (c + d - my * here)
                        - wz * (e + f - mz * here);
                }
            });
    }

    fn precondition(&self, r: &[f64], z: &mut [f64]) {
        z.par_chunks_mut(PIECE)
            .enumerate()
            .for_each(|(piece, out)| {
                for (node, out) in (piece * PIECE..).zip(out) {
                    *out = r[node] / self.diagonal[node];
                }
            });
    }
}

/// Inner product, summed piece by piece in order.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    // Pieces of fixed size, summed in order: the same bits for any number of threads.
    let pieces: Vec<f64> = (a.par_chunks(PIECE))
        .zip(b.par_chunks(PIECE))
        .map(|(a, b)| a.iter().zip(b).map(|(a, b)| a * b).sum())
        .collect();
    pieces.iter().sum()
}

/// x + step · d in place of x.
fn advance(x: &mut [f64], step: f64, d: &[f64]) {
    x.par_chunks_mut(PIECE)
        .zip(d.par_chunks(PIECE))
        .for_each(|(x, d)| {
            for (x, d) in x.iter_mut().zip(d) {
                *x += step * d;
            }
        });
}
