//! Noise on medial surfaces and the finding of patches as tables for scripts: names and order of columns are fixed.

use crate::analysis::experiments::{LocalisationRow, MeanAndError, MedialNoiseResult};

use super::report_csv::Table;

/// Noise on medial surfaces: a row per way of telling, family and level, shares in percent. `published` is table 4.2.
pub fn noise_medial_csv(result: &MedialNoiseResult) -> String {
    let mut table = Table::new(&[
        "method",
        "family",
        "percent",
        "tau_percent",
        "standard_error",
        "baseline",
        "specificity_percent",
        "sensitivity_percent",
        "published",
    ]);
    for cell in &result.cells {
        table.row([
            cell.method.name().to_owned(),
            cell.family.map_or("clean", |f| f.name()).to_owned(),
            cell.percent.to_string(),
            percent(cell.tau),
            percent(cell.standard_error),
            percent(cell.baseline),
            percent(cell.specificity),
            percent(cell.sensitivity),
            cell.published.map_or_else(String::new, percent),
        ]);
    }
    table.text
}

/// The finding of patches: a row per kind of sheet, family and level. Cells are empty where there is nothing to say.
pub fn localisation_csv(rows: &[LocalisationRow]) -> String {
    let mut header: Vec<String> = ["patches", "patch_percent", "family", "percent", "sheets"]
        .map(str::to_owned)
        .to_vec();
    for quantity in [
        "found_percent",
        "false_patches",
        "dice",
        "centroid_mm",
        "segments_agreeing_percent",
        "main_segment_percent",
    ] {
        header.extend([quantity.to_owned(), format!("{quantity}_standard_error")]);
    }
    header.extend(
        [
            "gap_of_all_percent",
            "gap_of_patch_percent",
            "normal_spread_of_all_rad",
            "normal_spread_of_patch_rad",
        ]
        .map(str::to_owned),
    );
    let mut table = Table::new(&header);
    for row in rows {
        let mut cells = vec![
            row.patches.to_string(),
            percent(row.share),
            row.family.map_or("clean", |f| f.name()).to_owned(),
            row.percent.to_string(),
            row.sheets.to_string(),
        ];
        cells.extend(pair(row.found, 100.0));
        cells.extend(pair(Some(row.false_patches), 1.0));
        cells.extend(pair(row.dice, 1.0));
        cells.extend(pair(row.centroid_mm, 1.0));
        cells.extend(pair(row.segments, 100.0));
        cells.extend(pair(row.main_segment, 100.0));
        let single = (row.gaps_percent.iter()).chain(&row.normal_spreads_rad);
        cells.extend(single.map(|value| value.map_or_else(String::new, rounded)));
        table.row(cells);
    }
    table.text
}

fn pair(value: Option<MeanAndError>, scale: f64) -> [String; 2] {
    value.map_or_else(
        || [String::new(), String::new()],
        |(mean, error)| [rounded(scale * mean), rounded(scale * error)],
    )
}

/// A share in percent, to a hundredth.
fn percent(share: f64) -> String {
    ((share * 1e4).round() / 100.0).to_string()
}

/// To a thousandth.
fn rounded(value: f64) -> String {
    ((value * 1e3).round() / 1e3).to_string()
}
