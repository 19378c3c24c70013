//! Names of files and the subjects that they make.

use super::*;

fn grouped(names: &[&str]) -> (Vec<SubjectPlan>, Vec<OpenError>) {
    let grouped = whole(names);
    (grouped.plans, grouped.errors)
}

fn whole(names: &[&str]) -> Grouped {
    let files = names
        .iter()
        .map(|name| LooseFile {
            path: PathBuf::from("in").join(name),
            stem: stem(Path::new(name)),
            ..LooseFile::default()
        })
        .collect();
    group_files(files, Path::new("in"), "in")
}

fn one(names: &[&str]) -> SubjectPlan {
    let (mut plans, errors) = grouped(names);
    assert!(errors.is_empty(), "{errors:?}");
    assert_eq!(plans.len(), 1);
    plans.remove(0)
}

fn texts(plan: &SubjectPlan) -> Vec<&str> {
    plan.notices.iter().map(|n| n.text.as_str()).collect()
}

fn names(surface: &SurfacePlan) -> Vec<String> {
    surface.files.iter().map(|path| name_of(path)).collect()
}

#[test]
fn frames_come_in_numeric_order() {
    let plan = one(&["endo_g10.obj", "endo_g9.obj", "endo_g8.obj"]);
    assert_eq!(plan.id, "in");
    assert_eq!(
        names(&plan.surfaces[0]),
        ["endo_g8.obj", "endo_g9.obj", "endo_g10.obj"]
    );
    assert!(plan.notices.is_empty());
}

#[test]
fn cases_of_one_folder_are_subjects_of_their_own() {
    let (plans, _) = grouped(&[
        "subj0189_ES_endo.obj",
        "subj0062_ES_endo.obj",
        "subj0062_ED_endo.obj",
        "subj0189_ED_endo.obj",
        "subj0062_ED_epi.obj",
        "subj0062_ES_epi.obj",
    ]);
    assert_eq!(plans[0].id, "subj0062");
    assert_eq!(plans[1].id, "subj0189");
    assert_eq!(plans[0].surfaces.len(), 2);
    assert_eq!(
        names(&plans[0].surfaces[1]),
        ["subj0062_ED_epi.obj", "subj0062_ES_epi.obj"]
    );
    assert_eq!(
        (plans[0].stated.end_diastole, plans[0].stated.end_systole),
        (Some(0), Some(1))
    );
    assert!(texts(&plans[0])[0].contains("from the file names"));
}

#[test]
fn numbers_in_even_steps_are_a_remark_and_gaps_a_warning() {
    assert_eq!(
        one(&["horse_00.obj", "horse_04.obj", "horse_08.obj"]).notices,
        [Notice::info(
            "files are numbered 0 to 8 in steps of 4: 3 frames, assumed evenly spaced"
        )]
    );
    assert_eq!(
        one(&["w_0.obj", "w_1.obj", "w_3.obj", "w_4.obj"]).notices,
        [Notice::warning(
            "1 number is missing between file 0 and file 4 (the first is 2): the motion jumps there"
        )]
    );
    assert_eq!(one(&["w_7.obj"]).notices, []);
}

#[test]
fn a_frame_that_only_one_surface_has_is_an_error_in_words() {
    let (plans, errors) = grouped(&["endo_1.obj", "endo_2.obj", "epi_1.obj"]);
    assert!(plans.is_empty());
    assert_eq!(
        errors[0].to_string(),
        "epicardium has no file 2, which endocardium has: in"
    );
}

#[test]
fn two_files_for_one_frame_are_an_error_and_two_formats_are_not() {
    let (_, errors) = grouped(&["endo_1.obj", "endo_01.obj"]);
    assert_eq!(
        errors[0].to_string(),
        "endo_01.obj has the same surface and frame in its name: in/endo_1.obj"
    );
    let plan = one(&["endo_1.obj", "endo_2.obj", "endo_1.ply"]);
    assert_eq!(names(&plan.surfaces[0]), ["endo_1.obj", "endo_2.obj"]);
    assert_eq!(
        texts(&plan),
        ["1 file with the extension .ply holds the same frame and is not read"]
    );
    let plan = one(&["endo_0.obj", "endo_1.obj", "endo_1.ply", "endo_2.ply"]);
    assert_eq!(
        names(&plan.surfaces[0]),
        ["endo_0.obj", "endo_1.obj", "endo_2.ply"],
        "no frame is dropped with its format"
    );
}

#[test]
fn unrelated_files_are_still_hearts() {
    let (plans, errors) = grouped(&["b.stl", "a.stl"]);
    assert!(errors.is_empty());
    let ids: Vec<&str> = plans.iter().map(|plan| plan.id.as_str()).collect();
    assert_eq!(ids, ["a", "b"]);
    assert_eq!(plans[0].surfaces[0].kind, KindPlan::Unnamed);
}

#[test]
fn a_word_for_the_ventricle_leaves_the_sheet_to_its_shape() {
    let plan = one(&["LV_ED_mean.vtk"]);
    assert_eq!(plan.surfaces[0].kind, KindPlan::Ventricle);
    assert_eq!(plan.stated.end_diastole, Some(0));
    assert_eq!(plan.place, Path::new("in/LV_ED_mean.vtk"));
}

#[test]
fn decimal_times_are_frames_in_the_order_of_their_values() {
    let plan = one(&[
        "endo_0.0.obj",
        "endo_0.05.obj",
        "endo_0.1.obj",
        "endo_0.15.obj",
    ]);
    assert_eq!(
        names(&plan.surfaces[0]),
        [
            "endo_0.0.obj",
            "endo_0.05.obj",
            "endo_0.1.obj",
            "endo_0.15.obj"
        ]
    );
    let times = plan.surfaces[0].times.as_ref().unwrap();
    assert_eq!(times.values, [0.0, 0.05, 0.1, 0.15]);
    for names in [
        ["endo_0s.obj", "endo_0.05s.obj", "endo_0.1s.obj"],
        ["endo_t=0.obj", "endo_t=0.05.obj", "endo_t=0.1.obj"],
        ["endo_0%.obj", "endo_5%.obj", "endo_10%.obj"],
        ["endo-0pct.obj", "endo-5pct.obj", "endo-10pct.obj"],
        ["endo_1_of_3.obj", "endo_2_of_3.obj", "endo_3_of_3.obj"],
        ["endo 1of12.obj", "endo 2of12.obj", "endo 10of12.obj"],
        ["endo (1).obj", "endo (2).obj", "endo (10).obj"],
        ["ES_endo_0.obj", "ES_endo_1.obj", "ES_endo_10.obj"],
    ] {
        let plan = one(&names);
        assert_eq!(plan.surfaces[0].files.len(), 3, "{names:?}");
        assert_eq!(self::names(&plan.surfaces[0]), names);
        assert_eq!(plan.stated.end_systole, None);
    }
}

#[test]
fn the_right_ventricle_beside_the_left_is_left_out_and_told() {
    let plan = one(&[
        "patient1_LV_ENDOCARDIAL_000.obj",
        "patient1_LV_ENDOCARDIAL_001.obj",
        "patient1_RV_ENDOCARDIAL_000.obj",
        "patient1_RV_ENDOCARDIAL_001.obj",
        "patient1_MITRAL_VALVE_000.obj",
    ]);
    assert_eq!(plan.id, "in");
    assert_eq!((plan.surfaces.len(), plan.surfaces[0].files.len()), (1, 2));
    let texts = texts(&plan);
    assert!(
        texts
            .iter()
            .any(|t| t.starts_with("2 files of the right ventricle not read")),
        "{texts:?}"
    );
    assert!(
        texts.iter().any(|t| t.contains("mitral valve")),
        "{texts:?}"
    );
}

#[test]
fn a_right_ventricle_alone_is_shown_as_no_left_one() {
    for names in [
        ["RV_endo_0.obj", "RV_endo_1.obj"],
        ["RVEndo_0.obj", "RVEndo_1.obj"],
    ] {
        let plan = one(&names);
        assert_eq!(
            (plan.id.as_str(), plan.surfaces[0].kind),
            ("in", KindPlan::Unnamed)
        );
        assert!(
            texts(&plan)[0].starts_with("right ventricle"),
            "{:?}",
            plan.notices
        );
    }
    let (plans, errors) = grouped(&["RV_endo_0.obj", "RV_epi_0.obj", "RV_SEPTUM_0.obj"]);
    assert_eq!((plans.len(), errors.len()), (3, 0));
    assert!(
        plans
            .iter()
            .all(|plan| plan.surfaces[0].kind == KindPlan::Unnamed)
    );
}

#[test]
fn a_file_that_cannot_be_read_costs_its_subject_under_its_own_name() {
    let files = [
        "endo_0.obj",
        "endo_1.obj",
        "endo_2.obj",
        "epi_0.obj",
        "epi_1.obj",
    ]
    .iter()
    .map(|name| LooseFile {
        path: PathBuf::from("in").join(name),
        stem: stem(Path::new(name)),
        unreadable: (*name == "endo_2.obj").then(|| "a link to nowhere".to_owned()),
        ..LooseFile::default()
    })
    .collect();
    let grouped = group_files(files, Path::new("in"), "in");
    assert!(grouped.plans.is_empty());
    let errors: Vec<String> = grouped.errors.iter().map(ToString::to_string).collect();
    assert_eq!(errors, ["a link to nowhere: in/endo_2.obj"]);
}

#[test]
fn subjects_of_one_frame_that_differ_in_a_number_are_told() {
    let grouped = whole(&["scan3a_x.obj", "scan4a_x.obj"]);
    assert_eq!(grouped.plans.len(), 2);
    assert!(
        grouped.notices[0].text.contains("differ only in a number"),
        "{:?}",
        grouped.notices
    );
    assert!(whole(&["a.obj", "b.obj"]).notices.is_empty());
}

#[test]
fn a_file_without_a_frame_beside_frames_is_told() {
    let plan = one(&["endo.obj", "endo_1.obj"]);
    assert!(texts(&plan)[0].starts_with("endo.obj has no frame in its name"));
}
