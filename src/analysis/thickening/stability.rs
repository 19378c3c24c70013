//! Detection stability of a patch: how often it is detected again when the noise is drawn anew.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::progress::{Progress, Stopped};

use super::akinetic_regions::{REMOTE_QUANTILE, akinetic_regions, area_quantile};
use super::averaged_thickening::AveragedThickening;
use super::diffusion::RegularMesh;
use super::params::CheckedThickeningParams;
use super::surface::Surface;

/// Share of a patch's area that must lie in patches of a redraw, for it to be detected again: a patch that moves at its outline is
/// the same patch, and one that shares less with another than with what is around it is not.
const SAME_PATCH_SHARE: f64 = 0.5;

/// Share of redraws in which each part is detected again.
///
/// A redraw adds noise of the same standard deviation and extent over the surface as that of averaged
/// thickening: independent numbers per atom, averaged alike and scaled.
pub(super) fn stabilities(
    estimate: &AveragedThickening,
    surface: &Surface,
    parts: &[Vec<u32>],
    params: &CheckedThickeningParams,
    progress: &Progress,
) -> Result<Vec<f64>, Stopped> {
    let mesh = &surface.mesh;
    // Without noise every redraw is the estimate itself.
    if params.redraws == 0 || parts.is_empty() || estimate.noise == 0.0 {
        return Ok(vec![1.0; parts.len()]);
    }
    let mut found = vec![0_u32; parts.len()];
    for redraw in 0..params.redraws {
        progress.check()?;
        let mut random = ChaCha8Rng::seed_from_u64(params.seed);
        // A stream for each, so that more redraws leave the first ones as they are.
        random.set_stream(u64::from(redraw));
        let drawn = redrawn(estimate, mesh, &mut random);
        // The reference is redrawn as well: it is estimated from the same noisy values.
        let remote = area_quantile(&drawn, &mesh.areas, REMOTE_QUANTILE);
        // Redraws may split or join regions, so that atoms are compared and not regions.
        let mut again = vec![false; drawn.len()];
        for part in akinetic_regions(&drawn, remote, surface, estimate.min_share, params) {
            part.iter().for_each(|&atom| again[atom as usize] = true);
        }
        for (found, part) in found.iter_mut().zip(parts) {
            let area = |keep: &dyn Fn(usize) -> bool| -> f64 {
                (part.iter().map(|&atom| atom as usize))
                    .filter(|&atom| keep(atom))
                    .map(|atom| mesh.areas[atom])
                    .sum()
            };
            let kept = area(&|atom| again[atom]);
            *found += u32::from(kept >= SAME_PATCH_SHARE * area(&|_| true));
        }
    }
    let redraws = f64::from(params.redraws);
    Ok(found
        .iter()
        .map(|&found| f64::from(found) / redraws)
        .collect())
}

fn redrawn(estimate: &AveragedThickening, mesh: &RegularMesh, random: &mut ChaCha8Rng) -> Vec<f64> {
    let areas = &mesh.areas;
    // Sums of three uniform numbers: near enough to normal, since averaging sums them again.
    let mut field: Vec<f64> = (0..areas.len())
        .map(|_| (0..3).map(|_| random.random_range(-1.0..1.0)).sum())
        .collect();
    estimate.diffusion.apply(&mut field);
    let square: f64 = field.iter().zip(areas).map(|(x, area)| area * x * x).sum();
    // Scaled after averaging, since the noise to be reproduced is that of averaged thickening.
    let deviation = (square / mesh.whole).sqrt().max(f64::MIN_POSITIVE);
    (field.iter().zip(&estimate.thickening))
        .map(|(x, thickening)| thickening + estimate.noise * x / deviation)
        .collect()
}
