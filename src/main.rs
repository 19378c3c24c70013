//! Chooses the door: the window, or the command line.

use std::process::ExitCode;

use cardiomorph::{app, cli};

fn main() -> ExitCode {
    match cli::chosen_door() {
        cli::Door::Command(command) => {
            if command.draws() {
                cli::ensure_runtime_folder();
            }
            cli::run(*command)
        }
        cli::Door::Columns => cli::print_columns(),
        cli::Door::Window(paths) => {
            cli::ensure_runtime_folder();
            match app::run_window(paths.clone()) {
                Ok(()) => ExitCode::SUCCESS,
                Err(app::WindowError::Start(reason)) => {
                    cli::run_unseen(&reason.to_string(), &paths)
                }
                Err(reason @ app::WindowError::Died { .. }) => {
                    cli::end_of_window(&reason.to_string())
                }
            }
        }
    }
}
