//! The deformation map: a point is the whole motion of one subject, similar motions lie near each
//! other; below it, how well classifiers find the labels.

mod classes;
mod figure;
mod header;
mod map;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub(crate) mod view;
mod words;

pub use {classes::*, header::*, map::*, words::*};
