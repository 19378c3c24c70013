//! All steps in order: PT over the cycle, the akinetic atoms, and the patches that they make.

use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial::MedialBeat;
use crate::analysis::segments::LongAxis;
use crate::progress::Progress;

use super::akinetic_regions::{akinetic_regions, tidied};
use super::averaged_thickening::AveragedThickening;
use super::curve::centred_logs;
use super::error::ThickeningError;
use super::params::CheckedThickeningParams;
use super::patches::{Wall, segments_of};
use super::result::{SmallestPatch, Thickening, WallThickening};
use super::smallest_detectable::smallest_detectable;
use super::stability::stabilities;
use super::steps::{StepCriteria, steps, thickness_ratios};
use super::surface::Surface;
use super::temporal_consistency::temporal_consistency;

/// Fewest regular atoms: with a dozen a patch would be one of them.
const MIN_ATOMS: usize = 30;
/// And the least share of all: where more than half of the sheet ends, as under noise that leaves atoms no sphere
/// in one pose or the other, what remains is torn.
const MIN_REGULAR: f64 = 0.5;

/// Thickening of one subject over the beat, and the patches that do not take part in it.
///
/// 1. PT of each atom for consecutive poses, the last to the first, and for end-diastole to end-systole;
///    M̂ per step, with its descriptor (4.4, 4.5).
/// 2. What persists over all steps: ln r of each atom is projected on the subject's own curve c(t), its first
///    principal component over time, and averaged over neighbourhoods of the medial mesh; the area grows until noise,
///    estimated from what the curve leaves, is a twentieth of the thickening of remote myocardium. All poses count;
///    with two this is ln PT.
/// 3. Patches (4.6.2, 4.6.3): connected parts that thicken by less than a share of the subject's own remote myocardium, by
///    hysteresis, most of each away from the edge at which the wall was cut; a path and a descriptor for each. Where even remote
///    myocardium hardly thickens, there are none:
///    hypokinesia is global.
///
/// # Errors
/// If there are fewer than two poses, or than 30 regular atoms or half of all, a radius is not positive, or on "stop".
pub fn thickening(
    beat: &MedialBeat,
    measures: &SubjectMeasures,
    axis: Option<&LongAxis>,
    params: &CheckedThickeningParams,
    progress: &Progress,
) -> Result<Thickening, ThickeningError> {
    check(beat)?;
    progress.expect_steps(beat.frames.len());
    let mut surface = Surface::new(beat, measures)?;
    let estimate = AveragedThickening::new(&centred_logs(beat), &surface, params)?;
    // After averaging, since it smooths positions over the area that noise asked for.
    surface.steady(beat, &estimate.diffusion);
    let Surface {
        mesh,
        at_end_diastole,
        ..
    } = &surface;
    let [ed, es] = surface.phases;
    progress.check()?;
    // PT compares two poses, each with its own noise.
    let tolerance = (params.tolerance)
        .unwrap_or_else(|| (2.0 * 2.0_f64.sqrt() * estimate.atom_noise).max(1.05_f64.ln()));
    let remote_curve: Vec<f64> = (0..beat.frames.len())
        .map(|pose| estimate.curve.step(estimate.remote, ed, pose))
        .collect();
    let criteria = StepCriteria {
        remote_curve: &remote_curve,
        tolerance,
        ratio: params.ratio,
    };
    let steps = steps(beat, at_end_diastole, surface.phases, &criteria, progress)?;
    // A share of next to nothing is noise: hypokinesia is then global, and no patch is reported.
    let parts = if estimate.hardly_thickens(params) {
        Vec::new()
    } else {
        let least = estimate.min_share;
        akinetic_regions(
            &estimate.thickening,
            estimate.remote,
            &surface,
            least,
            params,
        )
    };
    let stabilities = stabilities(&estimate, &surface, &parts, params, progress)?;
    let wall = Wall {
        beat,
        mesh: at_end_diastole,
        end_diastole: ed,
        size: surface.size,
        unit: measures.unit,
        steps: &steps,
        thickening: &estimate.thickening,
        segments: segments_of(beat, ed, axis),
        ratio: params.ratio,
    };
    let tidied = |part| tidied(part, mesh, &surface.neighbours, estimate.min_share);
    let patches: Vec<_> = (parts.into_iter().zip(stabilities))
        .map(|(part, stability)| wall.patch(tidied(part), stability))
        .collect();
    let telling = || steps.iter().filter(|step| step.telling);
    // Steps in which even remote myocardium keeps its thickness say nothing about who takes part.
    let path: Vec<_> = telling().map(|step| step.descriptor).collect();
    let gaps: Vec<_> = telling().map(|step| step.gap).collect();
    Ok(Thickening {
        end_diastole: ed,
        end_systole: es,
        tolerance,
        noise: estimate.atom_noise,
        temporal_consistency: temporal_consistency(&path, &gaps, surface.size),
        ed_to_es: thickness_ratios(&beat.frames[ed], &beat.frames[es]),
        smallest: smallest_detectable(&estimate, mesh, params).map(|share| SmallestPatch {
            share,
            area: share * at_end_diastole.whole,
            area_cm2: wall.in_cm2(share * at_end_diastole.whole),
        }),
        wall_thickening: match (estimate.hardly_thickens(params), patches.is_empty()) {
            (true, _) => WallThickening::HardlyAnywhere,
            (false, true) => WallThickening::Everywhere,
            (false, false) => WallThickening::AllButPatches,
        },
        remote: estimate.remote,
        remote_curve,
        min_share: estimate.min_share,
        averaged_share: estimate.share,
        averaged_noise: estimate.noise,
        regular_area: at_end_diastole.whole,
        averaged: estimate.thickening,
        at_edge: surface.at_edge,
        size: surface.size,
        steps,
        patches,
    })
}

fn check(beat: &MedialBeat) -> Result<(), ThickeningError> {
    let (frames, atoms) = (beat.frames.len(), beat.faces.vertex_count());
    if frames < 2 {
        return Err(ThickeningError::TooFewPoses { frames });
    }
    for (frame, surface) in beat.frames.iter().enumerate() {
        for found in [
            surface.atoms.len(),
            surface.normals.len(),
            beat.regular.len(),
        ] {
            if found != atoms {
                return Err(ThickeningError::Count {
                    frame,
                    found,
                    expected: atoms,
                });
            }
        }
        let bad = |&atom: &usize| {
            let radius = surface.atoms[atom].radius;
            beat.regular[atom] && !(radius > 0.0 && radius.is_finite())
        };
        if let Some(atom) = (0..atoms).find(bad) {
            return Err(ThickeningError::BadRadius {
                atom,
                frame,
                radius: surface.atoms[atom].radius,
            });
        }
    }
    let regular = beat.regular.iter().filter(|&&regular| regular).count();
    let least = MIN_ATOMS.max((MIN_REGULAR * atoms as f64) as usize);
    if regular < least {
        return Err(ThickeningError::TooFewAtoms {
            regular,
            atoms,
            least,
        });
    }
    Ok(())
}
