//! Experiments as tables for scripts: names and order of columns are fixed, shares are in percent.

use crate::analysis::experiments::{
    InterpolationStudy, MetricComparison, NoiseDeformationResult, NoiseReference, PartnerStudy,
    RuleShare, TransportStudy,
};

use super::report_csv::Table;

/// The noise study: a row per method, reading, family and level; `kind` is the object, or "all" for
/// the mean over objects, which alone has a standard error. `published` is table 3.1.
pub fn noise_csv(result: &NoiseDeformationResult) -> String {
    let mut table = Table::new(&[
        "method",
        "family",
        "percent",
        "percent_of",
        "object",
        "tau_percent",
        "standard_error",
        "baseline",
        "published",
    ]);
    for cell in &result.cells {
        let head = |object: &str| {
            vec![
                cell.method.to_owned(),
                cell.family.map_or("clean", |f| f.name()).to_owned(),
                cell.percent.to_string(),
                reference_word(cell.reference).to_owned(),
                object.to_owned(),
            ]
        };
        let mut row = head("all");
        row.extend([
            percent(cell.tau),
            percent(cell.standard_error),
            percent(cell.baseline),
            cell.published.map_or_else(String::new, percent),
        ]);
        table.row(row);
        for (object, tau) in &cell.by_object {
            let mut row = head(object.name());
            row.extend([percent(*tau), String::new(), String::new(), String::new()]);
            table.row(row);
        }
    }
    table.text
}

/// The comparison of metrics: a row per level and method.
pub fn comparison_csv(comparison: &MetricComparison) -> String {
    let mut header: Vec<String> = ["noise_percent", "method", "labelled", "copies"]
        .map(str::to_owned)
        .to_vec();
    for rule in ["nearest_neighbour", "linear_rule", "plane_rule", "tau"] {
        header.extend(
            ["percent", "standard_error", "baseline"].map(|column| format!("{rule}_{column}")),
        );
    }
    let mut table = Table::new(&header);
    for row in &comparison.rows {
        let mut cells = vec![
            row.percent.to_string(),
            row.method.to_owned(),
            row.labelled.to_string(),
            row.copies.to_string(),
        ];
        let rules = [
            row.nearest_neighbour,
            row.linear_rule,
            row.plane_rule,
            row.tau,
        ];
        cells.extend(rules.iter().flat_map(|rule: &RuleShare| {
            [rule.share, rule.standard_error, rule.baseline].map(percent)
        }));
        table.row(cells);
    }
    table.text
}

/// The study of partners: a row per way of carrying and method.
pub fn partners_csv(study: &PartnerStudy) -> String {
    let mut table = Table::new(&[
        "transfer",
        "method",
        "pairs",
        "nearer_than_median",
        "nearest",
        "mean_rank",
        "nearest_by_chance",
        "mean_rank_by_chance",
        "mean_distance",
    ]);
    for row in &study.rows {
        let ranks = &row.ranks;
        table.row([
            row.transport.to_owned(),
            row.method.to_owned(),
            ranks.pairs.to_string(),
            ranks.nearer_than_median.to_string(),
            ranks.nearest.to_string(),
            ranks.mean_rank.to_string(),
            ranks.nearest_by_chance.to_string(),
            ranks.mean_rank_by_chance.to_string(),
            ranks.mean_distance.to_string(),
        ]);
    }
    table.text
}

/// The study of transfer: a row per deformation.
pub fn transfer_study_csv(study: &TransportStudy) -> String {
    let mut table = Table::new(&[
        "source",
        "target",
        "motion",
        "relative_error",
        "cosine",
        "norm_ratio",
        "flipped_faces",
        "followed",
    ]);
    for case in &study.cases {
        table.row([
            case.object.name().to_owned(),
            case.target.to_owned(),
            case.motion.name().to_owned(),
            case.relative_error.to_string(),
            case.cosine.to_string(),
            case.norm_ratio.to_string(),
            case.flipped_faces.to_string(),
            case.followed.to_string(),
        ]);
    }
    table.text
}

/// The study of interpolation: a row per object and motion.
pub fn interpolation_csv(study: &InterpolationStudy) -> String {
    let mut table = Table::new(&[
        "object",
        "motion",
        "energy_over_linear",
        "longest_over_shortest_step",
        "least_volume_ratio",
        "greatest_volume_ratio",
        "midpoint_error",
        "self_intersections",
    ]);
    for case in &study.cases {
        table.row([
            case.object.name().to_owned(),
            case.motion.name().to_owned(),
            case.energy_ratio.to_string(),
            case.step_ratio.to_string(),
            case.volume_ratios[0].to_string(),
            case.volume_ratios[1].to_string(),
            case.midpoint_error.to_string(),
            case.self_intersections.to_string(),
        ]);
    }
    table.text
}

/// The word for what a level is a share of.
pub(super) fn reference_word(reference: NoiseReference) -> &'static str {
    match reference {
        NoiseReference::Shape => "shape",
        NoiseReference::Displacement => "displacement",
    }
}

/// A share in percent, to a hundredth.
fn percent(share: f64) -> String {
    ((share * 1e4).round() / 100.0).to_string()
}
