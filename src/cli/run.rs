//! Runs a command and turns its end into an exit code.

use std::process::ExitCode;

use crate::cli::args::Command;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, say};
use crate::cli::work::hear_ctrl_c;
use crate::cli::{
    analyze, curvature, demo, embed, experiment, figure, image, info, interpolate, learn, measure,
    medial, mesh, metric, register, transfer,
};
use crate::report::all_columns_md;

/// Runs one command. Errors are reported once, here, on standard error.
pub fn run(command: Command) -> ExitCode {
    hear_ctrl_c();
    exit_code(match command {
        Command::Demo(args) => demo::demo(&args),
        Command::Info(args) => info::info(&args),
        Command::Image(args) => image::image(&args),
        Command::Analyze(args) => analyze::analyze(&args),
        Command::Learn(args) => learn::learn(&args),
        Command::Measure(args) => measure::measure(&args),
        Command::Mesh(args) => mesh::mesh(&args),
        Command::Medial(args) => medial::medial(&args),
        Command::Curvature(args) => curvature::curvature(&args),
        Command::Metric(args) => metric::metric(&args),
        Command::Interpolate(args) => interpolate::interpolate(&args),
        Command::Register(args) => register::register(&args),
        Command::Transfer(args) => transfer::transfer(&args),
        Command::Embed(args) => embed::embed(&args),
        Command::Figure(args) => figure::figure(&args),
        Command::Experiment(command) => experiment::experiment(&command),
    })
}

/// Prints what every column of every table means.
pub fn print_columns() -> ExitCode {
    exit_code(print(all_columns_md().trim_end()))
}

/// Says why the window is gone; the code is that of an error.
pub fn end_of_window(reason: &str) -> ExitCode {
    exit_code(Err(CliError::Unusable(reason.to_owned())))
}

/// Says what went wrong, if anything did, and gives the code for it.
pub(super) fn exit_code(outcome: Result<(), CliError>) -> ExitCode {
    let Err(error) = outcome else {
        return ExitCode::SUCCESS;
    };
    match &error {
        // Whoever closed the pipe or pressed Ctrl-C knows.
        CliError::OutputClosed => {}
        CliError::Stopped(_) => say("cardiomorph: stopped"),
        CliError::Usage(_) => say(&format!("cardiomorph: {error}\nSee `cardiomorph --help`")),
        CliError::Unusable(_) => say(&format!("cardiomorph: {error}")),
    }
    error.exit_code()
}
