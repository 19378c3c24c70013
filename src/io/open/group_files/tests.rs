//! Names of files and the subjects that they make.

use super::*;

fn grouped(names: &[&str]) -> (Vec<SubjectPlan>, Vec<OpenError>) {
    let files = names
        .iter()
        .map(|name| LooseFile {
            path: PathBuf::from("in").join(name),
            series: None,
            folder_surface: None,
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
    surface.files.iter().map(|path| file_name(path)).collect()
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
        ["1 file with the extension .ply hold the same frames and are not read"]
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
