//! Settings of an analysis in words: what summaries, figures and the activity list say of them.

use crate::analysis::medial::MedialParams;
use crate::analysis::medial_space::RatioForm;
use crate::analysis::thickening::{ThickeningParams, ThickeningSettings};

/// How medial spheres are fitted, as summaries and the activity list say it.
pub fn medial_words(params: &MedialParams) -> String {
    let smoothing = match params.smoothing {
        0.0 => "no smoothing".to_owned(),
        share => format!("smoothed over {share} thicknesses"),
    };
    format!(
        "{smoothing}, separation {}, end {}",
        degrees(params.separation_rad),
        degrees(params.end_rad)
    )
}

/// An angle as a person would say it; rounding of radians leaves no trace.
fn degrees(angle_rad: f64) -> String {
    format!("{}°", (angle_rad.to_degrees() * 1e6).round() / 1e6)
}

/// Settings of the search for patches, as summaries and the activity list say it.
pub fn thickening_words(settings: &ThickeningSettings) -> String {
    let ThickeningParams {
        tolerance,
        ratio,
        core_threshold,
        akinetic_threshold,
        extent_threshold,
        min_share,
        min_thickening,
        smoothing,
        redraws,
        seed,
    } = settings.patches;
    let tolerance =
        tolerance.map_or_else(|| "estimated from noise".to_owned(), |t| format!("± {t}"));
    let ratio = match ratio {
        RatioForm::GeometricMean => "geometric mean",
        RatioForm::Product => "product",
    };
    format!(
        "{}, tolerance of ln PT {tolerance}, ratio as {ratio}, core threshold {core_threshold}, akinetic threshold {akinetic_threshold:.3}, \
         extent threshold {extent_threshold}, minimum area {min_share}, minimum thickening {min_thickening:.3}, \
         averaged over {smoothing}, \
         {redraws} redraws, seed {seed}",
        medial_words(&settings.medial)
    )
}
