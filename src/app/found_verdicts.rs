//! What is said of all hearts, with the state of the study and the thresholds that it was said of.

use std::sync::Arc;

use crate::analysis::verdicts::{NotAssessed, Verdict, Verdicts};
use crate::engine::{ThickeningSettings, VerdictSettings};
use crate::picture::{PatchLook, PatchStanding};
use crate::study::Revision;

use super::state::State;

/// What verdicts belong to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VerdictKey {
    /// State of the study.
    pub revision: Revision,
    /// Which opening that study came from.
    pub opening: u64,
    /// How walls are assessed.
    pub settings: ThickeningSettings,
}

impl VerdictKey {
    /// The verdicts that the state on screen needs.
    pub fn wanted(state: &State) -> Self {
        let document = &state.document;
        Self {
            revision: document.study().revision,
            opening: document.study.opening,
            settings: document.thickening,
        }
    }

    /// How they are asked for.
    pub fn settings(&self) -> VerdictSettings {
        VerdictSettings {
            thickening: self.settings,
            ..VerdictSettings::default()
        }
    }
}

/// The last verdicts, and those that were asked for last.
#[derive(Clone, Debug, Default)]
pub struct VerdictStore {
    /// What the engine was asked; `None` before the first time.
    pub asked: Option<VerdictKey>,
    /// What it answered last.
    pub found: Option<(VerdictKey, Arc<Verdicts>)>,
}

impl State {
    /// The verdicts on the study on screen, and whether they are of its state and thresholds of today; those
    /// before stay until the new are there.
    pub fn verdicts(&self) -> Option<(&Arc<Verdicts>, bool)> {
        let (key, verdicts) = self.results.verdicts.found.as_ref()?;
        let wanted = VerdictKey::wanted(self);
        (key.opening == wanted.opening).then_some((verdicts, *key == wanted))
    }

    /// What is said of one heart.
    pub fn verdict_of(&self, index: usize) -> Option<&Result<Verdict, NotAssessed>> {
        self.verdicts()?.0.subjects.get(index)
    }

    /// What the parts of a heart's wall that do not thicken may be called. A patch is abnormal only where the
    /// verdict on the heart is that it has one.
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
    use crate::analysis::verdicts::{Features, Finding, RuleSource};
    use crate::app::testing::{state_of, subject_with_frames};

    fn verdicts(findings: &[Option<Finding>]) -> Arc<Verdicts> {
        let verdict = |finding: &Option<Finding>| match *finding {
            None => Err(NotAssessed::NoThickening("no wall".to_owned())),
            Some(finding) => Ok(Verdict {
                finding,
                abnormal: finding != Finding::Nothing,
                probability: 0.5,
                features: Features::default(),
                patched: 0.1,
                alike_normal: Vec::new(),
                alike_abnormal: Vec::new(),
                familiarity: None,
            }),
        };
        Arc::new(Verdicts {
            subjects: findings.iter().map(verdict).collect(),
            rule: RuleSource::Uncalibrated {
                normal: 0,
                abnormal: 0,
            },
            quality: None,
        })
    }

    #[test]
    fn a_patch_is_abnormal_only_where_the_verdict_says_so() {
        let ids = ["a", "b", "c", "d"];
        let mut state = state_of(ids.map(|id| subject_with_frames(id, 3)).to_vec());
        assert_eq!(state.patch_standing(0), PatchStanding::NoVerdict);
        let found = verdicts(&[
            Some(Finding::Patch),
            Some(Finding::Nothing),
            Some(Finding::GlobalFailure),
            None,
        ]);
        state.results.verdicts.found = Some((VerdictKey::wanted(&state), found));
        let standings: Vec<PatchStanding> = (0..4).map(|i| state.patch_standing(i)).collect();
        let little = PatchStanding::LowThickening;
        assert_eq!(standings, [PatchStanding::Abnormal, little, little, little]);
        assert_eq!(state.patch_look(0), PatchLook::Found);
        assert_eq!(state.patch_look(1), PatchLook::Faint);
    }

    #[test]
    fn verdicts_of_the_thresholds_before_stay_and_say_so_but_not_those_of_another_study() {
        let mut state = state_of(vec![subject_with_frames("a", 3)]);
        let found = verdicts(&[Some(Finding::Patch)]);
        state.results.verdicts.found = Some((VerdictKey::wanted(&state), found));
        assert!(matches!(state.verdicts(), Some((_, true))));
        state.document.thickening.thickening.border = 0.5;
        assert!(matches!(state.verdicts(), Some((_, false))));
        assert_eq!(state.patch_standing(0), PatchStanding::Abnormal);
        state.document.study.opening += 1;
        assert!(state.verdicts().is_none());
        assert_eq!(state.patch_standing(0), PatchStanding::NoVerdict);
    }
}
