//! `summary.json`: what was analysed, with which settings, and how well the map keeps the distances.

use std::io::Write;

use serde_json::{Map, Value, json};

use crate::analysis::embedding::{Embedding, MapMethod};
use crate::analysis::measures::{PhaseSource, SubjectMeasures};
use crate::analysis::metrics::{Corners, Form, MetricKind, MetricParams, Regulariser};
use crate::analysis::pose_distances::PoseDistances;
use crate::study::{LabelRole, Study};

use super::report_csv::{ReportError, rows};

/// Everything that a summary tells of a map of poses.
#[derive(Clone, Copy, Debug)]
pub struct MapSummary<'a> {
    /// The metric that the distances were computed with.
    pub metric: &'a MetricParams,
    /// The distances and who took part.
    pub distances: &'a PoseDistances,
    /// How the map was made.
    pub method: MapMethod,
    /// The map.
    pub map: &'a Embedding,
}

/// The summary of an analysis as one JSON object; `map` is `null` where none was made.
///
/// # Errors
/// If measures are not one per subject.
pub fn summary(
    study: &Study,
    measures: &[SubjectMeasures],
    map: Option<MapSummary<'_>>,
) -> Result<Value, ReportError> {
    let frames: usize = measures.iter().map(|measured| measured.frames.len()).sum();
    Ok(json!({
        "program": env!("CARGO_PKG_NAME"),
        "version": env!("CARGO_PKG_VERSION"),
        "study": study.name,
        "subjects": study.subjects.len(),
        "frames": frames,
        "labels": labels(study),
        "measures": measures_summary(study, measures)?,
        "metric": map.map(|map| metric(map.metric)),
        "map": map.map(|map| map_summary(study, &map)),
    }))
}

/// Writes [`summary`], indented, with a line end.
///
/// # Errors
/// If measures are not one per subject, or writing fails.
pub fn write_summary_json(
    study: &Study,
    measures: &[SubjectMeasures],
    map: Option<MapSummary<'_>>,
    mut out: impl Write,
) -> Result<(), ReportError> {
    serde_json::to_writer_pretty(&mut out, &summary(study, measures, map)?)?;
    out.write_all(b"\n")?;
    Ok(out.flush()?)
}

/// Settings of a metric, in the words of the command line.
pub fn metric(params: &MetricParams) -> Value {
    json!({
        "metric": match params.kind {
            MetricKind::Isometric => "isometric",
            MetricKind::Rigid => "rigid",
            MetricKind::AnglePreserving => "angle-preserving",
            MetricKind::QuasiConformal => "quasi-conformal",
        },
        "form": match params.form {
            Form::Printed => "printed",
            Form::Bilinear => "bilinear",
            Form::Frozen => "frozen",
            Form::Additive => "additive",
        },
        "corners": match params.corners {
            Corners::Raw => "raw",
            Corners::ScaleFree => "scale-free",
        },
        "area_weights": if params.area_weights { "on" } else { "off" },
        "mu": params.mu,
        "curvature_rings": params.curvature_rings,
        "lambda": params.lambda,
        "regulariser": match params.regulariser {
            Regulariser::Uniform => "uniform",
            Regulariser::Area => "area",
        },
    })
}

/// How many subjects carry each label, in the order of the labels; those without one last.
fn labels(study: &Study) -> Value {
    let mut names: Vec<&str> = study
        .subjects
        .iter()
        .filter_map(|subject| subject.label.as_deref())
        .collect();
    names.sort_unstable();
    let mut counts: Map<String, Value> = names
        .chunk_by(|a, b| a == b)
        .map(|run| (run[0].to_owned(), json!(run.len())))
        .collect();
    let without = study.subjects.len() - names.len();
    if without > 0 {
        counts.insert(String::new(), json!(without));
    }
    Value::Object(counts)
}

fn measures_summary(study: &Study, measures: &[SubjectMeasures]) -> Result<Value, ReportError> {
    let fractions: Vec<(LabelRole, f64)> = rows(study, measures)?
        .filter_map(|(subject, measured)| Some((study.role(subject), measured.ef?)))
        .collect();
    let mean = |role: LabelRole| {
        let of_role: Vec<f64> = fractions
            .iter()
            .filter(|(its, _)| *its == role)
            .map(|(_, ef)| *ef)
            .collect();
        (!of_role.is_empty()).then(|| of_role.iter().sum::<f64>() / of_role.len() as f64)
    };
    let stated = measures
        .iter()
        .filter(|measured| measured.phase_source == PhaseSource::Stated)
        .count();
    Ok(json!({
        "with_ejection_fraction": fractions.len(),
        "with_stated_phases": stated,
        "mean_ef_normal": mean(LabelRole::Normal),
        "mean_ef_abnormal": mean(LabelRole::Abnormal),
        "mean_ef_unlabelled": mean(LabelRole::Unknown),
    }))
}

fn map_summary(study: &Study, of: &MapSummary<'_>) -> Value {
    let left_out: Vec<Value> = of
        .distances
        .left_out
        .iter()
        .map(|left_out| {
            let id = study.subjects.get(left_out.subject).map(|s| s.id.as_str());
            json!({ "subject": id, "reason": left_out.reason })
        })
        .collect();
    json!({
        "method": match of.method {
            MapMethod::ClassicalMds => "mds",
            MapMethod::Smacof => "smacof",
        },
        "dimensions": of.map.dimensions,
        "poses": of.distances.poses.len(),
        "stress": of.map.stress,
        "iterations": of.map.iterations,
        "left_out": left_out,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::measure_study;
    use crate::analysis::pose_distances::{DistanceMatrix, LeftOut, PoseId};
    use crate::progress::Progress;
    use crate::study::built_in::{BuiltInParams, cohort};

    #[test]
    fn a_summary_tells_counts_settings_stress_and_version() {
        let params = BuiltInParams {
            vertices: 300,
            ..BuiltInParams::default()
        };
        let study = cohort(&params).unwrap().study;
        let measures = measure_study(&study, &Progress::default()).unwrap();
        let distances = PoseDistances {
            poses: vec![PoseId { subject: 0, frame: 0 }],
            distances: DistanceMatrix::from_upper(1, Vec::new()).unwrap(),
            left_out: vec![LeftOut {
                subject: 22,
                reason: "another connectivity".to_owned(),
            }],
        };
        let map = Embedding {
            dimensions: 2,
            coordinates: vec![0.0, 0.0],
            stress: Some(0.125),
            eigenvalues: None,
            iterations: Some(17),
        };
        let of_map = MapSummary {
            metric: &MetricParams::default(),
            distances: &distances,
            method: MapMethod::Smacof,
            map: &map,
        };
        let told = summary(&study, &measures, Some(of_map)).unwrap();
        assert_eq!(told["version"], env!("CARGO_PKG_VERSION"));
        assert_eq!((&told["subjects"], &told["frames"]), (&json!(23), &json!(184)));
        assert_eq!(told["labels"], json!({ "abnormal": 14, "normal": 9 }));
        assert_eq!(told["metric"]["corners"], "scale-free");
        assert_eq!(told["map"]["stress"], 0.125);
        assert_eq!(told["map"]["left_out"][0]["subject"], "P14");
        let normal = told["measures"]["mean_ef_normal"].as_f64().unwrap();
        assert!(normal > told["measures"]["mean_ef_abnormal"].as_f64().unwrap());
        let write = || {
            let mut bytes = Vec::new();
            write_summary_json(&study, &measures, Some(of_map), &mut bytes).unwrap();
            bytes
        };
        assert_eq!(write(), write());
    }

    #[test]
    fn without_a_map_its_place_is_null() {
        let told = summary(&Study::default(), &[], None).unwrap();
        assert!(told["map"].is_null() && told["metric"].is_null());
        assert!(summary(&Study::default(), &[], None).is_ok());
    }
}
