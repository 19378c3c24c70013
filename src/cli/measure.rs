//! `measure`: volumes over the beat and what follows from them.

use serde_json::json;

use crate::cli::args::MeasureArgs;
use crate::cli::input::{measured, opened_study, store};
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::tables;
use crate::engine::write_files;
use crate::report::{SubjectRow, subjects_json};

pub(super) fn measure(args: &MeasureArgs) -> Result<(), CliError> {
    let study = opened_study(&args.study)?;
    let measures = measured(&store()?, &study)?;
    let files = tables::measure_files(&study, &measures, &args.out);
    let written = write_files(files).map_err(CliError::Unusable)?;
    let rows = SubjectRow::of_study(&study, &measures);
    if args.json {
        let files: Vec<String> = written
            .iter()
            .map(|path| path.display().to_string())
            .collect();
        let subjects = subjects_json(&rows);
        return print_json(&json!({ "files": files, "subjects": subjects }));
    }
    print(&format!(
        "{}\n{}",
        tables::overview(&rows),
        args.out.display()
    ))
}
