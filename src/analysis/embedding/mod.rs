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
mod method;
mod moderate;
mod neighbour_graph;
mod neighbours;
mod orientation;
mod parts;
mod pca;
mod pose_map;
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
pub use method::MapMethod;
pub use neighbours::Neighbours;
pub use pca::pca;
pub use pose_map::PoseMap;
pub use result::Embedding;
pub use smacof::{CheckedSmacofParams, SmacofParamError, SmacofParams, smacof};
pub use stress::{FAIR_STRESS, GOOD_STRESS, POOR_STRESS, kruskal_stress, raw_stress};
