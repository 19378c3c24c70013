//! How surely a patch is there: how often it is detected again when the noise is drawn anew.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::progress::{Progress, Stopped};

use super::averaged::Averaged;
use super::diffusion::RegularMesh;
use super::params::CheckedThickeningParams;
use super::regions::{REMOTE_QUANTILE, akinetic_regions, area_quantile};
use super::surface::Surface;

/// Share of redraws in which at least half of each part's area lies in a part again.
///
/// A redraw adds noise of the same standard deviation and extent over the surface as that of averaged
/// thickening: independent numbers per atom, averaged alike and scaled.
pub(super) fn confidences(
    estimate: &Averaged,
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
            // Half of the area: a patch that moves at its outline is the same patch.
            *found += u32::from(2.0 * area(&|atom| again[atom]) >= area(&|_| true));
        }
    }
    let redraws = f64::from(params.redraws);
    Ok(found
        .iter()
        .map(|&found| f64::from(found) / redraws)
        .collect())
}

fn redrawn(estimate: &Averaged, mesh: &RegularMesh, random: &mut ChaCha8Rng) -> Vec<f64> {
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
