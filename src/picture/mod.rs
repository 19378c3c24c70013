//! A heart at a pose as a scene with colours, legends and labels: what the window and exported figures share.

mod axes;
mod bulls_eye;
mod colour_map;
mod colour_ranges;
pub mod figure;
mod fitted_camera;
mod frame_words;
mod label_marks;
mod legend;
mod medial;
mod medial_noise_plot;
mod noise_plot;
mod openings;
mod origin;
pub mod page;
mod patch_words;
pub mod plot;
mod prepared;
mod quantity;
pub mod report;
mod scale_bar;
mod scene;
mod scene_settings;
mod subject_frame;
mod surface_scalars;
mod ticks;
mod tokens;
mod wall_rim;

pub use axes::{AnatomicalView, CubeFace, SubjectAxes};
pub use bulls_eye::{
    BullsEyeQuantity, BullsEyeScale, PolarMap, PolarPatch, PolarValues, ink_on, sector_line,
    sector_outline, sector_strip,
};
pub use colour_map::ColourMap;
pub use colour_ranges::{CohortColourRanges, reference_frame};
pub use fitted_camera::fitted_camera;
pub use frame_words::{
    frame_words, frames_around, is_between, position_words, share_unit, share_words,
};
pub use label_marks::{LabelMark, MarkShape, label_colour_of};
pub use legend::{ColourLegend, Tick, USER_LIMITS};
pub use medial::{
    MedialSettings, PatchLook, PreparedMedial, SubjectMedial, WallPart, facing_patch,
};
pub use medial_noise_plot::medial_noise_page;
pub use noise_plot::noise_page;
pub use origin::PictureOrigin;
pub use patch_words::{
    PatchStanding, area_text, part_name, patch_heading, percent, segment_words, sentence,
    smallest_words, wall_thickening_words,
};
pub use prepared::{PreparedSubject, PreparedSurface, SurfaceRole};
pub use quantity::Quantity;
pub use scale_bar::ScaleBar;
pub use scene::{SubjectExtras, SubjectScene, scene_with_extras, subject_scene};
pub use scene_settings::SceneSettings;
pub use subject_frame::SubjectFrame;
pub use surface_scalars::{SurfaceScalars, relative_density};
pub use ticks::{logarithmic_ticks, nice_ceiling, nice_floor, nice_ticks, tick_text};
pub use tokens::{PictureTheme, srgb};
