//! `measure`: volumes over the beat and what follows from them.

use serde_json::json;

use crate::cli::args::MeasureArgs;
use crate::cli::input::{in_unit, measured, opened_study, store};
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json, say};
use crate::cli::tables;
use crate::engine::replace_results;
use crate::report::{SubjectRow, subjects_json};
use crate::study::{Severity, Study};

pub(super) fn measure(args: &MeasureArgs) -> Result<(), CliError> {
    let study = in_unit(opened_study(&args.study)?, args.unit);
    say_warnings(&study);
    let measures = measured(&store()?, &study)?;
    let files = tables::measure_files(&study, &measures, &args.out);
    let written = replace_results(&args.out, files).map_err(CliError::Unusable)?;
    let rows = SubjectRow::of_study(&study, &measures);
    if args.json {
        let files: Vec<String> = written
            .iter()
            .map(|path| path.display().to_string())
            .collect();
        let subjects = subjects_json(&rows);
        return print_json(&json!({ "files": files, "subjects": subjects }));
    }
    let mut lines = vec![tables::overview(&rows)];
    lines.extend(remarks(&rows));
    lines.push(args.out.display().to_string());
    print(&lines.join("\n"))
}

/// What is unusual or missing, a line per subject, and whose range it is.
fn remarks(rows: &[SubjectRow]) -> Vec<String> {
    let mut lines = Vec::new();
    let mut any_outside = false;
    for row in rows {
        let parts: Vec<&str> = [row.outside_range.as_str(), &row.notes]
            .into_iter()
            .filter(|part| !part.is_empty())
            .collect();
        any_outside |= !row.outside_range.is_empty();
        if !parts.is_empty() {
            lines.push(format!("{}: {}", row.subject, parts.join("; ")));
        }
    }
    if any_outside {
        lines.push(
            "ranges are those of healthy adults of either sex: EF by Lang 2015, volumes and mass by Kawel-Boehm 2015"
                .to_owned(),
        );
    }
    lines
}

/// Warnings of the load report about subjects on standard error: a number in a table does not show them. Beyond so many
/// lines they are counted.
pub(super) fn say_warnings(study: &Study) {
    const LINES: usize = 20;
    let warnings: Vec<String> = (study.subjects.iter())
        .flat_map(|subject| {
            let warnings =
                (subject.notices.iter()).filter(|notice| notice.severity == Severity::Warning);
            warnings.map(|notice| format!("cardiomorph: {}: warning: {}", subject.id, notice.text))
        })
        .collect();
    for line in warnings.iter().take(LINES) {
        say(line);
    }
    if warnings.len() > LINES {
        say(&format!(
            "cardiomorph: {} more warnings, listed by `cardiomorph info`",
            warnings.len() - LINES
        ));
    }
}
