//! `experiment noise-medial`: medial surfaces with and without a patch under noise, and patches found where they are.

use crate::analysis::experiments::{
    LocalisationParams, LocalisationRow, MeanAndError, MedialNoiseParams, MedialNoiseResult,
    localisation, noise_medial as told_apart,
};
use crate::cli::experiment_args::NoiseMedialArgs;
use crate::cli::outcome::CliError;
use crate::cli::print::{pretty, print, print_json};
use crate::cli::work::run_work;
use crate::engine::{ExportFile, write_files};
use crate::io::{localisation_csv, noise_medial_csv, noise_medial_json, noise_medial_svg};

/// Section 4.6.
pub(super) fn noise_medial(args: &NoiseMedialArgs) -> Result<(), CliError> {
    let params = MedialNoiseParams {
        redraws: args.redraws,
        per_class: args.per_class,
        seed: args.seed,
        ..MedialNoiseParams::default()
    };
    let places = LocalisationParams {
        redraws: args.redraws,
        per_kind: args.per_size,
        seed: args.seed,
        ..LocalisationParams::default()
    };
    let result = run_work(move |progress| {
        progress.begin_phase("classifying noisy medial surfaces", 0.0, 1.0);
        told_apart(&params, progress)
    })?;
    let rows = run_work(move |progress| {
        progress.begin_phase("finding patches", 0.0, 1.0);
        localisation(&places, progress)
    })?;
    let summary = noise_medial_json(&result, &rows);
    let files = vec![
        ExportFile::text(&args.out, "noise_medial.csv", noise_medial_csv(&result)),
        ExportFile::text(&args.out, "localisation.csv", localisation_csv(&rows)),
        ExportFile::text(
            &args.out,
            "noise_medial.svg",
            noise_medial_svg(&result, &rows),
        ),
        ExportFile::text(&args.out, "summary.json", pretty(&summary)?),
    ];
    write_files(files).map_err(CliError::Unusable)?;
    if args.json {
        return print_json(&summary);
    }
    let mut lines = result.protocol();
    lines.extend(noise_lines(&result));
    lines.extend(place_lines(&rows));
    lines.push(args.out.display().to_string());
    print(&lines.join("\n"))
}

fn noise_lines(result: &MedialNoiseResult) -> impl Iterator<Item = String> {
    let head = "\n| way | noise | τ | chance | without a patch | with a patch | table 4.2 |\n|---|---|---|---|---|---|---|";
    let cells = result.cells.iter().map(|cell| {
        let published = cell
            .published
            .map_or_else(String::new, |share| format!("{:.1}", 100.0 * share));
        let noise = cell.family.map_or_else(
            || "clean".to_owned(),
            |family| format!("{} {} %", family.name(), cell.percent),
        );
        format!(
            "| {} | {noise} | {:.1} ± {:.1} | {:.0} | {:.0} | {:.0} | {published} |",
            cell.method.name(),
            100.0 * cell.tau,
            100.0 * cell.standard_error,
            100.0 * cell.baseline,
            100.0 * cell.specificity,
            100.0 * cell.sensitivity,
        )
    });
    std::iter::once(head.to_owned()).chain(cells)
}

fn place_lines(rows: &[LocalisationRow]) -> impl Iterator<Item = String> {
    let head = "\n| patches | noise | found, % | false | Dice | centroid, mm | segments, % | main segment, % |\n|---|---|---|---|---|---|---|---|";
    let told = |value: Option<MeanAndError>, scale: f64, digits: usize| {
        value.map_or_else(String::new, |(mean, error)| {
            format!("{:.digits$} ± {:.digits$}", scale * mean, scale * error)
        })
    };
    let lines = rows.iter().map(move |row| {
        let noise = row.family.map_or_else(
            || "clean".to_owned(),
            |family| format!("{} {} %", family.name(), row.percent),
        );
        let patches = match row.patches {
            0 => "none".to_owned(),
            count => format!("{count} of {:.0} %", 100.0 * row.share),
        };
        format!(
            "| {patches} | {noise} | {} | {} | {} | {} | {} | {} |",
            told(row.found, 100.0, 0),
            told(Some(row.false_patches), 1.0, 2),
            told(row.dice, 1.0, 2),
            told(row.centroid_mm, 1.0, 1),
            told(row.segments, 100.0, 0),
            told(row.main_segment, 100.0, 0),
        )
    });
    std::iter::once(head.to_owned()).chain(lines)
}
