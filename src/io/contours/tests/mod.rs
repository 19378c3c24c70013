//! Tests of files of outlines: folders on disk, and damaged copies of every format.
#![allow(clippy::unwrap_used, clippy::panic)] // A test that fails here says so.

mod damage;
mod samples;
mod subjects;
