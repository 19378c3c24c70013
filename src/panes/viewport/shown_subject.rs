//! A subject on screen: whose it is, where in its cycle, and the numbers that it has beside another one.

use std::sync::Arc;

use egui::Rect;

use crate::document::ViewMode;
use crate::picture::{
    MedialSettings, PatchLook, PreparedMedial, Quantity, SceneSettings, SubjectExtras,
    SubjectMedial, SurfaceScalars,
};
use crate::render::Camera;
use crate::study::{Study, Subject};

use crate::document::VisiblePose;
use crate::document::state::State;
use crate::engine::{ESTIMATED_FRAME, EstimatedPose};
use crate::panes::same::Same;
use crate::panes::viewport::overlay::SubjectCaption;
use crate::panes::viewport::overlay_view::{caption, estimated_caption};
use crate::panes::viewport::queries::{Pictures, PlacedSubject, ShownMedial};

/// A subject on screen: it stays until the next one is ready.
#[derive(Clone)]
pub struct ShownSubject {
    /// Index into the study's subjects.
    pub index: usize,
    /// Whose it is; with a transported motion, a subject of its own.
    pub subject: Arc<Subject>,
    /// Whether it plays a transported motion.
    pub transported: bool,
    /// Place in its cycle.
    pub position: f64,
    /// Its geometry.
    pub placed: Arc<PlacedSubject>,
    /// Numbers that it has beside another subject.
    pub numbers: Option<Arc<SurfaceScalars>>,
    /// The middle of its wall.
    pub medial: Option<ShownMedial>,
    /// Whether it is no pose of any subject: no number is drawn on it.
    pub estimated: bool,
    /// How the borders of its patches look.
    pub patch_look: PatchLook,
    /// What is said over it.
    pub caption: SubjectCaption,
}

impl ShownSubject {
    /// Whichever place it has in the study now.
    pub fn follow(&mut self, study: &Study) {
        let id = self.subject.sequence.id();
        let place = study.all().position(|subject| subject.sequence.id() == id);
        self.index = place.unwrap_or(self.index);
    }

    /// How it is drawn, where subjects are drawn so.
    pub fn settings(&self, settings: &SceneSettings) -> SceneSettings {
        SceneSettings {
            quantity: match self.estimated {
                true => Quantity::Tissue,
                false => settings.quantity,
            },
            medial: MedialSettings {
                patch_look: self.patch_look,
                ..settings.medial
            },
            ..*settings
        }
    }

    /// What is drawn beside its surfaces.
    pub fn extras(&self) -> SubjectExtras<'_> {
        SubjectExtras {
            numbers: self.numbers.as_deref(),
            medial: self.medial.as_ref().map(|medial| SubjectMedial {
                prepared: &medial.prepared,
                wall: &medial.wall,
            }),
        }
    }
}

/// One subject of this frame's picture.
pub struct Tile<'a> {
    /// Which subject.
    pub shown: &'a ShownSubject,
    /// Where on the screen.
    pub rect: Rect,
    /// From where it is looked at.
    pub camera: Camera,
}

/// The subject of one place, once it is ready.
pub fn shown_subject(
    state: &State,
    pictures: Pictures<'_>,
    numbers: &mut ScalarCache,
    reference_frames: &[usize],
    place: &VisiblePose,
) -> Option<ShownSubject> {
    let origin = if place.transported {
        state.document.subject
    } else {
        place.subject
    };
    let reference = reference_frames.get(origin).copied().unwrap_or(0);
    let (subject, placed) = if place.transported {
        let subject = &state.transported_subject()?.subject;
        (subject, pictures.placed(subject, reference)?)
    } else {
        let subject = state.subject(place.subject)?;
        let between = state.interpolated_poses_of(place.subject);
        (
            subject,
            pictures.placed_between(subject, reference, between)?,
        )
    };
    let found = (!place.transported)
        .then(|| state.wall_of(place.subject))
        .flatten();
    let medial = match found {
        Some((Ok(found), _)) => pictures.medial(subject, found),
        _ => None,
    };
    Some(ShownSubject {
        index: place.subject,
        subject: Arc::clone(subject),
        transported: place.transported,
        position: place.position,
        numbers: numbers.of(state, place, &placed, medial.as_ref()),
        medial,
        placed,
        estimated: false,
        patch_look: state.patch_look(place.subject),
        caption: caption(state, place),
    })
}

/// A pose that is estimated, in place of the subjects, once it is ready.
pub fn shown_estimate(
    state: &State,
    pictures: Pictures<'_>,
    pose: &EstimatedPose,
) -> Option<ShownSubject> {
    Some(ShownSubject {
        index: state.document.subject,
        subject: Arc::clone(&pose.subject),
        transported: false,
        position: ESTIMATED_FRAME as f64,
        placed: pictures.placed(&pose.subject, 0)?,
        numbers: None,
        medial: None,
        estimated: true,
        patch_look: PatchLook::default(),
        caption: estimated_caption(state, pose),
    })
}

/// Numbers that were divided over the surfaces of the subjects on screen: the same arrays as long as
/// subjects and numbers stay, so that playing uploads nothing.
#[derive(Default)]
pub struct ScalarCache(Vec<Made>);

struct Made {
    placed: Arc<PlacedSubject>,
    source: Source,
    numbers: Arc<SurfaceScalars>,
}

/// What numbers are divided from.
#[derive(Clone, PartialEq)]
enum Source {
    /// Lists over all vertices.
    Lists(Same<Vec<Vec<f32>>>),
    /// Atoms.
    Medial(Same<PreparedMedial>),
}

impl Source {
    fn numbers(&self, placed: &PlacedSubject, quantity: Quantity) -> Option<SurfaceScalars> {
        match self {
            Self::Lists(Same(lists)) => SurfaceScalars::of_heart(&placed.prepared, quantity, lists),
            Self::Medial(Same(medial)) => medial.numbers(&placed.prepared),
        }
    }
}

impl ScalarCache {
    /// Forgets the numbers of all other subjects.
    pub fn keep(&mut self, on_screen: &[Arc<PlacedSubject>]) {
        self.0.retain(|made| {
            on_screen
                .iter()
                .any(|placed| Arc::ptr_eq(placed, &made.placed))
        });
    }

    fn of(
        &mut self,
        state: &State,
        place: &VisiblePose,
        placed: &Arc<PlacedSubject>,
        medial: Option<&ShownMedial>,
    ) -> Option<Arc<SurfaceScalars>> {
        // Where atoms have the colours, the wall under the pointer says PT.
        let quantity = state.document.bar_quantity();
        let source = match quantity {
            Quantity::MotionDifference if place.transported => {
                Source::Lists(Same(Arc::clone(&state.transported_subject()?.distances)))
            }
            Quantity::Contribution if state.document.view_mode == ViewMode::SideBySide => {
                Source::Lists(Same(Arc::clone(state.answers.difference()?)))
            }
            Quantity::ThicknessRatio => Source::Medial(Same(Arc::clone(&medial?.prepared))),
            _ => return None,
        };
        let same = |made: &&Made| {
            Arc::ptr_eq(&made.placed, placed)
                && made.source == source
                && made.numbers.quantity == quantity
        };
        if let Some(made) = self.0.iter().find(same) {
            return Some(Arc::clone(&made.numbers));
        }
        let numbers = Arc::new(source.numbers(placed, quantity)?);
        self.0.retain(|made| !Arc::ptr_eq(&made.placed, placed));
        self.0.push(Made {
            placed: Arc::clone(placed),
            source,
            numbers: Arc::clone(&numbers),
        });
        Some(numbers)
    }
}
