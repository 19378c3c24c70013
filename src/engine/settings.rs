//! Settings of requests that stand on other requests.

use crate::analysis::classification::ClassesParams;
use crate::analysis::deformations::DeformationMapParams;
use crate::analysis::embedding::MapMethod;
use crate::analysis::pose_distances::PoseDistanceParams;

/// Settings of the map of all poses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseMapParams {
    /// How poses are compared.
    pub distances: PoseDistanceParams,
    /// How distances become a map.
    pub method: MapMethod,
}

/// Settings of the map of whole deformations.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DeformationMapSettings {
    /// The map of poses on which deformations are curves.
    pub poses: PoseMapParams,
    /// How curves become a map.
    pub map: DeformationMapParams,
}

/// Settings of what is said of classes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ClassesSettings {
    /// The distances and the map by which classes are told apart.
    pub deformations: DeformationMapSettings,
    /// How they are.
    pub classes: ClassesParams,
}
