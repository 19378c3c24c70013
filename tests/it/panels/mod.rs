//! Panels seen from outside, with a cohort made up for them.

pub mod example;
mod layout;
pub mod window;
