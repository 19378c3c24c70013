//! Can the classes be told apart?

mod classify;
mod result;

pub use classify::{
    CheckedClassesParams, ClassesParamError, ClassesParams, ClassifyError, classify,
};
pub use result::{Accuracy, Classes, Clustering};
