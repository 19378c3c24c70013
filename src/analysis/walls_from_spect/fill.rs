//! Masks of what lies between surfaces around an axis.

use std::sync::Arc;

use rayon::prelude::*;

use crate::analysis::walls_from_masks::{Masks, Tissue};
use crate::image::VolumeFrame;
use crate::mesh::Vector3;
use crate::progress::{Progress, Stopped};

use super::SpectError;
use super::rays::{Rays, Sheet};

/// Voxels of the masks at one instant at most: a heart of 250 mm at the finest spacing.
const MAX_VOXELS: usize = 20_000_000;

/// One instant: the distances of both surfaces along the rays, and the height of the valve.
#[derive(Clone, Debug)]
pub(super) struct Surfaces {
    pub endo: Sheet,
    pub epi: Sheet,
    pub base: f64,
}

/// Masks on a grid whose last axis is the long axis, from the apex to the base.
///
/// # Errors
/// If the grid is too fine or it was asked to stop.
pub(super) fn masks(
    rays: &Rays,
    instants: &[Surfaces],
    spacing: f64,
    progress: &Progress,
) -> Result<Masks, SpectError> {
    let (mut low, mut high) = (Vector3::repeat(f64::MAX), Vector3::repeat(f64::MIN));
    for surfaces in instants {
        for (ray, &distance) in surfaces.epi.iter().enumerate() {
            let point = rays.point(ray, distance);
            low = low.inf(&point);
            high = high.sup(&point);
        }
    }
    let base = instants.iter().fold(f64::MIN, |most, s| most.max(s.base));
    // One voxel more on all sides but the base, where the masks end.
    low -= Vector3::repeat(spacing);
    high += Vector3::repeat(spacing);
    high.z = base + spacing;
    let size =
        [0, 1, 2].map(|axis| ((high[axis] - low[axis]) / spacing).max(0.0).ceil() as usize + 1);
    let voxels = size.iter().try_fold(1_usize, |all, &n| all.checked_mul(n));
    if voxels.is_none_or(|voxels| voxels > MAX_VOXELS) {
        return Err(SpectError::TooLarge {
            voxels: voxels.unwrap_or(usize::MAX),
            instants: instants.len(),
            limit: MAX_VOXELS,
        });
    }
    let axis = rays.conic.axis;
    let steps = [0, 1, 2].map(|n| axis.directions.column(n) * spacing);
    let frame = VolumeFrame::new(size, axis.position(low), steps)?;
    let filled = instants.par_iter().map(|surfaces| {
        let mut tissues = Vec::with_capacity(frame.voxel_count());
        for k in 0..size[2] {
            progress.check()?;
            for place in 0..size[0] * size[1] {
                let voxel = [place % size[0], place / size[0], k].map(|n| n as f64);
                let local = low + Vector3::from(voxel) * spacing;
                tissues.push(tissue(rays, surfaces, local));
            }
        }
        Ok(Arc::from(tissues))
    });
    let filled = filled.collect::<Result<Vec<Arc<[Tissue]>>, Stopped>>()?;
    Ok(Masks::new(frame, filled)?)
}

fn tissue(rays: &Rays, surfaces: &Surfaces, local: Vector3) -> Tissue {
    if local.z > surfaces.base {
        return Tissue::Other;
    }
    let (distance, epi) = rays.of_point(local, &surfaces.epi);
    if distance > epi {
        return Tissue::Other;
    }
    match distance <= rays.of_point(local, &surfaces.endo).1 {
        true => Tissue::Cavity,
        false => Tissue::Wall,
    }
}
