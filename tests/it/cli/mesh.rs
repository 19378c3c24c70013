//! `mesh` from outside: a small cohort of masks becomes a study that opens.

use std::fs;
use std::path::Path;

use super::{cardiomorph, code, json_of, said};

/// A NIfTI-1 file of labels with steps of 3, 3 and 8 mm: half-ellipsoids of these half-axes below the first slice.
fn mask(endo: [f64; 2], epi: [f64; 2]) -> Vec<u8> {
    let [n, slices] = [32_u16, 12];
    let mut bytes = vec![0_u8; 352];
    bytes[0..4].copy_from_slice(&348_i32.to_le_bytes());
    for (place, size) in [3, n, n, slices, 1].into_iter().enumerate() {
        bytes[40 + 2 * place..42 + 2 * place].copy_from_slice(&size.to_le_bytes());
    }
    bytes[70..72].copy_from_slice(&2_i16.to_le_bytes());
    bytes[72..74].copy_from_slice(&8_i16.to_le_bytes());
    for (place, step) in [1.0_f32, 3.0, 3.0, 8.0].into_iter().enumerate() {
        bytes[76 + 4 * place..80 + 4 * place].copy_from_slice(&step.to_le_bytes());
    }
    bytes[108..112].copy_from_slice(&352.0_f32.to_le_bytes());
    bytes[123] = 2;
    bytes[344..348].copy_from_slice(b"n+1\0");
    for k in 0..slices {
        for j in 0..n {
            for i in 0..n {
                let [x, y] = [i, j].map(|p| 3.0 * (f64::from(p) - 15.5));
                let z = 8.0 * (f64::from(k) + 0.5);
                let inside = |[a, c]: [f64; 2]| (x * x + y * y) / (a * a) + z * z / (c * c) <= 1.0;
                bytes.push(match (inside(endo), inside(epi), x < -33.0 && k < 6) {
                    (true, ..) => 3,
                    (_, true, _) => 2,
                    (.., true) => 1,
                    _ => 0,
                });
            }
        }
    }
    bytes
}

/// Masks of two subjects with two frames each.
pub fn cohort(folder: &Path) {
    for (id, group) in [("a1", "NOR"), ("a2", "DCM")] {
        let place = folder.join(id);
        fs::create_dir(&place).unwrap();
        let write = |name: String, bytes: &[u8]| fs::write(place.join(name), bytes).unwrap();
        write(
            format!("{id}_frame01_gt.nii"),
            &mask([25.0, 70.0], [34.0, 79.0]),
        );
        write(
            format!("{id}_frame10_gt.nii"),
            &mask([18.0, 60.0], [31.0, 74.0]),
        );
        write(
            "Info.cfg".to_owned(),
            format!("ED: 1\nES: 10\nGroup: {group}\nHeight: 170\n").as_bytes(),
        );
    }
}

#[test]
fn masks_become_a_study_with_its_fits() {
    let masks = tempfile::tempdir().unwrap();
    cohort(masks.path());
    let out = tempfile::tempdir().unwrap();
    let [from, to] = [masks.path(), out.path()].map(|path| path.to_str().unwrap());
    let made = json_of(&cardiomorph(&[
        "mesh",
        from,
        "--out",
        to,
        "--vertices",
        "481",
        "--json",
    ]));
    assert_eq!(made["subjects"].as_array().unwrap().len(), 2);
    assert_eq!(made["subjects"][0]["vertices"], 962);
    let table = fs::read_to_string(out.path().join("fit.csv")).unwrap();
    let head = "subject,frame,surface,mean_mm,p95_mm,foldovers,volume_ml,mask_volume_ml";
    assert_eq!(table.lines().next(), Some(head));
    assert_eq!(table.lines().count(), 9);
    for row in table.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let [mesh, mask] = [6, 7].map(|cell: usize| cells[cell].parse::<f64>().unwrap());
        assert!((mesh / mask - 1.0).abs() < 0.01, "{row}");
        assert_eq!(cells[5], "0", "{row}");
    }
    let manifest = out.path().join("study.toml");
    let info = json_of(&cardiomorph(&[
        "info",
        manifest.to_str().unwrap(),
        "--json",
    ]));
    assert_eq!(info["subjects"][1]["id"], "a2");
    assert_eq!(info["subjects"][1]["label"], "DCM");
    assert_eq!(info["subjects"][1]["frames"], 2);
    let text = fs::read_to_string(manifest).unwrap();
    for words in [
        "normal = [\"NOR\"]",
        "end_systole = 1",
        "height_cm = 170.0",
        "orientation = ",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
}

#[test]
fn a_folder_of_masks_is_measured_as_the_study_made_of_it() {
    let [masks, made, measured] = [0; 3].map(|_| tempfile::tempdir().unwrap());
    cohort(masks.path());
    let [from, study, out] = [&masks, &made, &measured].map(|f| f.path().to_str().unwrap());
    assert_eq!(code(&cardiomorph(&["mesh", from, "--out", study])), 0);
    let fractions = |input: &str| -> Vec<f64> {
        let ran = cardiomorph(&["measure", input, "--out", out]);
        assert_eq!(code(&ran), 0, "{}", said(&ran));
        let table = fs::read_to_string(measured.path().join("subjects.csv")).unwrap();
        let ef = |row: &str| row.split(',').nth(7).unwrap().parse().unwrap();
        table.lines().skip(1).map(ef).collect()
    };
    let [direct, written] = [from, study].map(fractions);
    assert_eq!(direct.len(), 2);
    for (direct, written) in direct.iter().zip(&written) {
        assert!(
            (direct - written).abs() < 1e-6 && *direct > 0.2,
            "{direct} {written}"
        );
    }
}

#[test]
fn a_subject_that_cannot_be_made_is_told_and_the_rest_goes_on() {
    let masks = tempfile::tempdir().unwrap();
    cohort(masks.path());
    fs::write(
        masks.path().join("a2/a2_frame10_gt.nii"),
        mask([1.0, 1.0], [34.0, 79.0]),
    )
    .unwrap();
    let out = tempfile::tempdir().unwrap();
    let [from, to] = [masks.path(), out.path()].map(|path| path.to_str().unwrap());
    let ran = cardiomorph(&["mesh", from, "--out", to]);
    assert_eq!(code(&ran), 1);
    assert!(said(&ran).contains("a2: "), "{}", said(&ran));
    assert!(out.path().join("study.toml").is_file());
    assert!(out.path().join("a1").is_dir() && !out.path().join("a2").exists());
}

#[test]
fn wrong_options_and_nothing_to_mesh_are_told_apart() {
    let empty = tempfile::tempdir().unwrap();
    let path = empty.path().to_str().unwrap();
    let nothing = cardiomorph(&["mesh", path, "--out", path]);
    assert_eq!(code(&nothing), 1);
    assert!(
        said(&nothing).contains("no images were found here"),
        "{}",
        said(&nothing)
    );
    for wrong in [["--labels", "cavity=3"], ["--vertices", "12"]] {
        let ran = cardiomorph(&["mesh", path, "--out", path, wrong[0], wrong[1]]);
        assert_eq!(code(&ran), 2, "{wrong:?}: {}", said(&ran));
    }
}
