//! Chooses the door: the window, or the command line.

use std::process::ExitCode;

use cardiomorph::{app, cli};

/// Bytes that make glibc keep twice as many at the end of each heap.
const KEPT: usize = 4 << 20;

fn main() -> ExitCode {
    keep_freed_memory();
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

/// Gives a large piece of memory back. From then on glibc keeps up to twice its size at the end of each heap, where it
/// otherwise gives back whatever passes 128 KiB: readers and analyses that free a few hundred KiB for each frame and ask for
/// them again then spend a sixth of their time on pages. Elsewhere it does nothing.
fn keep_freed_memory() {
    drop(std::hint::black_box(Vec::<u8>::with_capacity(KEPT)));
}
