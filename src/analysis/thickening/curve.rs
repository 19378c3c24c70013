//! How the wall thickens over the beat as a whole, and how much of that each atom does.

use crate::analysis::medial::{Atom, MedialBeat};
use crate::numeric::symmetric_eigen;

use super::diffusion::Diffusion;

/// The subject's own curve of ln r over the beat.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct ThickeningCurve {
    /// c(t): square sum 1, sum 0; greater at end-systole than at end-diastole.
    pub shape: Vec<f64>,
    /// c(ES) − c(ED).
    pub rise: f64,
}

/// ln r of each atom less its mean over the beat, one column of atoms per pose; 0 for atoms that do not
/// take part, which may have no sphere.
pub(super) fn centred_logs(beat: &MedialBeat) -> Vec<Vec<f64>> {
    let mut columns: Vec<Vec<f64>> = (beat.frames.iter())
        .map(|frame| {
            let log = |(regular, atom): (&bool, &Atom)| {
                if *regular { atom.radius.ln() } else { 0.0 }
            };
            beat.regular.iter().zip(&frame.atoms).map(log).collect()
        })
        .collect();
    for atom in 0..beat.regular.len() {
        let sum: f64 = columns.iter().map(|column| column[atom]).sum();
        let mean = sum / beat.frames.len() as f64;
        // The mean over the cycle is thickness itself, which says nothing of its change.
        columns.iter_mut().for_each(|column| column[atom] -= mean);
    }
    columns
}

impl ThickeningCurve {
    /// The curve c along which the area-weighted sum of squares Σᵢ Aᵢ (xᵢ · c)² is greatest, x being
    /// centred ln r averaged over neighbourhoods: the first principal component over time.
    ///
    /// Atoms that do not thicken have next to no weight in it, so that it is the curve of the remote
    /// myocardium however large the patch is. With two poses it is (−1, 1) / √2.
    pub fn new(columns: &[Vec<f64>], areas: &[f64], [ed, es]: [usize; 2]) -> Self {
        let poses = columns.len();
        let product = |s: usize, t: usize| -> f64 {
            (columns[s].iter().zip(&columns[t]).zip(areas))
                .map(|((x, y), area)| area * x * y)
                .sum()
        };
        let mut matrix = vec![0.0; poses * poses];
        for s in 0..poses {
            for t in s..poses {
                let value = product(s, t);
                matrix[s * poses + t] = value;
                matrix[t * poses + s] = value;
            }
        }
        // Without a component, as where nothing moves, the plain difference stands in.
        let mut shape = (symmetric_eigen(poses, &matrix).ok())
            .and_then(|eigen| eigen.vectors.into_iter().next())
            .unwrap_or_else(|| vec![0.0; poses]);
        // Columns are centred, so that the component sums to 0 but for rounding.
        let sum = shape.iter().sum::<f64>() / poses as f64;
        shape.iter_mut().for_each(|c| *c -= sum);
        let length = shape.iter().map(|c| c * c).sum::<f64>().sqrt();
        // Eigenvectors have length 1: so little is left only of a constant one.
        if length > 1e-9 {
            shape.iter_mut().for_each(|c| *c /= length);
        } else {
            shape.fill(0.0);
            shape[ed] = -0.5_f64.sqrt();
            shape[es] = 0.5_f64.sqrt();
        }
        // Eigenvectors have no sign; thickening is to be positive.
        if shape[es] < shape[ed] {
            shape.iter_mut().for_each(|c| *c = -*c);
        }
        Self {
            rise: shape[es] - shape[ed],
            shape,
        }
    }

    /// What a wall of this thickening adds to ln r from one pose to another.
    pub fn step(&self, thickening: f64, from: usize, to: usize) -> f64 {
        // All of the wall follows one curve: a step is its part of the way from ED to ES.
        thickening * (self.shape[to] - self.shape[from]) / self.rise.max(f64::EPSILON)
    }

    /// Thickening of each atom, ln PT from end-diastole to end-systole from all poses:
    /// (xᵢ · c) (c(ES) − c(ED)), which is ln(r(ES) / r(ED)) where there are two poses.
    pub fn thickening(&self, columns: &[Vec<f64>]) -> Vec<f64> {
        let mut sums = vec![0.0; columns.first().map_or(0, Vec::len)];
        for (column, c) in columns.iter().zip(&self.shape) {
            sums.iter_mut()
                .zip(column)
                .for_each(|(sum, x)| *sum += self.rise * c * x);
        }
        sums
    }
}

/// Each column averaged over neighbourhoods.
pub(super) fn averaged(columns: &[Vec<f64>], diffusion: &Diffusion) -> Vec<Vec<f64>> {
    let atoms = columns.first().map_or(0, Vec::len).max(1);
    let mut joined = columns.concat();
    diffusion.apply(&mut joined);
    joined.chunks_exact(atoms).map(<[f64]>::to_vec).collect()
}
