//! What a picture file says about the view that it shows, so that the window can take it up again.

use serde::{Deserialize, Serialize};

use crate::analysis::segments::Segment;
use crate::analysis::thickening::ThickeningSettings;
use crate::picture::bulls_eye::BullsEyeQuantity;
use crate::picture::medial::WallPart;
use crate::picture::quantity::Quantity;
use crate::picture::scene_settings::SceneSettings;
use crate::picture::subject_frame::SubjectFrame;
use crate::render::{Camera, Shading};
use crate::study::{Study, Subject};

/// Counts changes of meaning: a file of a later one is refused rather than read wrongly.
const FORMAT: u32 = 1;

/// A view of one heart. Nothing in it names a person or a place on disk: a subject has its pseudonym.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SavedView {
    /// Of this description.
    pub format: u32,
    /// The program that wrote it.
    pub program: String,
    /// Name of the study.
    pub study: String,
    /// The heart.
    pub subject: SavedSubject,
    /// Place in its beat, counted in frames.
    pub position: f64,
    /// From where it is seen.
    pub camera: SavedCamera,
    /// Quantity shown in colour.
    pub quantity: Quantity,
    /// Typed limits of its colours.
    #[serde(default)]
    pub limits: Option<[f64; 2]>,
    /// Typed limits of PT.
    #[serde(default)]
    pub ratio_limits: Option<[f64; 2]>,
    /// What is drawn.
    pub shows: SavedShows,
    /// The patch that is selected, from 1.
    #[serde(default)]
    pub patch: Option<usize>,
    /// The segment that is selected, from 1.
    #[serde(default)]
    pub segment: Option<u8>,
    /// What the bull's-eye shows.
    #[serde(default)]
    pub bulls_eye: BullsEyeQuantity,
    /// How the wall was assessed.
    #[serde(default)]
    pub thickening: ThickeningSettings,
}

/// By what a heart is known again.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct SavedSubject {
    /// Pseudonym.
    pub id: String,
    /// Number of frames.
    pub frames: usize,
    /// Number of vertices of a frame.
    pub vertices: usize,
}

/// A camera in the heart's own axes; lengths in coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SavedCamera {
    /// x, y, z, w.
    pub rotation: [f32; 4],
    /// From the heart's middle.
    pub offset: [f32; 3],
    /// Half of what is seen from top to bottom.
    pub half_height: f32,
}

/// What of a heart is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[expect(
    clippy::struct_excessive_bools,
    reason = "each is a switch of the window"
)]
pub struct SavedShows {
    /// The inner side of the wall.
    pub inner: bool,
    /// Its outer side.
    pub outer: bool,
    /// Edges.
    pub wireframe: bool,
    /// Vertices as discs.
    pub vertices: bool,
    /// One normal per face.
    pub flat: bool,
    /// Atoms of the medial surface.
    pub atoms: bool,
    /// Their spokes.
    pub spokes: bool,
    /// Borders of patches.
    pub patches: bool,
    /// ANV and MP.
    pub direction: bool,
}

/// Why a picture's view cannot be restored.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SavedViewError {
    /// No description, or a damaged one.
    #[error("the description of the view inside the picture is damaged: {0}")]
    Damaged(String),
    /// Written by a later program.
    #[error("the picture was written by a later version, {0}")]
    Later(String),
    /// A number that no view has.
    #[error(
        "the description of the view inside the picture has a camera or a position that is not a number"
    )]
    NotFinite,
    /// The heart is not open.
    #[error(
        "the picture shows {id} of the study “{study}” ({frames} frames of {vertices} vertices): open that study, and the \
         view is restored"
    )]
    NotOpen {
        /// Pseudonym.
        id: String,
        /// Name of the study.
        study: String,
        /// Number of frames.
        frames: usize,
        /// Number of vertices of a frame.
        vertices: usize,
    },
}

impl SavedSubject {
    /// What a heart is known by.
    pub fn of(subject: &Subject) -> Self {
        Self {
            id: subject.id.clone(),
            frames: subject.sequence.frame_count(),
            vertices: subject.sequence.vertex_count(),
        }
    }
}

impl SavedCamera {
    /// A camera in the world, for a heart that lies like `frame`.
    pub fn of(camera: Camera, frame: &SubjectFrame) -> Self {
        let inside = frame.heart_camera(camera);
        Self {
            rotation: inside.world_from_camera.to_array(),
            offset: inside.target.to_array(),
            half_height: inside.half_height,
        }
    }
}

impl SavedShows {
    /// What the settings of a scene draw.
    pub fn of(settings: &SceneSettings) -> Self {
        let medial = &settings.medial;
        Self {
            inner: settings.inner,
            outer: settings.outer,
            wireframe: settings.wireframe,
            vertices: settings.vertices,
            flat: settings.shading == Shading::Flat,
            atoms: medial.atoms,
            spokes: medial.spokes,
            patches: medial.patches,
            direction: medial.direction,
        }
    }
}

impl SavedView {
    /// The view of a figure.
    pub fn of(
        study: &str,
        subject: &Subject,
        position: f64,
        camera: SavedCamera,
        scene: &SceneSettings,
        bulls_eye: BullsEyeQuantity,
        thickening: ThickeningSettings,
    ) -> Self {
        let (patch, segment) = match scene.medial.part {
            Some(WallPart::Patch(index)) => (Some(index + 1), None),
            Some(WallPart::Segment(segment)) => (None, Some(segment.number())),
            None => (None, None),
        };
        Self {
            format: FORMAT,
            program: concat!("Cardiomorph ", env!("CARGO_PKG_VERSION")).to_owned(),
            study: study.to_owned(),
            subject: SavedSubject::of(subject),
            position,
            camera,
            quantity: scene.quantity,
            limits: scene.typed_limits,
            ratio_limits: scene.medial.limits,
            shows: SavedShows::of(scene),
            patch,
            segment,
            bulls_eye,
            thickening,
        }
    }

    /// The part of the wall that is selected.
    pub fn part(&self) -> Option<WallPart> {
        let patch = self.patch.and_then(|number| number.checked_sub(1));
        let segment = self.segment.and_then(Segment::new);
        patch
            .map(WallPart::Patch)
            .or_else(|| segment.map(WallPart::Segment))
    }

    /// As text, for a file.
    pub fn text(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }

    /// From the text of a file.
    ///
    /// # Errors
    /// If it is damaged, or of a later program.
    pub fn read(text: &str) -> Result<Self, SavedViewError> {
        let damaged = |error: serde_json::Error| SavedViewError::Damaged(error.to_string());
        let value: serde_json::Value = serde_json::from_str(text).map_err(damaged)?;
        let format = value.get("format").and_then(serde_json::Value::as_u64);
        if format.is_some_and(|format| format > u64::from(FORMAT)) {
            let program = value.get("program").and_then(serde_json::Value::as_str);
            return Err(SavedViewError::Later(
                program.unwrap_or("unknown").to_owned(),
            ));
        }
        let view: Self = serde_json::from_value(value).map_err(damaged)?;
        let camera = &view.camera;
        let length: f32 = camera.rotation.iter().map(|part| part * part).sum();
        let fine = view.position.is_finite()
            && view.position >= 0.0
            && camera.offset.iter().all(|part| part.is_finite())
            && (camera.half_height.is_finite() && camera.half_height > 0.0)
            && (length - 1.0).abs() < 1e-2;
        if fine {
            Ok(view)
        } else {
            Err(SavedViewError::NotFinite)
        }
    }

    /// The index of its heart in a study.
    ///
    /// # Errors
    /// If the heart is not there, or another one has its name.
    pub fn find_in(&self, study: &Study) -> Result<usize, SavedViewError> {
        let wanted = &self.subject;
        let found = study.index_of(&wanted.id);
        found
            .filter(|&index| {
                let subject = study.subject(index);
                subject.is_some_and(|subject| SavedSubject::of(subject) == *wanted)
            })
            .ok_or_else(|| SavedViewError::NotOpen {
                id: wanted.id.clone(),
                study: self.study.clone(),
                frames: wanted.frames,
                vertices: wanted.vertices,
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view() -> SavedView {
        SavedView {
            format: FORMAT,
            program: "Cardiomorph 0.1.0".to_owned(),
            study: "Built-in cohort".to_owned(),
            subject: SavedSubject {
                id: "P07".to_owned(),
                frames: 8,
                vertices: 2546,
            },
            position: 3.25,
            camera: SavedCamera {
                rotation: [0.0, 0.6, 0.0, 0.8],
                offset: [1.0, 2.0, 3.5],
                half_height: 61.5,
            },
            quantity: Quantity::ThicknessRatio,
            limits: Some([0.8, 1.5]),
            ratio_limits: None,
            shows: SavedShows::of(&SceneSettings::default()),
            patch: Some(2),
            segment: None,
            bulls_eye: BullsEyeQuantity::ThicknessRatio,
            thickening: ThickeningSettings::default(),
        }
    }

    #[test]
    fn a_view_comes_back_from_its_text() {
        let mut view = view();
        view.thickening.patches.extent_threshold = 0.55;
        assert_eq!(SavedView::read(&view.text()).unwrap(), view);
        assert_eq!(view.part(), Some(WallPart::Patch(1)));
    }

    #[test]
    fn settings_that_an_older_program_did_not_know_have_their_defaults() {
        let mut value: serde_json::Value = serde_json::from_str(&view().text()).unwrap();
        value.as_object_mut().unwrap().remove("thickening");
        value.as_object_mut().unwrap().remove("bulls_eye");
        let read = SavedView::read(&value.to_string()).unwrap();
        assert_eq!(read.thickening, ThickeningSettings::default());
        assert_eq!(read.bulls_eye, BullsEyeQuantity::default());
    }

    #[test]
    fn damage_and_later_versions_are_refused() {
        let text = view().text();
        for cut in [0, 1, text.len() / 2, text.len() - 1] {
            let refused = SavedView::read(&text[..cut]).unwrap_err();
            assert!(matches!(refused, SavedViewError::Damaged(_)), "{cut}");
        }
        let later = text.replace("\"format\":1", "\"format\":2");
        let refused = SavedView::read(&later).unwrap_err();
        assert_eq!(
            refused,
            SavedViewError::Later("Cardiomorph 0.1.0".to_owned())
        );
        for (right, wrong) in [
            ("61.5", "-1.0"),
            ("61.5", "1e60"),
            ("3.25", "-3.25"),
            ("0.6", "3.6"),
        ] {
            let text = text.replace(right, wrong);
            assert!(SavedView::read(&text).is_err(), "{wrong}");
        }
    }
}
