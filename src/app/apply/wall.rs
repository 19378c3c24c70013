//! Commands about the middle of the wall, its patches and the bull's-eye.

use crate::analysis::thickening::ThickeningSettings;
use crate::panes::WallCommand;

use super::change::{Moment, change};
use crate::document::state::State;
use crate::document::undo::Gesture;
use crate::document::viewpoint::Viewpoint;

/// Applies a command about atoms, patches or the bull's-eye.
pub fn apply(state: &mut State, command: WallCommand, moment: &Moment) {
    let gesture = matches!(command, WallCommand::SetThickening(_)).then_some(Gesture::Threshold);
    change(state, moment, gesture, |d| {
        let visible = &mut d.visibility;
        match command {
            WallCommand::ToggleAtoms => visible.atoms = !visible.atoms,
            WallCommand::ToggleSpokes => visible.spokes = !visible.spokes,
            WallCommand::TogglePatches => visible.patches = !visible.patches,
            WallCommand::ToggleDirection => visible.direction = !visible.direction,
            WallCommand::SetThickening(settings) => {
                if is_usable(&settings) {
                    d.thickening = settings;
                }
            }
            WallCommand::ResetThickening => d.thickening = ThickeningSettings::default(),
            WallCommand::SelectPart(part) => d.part = part,
            WallCommand::ShowPatch { patch, camera } => {
                d.part = Some(crate::picture::WallPart::Patch(patch));
                visible.patches = true;
                d.viewpoint = Viewpoint::through(&camera).unwrap_or(d.viewpoint);
            }
            WallCommand::SetBullsEye(quantity) => d.bulls_eye = quantity,
            WallCommand::NextBullsEye => d.bulls_eye = d.bulls_eye.next(),
            WallCommand::ToggleBullsEyeSegments => d.bulls_eye_segments = !d.bulls_eye_segments,
        }
    });
}

/// Whether settings can be computed with.
pub fn is_usable(settings: &ThickeningSettings) -> bool {
    settings.medial.check().is_ok() && settings.patches.check().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::segments::Segment;
    use crate::app::apply::apply;
    use crate::document::testing::{state_of, subject_with_frames};
    use crate::panes::{Command, EditCommand, Phase, PhaseFrame, SelectCommand, Whose};
    use crate::picture::WallPart;
    use crate::study::Revision;

    fn give(state: &mut State, command: Command, pointer_held: bool) {
        let moment = Moment {
            now_s: 0.0,
            pointer_held,
            fresh_revision: Revision(9),
        };
        apply(state, command, &moment);
    }

    fn state() -> State {
        state_of(vec![
            subject_with_frames("a", 3),
            subject_with_frames("b", 3),
        ])
    }

    #[test]
    fn a_drag_of_a_threshold_is_one_step_of_undo() {
        let mut state = state();
        let before = state.document.thickening;
        for extent in [0.3, 0.35, 0.5] {
            let mut settings = before;
            settings.patches.extent_threshold = extent;
            give(
                &mut state,
                Command::Wall(WallCommand::SetThickening(settings)),
                true,
            );
        }
        assert_eq!(state.document.thickening.patches.extent_threshold, 0.5);
        give(&mut state, Command::Edit(EditCommand::Undo), false);
        assert_eq!(state.document.thickening, before);
    }

    #[test]
    fn thresholds_that_no_search_takes_change_nothing() {
        let mut state = state();
        let before = state.document.thickening;
        let mut settings = before;
        settings.patches.extent_threshold = 0.1;
        give(
            &mut state,
            Command::Wall(WallCommand::SetThickening(settings)),
            false,
        );
        assert_eq!(state.document.thickening, before);
    }

    #[test]
    fn another_subject_keeps_the_segment_and_lets_the_patch_go() {
        let mut state = state();
        let segment = WallPart::Segment(Segment::new(7).unwrap());
        give(
            &mut state,
            Command::Wall(WallCommand::SelectPart(Some(segment))),
            false,
        );
        give(
            &mut state,
            Command::Select(SelectCommand::SelectSubject(1)),
            false,
        );
        assert_eq!(state.document.part, Some(segment));
        give(
            &mut state,
            Command::Wall(WallCommand::SelectPart(Some(WallPart::Patch(0)))),
            false,
        );
        give(
            &mut state,
            Command::Select(SelectCommand::SelectSubject(0)),
            false,
        );
        assert_eq!(state.document.part, None);
        give(&mut state, Command::Edit(EditCommand::Undo), false);
        assert_eq!(state.document.part, Some(WallPart::Patch(0)));
    }

    #[test]
    fn frames_that_are_stated_anew_let_the_patch_go() {
        let mut state = state();
        give(
            &mut state,
            Command::Wall(WallCommand::SelectPart(Some(WallPart::Patch(1)))),
            false,
        );
        give(
            &mut state,
            Command::Edit(EditCommand::SetPhase(
                Whose::Selected,
                Phase::EndDiastole,
                PhaseFrame::Frame(1),
            )),
            false,
        );
        assert_eq!(state.document.part, None);
    }

    #[test]
    fn a_pose_of_another_subject_lets_the_patch_go_and_one_of_the_same_keeps_it() {
        let mut state = state();
        let patch = Some(WallPart::Patch(0));
        give(
            &mut state,
            Command::Wall(WallCommand::SelectPart(patch)),
            false,
        );
        for (subject, kept) in [(0, patch), (1, None)] {
            let pose = SelectCommand::SelectPose {
                subject,
                frame: 2,
                play: true,
            };
            give(&mut state, Command::Select(pose), false);
            assert_eq!(state.document.part, kept);
        }
    }
}
