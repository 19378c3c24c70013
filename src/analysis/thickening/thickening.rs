//! The whole question: PT over the beat, what stands still in it, and which patches that makes.

use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial::MedialBeat;
use crate::analysis::segments::LongAxis;
use crate::mesh::{Point3, Vector3, bounding_box};
use crate::progress::Progress;

use super::confidence::{Estimate, confidences};
use super::curve::{ThickeningCurve, averaged, centred_logs};
use super::diffusion::{Diffusion, RegularMesh};
use super::error::ThickeningError;
use super::neighbours::Neighbours;
use super::noise::noise_of;
use super::params::CheckedThickeningParams;
use super::patches::{Wall, segments_of};
use super::regions::{WELL_QUANTILE, area_quantile, still_parts};
use super::result::{Extent, Thickening};
use super::steadiness::steadiness;
use super::steps::{steps, thickness_ratios};

/// Fewest regular atoms: with a dozen a patch would be one of them.
const LEAST_ATOMS: usize = 30;
/// Averaging goes on over twice, four times… the area, up to so many times what it begins with, while noise is above …
const MOST_AVERAGING: f64 = 4.0;
/// … this share of what the well wall does: three times as much stays below the default distance from the core's
/// limit to what is well.
const MOST_NOISE: f64 = 0.1;
/// Least thickening of the well wall, in standard deviations of averaged noise, that is thickening at all.
const SURE: f64 = 3.0;

/// Thickening of one heart over the beat, and the patches that do not take part in it.
///
/// 1. PT of each atom for consecutive poses, the last to the first, and for end-diastole to end-systole;
///    M̂ per step, with its descriptor (4.4, 4.5).
/// 2. What persists over all steps: ln r of each atom is projected on the heart's own curve c(t) (see
///    [`ThickeningCurve`]) and averaged over neighbourhoods of the medial mesh; the area grows until noise,
///    told from what the curve leaves, is a tenth of what the well wall does. All poses speak;
///    with two this is ln PT.
/// 3. Patches (4.6.2, 4.6.3): connected parts that thicken by less than a share of the heart's own well wall, by
///    hysteresis; a path and a descriptor for each. Where even the well wall hardly thickens, there are none:
///    failure is global.
///
/// # Errors
/// If there are fewer than two poses or 30 regular atoms, a radius is not positive, or on "stop".
pub fn thickening(
    beat: &MedialBeat,
    measures: &SubjectMeasures,
    axis: Option<&LongAxis>,
    params: &CheckedThickeningParams,
    progress: &Progress,
) -> Result<Thickening, ThickeningError> {
    check(beat)?;
    progress.expect_steps(beat.frames.len());
    let middle = mean_shape(beat);
    let mesh = RegularMesh::new(beat.faces.triangles(), &middle, &beat.regular);
    if mesh.whole.is_nan() || mesh.whole <= 0.0 {
        return Err(ThickeningError::NoArea);
    }
    let neighbours = Neighbours::new(middle.len(), &mesh.triangles);
    let [ed, es] = phases(beat, measures);
    let rest = positions(beat, ed);
    let at_rest = RegularMesh::new(beat.faces.triangles(), &rest, &beat.regular);
    let radii: Vec<Vec<f64>> = (beat.frames.iter())
        .map(|frame| frame.atoms.iter().map(|atom| atom.radius).collect())
        .collect();
    let found = Averaged::new(
        &centred_logs(&radii),
        &mesh,
        &middle,
        &neighbours,
        [ed, es],
        params,
    )?;
    progress.check()?;
    // PT compares two poses, each with its own noise.
    let tolerance = (params.tolerance)
        .unwrap_or_else(|| (2.0 * 2.0_f64.sqrt() * found.atom_noise).max(1.05_f64.ln()));
    let steps = steps(beat, &at_rest, [ed, es], tolerance, params, progress)?;
    let size = bounding_box(&rest).map_or(0.0, |[low, high]| (high - low).max());
    let parts = if found.hardly_thickens(params) {
        Vec::new()
    } else {
        still_parts(&found.thickening, found.well, &mesh, &neighbours, params)
    };
    let estimate = Estimate {
        thickening: &found.thickening,
        noise: found.noise,
        diffusion: &found.diffusion,
        mesh: &mesh,
        neighbours: &neighbours,
    };
    let confidences = confidences(&estimate, &parts, params, progress)?;
    let wall = Wall {
        beat,
        mesh: &at_rest,
        end_diastole: ed,
        size,
        unit: measures.unit,
        steps: &steps,
        thickening: &found.thickening,
        segments: segments_of(beat, ed, axis),
    };
    let patches: Vec<_> = (parts.into_iter().zip(confidences))
        .map(|(atoms, confidence)| wall.patch(atoms, confidence, params))
        .collect();
    let path: Vec<_> = steps.iter().map(|step| step.descriptor).collect();
    let gaps: Vec<_> = steps.iter().map(|step| step.gap).collect();
    Ok(Thickening {
        end_diastole: ed,
        end_systole: es,
        tolerance,
        noise: found.atom_noise,
        steadiness: steadiness(&path, &gaps, size),
        ed_to_es: thickness_ratios(&beat.frames[ed], &beat.frames[es]),
        extent: match (found.hardly_thickens(params), patches.is_empty()) {
            (true, _) => Extent::HardlyAnywhere,
            (false, true) => Extent::Everywhere,
            (false, false) => Extent::AllButPatches,
        },
        well: found.well,
        averaged_share: found.share,
        averaged_noise: found.noise,
        regular_area: at_rest.whole,
        thickening: found.thickening,
        size,
        steps,
        patches,
    })
}

/// Thickening averaged over neighbourhoods that are as large as noise asks for.
struct Averaged {
    thickening: Vec<f64>,
    /// Share of the area averaged over.
    share: f64,
    diffusion: Diffusion,
    well: f64,
    /// Standard deviation of the noise of `thickening`.
    noise: f64,
    /// And of ln r of one atom at one pose.
    atom_noise: f64,
}

impl Averaged {
    fn new(
        columns: &[Vec<f64>],
        mesh: &RegularMesh,
        middle: &[Point3],
        neighbours: &Neighbours,
        phases: [usize; 2],
        params: &CheckedThickeningParams,
    ) -> Result<Self, ThickeningError> {
        let mut share = params.smoothing;
        loop {
            let diffusion = Diffusion::new(mesh, middle, share)?;
            let means = averaged(columns, &diffusion);
            let curve = ThickeningCurve::new(&means, &mesh.areas, phases);
            let mut thickening = curve.thickening(&means);
            for (value, area) in thickening.iter_mut().zip(&mesh.areas) {
                if *area == 0.0 {
                    *value = 0.0;
                }
            }
            let well = area_quantile(&thickening, &mesh.areas, WELL_QUANTILE);
            let noise = curve.rise * noise_of(&means, &curve, &mesh.areas, neighbours);
            let wider = 2.0 * share;
            if noise <= MOST_NOISE * well
                || wider > MOST_AVERAGING * params.smoothing
                || share == 0.0
            {
                return Ok(Self {
                    atom_noise: noise_of(columns, &curve, &mesh.areas, neighbours),
                    thickening,
                    share,
                    diffusion,
                    well,
                    noise,
                });
            }
            share = wider;
        }
    }

    fn hardly_thickens(&self, params: &CheckedThickeningParams) -> bool {
        self.well < params.least_thickening.max(SURE * self.noise)
    }
}

fn positions(beat: &MedialBeat, pose: usize) -> Vec<Point3> {
    beat.frames[pose]
        .atoms
        .iter()
        .map(|atom| atom.position)
        .collect()
}

/// Mean position of each atom over the beat, whose edges have less noise than those of a pose.
fn mean_shape(beat: &MedialBeat) -> Vec<Point3> {
    let mut sums = vec![Vector3::zeros(); beat.faces.vertex_count()];
    for frame in &beat.frames {
        sums.iter_mut()
            .zip(&frame.atoms)
            .for_each(|(sum, atom)| *sum += atom.position.coords);
    }
    let poses = beat.frames.len() as f64;
    sums.into_iter()
        .map(|sum| Point3::from(sum / poses))
        .collect()
}

/// Poses of end-diastole and end-systole: by volume or as stated; where that is not told, the greatest and
/// least area of the medial surface.
pub fn phases(beat: &MedialBeat, measures: &SubjectMeasures) -> [usize; 2] {
    let count = beat.frames.len();
    let told = |pose: Option<usize>| pose.filter(|&pose| pose < count);
    match [told(measures.end_diastole), told(measures.end_systole)] {
        [Some(ed), Some(es)] if ed != es => [ed, es],
        _ => {
            let area = |pose: usize| {
                RegularMesh::new(
                    beat.faces.triangles(),
                    &positions(beat, pose),
                    &beat.regular,
                )
                .whole
            };
            let areas: Vec<f64> = (0..count).map(area).collect();
            let extreme = |sign: f64| {
                let better =
                    |a: &usize, b: &usize| (sign * areas[*a]).total_cmp(&(sign * areas[*b]));
                (0..count).rev().max_by(better).unwrap_or(0)
            };
            match [extreme(1.0), extreme(-1.0)] {
                [ed, es] if ed != es => [ed, es],
                _ => [0, 1],
            }
        }
    }
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
        let bad = |radius: f64| !(radius > 0.0 && radius.is_finite());
        if let Some(atom) = surface.atoms.iter().position(|atom| bad(atom.radius)) {
            return Err(ThickeningError::BadRadius {
                atom,
                frame,
                radius: surface.atoms[atom].radius,
            });
        }
    }
    let regular = beat.regular.iter().filter(|&&regular| regular).count();
    if regular < LEAST_ATOMS {
        return Err(ThickeningError::TooFewAtoms {
            regular,
            atoms,
            least: LEAST_ATOMS,
        });
    }
    Ok(())
}
