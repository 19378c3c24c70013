//! Where do items lie on a map that keeps their distances?

mod bottom_eigenvectors;
mod classical;
mod embed;
mod error;
mod inverse_map;
mod isomap;
mod lle;
mod lle_params;
mod local_weights;
mod moderate;
mod neighbour_graph;
mod neighbours;
mod orientation;
mod parts;
mod pca;
mod placement;
mod result;
mod smacof;
mod stress;

pub use classical::classical_mds;
pub use embed::embed;
pub use error::EmbeddingError;
pub use inverse_map::{InverseMapError, inverse_map};
pub use isomap::{isomap, isomap_of_neighbours, shortest_paths};
pub use lle::{lle, lle_of_weights};
pub use lle_params::{CheckedLleParams, LleParamError, LleParams};
pub use local_weights::LocalWeights;
pub use neighbours::Neighbours;
pub use pca::pca;
pub use placement::placed_classically;
pub use result::{Embedding, MapMethod};
pub use smacof::{CheckedSmacofParams, SmacofParamError, SmacofParams, smacof};
pub use stress::{kruskal_stress, raw_stress};
