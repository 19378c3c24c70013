//! What was found of walls, by heart and settings; what came before stays on screen until the new is there.

use std::sync::Arc;

use crate::engine::{SubjectThickening, ThickeningSettings};
use crate::study::Subject;

/// Answers kept: a heart beside another, each at some settings, and those looked at before.
const MOST_WALLS: usize = 32;

/// How a wall thickens, or why that cannot be told.
pub type FoundWall = Result<Arc<SubjectThickening>, String>;

#[derive(Clone, Debug)]
struct Known {
    subject: Arc<Subject>,
    settings: ThickeningSettings,
    found: FoundWall,
}

/// The answers that came lately; the one that came last stands last.
#[derive(Clone, Debug, Default)]
pub struct WallStore(Vec<Known>);

impl WallStore {
    /// The answer for a heart with these settings.
    pub fn get(&self, subject: &Arc<Subject>, settings: &ThickeningSettings) -> Option<&FoundWall> {
        let known = self.0.iter().rev();
        let mut of_heart = known.filter(|known| Arc::ptr_eq(&known.subject, subject));
        let found = of_heart.find(|known| known.settings == *settings);
        found.map(|known| &known.found)
    }

    /// The answer for a heart with these settings, and true; else the last one with any, and false.
    pub fn latest(
        &self,
        subject: &Arc<Subject>,
        settings: &ThickeningSettings,
    ) -> Option<(&FoundWall, bool)> {
        if let Some(found) = self.get(subject, settings) {
            return Some((found, true));
        }
        let mut known = self.0.iter().rev();
        let last = known.find(|known| Arc::ptr_eq(&known.subject, subject));
        last.map(|known| (&known.found, false))
    }

    /// Takes in an answer.
    pub fn put(&mut self, subject: &Arc<Subject>, settings: &ThickeningSettings, found: FoundWall) {
        self.0
            .retain(|known| !(Arc::ptr_eq(&known.subject, subject) && known.settings == *settings));
        self.0.push(Known {
            subject: Arc::clone(subject),
            settings: *settings,
            found,
        });
        if self.0.len() > MOST_WALLS {
            self.0.remove(0);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::subject_with_frames;

    #[test]
    fn the_answer_before_stays_until_the_one_for_new_settings_is_there() {
        let [a, b] = ["a", "b"].map(|id| Arc::new(subject_with_frames(id, 3)));
        let first = ThickeningSettings::default();
        let mut second = first;
        second.thickening.border = 0.6;
        let mut store = WallStore::default();
        store.put(&a, &first, Err("first".to_owned()));
        assert_eq!(
            store.latest(&a, &first),
            Some((&Err("first".to_owned()), true))
        );
        assert_eq!(
            store.latest(&a, &second),
            Some((&Err("first".to_owned()), false))
        );
        assert_eq!(store.latest(&b, &first), None);
        store.put(&a, &second, Err("second".to_owned()));
        assert_eq!(
            store.latest(&a, &second),
            Some((&Err("second".to_owned()), true))
        );
        for step in 0..2 * MOST_WALLS {
            second.thickening.border = 0.3 + 0.005 * step as f64;
            store.put(&b, &second, Err(String::new()));
        }
        assert_eq!(store.0.len(), MOST_WALLS);
        assert!(store.latest(&a, &first).is_none());
    }
}
