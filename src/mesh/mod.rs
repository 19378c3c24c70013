//! One triangle mesh at one instant: connectivity, positions, and what can be measured on them.

mod angle_deficit;
mod borders;
mod capping;
mod closest_point;
mod components;
mod decimation;
mod face_order;
mod faces;
mod measure;
mod normals;
pub mod phantom;
mod plane_section;
mod point;
mod scan_lines;
mod self_intersections;
mod tri_mesh;

pub use angle_deficit::{angle_deficits_rad, corner_angles_rad, flat_angles_rad};
pub use borders::{Borders, Edge};
pub use capping::CappedSheet;
pub use closest_point::{ClosestPoint, Nearest};
pub use components::{Sheet, SheetError, sheets};
pub use decimation::Decimation;
pub use face_order::FaceOrder;
pub use faces::{Faces, MeshError};
pub use measure::{area, bounding_box, mean_point, signed_volume, vertex_areas, winding_number};
pub use normals::{face_normals, vertex_normals};
pub use plane_section::{Contour, plane_section};
pub use point::{Point3, Vector3};
pub use scan_lines::{ScanGrid, scan_lines};
pub use self_intersections::crossing_faces;
pub use tri_mesh::TriMesh;
