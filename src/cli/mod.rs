//! The headless door: one file per command, sharing requests, engine and writers with the window.
