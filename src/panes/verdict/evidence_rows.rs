//! The numbers that speak for a verdict, each beside those of the normal subjects.

use crate::analysis::verdicts::{Feature, Features, Verdicts};
use crate::panes::EvidenceRow;
use crate::study::{LabelRole, Study};

/// How a number is written.
#[derive(Clone, Copy)]
enum Written {
    /// A share, as percent.
    Share,
    /// A logarithm of a ratio, as percent of growth.
    Growth,
    /// A ratio, with two places.
    Ratio,
    /// A distance without a unit, with three places.
    Distance,
    /// Radians, as degrees.
    Degrees,
    /// A share of the heart's size, as percent with one place.
    OfSize,
    /// In a unit, with the places that it is known to.
    In(&'static str, usize),
}

/// A feature as it is shown: what it is, how it is written.
type Shown = (Feature, &'static str, Written);

/// What is shown, in this order: first those of [`Feature::MODEL_FEATURES`], of the wall and of the whole heart, then those
/// of the method (4.4–4.7) and what the patch table knows.
const SHOWN: [Shown; 24] = [
    (
        Feature::AkineticShare,
        "Share of the wall with thickening below 10 % from end-diastole to end-systole",
        Written::Share,
    ),
    (
        Feature::Median,
        "Median over the wall of thickening from end-diastole to end-systole",
        Written::Growth,
    ),
    (
        Feature::RelativeSpread,
        "Spread of thickening over the wall, relative to the thickening of remote myocardium; 0 for uniform \
         thickening",
        Written::Ratio,
    ),
    (
        Feature::EjectionFraction,
        "Stroke volume relative to end-diastolic volume",
        Written::Share,
    ),
    (
        Feature::EdvIndex,
        "End-diastolic volume relative to body surface (Mosteller); no value without height and weight",
        Written::In(" ml/m²", 0),
    ),
    (
        Feature::EsvIndex,
        "End-systolic volume relative to body surface (Mosteller); no value without height and weight",
        Written::In(" ml/m²", 0),
    ),
    (
        Feature::MassIndex,
        "Mass of the myocardium relative to body surface (Mosteller); no value without height and weight",
        Written::In(" g/m²", 0),
    ),
    (
        Feature::MassToVolume,
        "Mass of the myocardium relative to end-diastolic volume: large where the wall is thick for its cavity",
        Written::In(" g/ml", 2),
    ),
    (
        Feature::WallEd,
        "Median over the wall of its thickness at end-diastole",
        Written::In(" mm", 1),
    ),
    (
        Feature::ThickestEd,
        "95th percentile over the wall of its thickness at end-diastole",
        Written::In(" mm", 1),
    ),
    (
        Feature::ThicknessRatio,
        "95th percentile of wall thickness at end-diastole relative to its median: 1 for a wall of one thickness",
        Written::Ratio,
    ),
    (
        Feature::WallEs,
        "Median over the wall of its thickness at end-systole",
        Written::In(" mm", 1),
    ),
    (
        Feature::ThickestEs,
        "95th percentile over the wall of its thickness at end-systole",
        Written::In(" mm", 1),
    ),
    (
        Feature::SphericityEd,
        "Volume of the cavity at end-diastole relative to a sphere whose diameter is the long axis",
        Written::Ratio,
    ),
    (
        Feature::SphericityEs,
        "Volume of the cavity at end-systole relative to a sphere whose diameter is the long axis",
        Written::Ratio,
    ),
    (
        Feature::InwardSpread,
        "Standard deviation over the inner surface of its motion towards the centroid, relative to the distance there",
        Written::Share,
    ),
    (
        Feature::InwardTenth,
        "10th percentile over the inner surface of its motion towards the centroid, relative to the distance there",
        Written::Share,
    ),
    (
        Feature::Remote,
        "Thickening of remote myocardium from end-diastole to end-systole",
        Written::Growth,
    ),
    (
        Feature::PatchThickening,
        "Thickening of the largest patch relative to that of remote myocardium: 0 without thickening, 1 without a \
         patch",
        Written::Ratio,
    ),
    (
        Feature::Confidence,
        "Share of noise redraws in which the largest patch is detected again; 0 without a patch",
        Written::Share,
    ),
    (
        Feature::Compactness,
        "4π × area / perimeter² of the largest patch: 1 for a disc, small for an irregular outline, 0 without a \
         patch",
        Written::Ratio,
    ),
    (
        Feature::MeanPoseDistance,
        "Mean distance between poses in the shape space of the largest patch or, without one, of the akinetic \
         region: small for a region that changes little over the cycle",
        Written::Distance,
    ),
    (
        Feature::NormalSpread,
        "Angular standard deviation over the cycle of the average normal vector (ANV) of the largest patch or of the akinetic region",
        Written::Degrees,
    ),
    (
        Feature::MeanPositionDistance,
        "Mean distance to the medial surface of the mean position (MP) of the largest patch or of the akinetic \
         region, in percent of the size of the heart: small for one compact patch",
        Written::OfSize,
    ),
];

/// The rows of one subject, beside the subjects of the study that are assessed.
pub fn evidence(study: &Study, verdicts: &Verdicts, own: &Features) -> Vec<EvidenceRow> {
    let assessed: Vec<(LabelRole, &Features)> = (study.subjects.iter().zip(&verdicts.subjects))
        .filter_map(|(subject, told)| Some((study.role(subject), &told.as_ref().ok()?.features)))
        .collect();
    SHOWN
        .into_iter()
        .map(|(feature, what, written)| {
            let all = assessed.iter().map(|(_, features)| features.get(feature));
            let whole = range(all);
            let normal = (assessed.iter())
                .filter(|(role, _)| *role == LabelRole::Normal)
                .map(|(_, features)| features.get(feature));
            let normal = range(normal);
            let value = own.get(feature);
            let place = |value: f64| {
                let [least, most] = whole?;
                (most > least).then(|| ((value - least) / (most - least)) as f32)
            };
            EvidenceRow {
                name: feature.name(),
                what,
                value: value.map_or_else(|| "no value".to_owned(), |value| text(written, value)),
                normal: normal.map_or_else(String::new, |range| range_text(written, range)),
                place: value.and_then(place),
                band: normal.and_then(|[least, most]| Some([place(least)?, place(most)?])),
                model_feature: verdicts.features.contains(&feature),
            }
        })
        .collect()
}

/// A feature as its row writes it.
pub fn written(feature: Feature, value: f64) -> String {
    let row = SHOWN.iter().find(|(shown, ..)| *shown == feature);
    row.map_or_else(|| format!("{value:.2}"), |row| text(row.2, value))
}

/// The least and the greatest of what is told.
fn range(values: impl Iterator<Item = Option<f64>>) -> Option<[f64; 2]> {
    values.flatten().fold(None, |range, value| match range {
        None => Some([value; 2]),
        Some([least, most]) => Some([least.min(value), most.max(value)]),
    })
}

fn text(written: Written, value: f64) -> String {
    let (number, unit) = parts(written, value);
    format!("{number}{unit}")
}

/// "0–5 %": the unit once; "to" where a sign could be taken for the dash.
fn range_text(written: Written, range: [f64; 2]) -> String {
    let [(least, unit), (most, _)] = range.map(|value| parts(written, value));
    let dash = if range[0] < 0.0 { " to " } else { "–" };
    format!("{least}{dash}{most}{unit}")
}

fn parts(written: Written, value: f64) -> (String, &'static str) {
    let (value, places, unit) = match written {
        Written::Share => (100.0 * value, 0, " %"),
        Written::Growth => (100.0 * value.exp_m1(), 0, " %"),
        Written::Ratio => (value, 2, ""),
        Written::Distance => (value, 3, ""),
        Written::Degrees => (value.to_degrees(), 1, "°"),
        Written::OfSize => (100.0 * value, 1, " %"),
        Written::In(unit, places) => (value, places, unit),
    };
    let number = format!("{value:.places$}");
    // A true minus, and no minus zero.
    let zero = number.trim_start_matches('-').parse() == Ok(0.0);
    let number = if zero {
        number.replace('-', "")
    } else {
        number.replace('-', "−")
    };
    (number, unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_units_and_a_true_minus() {
        assert_eq!(text(Written::Share, 0.312), "31 %");
        assert_eq!(text(Written::Growth, -0.05), "−5 %");
        assert_eq!(text(Written::Growth, -0.001), "0 %");
        assert_eq!(text(Written::Degrees, 0.1), "5.7°");
        assert_eq!(range_text(Written::Share, [0.0, 0.05]), "0–5 %");
        assert_eq!(range_text(Written::Growth, [-0.05, 0.5]), "−5 to 65 %");
    }

    #[test]
    fn what_the_rule_reads_comes_first() {
        let read = SHOWN.map(|(feature, ..)| feature);
        assert_eq!(read[..17], Feature::MODEL_FEATURES);
    }
}
