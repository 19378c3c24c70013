//! Chooses the door: the window, or the command line.

use std::process::ExitCode;

use cardiomorph::{app, cli};

fn main() -> ExitCode {
    match cli::chosen_door() {
        cli::Door::Command(command) => cli::run(*command),
        cli::Door::Window(paths) => match app::run_window(paths.clone()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(reason) => cli::run_unseen(&reason.to_string(), &paths),
        },
    }
}
