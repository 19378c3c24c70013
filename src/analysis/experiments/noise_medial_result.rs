//! The table of noise on medial surfaces, with its protocol in words.

use super::noise_medial_params::{Condition, MedialDraw};
use super::noise_result::mean_and_error;
use super::{MedialMethod, MedialNoiseParams, NoiseFamily};

/// All cells of the study, and the settings that they came from.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialNoiseResult {
    /// The settings with which it was run.
    pub params: MedialNoiseParams,
    /// By method; for each the clean data first, then by family and level.
    pub cells: Vec<MedialNoiseCell>,
}

/// τ of one way of telling under one condition. Shares are in `0.0..=1.0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MedialNoiseCell {
    /// The way.
    pub method: MedialMethod,
    /// The distribution of the noise; `None` for clean data.
    pub family: Option<NoiseFamily>,
    /// The level; 0 for clean data.
    pub percent: f64,
    /// Mean of τ over redraws.
    pub tau: f64,
    /// Standard error of that mean from the scatter between redraws; 0 for a single one.
    pub standard_error: f64,
    /// Mean of τ with permuted labels.
    pub baseline: f64,
    /// Share of deformations without a patch that are called so.
    pub specificity: f64,
    /// Share of deformations with a patch that are called so.
    pub sensitivity: f64,
    /// The figure of table 4.2, where it has this level.
    pub published: Option<f64>,
}

/// Table 4.2: level and τ in percent for uniform and Gaussian noise.
const PUBLISHED: [(f64, [f64; 2]); 4] = [
    (1.0, [88.6, 85.7]),
    (2.5, [83.3, 82.0]),
    (5.0, [77.0, 78.9]),
    (10.0, [64.3, 73.1]),
];

/// The figure of table 4.2 as a share, where it has this family and level.
///
/// Source: V. Taimouri, *Shape Analysis in Shape Space*, table 4.2.
pub fn published_medial_tau(family: NoiseFamily, percent: f64) -> Option<f64> {
    let column = match family {
        NoiseFamily::Uniform => 0,
        NoiseFamily::Gaussian => 1,
        // Table 4.2 has no column for it.
        NoiseFamily::Poisson => return None,
    };
    let (_, row) = PUBLISHED.iter().find(|(level, _)| *level == percent)?;
    Some(row[column] / 100.0)
}

impl MedialNoiseCell {
    pub(super) fn new(method: MedialMethod, condition: Condition, draws: &[MedialDraw]) -> Self {
        let of = |value: &dyn Fn(&MedialDraw) -> f64| {
            mean_and_error(&draws.iter().map(value).collect::<Vec<_>>())
        };
        let (tau, standard_error) = of(&|draw| draw.tau);
        Self {
            method,
            family: condition.map(|(family, _)| family),
            percent: condition.map_or(0.0, |(_, percent)| percent),
            tau,
            standard_error,
            baseline: of(&|draw| draw.baseline).0,
            specificity: of(&|draw| draw.right[0]).0,
            sensitivity: of(&|draw| draw.right[1]).0,
            published: condition.and_then(|(family, level)| published_medial_tau(family, level)),
        }
    }
}

impl MedialNoiseResult {
    /// The cell of a way; `None` as family for clean data.
    pub fn cell(
        &self,
        method: MedialMethod,
        family: Option<NoiseFamily>,
        percent: f64,
    ) -> Option<&MedialNoiseCell> {
        (self.cells.iter())
            .find(|cell| cell.method == method && cell.family == family && cell.percent == percent)
    }

    /// What was done, a sentence a line, to stand beside every table.
    pub fn protocol(&self) -> Vec<String> {
        let params = &self.params;
        let sheets = &params.sheets;
        let [least, most] = params.patch_shares.map(|share| 100.0 * share);
        vec![
            format!(
                "{} deformations of medial surfaces like a left ventricle's, {} without and {} with a patch of \
                 {least} to {most} % of the sheet anywhere on it, in which thickness is constant while the other \
                 atoms thicken (r grows by half) and thin over a beat of 8 poses; the patch moves with the sheet.",
                2 * params.per_class, params.per_class, params.per_class,
            ),
            format!(
                "Axes vary by ±{:.0} %, thickness by ±{:.0} %, shortening, inward motion, twist, thickening and timing \
                 of the beat by ±{:.0} %; thickening is uneven within each sheet and least at the apex; sheets lie \
                 within 8 mm and 9° of each other about each axis.",
                100.0 * sheets.shape_jitter,
                100.0 * sheets.thickness_jitter,
                100.0 * sheets.motion_jitter,
            ),
            "Noise is independent for every atom, coordinate, radius and pose; its variance is the level times the \
             variance per coordinate of the clean sheet at end-diastole for positions, and times the variance of \
             the clean radii over atoms and poses for radii; uniform noise has half-width √3 σ. Normals, spokes, \
             areas and sizes are computed from noisy atoms. End-diastole and end-systole are given, the rim is \
             left out."
                .to_owned(),
            "Patch detection: a deformation is classified as abnormal if a patch is detected in it. Each is assessed \
             alone with the program's default settings, none of which was chosen on these data."
                .to_owned(),
            format!(
                "Mean pose distance: akinetic atoms of every step, their descriptors, distances 4.5.1 with positions in \
                 sizes of the sheet, the plane of all poses, and k-means (2 clusters, {} starts) of how far the \
                 points of each deformation scatter on it; tolerance from noise, steps in which a normal wall \
                 changes. As printed: |PT − 1| ≤ 5 %, r̂ a product, all steps. Clusters of poses: k-means of the \
                 points themselves, a deformation is assigned to the cluster of most of its poses.",
                params.restarts
            ),
            format!(
                "τ: share of deformations classified correctly, with the best matching of clusters to classes; {} redraws of \
                 sheets, patches and noise, seed {}, mean ± standard error from the scatter between redraws; \
                 baseline: τ of permuted labels.",
                params.redraws, params.seed
            ),
        ]
    }
}
