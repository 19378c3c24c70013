//! What was measured of walls, by heart, settings and frame.

use std::sync::Arc;

use crate::engine::{FrameThickness, ThicknessSettings};
use crate::study::Subject;

/// Answers kept: three poses of a score of hearts, or the frames of one beat.
const MOST_POSES: usize = 64;

/// Thickness at a pose, or why it cannot be measured.
pub type FoundThickness = Result<Arc<FrameThickness>, String>;

#[derive(Clone, Debug)]
struct Known {
    subject: Arc<Subject>,
    settings: ThicknessSettings,
    frame: usize,
    found: FoundThickness,
}

/// The answers that came lately, the latest last.
#[derive(Clone, Debug, Default)]
pub struct ThicknessStore(Vec<Known>);

impl ThicknessStore {
    /// The answer for a pose.
    pub fn get(
        &self,
        subject: &Arc<Subject>,
        settings: &ThicknessSettings,
        frame: usize,
    ) -> Option<&FoundThickness> {
        let same = |known: &&Known| {
            Arc::ptr_eq(&known.subject, subject)
                && (known.frame, known.settings) == (frame, *settings)
        };
        self.0.iter().find(same).map(|known| &known.found)
    }

    /// Takes in an answer that is not there.
    pub fn put(
        &mut self,
        subject: &Arc<Subject>,
        settings: &ThicknessSettings,
        frame: usize,
        found: FoundThickness,
    ) {
        self.0.push(Known {
            subject: Arc::clone(subject),
            settings: *settings,
            frame,
            found,
        });
        if self.0.len() > MOST_POSES {
            self.0.remove(0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::subject_with_frames;

    #[test]
    fn answers_are_known_by_heart_settings_and_frame_and_the_oldest_goes() {
        let [a, b] = ["a", "b"].map(|id| Arc::new(subject_with_frames(id, 3)));
        let settings = ThicknessSettings::default();
        let mut other = settings;
        other.methods.slices += 1;
        let mut store = ThicknessStore::default();
        store.put(&a, &settings, 1, Err("found".to_owned()));
        assert!(store.get(&a, &settings, 1).is_some());
        assert!(store.get(&a, &settings, 2).is_none());
        assert!(store.get(&a, &other, 1).is_none());
        assert!(store.get(&b, &settings, 1).is_none());
        for frame in 0..MOST_POSES {
            store.put(&b, &settings, frame, Err(String::new()));
        }
        assert!(store.get(&a, &settings, 1).is_none());
        assert!(store.get(&b, &settings, 0).is_some());
    }
}
