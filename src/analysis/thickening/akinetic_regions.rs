//! Connected parts of the wall that do not thicken: found by their core, grown to the extent threshold.

use super::diffusion::RegularMesh;
use super::neighbours::Neighbours;
use super::params::CheckedThickeningParams;
use super::surface::Surface;

/// Thickening of remote myocardium: the value that a fifth of the area exceeds. With patches of up to
/// three fifths of the wall it is the median of what is left.
pub(super) const REMOTE_QUANTILE: f64 = 0.8;

/// Value below which a share of the area lies; 0 of no area.
pub(super) fn area_quantile(values: &[f64], areas: &[f64], share: f64) -> f64 {
    let mut order: Vec<usize> = (0..values.len()).filter(|&i| areas[i] > 0.0).collect();
    order.sort_unstable_by(|&i, &j| values[i].total_cmp(&values[j]).then(i.cmp(&j)));
    let whole: f64 = order.iter().map(|&i| areas[i]).sum();
    let mut below = 0.0;
    for &i in &order {
        below += areas[i];
        // The first value at or past the share: with few atoms an interpolated one would belong to none.
        if below >= share * whole {
            return values[i];
        }
    }
    order.last().map_or(0.0, |&i| values[i])
}

/// Share of the least area of a patch that its core must have, so that one atom in noise makes none.
pub(super) const CORE_AREA: f64 = 0.5;

/// Share of a patch's area that must lie away from the edge at which the wall was cut: atoms there are fitted to a surface that ends
/// beside them. "Most of it", not tuned.
const MIN_INNER_SHARE: f64 = 0.5;

/// Parts of the wall that do not thicken, by hysteresis: connected atoms that thicken by less than `extent_threshold` of what
/// remote myocardium does, with the least area together, half of which thickens by less than `core_threshold` of it and
/// less than `akinetic_threshold`. A part may reach the edge at which the wall was cut, but most of it lies away from there. By falling area.
pub(super) fn akinetic_regions(
    thickening: &[f64],
    remote: f64,
    surface: &Surface,
    min_share: f64,
    params: &CheckedThickeningParams,
) -> Vec<Vec<u32>> {
    let Surface {
        mesh,
        neighbours,
        at_edge,
        ..
    } = surface;
    let inside: Vec<bool> = (thickening.iter().zip(&mesh.areas))
        .map(|(&value, &area)| area > 0.0 && value <= params.extent_threshold * remote)
        .collect();
    // The absolute limit guards against calling a moderately thickening part akinetic beside a very good rest.
    let core = params
        .akinetic_threshold
        .min(params.core_threshold * remote);
    let area_of = |part: &[u32], counts: &dyn Fn(usize) -> bool| -> f64 {
        (part.iter().map(|&atom| atom as usize))
            .filter(|&atom| counts(atom))
            .map(|atom| mesh.areas[atom])
            .sum()
    };
    let least = min_share * mesh.whole;
    let mut parts: Vec<(f64, Vec<u32>)> = (neighbours.parts(&inside).into_iter())
        .filter(|part| {
            let core_area = area_of(part, &|atom| thickening[atom] <= core);
            core_area >= (CORE_AREA * least).max(f64::MIN_POSITIVE)
        })
        .map(|part| (area_of(&part, &|_| true), part))
        .filter(|(area, part)| {
            *area >= least && area_of(part, &|atom| !at_edge[atom]) > MIN_INNER_SHARE * area
        })
        .collect();
    // Largest first: features and the report speak of the first patch.
    parts.sort_by(|a, b| b.0.total_cmp(&a.0));
    parts.into_iter().map(|(_, part)| part).collect()
}

/// A part as it is reported: holes in it are filled that are smaller than the least area of a patch, since motion is separated from
/// noise over no less an area than stillness, and atoms without a face in it are left out.
pub(super) fn tidied(
    part: Vec<u32>,
    mesh: &RegularMesh,
    neighbours: &Neighbours,
    min_share: f64,
) -> Vec<u32> {
    let mut outside: Vec<bool> = mesh.areas.iter().map(|&area| area > 0.0).collect();
    part.iter().for_each(|&atom| outside[atom as usize] = false);
    let area = |hole: &[u32]| -> f64 { hole.iter().map(|&v| mesh.areas[v as usize]).sum() };
    // A hole smaller than a patch would count is no remote myocardium within it.
    let holes =
        (neighbours.parts(&outside).into_iter()).filter(|hole| area(hole) < min_share * mesh.whole);
    let mut inside = vec![false; mesh.areas.len()];
    (part.iter().copied().chain(holes.flatten())).for_each(|atom| inside[atom as usize] = true);
    let mut on_face = vec![false; mesh.areas.len()];
    for triangle in &mesh.triangles {
        // Single rows of atoms at the outline have no area of their own.
        if triangle.iter().all(|&atom| inside[atom as usize]) {
            triangle
                .iter()
                .for_each(|&atom| on_face[atom as usize] = true);
        }
    }
    let tidy: Vec<u32> = (0..on_face.len() as u32)
        .filter(|&atom| on_face[atom as usize])
        .collect();
    // A patch along one row of atoms has no face, and is still a patch.
    if tidy.is_empty() { part } else { tidy }
}
