//! Questions asked of a study, one folder each: pure, stoppable, seeded.

pub mod alignment;
pub mod classification;
pub mod correspondence;
pub mod curvature;
pub mod deformations;
pub mod embedding;
pub mod experiments;
pub mod geodesics;
pub mod measures;
pub mod medial;
pub mod medial_map;
pub mod medial_space;
pub mod metrics;
pub mod pose_distances;
pub mod preparation;
pub mod registration;
pub mod segments;
pub mod surface_extraction;
pub mod thickening;
pub mod thickness_methods;
pub mod transport;
pub mod verdicts;
pub mod walls_from_cine;
pub mod walls_from_contours;
pub mod walls_from_masks;
pub mod walls_from_spect;
