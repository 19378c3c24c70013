//! How well patches of known place and size are detected again under noise (4.6.2, 4.6.3).

use rayon::prelude::*;

use crate::analysis::segments::{LongAxis, Segment, segment};
use crate::analysis::thickening::{Patch, Thickening, ThickeningParams};
use crate::mesh::{Point3, Vector3};
use crate::progress::Progress;

use super::medial_methods::assessed;
use super::noise_medial::disturbed;
use super::noise_medial_params::{
    Condition, at_least_one, check_levels, conditions, without_redraws,
};
use super::noise_result::mean_and_error;
use super::sheet_patches::regular_areas;
use super::sheets::{PHASES, Sheet, sheet};
use super::{ExperimentError, NoiseFamily, SheetParams};

/// Which patches are looked for, under which noise.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalisationParams {
    /// The medial surfaces.
    pub sheets: SheetParams,
    /// Shares of the regular area of each patch of a sheet, one list per kind of sheet; an empty list is a
    /// sheet without.
    pub shares: Vec<Vec<f64>>,
    /// Distributions of noise.
    pub families: Vec<NoiseFamily>,
    /// Levels in percent; 0 is always run as well.
    pub percents: Vec<f64>,
    /// Sheets of each kind in a redraw.
    pub per_kind: u16,
    /// Draws of sheets, patches and noise, all anew.
    pub redraws: u16,
    /// The search for patches.
    pub thickening: ThickeningParams,
    /// Seed of every random number that is drawn.
    pub seed: u64,
}

impl Default for LocalisationParams {
    /// None, one patch of 1 % to 60 % of the sheet, and two of 8 %; four sheets of each, ten redraws.
    fn default() -> Self {
        let sizes = [0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.45, 0.6];
        let one = sizes.into_iter().map(|share| vec![share]);
        Self {
            sheets: SheetParams::default(),
            shares: std::iter::once(Vec::new())
                .chain(one)
                .chain([vec![0.08, 0.08]])
                .collect(),
            families: vec![NoiseFamily::Uniform, NoiseFamily::Gaussian],
            percents: vec![1.0, 2.5, 5.0, 10.0],
            per_kind: 4,
            redraws: 10,
            thickening: without_redraws(),
            seed: 1,
        }
    }
}

/// Mean and standard error over redraws.
pub type MeanAndError = (f64, f64);

/// One kind of sheet under one condition. Means are over redraws; those of what was found are over
/// the redraws that have it.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalisationRow {
    /// Patches there are.
    pub patches: usize,
    /// Share of the regular area of each; 0 without.
    pub share: f64,
    /// The distribution of the noise; `None` for clean data.
    pub family: Option<NoiseFamily>,
    /// The level; 0 for clean data.
    pub percent: f64,
    /// Sheets looked at.
    pub sheets: usize,
    /// Share of sheets all of whose patches are found, each as a patch of its own; `None` without any.
    pub found: Option<MeanAndError>,
    /// Found patches per sheet that share no atom with a true one.
    pub false_patches: MeanAndError,
    /// Dice of true patches, with 0 for those that are not found: 2 |A ∩ B| / (|A| + |B|) in area.
    pub dice: Option<MeanAndError>,
    /// From the centroid of a found patch to that of the true one, in millimetres.
    pub centroid_mm: Option<MeanAndError>,
    /// Segments on which both agree, over those that either has (Jaccard): segments of which at least a third lies
    /// in the patch, or else the one that has most of it.
    pub segments: Option<MeanAndError>,
    /// Share of found patches whose main segment, which has most of them, is one of the true one's.
    pub main_segment: Option<MeanAndError>,
    /// Mean distance of MP from the sheet in percent of its size: of all that is still, and of the patches apart.
    pub gaps_percent: [Option<f64>; 2],
    /// Root mean square angle of ANV from its mean over the beat, in radians, of both.
    pub normal_spreads_rad: [Option<f64>; 2],
}

/// What was found on one sheet; lists are empty where there is nothing to say.
#[derive(Clone, Debug, Default)]
struct Found {
    all: Vec<f64>,
    false_patches: Vec<f64>,
    dice: Vec<f64>,
    centroid_mm: Vec<f64>,
    segments: Vec<f64>,
    main_segment: Vec<f64>,
    gaps: [Vec<f64>; 2],
    normal_spreads: [Vec<f64>; 2],
}

/// Runs the study. The same bits for any number of threads.
///
/// # Errors
/// If settings are out of range, it was stopped, or the search for patches fails.
pub fn localisation(
    params: &LocalisationParams,
    progress: &Progress,
) -> Result<Vec<LocalisationRow>, ExperimentError> {
    at_least_one("kinds of sheets", params.shares.len())?;
    at_least_one("sheets of each kind", usize::from(params.per_kind))?;
    at_least_one("redraws", usize::from(params.redraws))?;
    check_levels(&params.percents)?;
    params.thickening.check()?;
    let conditions = conditions(&params.families, &params.percents);
    let rows: Vec<(usize, Condition)> = (0..params.shares.len())
        .flat_map(|kind| conditions.iter().map(move |&condition| (kind, condition)))
        .collect();
    let redraws = usize::from(params.redraws);
    progress.expect_steps(rows.len() * redraws * usize::from(params.per_kind));
    let tasks: Vec<(usize, u16)> = (0..rows.len())
        .flat_map(|row| (0..params.redraws).map(move |redraw| (row, redraw)))
        .collect();
    let found: Vec<Found> = tasks
        .par_iter()
        .map(|&(row, redraw)| {
            let (kind, condition) = rows[row];
            one_redraw(params, kind, condition, redraw, progress)
        })
        .collect::<Result<_, ExperimentError>>()?;
    Ok((rows.iter().zip(found.chunks_exact(redraws)))
        .map(|(&(kind, condition), found)| row(params, kind, condition, found))
        .collect())
}

/// All sheets of a kind in a redraw, what is said of them in joined lists.
fn one_redraw(
    params: &LocalisationParams,
    kind: usize,
    condition: Condition,
    redraw: u16,
    progress: &Progress,
) -> Result<Found, ExperimentError> {
    let seed = params.seed.wrapping_add(u64::from(redraw));
    let mut joined = Found::default();
    for member in 0..params.per_kind {
        progress.step()?;
        // Another stream than those of the sheets that are classified.
        let stream = (kind as u64 + 16) << 32 | u64::from(member);
        let clean = sheet(&params.sheets, &params.shares[kind], seed, stream)?;
        let noisy = disturbed(&clean, condition, seed, stream);
        let found = assessed(&noisy, &params.thickening, false, &progress.within())?.found;
        compared(&clean, &found, &mut joined);
    }
    Ok(joined)
}

/// Adds what was found on one sheet.
fn compared(clean: &Sheet, found: &Thickening, joined: &mut Found) {
    let at_end_diastole = &clean.positions[PHASES[0]];
    // Areas of the clean sheet, so that noise changes no size of what is to be detected.
    let areas = regular_areas(at_end_diastole, clean.faces.triangles(), &clean.regular);
    let area = |atoms: &[u32]| -> f64 { atoms.iter().map(|&atom| areas[atom as usize]).sum() };
    let overlap = |patch: &Patch, truth: &[u32]| -> f64 {
        (truth.iter())
            .filter(|atom| patch.atoms.binary_search(atom).is_ok())
            .map(|&atom| areas[atom as usize])
            .sum()
    };
    let mut taken: Vec<usize> = Vec::new();
    for truth in &clean.patches {
        let nearest = (found.patches.iter().enumerate())
            .map(|(index, patch)| (overlap(patch, truth), index))
            // Each detected patch stands for one true patch at most.
            .filter(|(common, index)| *common > 0.0 && !taken.contains(index))
            .max_by(|a, b| a.0.total_cmp(&b.0));
        let Some((common, index)) = nearest else {
            // A patch that is missed overlaps with nothing; leaving it out would flatter the mean.
            joined.dice.push(0.0);
            continue;
        };
        taken.push(index);
        let patch = &found.patches[index];
        joined
            .dice
            .push(2.0 * common / (area(truth) + area(&patch.atoms)));
        let centroid = centroid(at_end_diastole, truth, &areas);
        joined.centroid_mm.push((patch.centroid - centroid).norm());
        if let Some(axis) = &clean.axis {
            segments_compared(axis, at_end_diastole, &areas, truth, patch, joined);
        }
    }
    if !clean.patches.is_empty() {
        // Detected are all or not: two patches that merge into one are a miss.
        let all = taken.len() == clean.patches.len();
        joined.all.push(f64::from(u8::from(all)));
    }
    let apart = |patch: &&Patch| {
        clean
            .patches
            .iter()
            .all(|truth| overlap(patch, truth) == 0.0)
    };
    let false_patches = found.patches.iter().filter(apart).count();
    joined.false_patches.push(false_patches as f64);
    joined.gaps[0].extend(found.temporal_consistency.gap);
    joined.normal_spreads[0].extend(found.temporal_consistency.normal_spread_rad);
    for index in taken {
        let temporal_consistency = &found.patches[index].temporal_consistency;
        joined.gaps[1].extend(temporal_consistency.gap);
        joined.normal_spreads[1].extend(temporal_consistency.normal_spread_rad);
    }
}

fn centroid(points: &[Point3], atoms: &[u32], areas: &[f64]) -> Point3 {
    let (mut sum, mut whole) = (Vector3::zeros(), 0.0);
    for atom in atoms.iter().map(|&atom| atom as usize) {
        sum += points[atom].coords * areas[atom];
        whole += areas[atom];
    }
    Point3::from(sum / whole.max(f64::MIN_POSITIVE))
}

/// Share of a segment that makes it one of a patch's.
const OF_SEGMENT: f64 = 1.0 / 3.0;

fn segments_compared(
    axis: &LongAxis,
    at_end_diastole: &[Point3],
    areas: &[f64],
    truth: &[u32],
    patch: &Patch,
    joined: &mut Found,
) {
    let mut whole = [0.0; 17];
    let mut within = [0.0; 17];
    for (point, area) in at_end_diastole.iter().zip(areas) {
        if let Some(segment) = segment(axis, *point) {
            whole[segment.index()] += area;
        }
    }
    for atom in truth.iter().map(|&atom| atom as usize) {
        if let Some(segment) = segment(axis, at_end_diastole[atom]) {
            within[segment.index()] += areas[atom];
        }
    }
    let of_truth = (Segment::all()).map(|s| {
        (
            s,
            within[s.index()] / f64::max(whole[s.index()], f64::MIN_POSITIVE),
            within[s.index()],
        )
    });
    let of_found = (patch.segments.iter()).map(|s| (s.segment, s.of_segment, s.of_patch));
    let (truth, _) = taken_segments(of_truth);
    let (found, main) = taken_segments(of_found);
    let common = found.iter().filter(|s| truth.contains(s)).count();
    let either = found.len() + truth.len() - common;
    // Without segments on either side there is nothing to agree on.
    if either > 0 {
        joined.segments.push(common as f64 / either as f64);
    }
    if let Some(main) = main {
        joined
            .main_segment
            .push(f64::from(u8::from(truth.contains(&main))));
    }
}

/// Segments of which a third is taken, or else the one that has most; and the one that has most. Each comes
/// with its share that is taken, and how much of the patch it has.
fn taken_segments(
    shares: impl Iterator<Item = (Segment, f64, f64)>,
) -> (Vec<Segment>, Option<Segment>) {
    let mut taken = Vec::new();
    let mut main: Option<(f64, Segment)> = None;
    for (segment, of_segment, of_patch) in shares {
        if of_segment >= OF_SEGMENT {
            taken.push(segment);
        }
        if of_patch > main.map_or(0.0, |(most, _)| most) {
            main = Some((of_patch, segment));
        }
    }
    let main = main.map(|(_, segment)| segment);
    if taken.is_empty() {
        // A small patch fills a third of no segment, but lies in one.
        taken.extend(main);
    }
    (taken, main)
}

fn row(
    params: &LocalisationParams,
    kind: usize,
    condition: Condition,
    redraws: &[Found],
) -> LocalisationRow {
    let mean = |values: &[f64]| (!values.is_empty()).then(|| mean_and_error(values).0);
    let over = |list: &dyn Fn(&Found) -> &Vec<f64>| -> Option<MeanAndError> {
        // Redraws, not sheets, are what is drawn independently: the error is between their means.
        let means: Vec<f64> = redraws
            .iter()
            .filter_map(|found| mean(list(found)))
            .collect();
        (!means.is_empty()).then(|| mean_and_error(&means))
    };
    let only_mean = |list: &dyn Fn(&Found) -> &Vec<f64>| over(list).map(|(mean, _)| mean);
    let shares = &params.shares[kind];
    LocalisationRow {
        patches: shares.len(),
        share: shares.first().copied().unwrap_or(0.0),
        family: condition.map(|(family, _)| family),
        percent: condition.map_or(0.0, |(_, percent)| percent),
        sheets: redraws.len() * usize::from(params.per_kind),
        found: over(&|found| &found.all),
        false_patches: over(&|found| &found.false_patches).unwrap_or_default(),
        dice: over(&|found| &found.dice),
        centroid_mm: over(&|found| &found.centroid_mm),
        segments: over(&|found| &found.segments),
        main_segment: over(&|found| &found.main_segment),
        gaps_percent: [0, 1]
            .map(|which| only_mean(&|found| &found.gaps[which]).map(|gap| 100.0 * gap)),
        normal_spreads_rad: [0, 1].map(|which| only_mean(&|found| &found.normal_spreads[which])),
    }
}
