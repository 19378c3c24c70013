//! A heart on screen: whose it is, where in its beat, and the numbers that it has beside another one.

use std::sync::Arc;

use egui::Rect;

use crate::document::ViewMode;
use crate::picture::{
    HeartExtras, HeartMedial, MedialSettings, PatchLook, PreparedMedial, Quantity, SceneSettings,
    SurfaceScalars,
};
use crate::render::Camera;
use crate::study::Subject;

use crate::document::VisiblePose;
use crate::document::state::State;
use crate::panes::viewport::overlay_view::OverlayData;
use crate::panes::viewport::pictures::{Heart, Pictures, ShownMedial};

/// A heart on screen: it stays until the next one is ready.
#[derive(Clone)]
pub struct ShownHeart {
    /// Index into the study's subjects.
    pub index: usize,
    /// Whose heart it is; with a transported motion, a subject of its own.
    pub subject: Arc<Subject>,
    /// Place in its beat.
    pub position: f64,
    /// Its geometry.
    pub heart: Arc<Heart>,
    /// Numbers that it has beside another heart.
    pub numbers: Option<Arc<SurfaceScalars>>,
    /// The middle of its wall.
    pub medial: Option<ShownMedial>,
    /// How the borders of its patches look.
    pub patch_look: PatchLook,
    /// What lies over it.
    pub overlay: OverlayData,
}

impl ShownHeart {
    /// How it is drawn, where hearts are drawn so.
    pub fn settings(&self, settings: &SceneSettings) -> SceneSettings {
        SceneSettings {
            medial: MedialSettings {
                patch_look: self.patch_look,
                ..settings.medial
            },
            ..*settings
        }
    }

    /// What is drawn beside its surfaces.
    pub fn extras(&self) -> HeartExtras<'_> {
        HeartExtras {
            numbers: self.numbers.as_deref(),
            medial: self.medial.as_ref().map(|medial| HeartMedial {
                prepared: &medial.prepared,
                wall: &medial.wall,
            }),
        }
    }
}

/// One heart of this frame's picture.
pub struct Cell<'a> {
    /// Which heart.
    pub heart: &'a ShownHeart,
    /// Where on the screen.
    pub rect: Rect,
    /// From where it is looked at.
    pub camera: Camera,
}

/// The heart of one place, once it is ready.
pub fn shown_heart(
    state: &State,
    pictures: Pictures<'_>,
    numbers: &mut ScalarCache,
    reference_frames: &[usize],
    place: &VisiblePose,
) -> Option<ShownHeart> {
    let origin = if place.transported {
        state.document.subject
    } else {
        place.subject
    };
    let reference = reference_frames.get(origin).copied().unwrap_or(0);
    let (subject, heart) = if place.transported {
        let subject = &state.transported_subject()?.subject;
        (subject, pictures.heart(subject, reference)?)
    } else {
        let subject = state.subject(place.subject)?;
        let between = state.in_betweens_of(place.subject);
        (
            subject,
            pictures.heart_between(subject, reference, between)?,
        )
    };
    let found = (!place.transported)
        .then(|| state.wall_of(place.subject))
        .flatten();
    let medial = match found {
        Some((Ok(found), _)) => pictures.medial(subject, found),
        _ => None,
    };
    Some(ShownHeart {
        index: place.subject,
        subject: Arc::clone(subject),
        position: place.position,
        numbers: numbers.of(state, place, &heart, medial.as_ref()),
        medial,
        heart,
        patch_look: state.patch_look(place.subject),
        overlay: OverlayData::of(state, place),
    })
}

/// Numbers that were divided over the surfaces of the hearts on screen: the same arrays as long as
/// hearts and numbers stay, so that playing uploads nothing.
#[derive(Default)]
pub struct ScalarCache(Vec<Made>);

struct Made {
    heart: Arc<Heart>,
    source: Source,
    numbers: Arc<SurfaceScalars>,
}

/// What numbers are divided from.
#[derive(Clone)]
enum Source {
    /// Lists over all vertices.
    Lists(Arc<Vec<Vec<f32>>>),
    /// Atoms.
    Medial(Arc<PreparedMedial>),
}

impl Source {
    fn is(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Lists(a), Self::Lists(b)) => Arc::ptr_eq(a, b),
            (Self::Medial(a), Self::Medial(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    fn numbers(&self, heart: &Heart, quantity: Quantity) -> Option<SurfaceScalars> {
        match self {
            Self::Lists(lists) => SurfaceScalars::of_heart(&heart.prepared, quantity, lists),
            Self::Medial(medial) => medial.numbers(&heart.prepared),
        }
    }
}

impl ScalarCache {
    /// Forgets the numbers of all other hearts.
    pub fn keep(&mut self, hearts: &[Arc<Heart>]) {
        self.0
            .retain(|made| hearts.iter().any(|heart| Arc::ptr_eq(heart, &made.heart)));
    }

    fn of(
        &mut self,
        state: &State,
        place: &VisiblePose,
        heart: &Arc<Heart>,
        medial: Option<&ShownMedial>,
    ) -> Option<Arc<SurfaceScalars>> {
        // Where atoms have the colours, the wall under the pointer says PT.
        let quantity = state.document.bar_quantity();
        let source = match quantity {
            Quantity::MotionDifference if place.transported => {
                Source::Lists(Arc::clone(&state.transported_subject()?.distances))
            }
            Quantity::Contribution if state.document.view_mode == ViewMode::SideBySide => {
                Source::Lists(Arc::clone(state.answers.difference()?))
            }
            Quantity::ThicknessRatio => Source::Medial(Arc::clone(&medial?.prepared)),
            _ => return None,
        };
        let same = |made: &&Made| {
            Arc::ptr_eq(&made.heart, heart)
                && made.source.is(&source)
                && made.numbers.quantity == quantity
        };
        if let Some(made) = self.0.iter().find(same) {
            return Some(Arc::clone(&made.numbers));
        }
        let numbers = Arc::new(source.numbers(heart, quantity)?);
        self.0.retain(|made| !Arc::ptr_eq(&made.heart, heart));
        self.0.push(Made {
            heart: Arc::clone(heart),
            source,
            numbers: Arc::clone(&numbers),
        });
        Some(numbers)
    }
}
