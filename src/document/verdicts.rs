//! What is said of all subjects on screen, and what their patches may be called by it.

use std::sync::Arc;

use crate::analysis::verdicts::{NotAssessed, Verdict, Verdicts};
use crate::picture::{PatchLook, PatchStanding};

use crate::document::state::State;

impl State {
    /// The verdicts on the study on screen, and whether they are of its state and thresholds of today; those
    /// before stay until the new are there.
    pub fn verdicts(&self) -> Option<(&Arc<Verdicts>, bool)> {
        let showing = self.of_this_study(self.answers.verdicts.as_ref())?;
        Some((showing.latest()?, showing.ready().is_some()))
    }

    /// What is said of one subject.
    pub fn verdict_of(&self, index: usize) -> Option<&Result<Verdict, NotAssessed>> {
        self.verdicts()?.0.subjects.get(index)
    }

    /// What the parts of a subject's wall that do not thicken may be called. A patch is abnormal only where the
    /// verdict on the subject is that it has one.
    pub fn patch_standing(&self, index: usize) -> PatchStanding {
        PatchStanding::of(self.verdict_of(index))
    }

    /// How the borders of these parts are drawn.
    pub fn patch_look(&self, index: usize) -> PatchLook {
        self.patch_standing(index).look()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::verdicts::{ClassifierSource, Features, Finding};
    use crate::document::testing::{state_of, subject_with_frames};
    use crate::engine::Showing;

    fn verdicts(findings: &[Option<Finding>]) -> Arc<Verdicts> {
        let verdict = |finding: &Option<Finding>| match *finding {
            None => Err(NotAssessed::NoThickening("no wall".to_owned())),
            Some(finding) => Ok(Verdict {
                finding,
                abnormal: finding != Finding::Nothing,
                probability: 0.5,
                features: Features::default(),
                patched: 0.1,
                similar_normal: Vec::new(),
                similar_abnormal: Vec::new(),
                training_set_distance: None,
                wall: true,
                labels: Vec::new(),
                reasons: Vec::new(),
                outside: Vec::new(),
            }),
        };
        Arc::new(Verdicts {
            subjects: findings.iter().map(verdict).collect(),
            classifier: ClassifierSource::Cohort {
                normal: 0,
                abnormal: 0,
            },
            features: Vec::new(),
            quality: None,
        })
    }

    #[test]
    fn a_patch_is_abnormal_only_where_the_verdict_says_so() {
        let ids = ["a", "b", "c", "d"];
        let mut state = state_of(ids.map(|id| subject_with_frames(id, 3)).to_vec());
        assert_eq!(state.patch_standing(0), PatchStanding::NoVerdict);
        let found = verdicts(&[
            Some(Finding::AbnormalPatch),
            Some(Finding::Nothing),
            Some(Finding::GlobalHypokinesia),
            None,
        ]);
        state.answers.verdicts = Some(Showing::Ready(found));
        let standings: Vec<PatchStanding> = (0..4).map(|i| state.patch_standing(i)).collect();
        let little = PatchStanding::RegionOnly;
        assert_eq!(
            standings,
            [PatchStanding::AbnormalPatch, little, little, little]
        );
        assert_eq!(state.patch_look(0), PatchLook::Found);
        assert_eq!(state.patch_look(1), PatchLook::Faint);
    }

    #[test]
    fn verdicts_of_the_thresholds_before_stay_and_say_so_but_not_those_of_another_study() {
        let mut state = state_of(vec![subject_with_frames("a", 3)]);
        let found = verdicts(&[Some(Finding::AbnormalPatch)]);
        state.answers.verdicts = Some(Showing::Ready(Arc::clone(&found)));
        assert!(matches!(state.verdicts(), Some((_, true))));
        state.answers.verdicts = Some(Showing::Computing {
            previous: Some(found),
            watch: Arc::default(),
        });
        assert!(matches!(state.verdicts(), Some((_, false))));
        assert_eq!(state.patch_standing(0), PatchStanding::AbnormalPatch);
        state.document.study.listing.0 += 1;
        assert!(state.verdicts().is_none());
        assert_eq!(state.patch_standing(0), PatchStanding::NoVerdict);
    }
}
