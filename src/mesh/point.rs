//! Points and vectors of all meshes.

/// A point in the coordinates of the files, in their length unit.
pub type Point3 = nalgebra::Point3<f64>;
/// A displacement or direction in the coordinates of the files.
pub type Vector3 = nalgebra::Vector3<f64>;
