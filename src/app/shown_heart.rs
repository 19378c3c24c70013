//! A heart on screen: whose it is, where in its beat, and the numbers that it has beside another one.

use std::sync::Arc;

use egui::Rect;

use crate::picture::{HeartNumbers, Quantity};
use crate::render::Camera;
use crate::study::Subject;
use crate::ui::ViewMode;

use super::pictures::{Heart, Pictures};
use super::stage::OnStage;
use super::state::State;
use super::views::OverlayData;

/// A heart on screen: it stays until the next one is ready.
#[derive(Clone)]
pub struct ShownHeart {
    /// Index into the study's subjects.
    pub index: usize,
    /// Whose heart it is; with a carried beat, a subject of its own.
    pub subject: Arc<Subject>,
    /// Place in its beat.
    pub position: f64,
    /// Its geometry.
    pub heart: Arc<Heart>,
    /// Numbers that it has beside another heart.
    pub numbers: Option<Arc<HeartNumbers>>,
    /// What lies over it.
    pub overlay: OverlayData,
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
    pictures: &mut Pictures,
    numbers: &mut MadeNumbers,
    reference_frames: &[usize],
    place: &OnStage,
) -> Option<ShownHeart> {
    let origin = if place.carried {
        state.document.subject
    } else {
        place.subject
    };
    let reference = reference_frames.get(origin).copied().unwrap_or(0);
    let (subject, heart) = if place.carried {
        let subject = &state.carried_heart()?.subject;
        (subject, pictures.heart(subject, reference)?)
    } else {
        let subject = state.subject(place.subject)?;
        let between = state.in_betweens_of(place.subject);
        (
            subject,
            pictures.heart_between(subject, reference, between)?,
        )
    };
    Some(ShownHeart {
        index: place.subject,
        subject: Arc::clone(subject),
        position: place.position,
        numbers: numbers.of(state, place, &heart),
        heart,
        overlay: OverlayData::of(state, place),
    })
}

/// Numbers that were divided over the surfaces of the hearts on screen: the same arrays as long as
/// hearts and numbers stay, so that playing uploads nothing.
#[derive(Default)]
pub struct MadeNumbers(Vec<Made>);

struct Made {
    heart: Arc<Heart>,
    source: Arc<Vec<Vec<f32>>>,
    numbers: Arc<HeartNumbers>,
}

impl MadeNumbers {
    /// Forgets the numbers of all other hearts.
    pub fn keep(&mut self, hearts: &[Arc<Heart>]) {
        self.0
            .retain(|made| hearts.iter().any(|heart| Arc::ptr_eq(heart, &made.heart)));
    }

    fn of(
        &mut self,
        state: &State,
        place: &OnStage,
        heart: &Arc<Heart>,
    ) -> Option<Arc<HeartNumbers>> {
        let quantity = state.document.quantity;
        let source = match quantity {
            Quantity::CarriedDistance if place.carried => &state.carried_heart()?.distances,
            Quantity::Contribution if state.document.view_mode == ViewMode::SideBySide => {
                state.results.differences.shown()?
            }
            _ => return None,
        };
        let same = |made: &&Made| {
            Arc::ptr_eq(&made.heart, heart)
                && Arc::ptr_eq(&made.source, source)
                && made.numbers.quantity == quantity
        };
        if let Some(made) = self.0.iter().find(same) {
            return Some(Arc::clone(&made.numbers));
        }
        let numbers = Arc::new(HeartNumbers::of_heart(&heart.prepared, quantity, source)?);
        self.0.retain(|made| !Arc::ptr_eq(&made.heart, heart));
        self.0.push(Made {
            heart: Arc::clone(heart),
            source: Arc::clone(source),
            numbers: Arc::clone(&numbers),
        });
        Some(numbers)
    }
}
