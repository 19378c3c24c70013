//! One volume at one instant, or several of a beat: values on a grid that stands in the world, in millimetres.

mod axes_of_points;
mod blur;
mod contour;
mod frame;
mod marked_points;
mod mask;
mod modality;
mod reorientation;
mod resample;
mod volume;
mod volume_edit;

pub use axes_of_points::{LongAxisEnds, PrincipalAxes, automatic_long_axis, principal_axes};
pub use blur::{BlurError, Border, blurred_image, gaussian_blur};
pub use contour::{Contour, ContourPart};
pub use frame::{FrameError, VolumeFrame};
pub use marked_points::MarkedPoints;
pub use mask::{Mask, MaskError};
pub use modality::Modality;
pub use reorientation::{Reorientation, ReorientationError, rotation_to_z};
pub use resample::{Interpolation, ResampleError, Sampler};
pub use volume::{Image, ImageError};
pub use volume_edit::{VolumeEdit, VolumeEditError, edited};
