//! A heart at a pose as a scene with colours, legends and labels: what the window and exported figures share.

mod axes;
mod colour_map;
pub mod figure;
mod fit;
mod frame_words;
mod legend;
mod limits;
mod medial;
mod numbers;
mod openings;
mod prepared;
mod quantity;
mod scale_bar;
mod scene;
mod ticks;
mod tokens;
mod wall_rim;

pub use axes::{AnatomicalView, CubeFace, HeartAxes};
pub use colour_map::ColourMap;
pub use fit::fitted_camera;
pub use frame_words::frame_words;
pub use legend::{ColourLegend, Tick};
pub use limits::{CohortLimits, reference_frame};
pub use medial::{HeartMedial, MedialSettings, PatchLook, PreparedMedial, WallPart};
pub use numbers::{HeartNumbers, relative_density};
pub use prepared::{PreparedSubject, PreparedSurface, SurfaceRole};
pub use quantity::Quantity;
pub use scale_bar::ScaleBar;
pub use scene::{HeartExtras, HeartScene, SceneSettings, heart_scene, subject_scene};
pub use ticks::{logarithmic_ticks, nice_ceiling, nice_floor, nice_ticks, tick_text};
pub use tokens::{PictureTheme, srgb};
