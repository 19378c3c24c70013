//! The one way onto standard output and standard error.

use std::io::{ErrorKind, Write};

use crate::cli::outcome::CliError;

/// Writes lines to standard output.
///
/// # Errors
/// If the reader went away, which ends the command without complaint, or the system refuses.
pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    let written = out
        .write_all(text.as_bytes())
        .and_then(|()| out.write_all(b"\n"))
        .and_then(|()| out.flush());
    written.map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => CliError::OutputClosed,
        _ => CliError::Unusable(format!("standard output: {error}")),
    })
}

/// Prints one JSON object on one line of its own.
///
/// # Errors
/// As [`print()`].
pub(super) fn print_json(value: &serde_json::Value) -> Result<(), CliError> {
    print(&value.to_string())
}

/// Says something beside the result. A closed standard error is nobody's concern.
pub(super) fn say(text: &str) {
    writeln!(std::io::stderr().lock(), "{text}").ok();
}

/// JSON as files hold it: indented, with a line break at the end.
pub(super) fn pretty(value: &serde_json::Value) -> Result<String, CliError> {
    let text = serde_json::to_string_pretty(value).map_err(CliError::unusable)?;
    Ok(text + "\n")
}
