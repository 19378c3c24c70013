//! What the steps and the batch say.

use super::batch::BatchState;

#[test]
fn a_row_says_what_it_needs_and_whether_somebody_should_look() {
    let missing = BatchState::Missing("the apex, the middle of the mitral ring".to_owned());
    assert_eq!(
        missing.words(),
        "needs the apex, the middle of the mitral ring"
    );
    let looks = [
        (missing, true),
        (BatchState::Waiting, false),
        (BatchState::Making(0.4), false),
        (BatchState::Failed("no ventricle".to_owned()), true),
        (BatchState::Made(None), false),
        (BatchState::Made(Some("fit 1.9 mm".to_owned())), true),
        (BatchState::InCohort(None), false),
    ];
    for (state, wanted) in looks {
        assert_eq!(state.needs_a_look(), wanted, "{}", state.words());
    }
    assert_eq!(BatchState::Making(0.404).words(), "making walls, 40 %");
}
