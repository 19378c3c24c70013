//! What is opened is what is measured: phases and frames from names, through the measures that stand on them.

use std::fs;
use std::path::Path;
use std::time::Instant;

use cardiomorph::analysis::measures::{SubjectMeasures, measure_study};
use cardiomorph::io::{Limits, Opened, open_paths, write_obj};
use cardiomorph::mesh::phantom;
use cardiomorph::progress::Progress;

/// Frames of a cavity that empties and fills again, under these names.
fn put(folder: &Path, names: &[&str]) {
    let radii = [35.0, 32.0, 29.0, 33.0];
    for (name, radius) in names.iter().zip(radii.iter().cycle()) {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        let mut bytes = Vec::new();
        write_obj(&mut bytes, &phantom::sphere(2, *radius)).unwrap();
        fs::write(path, bytes).unwrap();
    }
}

fn opened(folder: &Path) -> Opened {
    open_paths(
        &[folder.to_owned()],
        &Limits::default(),
        &Progress::default(),
    )
    .unwrap()
}

fn measured(opened: &Opened) -> Vec<SubjectMeasures> {
    measure_study(&opened.study, &Progress::default()).unwrap()
}

fn ml(radius: f64) -> f64 {
    let opened = tempfile::tempdir().unwrap();
    let mut bytes = Vec::new();
    write_obj(&mut bytes, &phantom::sphere(2, radius)).unwrap();
    fs::write(opened.path().join("endo_0.obj"), bytes).unwrap();
    measured(&self::opened(opened.path()))[0].edv.unwrap()
}

#[test]
fn frames_are_the_same_however_their_names_count_them() {
    let (largest, smallest) = (ml(35.0), ml(29.0));
    for names in [
        ["endo_0.obj", "endo_1.obj", "endo_2.obj", "endo_3.obj"],
        [
            "endo_0.0.obj",
            "endo_0.05.obj",
            "endo_0.1.obj",
            "endo_0.15.obj",
        ],
        [
            "endo_0.obj",
            "endo_0.05.obj",
            "endo_0.1.obj",
            "endo_0.15.obj",
        ],
        [
            "endo_t=0s.obj",
            "endo_t=0.05s.obj",
            "endo_t=0.1s.obj",
            "endo_t=0.25s.obj",
        ],
        [
            "endo_0ms.obj",
            "endo_50ms.obj",
            "endo_100ms.obj",
            "endo_250ms.obj",
        ],
        [
            "endo_-0.05.obj",
            "endo_0.0.obj",
            "endo_0.1.obj",
            "endo_0.15.obj",
        ],
        [
            "endo_0e+00.obj",
            "endo_5e-02.obj",
            "endo_1e-01.obj",
            "endo_1.5e-01.obj",
        ],
        [
            "endo_0%.obj",
            "endo_25%.obj",
            "endo_50%.obj",
            "endo_75%.obj",
        ],
        [
            "endo-0pct.obj",
            "endo-5pct.obj",
            "endo-50pct.obj",
            "endo-75pct.obj",
        ],
        [
            "endo_1_of_4.obj",
            "endo_2_of_4.obj",
            "endo_3_of_4.obj",
            "endo_4_of_4.obj",
        ],
        [
            "endo_1of12.obj",
            "endo_2of12.obj",
            "endo_10of12.obj",
            "endo_12of12.obj",
        ],
        [
            "endo (1).obj",
            "endo (2).obj",
            "endo (10).obj",
            "endo (11).obj",
        ],
        [
            "endo_frame-1.obj",
            "endo_frame-2.obj",
            "endo_frame-3.obj",
            "endo_frame-10.obj",
        ],
        [
            "ES_endo_0.obj",
            "ES_endo_1.obj",
            "ES_endo_2.obj",
            "ES_endo_3.obj",
        ],
        [
            "Ed_endo_7.obj",
            "Ed_endo_8.obj",
            "Ed_endo_9.obj",
            "Ed_endo_10.obj",
        ],
        [
            "endo_0_v2.obj",
            "endo_1_v2.obj",
            "endo_2_v2.obj",
            "endo_10_v2.obj",
        ],
    ] {
        let folder = tempfile::tempdir().unwrap();
        put(folder.path(), &names);
        let opened = opened(folder.path());
        assert_eq!(opened.errors, [], "{names:?}");
        assert_eq!(opened.study.subjects.len(), 1, "{names:?}");
        let measures = measured(&opened);
        let volumes: Vec<f64> = measures[0]
            .frames
            .iter()
            .map(|f| f.endo_volume.unwrap())
            .collect();
        assert!(
            (volumes[0] - largest).abs() < 1e-9 && (volumes[2] - smallest).abs() < 1e-9,
            "{names:?}"
        );
        assert!(
            volumes[1] < volumes[0] && volumes[3] > volumes[2],
            "{names:?}: {volumes:?}"
        );
        assert_eq!(
            (measures[0].end_diastole, measures[0].end_systole),
            (Some(0), Some(2)),
            "{names:?}"
        );
    }
}

#[test]
fn one_phase_alone_has_no_ejection_fraction() {
    let folder = tempfile::tempdir().unwrap();
    put(folder.path(), &["endo_ES.obj"]);
    let systole = &measured(&opened(folder.path()))[0];
    assert_eq!((systole.edv, systole.ef, systole.sv), (None, None, None));
    assert!(systole.esv.is_some());
    fs::rename(
        folder.path().join("endo_ES.obj"),
        folder.path().join("endo_ED.obj"),
    )
    .unwrap();
    let diastole = &measured(&opened(folder.path()))[0];
    assert_eq!((diastole.esv, diastole.ef), (None, None));
    assert!(diastole.edv.is_some());
    let toml =
        "[[subject]]\nid = \"a\"\nendo = \"endo_ED.obj\"\nend_diastole = 0\nend_systole = 0\n";
    fs::write(folder.path().join("study.toml"), toml).unwrap();
    let both = opened(folder.path());
    assert_eq!(measured(&both)[0].ef, None);
    let told = &both.study.subjects[0].notices;
    assert!(
        told.iter()
            .any(|notice| notice.text.contains("both frame 0")),
        "{told:?}"
    );
}

#[test]
fn a_right_ventricle_is_never_measured_as_a_left_one() {
    for names in [
        ["p1_RV_ENDOCARDIAL_0.obj", "p1_RV_ENDOCARDIAL_1.obj"],
        ["rvendo_0.obj", "rvendo_1.obj"],
        ["RVEndo_0.obj", "RVEndo_1.obj"],
        ["right_endo_0.obj", "right_endo_1.obj"],
        ["p1_RV_SEPTUM_0.obj", "p1_RV_SEPTUM_1.obj"],
        ["p1_RV_FREEWALL_0.obj", "p1_RV_FREEWALL_1.obj"],
        ["RV/endo_0.obj", "RV/endo_1.obj"],
        ["left_atrium_endo_0.obj", "left_atrium_endo_1.obj"],
        ["p1_MITRAL_VALVE_0.obj", "p1_MITRAL_VALVE_1.obj"],
    ] {
        let folder = tempfile::tempdir().unwrap();
        put(folder.path(), &names);
        for measured in measured(&opened(folder.path())) {
            assert_eq!(
                (measured.edv, measured.esv, measured.ef),
                (None, None, None),
                "{names:?}"
            );
        }
        put(folder.path(), &["p1_LV_endo_0.obj", "p1_LV_endo_1.obj"]);
        let beside = opened(folder.path());
        let volumes: Vec<f64> = measured(&beside)
            .iter()
            .filter_map(|measured| measured.edv)
            .collect();
        assert_eq!(volumes.len(), 1, "{names:?}");
    }
}

#[test]
fn twenty_thousand_subjects_of_one_file_are_read_in_seconds_and_more_are_refused() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), &["a.obj"]);
    let toml = |count: usize| -> String {
        let subjects =
            (0..count).map(|id| format!("[[subject]]\nid = \"p{id}\"\ncavity = \"a.ob?\"\n"));
        subjects.collect()
    };
    fs::write(root.path().join("study.toml"), toml(100_000)).unwrap();
    let start = Instant::now();
    let found = opened(root.path());
    assert!(found.study.subjects.is_empty());
    assert_eq!(
        found.errors[0].reason,
        "100000 subjects; the limit is 20000"
    );
    println!("100,000 subjects refused in {:?}", start.elapsed());
    fs::write(root.path().join("study.toml"), toml(2_000)).unwrap();
    let found = opened(root.path());
    assert_eq!(found.study.subjects.len(), 2_000);
    println!("2,000 subjects read in {:?}", start.elapsed());
}

#[test]
fn fifty_patterns_through_everything_share_one_budget() {
    let root = tempfile::tempdir().unwrap();
    let subjects =
        (0..50).map(|id| format!("[[subject]]\nid = \"p{id}\"\ncavity = \"/**/none{id}\"\n"));
    fs::write(root.path().join("study.toml"), subjects.collect::<String>()).unwrap();
    let start = Instant::now();
    let found = opened(root.path());
    assert_eq!((found.study.subjects.len(), found.errors.len()), (0, 50));
    println!("50 patterns refused in {:?}", start.elapsed());
    assert!(start.elapsed().as_secs() < 20, "{:?}", start.elapsed());
}
