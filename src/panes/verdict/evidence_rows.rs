//! The numbers that speak for a verdict, each beside those of the normal subjects.

use crate::analysis::verdicts::{Feature, FeatureUnit, Features, Verdicts};
use crate::panes::EvidenceRow;
use crate::study::{LabelClass, Study};

/// What is shown below the features of the model: those of the method (4.4–4.7) and what the patch table knows.
const FURTHER: [Feature; 7] = [
    Feature::Remote,
    Feature::PatchThickening,
    Feature::Confidence,
    Feature::Compactness,
    Feature::MeanPoseDistance,
    Feature::NormalSpread,
    Feature::MeanPositionDistance,
];

/// The rows of one subject, beside the subjects of the study that are assessed.
pub fn evidence(study: &Study, verdicts: &Verdicts, own: &Features) -> Vec<EvidenceRow> {
    let assessed: Vec<(LabelClass, &Features)> = (study.subjects.iter().zip(&verdicts.subjects))
        .filter_map(|(subject, verdict)| {
            Some((study.class_of(subject), &verdict.as_ref().ok()?.features))
        })
        .collect();
    (Feature::MODEL_FEATURES.into_iter().chain(FURTHER))
        .map(|feature| {
            let all = assessed.iter().map(|(_, features)| features.get(feature));
            let whole = range(all);
            let normal = (assessed.iter())
                .filter(|(class, _)| *class == LabelClass::Normal)
                .map(|(_, features)| features.get(feature));
            let normal = range(normal);
            let value = own.get(feature);
            let place = |value: f64| {
                let [least, most] = whole?;
                (most > least).then(|| ((value - least) / (most - least)) as f32)
            };
            EvidenceRow {
                name: feature.name(),
                what: feature.explanation(),
                value: value.map_or_else(|| "no value".to_owned(), |value| written(feature, value)),
                normal: normal.map_or_else(String::new, |range| range_text(feature.unit(), range)),
                place: value.and_then(place),
                band: normal.and_then(|[least, most]| Some([place(least)?, place(most)?])),
                model_feature: verdicts.features.contains(&feature),
            }
        })
        .collect()
}

/// A feature as its row writes it.
pub fn written(feature: Feature, value: f64) -> String {
    text(feature.unit(), value)
}

/// The least and the greatest of what is told.
fn range(values: impl Iterator<Item = Option<f64>>) -> Option<[f64; 2]> {
    values.flatten().fold(None, |range, value| match range {
        None => Some([value; 2]),
        Some([least, most]) => Some([least.min(value), most.max(value)]),
    })
}

fn text(unit: FeatureUnit, value: f64) -> String {
    let (number, symbol) = parts(unit, value);
    format!("{number}{symbol}")
}

/// "0–5 %": the unit once; "to" where a sign could be taken for the dash.
fn range_text(unit: FeatureUnit, range: [f64; 2]) -> String {
    let [(least, symbol), (most, _)] = range.map(|value| parts(unit, value));
    let dash = if range[0] < 0.0 { " to " } else { "–" };
    format!("{least}{dash}{most}{symbol}")
}

/// Logarithms of PT are written as growth in percent, radians as degrees.
fn parts(unit: FeatureUnit, value: f64) -> (String, &'static str) {
    let (value, places, symbol) = match unit {
        FeatureUnit::Share => (100.0 * value, 0, " %"),
        FeatureUnit::LnPt => (100.0 * value.exp_m1(), 0, " %"),
        FeatureUnit::Ratio => (value, 2, ""),
        FeatureUnit::PoseDistance => (value, 3, ""),
        FeatureUnit::Radians => (value.to_degrees(), 1, "°"),
        FeatureUnit::Sizes => (100.0 * value, 1, " %"),
        FeatureUnit::Millimetres => (value, 1, " mm"),
        FeatureUnit::MillilitresPerSquareMetre => (value, 0, " ml/m²"),
        FeatureUnit::GramsPerSquareMetre => (value, 0, " g/m²"),
        FeatureUnit::GramsPerMillilitre => (value, 2, " g/ml"),
    };
    let number = format!("{value:.places$}");
    // A true minus, and no minus zero.
    let zero = number.trim_start_matches('-').parse() == Ok(0.0);
    let number = if zero {
        number.replace('-', "")
    } else {
        number.replace('-', "−")
    };
    (number, symbol)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_units_and_a_true_minus() {
        assert_eq!(text(FeatureUnit::Share, 0.312), "31 %");
        assert_eq!(text(FeatureUnit::LnPt, -0.05), "−5 %");
        assert_eq!(text(FeatureUnit::LnPt, -0.001), "0 %");
        assert_eq!(text(FeatureUnit::Radians, 0.1), "5.7°");
        assert_eq!(range_text(FeatureUnit::Share, [0.0, 0.05]), "0–5 %");
        assert_eq!(range_text(FeatureUnit::LnPt, [-0.05, 0.5]), "−5 to 65 %");
    }

    #[test]
    fn no_feature_is_shown_twice() {
        assert!(
            FURTHER
                .iter()
                .all(|further| !Feature::MODEL_FEATURES.contains(further))
        );
    }
}
