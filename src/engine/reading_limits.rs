//! How large an input may be in this run of the program.

use std::sync::OnceLock;

use crate::io::Limits;

static LIMITS: OnceLock<Limits> = OnceLock::new();

/// Sets the limits of all reading in this run; the first word stands.
pub fn configure_limits(limits: Limits) {
    LIMITS.set(limits).ok();
}

/// What was set, else the usual limits.
pub fn reading_limits() -> Limits {
    LIMITS.get().copied().unwrap_or_default()
}
