//! One file per metric: its words, its properties and its terms.

mod angle_preserving;
mod corner_passes;
mod displacement;
mod isometric;
mod metric_terms;
mod quasi_conformal;
mod table;

pub use metric_terms::MetricWords;
pub(super) use table::terms;

#[cfg(test)]
mod tests;
