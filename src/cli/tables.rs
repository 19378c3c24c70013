//! Which tables a command writes, and the overview that it prints.

use std::path::Path;

use crate::analysis::measures::SubjectMeasures;
use crate::engine::ExportFile;
use crate::io::{frames_csv, subjects_csv};
use crate::study::Study;

/// `frames.csv` and `subjects.csv`.
pub(super) fn measure_files(
    study: &Study,
    measures: &[SubjectMeasures],
    folder: &Path,
) -> Vec<ExportFile> {
    vec![
        ExportFile::text(folder, "frames.csv", frames_csv(study, measures)),
        ExportFile::text(folder, "subjects.csv", subjects_csv(study, measures)),
    ]
}

/// A line per subject for people: EF in percent, volumes with their unit.
pub(super) fn overview(study: &Study, measures: &[SubjectMeasures]) -> String {
    let widest = study.subjects.iter().map(|s| s.id.chars().count()).max();
    let width = widest.unwrap_or(0).max("subject".len());
    let mut lines = vec![format!(
        "{:width$}  {:>6}  {:>10}  {:>10}  unit  ED  ES  label",
        "subject", "EF %", "EDV", "ESV"
    )];
    let shown = |value: Option<f64>| value.map_or_else(|| "–".to_owned(), |v| format!("{v:.1}"));
    let frame = |value: Option<usize>| value.map_or_else(|| "–".to_owned(), |v| v.to_string());
    for (subject, measured) in study.subjects.iter().zip(measures) {
        lines.push(format!(
            "{:width$}  {:>6}  {:>10}  {:>10}  {:4}  {:>2}  {:>2}  {}",
            subject.id,
            shown(measured.ef.map(|ef| 100.0 * ef)),
            shown(measured.edv),
            shown(measured.esv),
            measured.unit.volume_symbol(),
            frame(measured.end_diastole),
            frame(measured.end_systole),
            subject.label.as_deref().unwrap_or(""),
        ));
    }
    lines
        .iter()
        .map(|line| line.trim_end())
        .collect::<Vec<_>>()
        .join("\n")
}
