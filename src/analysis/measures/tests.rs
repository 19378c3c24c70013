//! Measures of hearts whose sizes are known.
