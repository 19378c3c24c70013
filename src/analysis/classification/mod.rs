//! How well can the class of a subject be predicted?

mod classify;
mod k_means;
mod linear_classifier;
mod matching;
mod nearest;
mod nested_classifier;
mod result;

pub use classify::{
    CheckedClassesParams, ClassesParamError, ClassesParams, ClassifyError, MAX_COMPONENTS, classify,
};
pub use k_means::k_means;
pub use linear_classifier::leave_one_out_linear;
pub use matching::{Matching, tau};
pub use nearest::leave_one_out_nearest;
pub use result::{Accuracy, Classes, Clustering};
