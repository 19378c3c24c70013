//! What is said of hearts in the window: the column, the pane, and what patches may be called.

#[cfg(test)]
mod rules;

use super::*;
use cardiomorph::engine::{ClassesQuery, DeformationMapQuery};
use cardiomorph::panes::{
    EditCommand, SelectCommand, ViewCommand, WallCommand, WindowCommand, WorkCommand,
};

use cardiomorph::analysis::verdicts::{Finding, Verdict};
use cardiomorph::document::{CohortColumn, CohortSort};
use cardiomorph::io::{MeshFormat, write_study};
use cardiomorph::mesh::TriMesh;
use cardiomorph::picture::PatchStanding;
use cardiomorph::progress::Progress;
use cardiomorph::study::built_in::cohort;
use cardiomorph::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};

/// P05 has a large patch.
const PATCHED: usize = 13;

fn classified(app: &App) -> bool {
    matches!(app.state().verdicts(), Some((_, true))) && !app.busy()
}

fn verdict(app: &App, subject: usize) -> &Verdict {
    app.state().verdict_of(subject).unwrap().as_ref().unwrap()
}

fn judged_window() -> Harness<'static, App> {
    let mut harness = cohort_window();
    wait(&mut harness, "verdicts", classified);
    harness
}

fn select(harness: &mut Harness<'_, App>, subject: usize) {
    give(
        harness,
        Command::Select(SelectCommand::SelectSubject(subject)),
    );
    wait(harness, "the wall", |app| {
        matches!(app.state().wall_of(subject), Some((Ok(_), true)))
            && app.hearts_on_screen()[0].0 == subject
    });
}

/// The verdict that a row of the table tells.
fn told_in_row(harness: &Harness<'_, App>, id: &str) -> Option<String> {
    harness
        .get_all_by_label(id)
        .find(|node| node.accesskit_node().role() == egui::accesskit::Role::ListBoxOption)
        .and_then(|node| node.accesskit_node().value())
}

#[test]
fn the_built_in_cohort_is_judged_in_table_and_pane() {
    let mut harness = judged_window();
    select(&mut harness, PATCHED);
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::VERDICT)),
    );
    harness.run_steps(2);
    let found = verdict(harness.state(), PATCHED).clone();
    assert_eq!(found.finding, Finding::AbnormalPatch);
    let share = format!("{:.0} %", 100.0 * found.patched);
    let id = harness
        .state()
        .state()
        .document
        .selected()
        .unwrap()
        .id
        .clone();
    assert_eq!(told_in_row(&harness, &id), Some(format!("patch {share}")));
    harness.get_by_label(&format!("Abnormal patch · {share} of the LV"));
    harness.get_by_label_contains("Predicted probability of abnormal: ");
    harness.get_by_label("Leave-one-out: this subject was not in the training set");
    harness.get_by_label_contains(
        "trained on the labelled subjects that can be assessed (9 normal, 14 abnormal)",
    );
    harness.get_by_label_contains("Accuracy (leave-one-out): ");
    harness.get_by_label_contains("Angular SD of ANV: ");
    // In the pane and in the status bar.
    assert_eq!(
        harness
            .get_all_by_label("Research use, not for diagnosis")
            .count(),
        2
    );
    // The note over the picture and the table of patches say the same.
    assert_eq!(
        harness.state().state().patch_standing(PATCHED),
        PatchStanding::AbnormalPatch
    );
    harness.get_by_label_contains(" abnormal patch");
}

#[test]
fn a_normal_heart_has_no_abnormal_patch_whatever_thickens_little() {
    let mut harness = judged_window();
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::VERDICT)),
    );
    let normal = (0..9)
        .find(|&subject| verdict(harness.state(), subject).finding == Finding::Nothing)
        .unwrap();
    // Thresholds that take much of any wall for a patch.
    let mut settings = harness.state().state().document.thickening;
    settings.patches.extent_threshold = 0.9;
    settings.patches.core_threshold = 0.85;
    settings.patches.akinetic_threshold = 1.0;
    give(
        &mut harness,
        Command::Wall(WallCommand::SetThickening(settings)),
    );
    select(&mut harness, normal);
    wait(&mut harness, "verdicts", classified);
    let state = harness.state().state();
    let Some((Ok(wall), true)) = state.wall_of(normal) else {
        panic!("the wall is known");
    };
    assert!(
        !wall.thickening.patches.is_empty(),
        "regions of low thickening"
    );
    assert_eq!(verdict(harness.state(), normal).finding, Finding::Nothing);
    assert_eq!(state.patch_standing(normal), PatchStanding::RegionOnly);
    harness.run_steps(2);
    harness.get_by_label("No regional abnormality");
    assert!(
        harness
            .query_by_label_contains(" abnormal patch ·")
            .is_none()
    );
    let low = ["region of low thickening ·", "regions of low thickening ·"];
    assert!((low.iter()).any(|words| harness.query_by_label_contains(words).is_some()));
    let id = state_id(&harness, normal);
    assert_eq!(told_in_row(&harness, &id).as_deref(), Some("no finding"));
}

fn state_id(harness: &Harness<'_, App>, subject: usize) -> String {
    harness.state().state().subject(subject).unwrap().id.clone()
}

#[test]
fn a_heart_alike_is_selected_from_the_pane() {
    let mut harness = judged_window();
    select(&mut harness, PATCHED);
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::VERDICT)),
    );
    harness.run_steps(2);
    let found = verdict(harness.state(), PATCHED).clone();
    assert_eq!(
        [found.similar_normal.len(), found.similar_abnormal.len()],
        [3, 3]
    );
    let alike = found.similar_normal[0];
    let name = format!("Select {}, a similar subject", state_id(&harness, alike));
    // Further down than the pane reaches.
    harness.get_by_label(&name).scroll_to_me();
    harness.run_steps(4);
    harness.get_by_label(&name).click();
    harness.run_steps(3);
    assert_eq!(harness.state().state().document.subject, alike);
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert_eq!(harness.state().state().document.subject, PATCHED);
}

#[test]
fn the_table_is_sorted_and_searched_by_verdict() {
    let mut harness = judged_window();
    harness.get_by_label("Sort by Verdict").click();
    harness.run_steps(2);
    let sorting = harness.state().state().document.sorting;
    let column = CohortColumn::Verdict;
    let descending = false;
    assert_eq!(sorting, Some(CohortSort { column, descending }));
    give(&mut harness, Command::View(ViewCommand::SortCohort(column)));
    harness.run_steps(2);
    // From the surest patch down: the first row is above all others.
    let rows: Vec<(f32, String)> = (harness.get_all_by_role(egui::accesskit::Role::ListBoxOption))
        .filter_map(|node| {
            let node = node.accesskit_node();
            let top = node.bounding_box()?.y0 as f32;
            Some((top, node.value()?))
        })
        .collect();
    let first = rows.iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    assert!(
        first.1 != "no finding" && first.1 != "not assessed",
        "{rows:?}"
    );
    give(
        &mut harness,
        Command::View(ViewCommand::SetSearch("patch".to_owned())),
    );
    harness.run_steps(2);
    let shown = harness.get_all_by_role(egui::accesskit::Role::ListBoxOption);
    for node in shown {
        let told = node.accesskit_node().value().unwrap();
        assert!(told.starts_with("patch "), "{told}");
    }
}

#[test]
fn judging_can_be_cancelled_and_asked_for_again() {
    // So many vertices that the walls take seconds, whatever the machine.
    let mut harness = window(AppOptions::built_in(BuiltInParams {
        vertices: 4_000,
        ..BuiltInParams::default()
    }));
    wait_for_heart(&mut harness);
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::VERDICT)),
    );
    // The maps come first: nobody has to wait for them here.
    for kind in [
        Topic::of::<PoseMapQuery>(),
        Topic::of::<DeformationMapQuery>(),
        Topic::of::<ClassesQuery>(),
    ] {
        harness
            .state_mut()
            .push(Command::Work(WorkCommand::Cancel(kind)));
    }
    let begin = Instant::now();
    while harness.query_by_label("Cancel classification").is_none() {
        assert!(begin.elapsed() < Duration::from_secs(60), "never begun");
        harness.step();
        std::thread::sleep(Duration::from_millis(3));
    }
    harness.get_by_label("Cancel classification").click();
    harness.run_steps(3);
    harness.get_by_label("The classification was stopped");
    assert!(harness.state().state().verdicts().is_none());
    assert!(harness.state().state().errors.is_empty(), "no error");
    // It stays stopped until it is asked for.
    harness.run_steps(5);
    harness.get_by_label("Classify the subjects").click();
    let begin = Instant::now();
    while harness.query_by_label("Cancel classification").is_none()
        && harness.state().state().verdicts().is_none()
    {
        assert!(
            begin.elapsed() < Duration::from_secs(60),
            "not asked for again"
        );
        harness.step();
        std::thread::sleep(Duration::from_millis(3));
    }
}

#[test]
fn other_thresholds_ask_for_other_verdicts_while_those_before_stay() {
    let mut harness = judged_window();
    select(&mut harness, PATCHED);
    let before = Arc::clone(harness.state().state().verdicts().unwrap().0);
    let mut settings = harness.state().state().document.thickening;
    settings.patches.extent_threshold = 0.6;
    settings.patches.core_threshold = 0.3;
    give(
        &mut harness,
        Command::Wall(WallCommand::SetThickening(settings)),
    );
    let state = harness.state().state();
    let (shown, of_today) = state.verdicts().unwrap();
    assert!(Arc::ptr_eq(shown, &before) && !of_today);
    wait(&mut harness, "the new verdicts", classified);
    let (shown, _) = harness.state().state().verdicts().unwrap();
    assert_ne!(**shown, *before, "a wider border makes larger patches");
    give(&mut harness, Command::Edit(EditCommand::Undo));
    wait(&mut harness, "the verdicts of before", classified);
    assert_eq!(**harness.state().state().verdicts().unwrap().0, *before);
}

/// A heart whose wall loses what muscle keeps: drawn towards its inner side as it contracts.
fn blurred(heart: &Subject) -> Subject {
    let surfaces = heart.sequence.surfaces();
    let frames = |kind| heart.sequence.surface(kind).unwrap().frames().to_vec();
    assert_eq!(surfaces.len(), 2);
    let endo = frames(SurfaceKind::Endocardium);
    let epi = frames(SurfaceKind::Epicardium);
    let count = endo.len() as f64;
    let thinner = endo
        .iter()
        .zip(&epi)
        .enumerate()
        .map(|(frame, (endo, epi))| {
            let turn = (1.0 - (std::f64::consts::TAU * frame as f64 / count).cos()) / 2.0;
            let keeps = 1.0 - 0.45 * turn;
            let vertices: Vec<_> = (endo.vertices().iter().zip(epi.vertices()))
                .map(|(inner, outer)| inner + keeps * (outer - inner))
                .collect();
            TriMesh::new(vertices, Arc::clone(epi.faces())).unwrap()
        });
    let thinner: Vec<TriMesh> = thinner.collect();
    let surface = |kind, frames| SurfaceSequence::new(kind, frames).unwrap();
    let sequence = MeshSequence::new(vec![
        surface(SurfaceKind::Endocardium, endo),
        surface(SurfaceKind::Epicardium, thinner),
    ]);
    Subject::new("blurred", sequence.unwrap(), heart.unit)
}

#[test]
fn a_wall_that_is_not_resolved_is_not_assessed_and_says_why() {
    let folder = tempfile::tempdir().unwrap();
    let study = cohort(&small()).unwrap().study;
    let hearts = vec![
        Arc::new(blurred(&study.subjects[0])),
        Arc::clone(&study.subjects[1]),
    ];
    let study = Study {
        subjects: hearts,
        ..Study::default()
    };
    let format = MeshFormat::of_extension("ply").unwrap();
    write_study(&study, folder.path(), format, &Progress::default()).unwrap();
    let mut harness = window(AppOptions::opening(vec![folder.path().to_owned()]));
    wait(&mut harness, "verdicts", |app| {
        matches!(app.state().verdicts(), Some((_, true)))
    });
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::VERDICT)),
    );
    harness.run_steps(2);
    assert_eq!(
        told_in_row(&harness, "blurred").as_deref(),
        Some("not assessed")
    );
    assert!(harness.get_all_by_label("Not assessed").count() >= 1);
    assert!(
        harness
            .get_all_by_label_contains("The wall is not resolved")
            .count()
            >= 1
    );
    // The other subject is classified by the built-in classifier.
    give(
        &mut harness,
        Command::Select(SelectCommand::SelectSubject(1)),
    );
    harness.run_steps(2);
    harness.get_by_label_contains("Predicted probability of abnormal: ");
    harness.get_by_label_contains("Classifier “built-in”, trained on ");
}
