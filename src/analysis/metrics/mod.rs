//! How far apart are two poses, when what does not matter is ignored?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, sections 2.3.6–2.3.7 and 3.2.

mod params;

pub use params::{Corners, Form, MetricKind, MetricParams, ParamError, Regulariser};
