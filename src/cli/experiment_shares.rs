//! `experiment shares`: what the distances within beats are made of, by every metric.

use std::path::PathBuf;

use clap::Args;
use serde_json::{Value, json};

use crate::analysis::metrics::{EnergyShares, METRICS, MetricParams};
use crate::analysis::pose_distances::{PoseDistanceParams, beat_shares};
use crate::cli::input::opened_study;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::work::run_work;
use crate::report::beat_shares_json;

/// Options of `experiment shares`.
#[derive(Debug, Args)]
pub struct ShareArgs {
    /// Studies, each by itself; the built-in cohort if none is given
    #[arg(value_name = "STUDY")]
    pub study: Vec<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

pub(super) fn shares(args: &ShareArgs) -> Result<(), CliError> {
    let each: Vec<&[PathBuf]> = match args.study.is_empty() {
        true => vec![&[]],
        false => args.study.chunks(1).collect(),
    };
    let (mut rows, mut values) = (Vec::new(), Vec::new());
    for paths in each {
        let study = opened_study(paths)?;
        let name = study.name.clone();
        for smoothing in [0.0, PoseDistanceParams::default().smoothing] {
            for kind in METRICS {
                let params = PoseDistanceParams {
                    metric: MetricParams::of(kind),
                    transport: None,
                    smoothing,
                };
                let params = params.check().map_err(CliError::unusable)?;
                let study = study.clone();
                let found = run_work(move |progress| {
                    progress.begin_phase("comparing frames", 0.0, 1.0);
                    beat_shares(&study, &params, progress)
                })?;
                let cells = [found.phases, found.steps].map(|shares| {
                    shares.map_or_else(
                        || "none".to_owned(),
                        |shares: EnergyShares| {
                            let parts = [shares.own, shares.curvature, shares.displacement];
                            parts.map(|part| format!("{:.0}", 100.0 * part)).join(" / ")
                        },
                    )
                });
                let id = kind.words().id;
                rows.push(format!(
                    "| {name} | {} | {smoothing} | {id} | {} |",
                    found.beats,
                    cells.join(" | ")
                ));
                let mut value = beat_shares_json(&found, kind);
                if let Value::Object(object) = &mut value {
                    object.insert("study".to_owned(), json!(name));
                    object.insert("metric".to_owned(), json!(id));
                    object.insert("smoothing".to_owned(), json!(smoothing));
                }
                values.push(value);
            }
        }
    }
    if args.json {
        return print_json(&json!({ "shares": values }));
    }
    let head = "| study | beats | smoothing, √area | metric | end-diastole to end-systole: own term / curvature / displacement, % | frame to frame |\n|---|---|---|---|---|---|";
    print(&format!("{head}\n{}", rows.join("\n")))
}
