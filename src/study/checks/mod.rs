//! What is odd about a sequence: one file per invariant, each finding a sentence for the load report.
