//! Outlines that people drew in images: files of cvi42, 3D Slicer, the Sunnybrook challenge, biv-me, and radiotherapy, to contours
//! that stand in the world of an image.

mod cvi42;
mod find;
mod formats;
mod guide_points;
mod images;
mod instants;
mod markups;
mod outline;
mod placing;
mod read;
mod structures;
mod sunnybrook;
#[cfg(test)]
mod tests;

pub use find::{ContourStudy, find_contour_studies};
pub use read::{ContourStudyError, ContouredImage, read_contours};
