//! Where do items lie on a map that keeps their distances?

mod result;

pub use result::{Embedding, MapMethod};
