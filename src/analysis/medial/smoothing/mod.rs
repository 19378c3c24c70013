//! Takes roughness off surfaces before spheres are fitted between them.

mod flow;
mod system;

pub(super) use flow::{Smoothed, smooth, smooth_from};
