//! `experiment`: the experiments with noise, with transport and interpolation, of metrics on a labelled cohort, and of
//! partners.

use std::sync::Arc;

use serde_json::{Value, json};

use crate::analysis::experiments::{
    InterpolationExperimentParams, MetricComparisonParams, NoiseDeformationParams,
    NoiseDeformationResult, NoiseReference, PartnerParams, TransportExperiment,
    TransportExperimentParams, interpolation_experiment, metric_comparison, noise_deformation,
    partner_study, transport_experiment,
};
use crate::analysis::metrics::MetricParams;
use crate::analysis::transport::CohortTransportParams;
use crate::cli::experiment_args::{
    ExperimentCommand, MetricComparisonArgs, NoiseDeformationArgs, PartnerArgs,
};
use crate::cli::experiment_files::{figure_file, summary_file};
use crate::cli::experiment_medial::noise_medial;
use crate::cli::experiment_shares::shares;
use crate::cli::input::opened_study;
use crate::cli::map_options::reference;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::words::Switch;
use crate::cli::work::run_work;
use crate::engine::{ExportFile, write_files};
use crate::picture::noise_page;
use crate::report::{NoiseRow, comparison_json, csv, noise_json, partners_json};

pub(super) fn experiment(command: &ExperimentCommand) -> Result<(), CliError> {
    match command {
        ExperimentCommand::NoiseDeformation(args) => noise(args),
        ExperimentCommand::NoiseMedial(args) => noise_medial(args),
        ExperimentCommand::Metrics(args) => metrics(args),
        ExperimentCommand::Partners(args) => partners(args),
        ExperimentCommand::Shares(args) => shares(args),
    }
}

/// Section 3.4: noise, transport and interpolation of synthetic deformations.
fn noise(args: &NoiseDeformationArgs) -> Result<(), CliError> {
    let params = noise_params(args);
    let result = run_work(move |progress| {
        progress.begin_phase("classifying noisy deformations", 0.0, 1.0);
        noise_deformation(&params, progress)
    })?;
    let transported = run_work(|progress| {
        progress.begin_phase("transporting deformations", 0.0, 1.0);
        transport_experiment(&TransportExperimentParams::default(), progress)
    })?;
    let interpolations = run_work(|progress| {
        progress.begin_phase("interpolating deformations", 0.0, 1.0);
        interpolation_experiment(&InterpolationExperimentParams::default(), progress)
    })?;
    let mut summary = noise_json(&result);
    if let Value::Object(object) = &mut summary {
        object.insert("transferred".to_owned(), json!(transported.cases.len()));
        object.insert("followed".to_owned(), json!(followed(&transported)));
    }
    let files = vec![
        ExportFile::text(&args.out, "noise.csv", csv(&NoiseRow::of_result(&result))),
        figure_file(
            &args.out,
            "noise.svg",
            "Cluster agreement under noise",
            |fonts| noise_page(&result, fonts),
        )?,
        ExportFile::text(&args.out, "transfer.csv", csv(&transported.cases)),
        ExportFile::text(&args.out, "interpolation.csv", csv(&interpolations.cases)),
        summary_file(&args.out, &summary)?,
    ];
    write_files(files).map_err(CliError::Unusable)?;
    if args.json {
        return print_json(&summary);
    }
    print(&noise_table(&result))?;
    print(&format!(
        "parallel transport: {} of {} deformations reproduced on the target\n{}",
        followed(&transported),
        transported.cases.len(),
        args.out.display()
    ))
}

fn noise_params(args: &NoiseDeformationArgs) -> NoiseDeformationParams {
    let mut params = NoiseDeformationParams {
        redraws: args.redraws,
        seed: args.seed,
        ..NoiseDeformationParams::default()
    };
    params.cohort.per_class = args.per_class;
    if args.whole == Switch::Off {
        // The default metric, plain Procrustes and the printed metric; the others say why.
        params.methods.truncate(3);
        params.references = vec![NoiseReference::Shape];
    }
    params
}

fn followed(experiment: &TransportExperiment) -> usize {
    experiment.cases.iter().filter(|case| case.followed).count()
}

/// The protocol, then a line per cell.
fn noise_table(result: &NoiseDeformationResult) -> String {
    let mut lines = result.protocol();
    for cell in &result.cells {
        let published = cell.published.map_or_else(String::new, |share| {
            format!(", table 3.1 has {:.1}", 100.0 * share)
        });
        lines.push(format!(
            "{:28} {:9} {:5} %  τ {:5.1} ± {:.1} % (permutation mean {:.1}{published})",
            cell.method,
            cell.family.map_or("clean", |family| family.name()),
            cell.percent,
            100.0 * cell.tau,
            100.0 * cell.standard_error,
            100.0 * cell.baseline,
        ));
    }
    lines.join("\n")
}

/// Every metric and form on a labelled study and on its noisy copies.
fn metrics(args: &MetricComparisonArgs) -> Result<(), CliError> {
    let study = opened_study(&args.study)?;
    // Words of the first release, which had two answers here.
    let word = match args.transfer.as_str() {
        "off" if study.index_of("off").is_none() => "none",
        "on" if study.index_of("on").is_none() => "mean",
        word => word,
    };
    let transport = reference(word, &study)?.map(|reference| CohortTransportParams {
        reference,
        ..one_transport()
    });
    let params = MetricComparisonParams {
        redraws: args.redraws,
        seed: args.seed,
        ..MetricComparisonParams::all_metrics(transport)
    };
    let work_study = Arc::clone(&study);
    let comparison = run_work(move |progress| {
        progress.begin_phase("comparing metrics", 0.0, 1.0);
        metric_comparison(&work_study, &params, progress)
    })?;
    let summary = comparison_json(&comparison);
    let files = vec![
        ExportFile::text(&args.out, "metrics.csv", csv(&comparison.rows)),
        summary_file(&args.out, &summary)?,
    ];
    write_files(files).map_err(CliError::Unusable)?;
    if args.json {
        return print_json(&summary);
    }
    let head = "| noise | metric | nearest neighbour | linear classifier | classifier on the 2-D embedding | cluster agreement τ |\n|---|---|---|---|---|---|";
    let mut lines = vec![head.to_owned()];
    lines.extend(comparison.rows.iter().map(|row| {
        let accuracies = [
            row.nearest_neighbour,
            row.linear_classifier,
            row.plane_classifier,
            row.tau,
        ];
        let cells = accuracies.map(|mean| {
            format!(
                "{:.0} ± {:.0} ({:.0})",
                100.0 * mean.share,
                100.0 * mean.standard_error,
                100.0 * mean.baseline
            )
        });
        format!(
            "| {} % | {} | {} |",
            row.percent,
            row.method,
            cells.join(" | ")
        )
    }));
    lines.push(args.out.display().to_string());
    print(&lines.join("\n"))
}

/// The transport of every row of a table: by one metric, so that rows differ in how motions are compared alone.
fn one_transport() -> CohortTransportParams {
    CohortTransportParams {
        kind: Some(MetricParams::default().of_paths().kind),
        ..CohortTransportParams::default()
    }
}

/// How near the other sequence of the same patient is, by every metric and form.
fn partners(args: &PartnerArgs) -> Result<(), CliError> {
    let study = opened_study(&args.study)?;
    let default = one_transport();
    let transport = CohortTransportParams {
        interpolated_poses: args
            .interpolated_poses
            .unwrap_or(default.interpolated_poses),
        geodesics: args.geodesics.into(),
        max_vertices: match args.coarse_vertices {
            None => default.max_vertices,
            Some(0) => None,
            Some(vertices) => Some(vertices),
        },
        ..default
    };
    let params = PartnerParams::all_metrics(transport);
    let partners = run_work(move |progress| {
        progress.begin_phase("ranking partners", 0.0, 1.0);
        partner_study(&study, &params, progress)
    })?;
    let summary = partners_json(&partners);
    let files = vec![
        ExportFile::text(&args.out, "partners.csv", csv(&partners.rows)),
        summary_file(&args.out, &summary)?,
    ];
    write_files(files).map_err(CliError::Unusable)?;
    if args.json {
        return print_json(&summary);
    }
    let head = "| transport | metric | nearer than the median | nearest | mean rank | mean distance |\n|---|---|---|---|---|---|";
    let mut lines = vec![head.to_owned()];
    lines.extend(partners.rows.iter().map(|row| {
        let ranks = &row.ranks;
        format!(
            "| {} | {} | {} of {} | {} | {:.2} | {:.4} |",
            row.transport,
            row.method,
            ranks.nearer_than_median,
            ranks.pairs,
            ranks.nearest,
            ranks.mean_rank,
            ranks.mean_distance
        )
    }));
    if let Some(row) = partners.rows.first() {
        lines.push(format!(
            "random order: {:.1} nearest, mean rank {:.1}",
            row.ranks.nearest_by_chance, row.ranks.mean_rank_by_chance
        ));
    }
    lines.push(args.out.display().to_string());
    print(&lines.join("\n"))
}
