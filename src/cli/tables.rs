//! Which tables a command writes, and the overview that it prints.

use std::path::Path;

use crate::analysis::measures::SubjectMeasures;
use crate::cli::print::on_one_line;
use crate::engine::{ExportFile, columns_file};
use crate::report::{Column, Digits, FrameRow, SubjectRow, csv};
use crate::study::Study;
use crate::units::LengthUnit;

/// `frames.csv`, `subjects.csv`, and `columns.md`, which explains them.
pub(super) fn measure_files(
    study: &Study,
    measures: &[SubjectMeasures],
    folder: &Path,
) -> Vec<ExportFile> {
    let frames = csv(&FrameRow::of_frames(study, measures));
    let subjects = csv(&SubjectRow::of_study(study, measures));
    vec![
        ExportFile::text(folder, "frames.csv", frames),
        ExportFile::text(folder, "subjects.csv", subjects),
        columns_file(folder, &["frames.csv", "subjects.csv"].map(str::to_owned)),
    ]
}

/// A line per subject for people: EF in percent, volumes with their unit.
pub(super) fn overview(rows: &[SubjectRow]) -> String {
    let widest = (rows.iter())
        .map(|row| on_one_line(&row.subject).chars().count())
        .max();
    let width = widest.unwrap_or(0).max("subject".len());
    let head = format!(
        "{:width$}  {:>6}  {:>10}  {:>10}  unit  {}  {}  label",
        "subject",
        SubjectRow::EF
            .heading_with_unit(LengthUnit::default())
            .replace(',', ""),
        SubjectRow::EDV.heading,
        SubjectRow::ESV.heading,
        SubjectRow::END_DIASTOLE.heading,
        SubjectRow::END_SYSTOLE.heading,
    );
    let lines = rows.iter().map(|row| {
        let tenths = |column: Column<SubjectRow>| column.shown_with(Digits::Places(1), row);
        format!(
            "{:width$}  {:>6}  {:>10}  {:>10}  {:4}  {:>2}  {:>2}  {}",
            on_one_line(&row.subject),
            tenths(SubjectRow::EF),
            tenths(SubjectRow::EDV),
            tenths(SubjectRow::ESV),
            row.unit.volume_symbol(),
            SubjectRow::END_DIASTOLE.shown(row),
            SubjectRow::END_SYSTOLE.shown(row),
            on_one_line(row.label.as_deref().unwrap_or("")),
        )
    });
    let lines = std::iter::once(head).chain(lines);
    let trimmed = lines.map(|line| line.trim_end().to_owned());
    trimmed.collect::<Vec<String>>().join("\n")
}
