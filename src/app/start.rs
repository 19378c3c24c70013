//! Starts the window, or reports in one line why it cannot be opened.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use crate::engine::make_private;

use super::app::App;
use super::app_options::AppOptions;

/// Why no window could be opened; each message is one line that names what to install or do.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum StartError {
    /// Neither X11 nor Wayland is set up.
    #[error("no display was found: DISPLAY and WAYLAND_DISPLAY are not set")]
    NoDisplay,
    /// A library of the window system is missing, or it refused the window.
    #[error(
        "the window system cannot be used: {reason}; on Debian or Ubuntu: apt-get install \
         libx11-6 libx11-xcb1 libxcursor1 libxi6 libxkbcommon-x11-0"
    )]
    WindowSystem {
        /// Its first line of output.
        reason: String,
    },
    /// No graphics driver is usable.
    #[error(
        "no graphics driver was found: {reason}; on Debian or Ubuntu: apt-get install \
         libvulkan1 mesa-vulkan-drivers"
    )]
    NoDriver {
        /// The message of the graphics library.
        reason: String,
    },
    /// The program itself could not start.
    #[error("the window could not be prepared: {reason}")]
    Preparation {
        /// The error of the preparation.
        reason: String,
    },
}

/// Why the window is not, or no longer, there.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WindowError {
    /// It could not be opened.
    #[error(transparent)]
    Start(#[from] StartError),
    /// It was open, and ended without being closed: a bug, or the display is gone.
    #[error("the window ended unexpectedly: {reason}")]
    Died {
        /// What the panic or the window system said, in one line.
        reason: String,
    },
}

/// The file in which eframe keeps settings, in its folder of this program.
const SETTINGS_FILE: &str = "app.ron";

/// Name of the program where the window system and its folders ask for one.
const APP_ID: &str = "cardiomorph";

/// Size of the window at the first start, in points.
const FIRST_SIZE: [f32; 2] = [1600.0, 1000.0];

/// Smallest size at which every control can still be reached.
const MIN_SIZE: [f32; 2] = [880.0, 560.0];

/// Opens the window on `paths`, or on the built-in cohort if there are none, and returns when it
/// is closed.
///
/// # Errors
/// If there is no display, no driver, or a library of the window system is missing; the command line still works then. Or
/// if the window ended without being closed. Errors print as one line.
pub fn run_window(paths: Vec<PathBuf>) -> Result<(), WindowError> {
    if cfg!(all(unix, not(target_os = "macos"))) && !display_is_named() {
        return Err(StartError::NoDisplay.into());
    }
    if let Some(folder) = eframe::storage_dir(APP_ID) {
        // What cannot be made cannot be written by the window either.
        make_private(&folder.join(SETTINGS_FILE)).ok();
    }
    let options = AppOptions {
        live: true,
        ..AppOptions::opening(paths)
    };
    // winit panics where libxkbcommon-x11 is missing: until the window is open, that panic is caught and
    // reported as an error; afterwards panics are reported as usual.
    let hook = Arc::new(Mutex::new(Some(std::panic::take_hook())));
    std::panic::set_hook(Box::new(|_| {}));
    let restore = {
        let hook = Arc::clone(&hook);
        move || {
            if let Some(hook) = hook.lock().unwrap_or_else(PoisonError::into_inner).take() {
                std::panic::set_hook(hook);
            }
        }
    };
    let started = restore.clone();
    let opened = Arc::new(AtomicBool::new(false));
    let has_opened = Arc::clone(&opened);
    let outcome = catch_unwind(AssertUnwindSafe(|| {
        eframe::run_native(
            "Cardiomorph",
            native_options(),
            Box::new(move |cc| {
                started();
                let app = App::new(cc, options)?;
                has_opened.store(true, Ordering::SeqCst);
                Ok(Box::new(app))
            }),
        )
    }));
    restore();
    let ended = match outcome {
        Ok(Ok(())) => return Ok(()),
        Ok(Err(error)) => plain_error(&error),
        Err(payload) => StartError::WindowSystem {
            reason: panic_line(&*payload),
        },
    };
    Err(window_error(opened.load(Ordering::SeqCst), ended))
}

/// Only a window that never opened means a machine without one: one that ends later has broken down, and whoever saw it did
/// not ask for anything else.
fn window_error(opened: bool, ended: StartError) -> WindowError {
    if !opened {
        return ended.into();
    }
    WindowError::Died {
        reason: match ended {
            StartError::WindowSystem { reason }
            | StartError::NoDriver { reason }
            | StartError::Preparation { reason } => reason,
            StartError::NoDisplay => ended.to_string(),
        },
    }
}

fn display_is_named() -> bool {
    ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"]
        .iter()
        .any(|name| std::env::var_os(name).is_some_and(|value| !value.is_empty()))
}

fn native_options() -> eframe::NativeOptions {
    eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Cardiomorph")
            .with_app_id(APP_ID)
            .with_inner_size(FIRST_SIZE)
            .with_min_inner_size(MIN_SIZE)
            .with_drag_and_drop(true),
        ..Default::default()
    }
}

fn plain_error(error: &eframe::Error) -> StartError {
    let reason = first_line(&error.to_string());
    match error {
        eframe::Error::Wgpu(_) => StartError::NoDriver { reason },
        eframe::Error::AppCreation(_) => StartError::Preparation { reason },
        _ => StartError::WindowSystem { reason },
    }
}

fn first_line(text: &str) -> String {
    text.lines().next().unwrap_or_default().to_owned()
}

fn panic_line(payload: &(dyn Any + Send)) -> String {
    let text = payload
        .downcast_ref::<&str>()
        .map(|text| (*text).to_owned())
        .or_else(|| payload.downcast_ref::<String>().cloned());
    first_line(&text.unwrap_or_else(|| "no reason given".to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_that_ends_after_it_opened_is_no_machine_without_a_display() {
        let ended = || StartError::WindowSystem {
            reason: "index out of bounds".to_owned(),
        };
        assert_eq!(window_error(false, ended()), WindowError::Start(ended()));
        let died = window_error(true, ended());
        assert_eq!(
            died.to_string(),
            "the window ended unexpectedly: index out of bounds"
        );
    }

    #[test]
    fn start_errors_are_one_line() {
        let errors = [
            StartError::NoDisplay,
            StartError::WindowSystem {
                reason: panic_line(&"Library libxkbcommon-x11.so could not be loaded.\nmore"),
            },
            StartError::NoDriver {
                reason: "No suitable adapter".to_owned(),
            },
        ];
        for error in errors {
            assert_eq!(error.to_string().lines().count(), 1, "{error}");
        }
    }
}
