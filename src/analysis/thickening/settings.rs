//! The settings of the search for patches, from the surfaces on.

use serde::{Deserialize, Serialize};

use crate::analysis::medial::MedialParams;

use super::params::ThickeningParams;

/// Settings of the search for patches, from the surfaces on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ThickeningSettings {
    /// How medial spheres are fitted.
    pub medial: MedialParams,
    /// What is akinetic, and what is a patch.
    // The name in pictures that were saved.
    #[serde(rename = "thickening")]
    pub patches: ThickeningParams,
}
