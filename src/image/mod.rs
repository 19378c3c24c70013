//! One volume at one instant, or several of a beat: values on a grid that stands in the world, in millimetres.

mod axes_of_points;
mod blur;
mod frame;
mod mask;
mod reorientation;
mod resample;
mod volume;

pub use axes_of_points::{LongAxisEnds, PrincipalAxes, automatic_long_axis, principal_axes};
pub use blur::{BlurError, Border, blurred_image, gaussian_blur};
pub use frame::{FrameError, VolumeFrame};
pub use mask::{Mask, MaskError};
pub use reorientation::{Reorientation, ReorientationError, rotation_to_z};
pub use resample::{Interpolation, ResampleError, Sampler};
pub use volume::{Image, ImageError};
