//! Manifests as people write them, right and wrong.

use super::*;

const WHOLE: &str = r#"
name = "Rest"
units = "mm"
normal = ["NOR"]
abnormal = "DCM"

[[subject]]
id = "n01"
label = "NOR"
surface = "endo+epi"
endo = "n01/endo_*.ply"
epi = ["n01/epi_0.ply", "n01/epi_1.ply"]
time_ms = [0, 110.5]
rr_ms = 890
end_diastole = 0
end_systole = 1
height_cm = 172
weight_kg = 71.5
orientation = { apex = [0, 0, -80], base = [0, 0, 0], septum = [30, 0, 0], anterior = [0, 30, 0] }

[[subject]]
id = "n02"
wall = "n02/*.ply"
"#;

#[test]
fn every_field_is_read() {
    let manifest = parse_manifest(WHOLE).unwrap();
    assert_eq!(manifest.name.as_deref(), Some("Rest"));
    assert_eq!(manifest.unit, Some(StatedUnit::Millimetres(1.0)));
    let classes = manifest.label_classes.unwrap();
    assert_eq!(
        (classes.normal, classes.abnormal),
        (vec!["NOR".to_owned()], vec!["DCM".to_owned()])
    );
    assert_eq!(manifest.notices, []);
    let first = manifest.subjects[0].as_ref().unwrap();
    assert_eq!((first.id.as_str(), first.line), ("n01", 7));
    assert_eq!(first.stated.frame_times_s, Some(vec![0.0, 0.1105]));
    assert_eq!(first.stated.rr_s, Some(0.89));
    assert_eq!(
        (first.stated.end_diastole, first.stated.end_systole),
        (Some(0), Some(1))
    );
    assert_eq!(
        (first.stated.height_cm, first.stated.weight_kg),
        (Some(172.0), Some(71.5))
    );
    assert_eq!(
        first.stated.anatomy.unwrap().septal,
        crate::mesh::Vector3::x()
    );
    assert_eq!(
        first.surfaces,
        [
            (SurfaceKind::Endocardium, vec!["n01/endo_*.ply".to_owned()]),
            (
                SurfaceKind::Epicardium,
                vec!["n01/epi_0.ply".to_owned(), "n01/epi_1.ply".to_owned()]
            ),
        ]
    );
    let second = manifest.subjects[1].as_ref().unwrap();
    assert_eq!(second.surfaces[0].0, SurfaceKind::Wall);
    assert_eq!(second.stated, Stated::default());
}

fn subject_error(fields: &str) -> String {
    let text =
        format!("units = \"mm\"\n[[subject]]\nid = \"a\"\n{fields}\n[[subject]]\nid = \"b\"\n");
    let manifest = parse_manifest(&text).unwrap();
    assert!(manifest.subjects[1].is_ok(), "the sibling stays");
    let error = manifest.subjects[0].as_ref().unwrap_err();
    assert_eq!(error.id.as_deref(), Some("a"));
    error.reason.clone()
}

#[test]
fn a_wrong_field_costs_only_its_subject_and_names_its_line() {
    assert_eq!(
        subject_error("label = \"x\"\nend_systole = -1"),
        "line 5: end_systole must be the number of a frame, from 0"
    );
    assert_eq!(
        subject_error("time_ms = [0, \"soon\"]"),
        "line 4: time_ms must be a list of numbers"
    );
    assert_eq!(
        subject_error("weight_kg = nan"),
        "line 4: weight_kg must be a number above zero"
    );
    assert_eq!(
        subject_error("surface = \"endo+epi\"\nendo = \"e*.obj\""),
        "line 2: surface is \"endo+epi\", but there is no epi = \"…\""
    );
    assert_eq!(
        subject_error("surface = \"shell\""),
        "line 4: surface is \"shell\"; \"wall\", \"endo+epi\" and \"cavity\" are known"
    );
    assert_eq!(
        subject_error("orientation = { apex = [0, 0, 1] }"),
        "line 4: orientation has no base"
    );
}

#[test]
fn a_text_that_is_not_toml_names_its_line() {
    let error = parse_manifest("name = \"x\"\n[[subject]\n").unwrap_err();
    assert!(error.starts_with("line 2: "), "{error}");
    assert_eq!(
        parse_manifest("units = \"inch\"").unwrap_err(),
        "line 1: units are \"inch\"; \"mm\", \"cm\", \"m\" and \"file\" are known"
    );
    assert_eq!(
        parse_manifest("\nsubject = 3").unwrap_err(),
        "line 2: subject must be written as [[subject]]"
    );
}

#[test]
fn a_subject_without_an_id_and_an_unknown_key_are_told() {
    let manifest = parse_manifest("colour = 1\n[[subject]]\nlabel = \"x\"").unwrap();
    assert_eq!(
        manifest.subjects[0].as_ref().unwrap_err(),
        &SubjectError {
            id: None,
            reason: "line 2: subject 0 has no id".to_owned()
        }
    );
    assert_eq!(
        manifest.notices,
        [Notice::warning(
            "study.toml, line 1: unknown key \"colour\", ignored"
        )]
    );
}

#[test]
fn landmarks_on_a_line_leave_the_orientation_open() {
    let text = "[[subject]]\nid = \"a\"\norientation = { apex = [0,0,1], base = [0,0,0], septum = [0,0,2], anterior = [1,0,0] }";
    let manifest = parse_manifest(text).unwrap();
    let subject = manifest.subjects[0].as_ref().unwrap();
    assert_eq!(subject.stated.anatomy, None);
    assert!(subject.notices[0].text.contains("landmarks"));
}
