//! `mesh` from outside with images: counts of SPECT, labels under any name, cine MR that asks, and settings that are read again.

use std::fs;
use std::path::Path;

use super::{cardiomorph, code, json_of, said, text};

/// Half-axes across and along of endocardium and epicardium at each instant, in millimetres.
const AXES: [[[f64; 2]; 2]; 3] = [
    [[24.0, 70.0], [36.0, 82.0]],
    [[18.0, 62.0], [33.0, 77.0]],
    [[22.0, 67.0], [35.0, 80.0]],
];

/// A NIfTI-1 file of 32-bit numbers; `steps` are the distances of voxels, and 0 leaves them unsaid.
fn nifti(size: [u16; 3], steps: [f32; 3], value: impl Fn([f64; 3], usize) -> f32) -> Vec<u8> {
    let mut bytes = vec![0_u8; 352];
    let [ni, nj, nk] = size;
    bytes[0..4].copy_from_slice(&348_i32.to_le_bytes());
    let sizes = [4, ni, nj, nk, AXES.len() as u16];
    for (place, size) in sizes.into_iter().enumerate() {
        bytes[40 + 2 * place..42 + 2 * place].copy_from_slice(&size.to_le_bytes());
    }
    bytes[70..72].copy_from_slice(&16_i16.to_le_bytes());
    bytes[72..74].copy_from_slice(&32_i16.to_le_bytes());
    let [si, sj, sk] = steps;
    for (place, step) in [1.0_f32, si, sj, sk].into_iter().enumerate() {
        bytes[76 + 4 * place..80 + 4 * place].copy_from_slice(&step.to_le_bytes());
    }
    bytes[108..112].copy_from_slice(&352.0_f32.to_le_bytes());
    bytes[123] = 2;
    bytes[344..348].copy_from_slice(b"n+1\0");
    for instant in 0..AXES.len() {
        for k in 0..nk {
            for j in 0..nj {
                for i in 0..ni {
                    let place = [i, j, k].map(f64::from);
                    bytes.extend(value(place, instant).to_le_bytes());
                }
            }
        }
    }
    bytes
}

/// How far out a place is as a share of the way to an ellipsoid whose apex points to growing k, and whether it lies below the
/// base, at slice 4 of 4 mm.
fn out(place: [f64; 3], [a, c]: [f64; 2]) -> (f64, bool) {
    let [x, y] = [place[0], place[1]].map(|n| 4.0 * (n - 15.5));
    let z = 4.0 * (place[2] - 4.0);
    let share = ((x * x + y * y) / (a * a) + z * z / (c * c)).sqrt();
    (share, z >= 0.0)
}

/// A gated SPECT study in voxels of 4 mm: a bright wall of soft edges.
fn spect(steps: [f32; 3]) -> Vec<u8> {
    nifti([32, 32, 30], steps, |place, instant| {
        let [endo, epi] = AXES[instant];
        let middle = [0, 1].map(|n| 0.5 * (endo[n] + epi[n]));
        let (share, below) = out(place, middle);
        let half = 0.5 * (epi[0] - endo[0]) / middle[0];
        let wall = (-((share - 1.0) / half).powi(2)).exp();
        // No value is a whole number, so that none is a label.
        10.25 + if below { 100.5 * wall as f32 } else { 0.0 }
    })
}

/// Labels in slices of 4 mm: 5 within the endocardium, 6 in the wall.
fn labels(steps: [f32; 3]) -> Vec<u8> {
    nifti([32, 32, 30], steps, |place, instant| {
        let [endo, epi] = AXES[instant].map(|axes| out(place, axes));
        match (endo, epi) {
            ((share, true), _) if share <= 1.0 => 5.0,
            (_, (share, true)) if share <= 1.0 => 6.0,
            _ => 0.0,
        }
    })
}

const STATED: [f32; 3] = [4.0, 4.0, 4.0];
const UNSAID: [f32; 3] = [0.0, 0.0, 0.0];

/// Runs `mesh` on a file below `folder`, with its output in another.
fn mesh(folder: &Path, name: &str, more: &[&str]) -> std::process::Output {
    let [from, to] = [folder.join(name), folder.join("out")];
    let mut arguments = vec!["mesh", text(&from), "--out", text(&to), "--vertices", "481"];
    arguments.extend(more);
    cardiomorph(&arguments)
}

/// Volumes of the endocardium by frame, in millilitres.
fn cavities(folder: &Path) -> Vec<f64> {
    let table = fs::read_to_string(folder.join("out/fit.csv")).unwrap();
    let cells = table
        .lines()
        .skip(1)
        .map(|row| row.split(',').collect::<Vec<_>>());
    let endo = cells.filter(|cells| cells[2] == "endo");
    endo.map(|cells| cells[6].parse().unwrap()).collect()
}

#[test]
fn gated_counts_become_a_study_whose_settings_make_it_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("p7.nii"), spect(STATED)).unwrap();
    let made = json_of(&mesh(
        path,
        "p7.nii",
        &["--json", "--cycle", "900", "--blur", "4"],
    ));
    assert_eq!(made["subjects"][0]["id"], "p7");
    assert_eq!(made["subjects"][0]["road"], "spect");
    assert_eq!(made["subjects"][0]["frames"], 3);
    let first = cavities(path);
    assert!(
        first[1] < 0.8 * first[0] && first[1] < first[2],
        "{first:?}"
    );
    let manifest = fs::read_to_string(path.join("out/study.toml")).unwrap();
    for times in ["time_ms = [0.0, 300.0, 600.0]", "rr_ms = 900.0"] {
        assert!(manifest.contains(times), "{times}: {manifest}");
    }
    let kept = fs::read_to_string(path.join("out/preparation.json")).unwrap();
    assert!(
        kept.contains("\"cycle_ms\": 900.0") && kept.contains("\"blur_mm\": 4.0"),
        "{kept}"
    );
    let settings = path.join("kept.json");
    fs::write(&settings, &kept).unwrap();
    fs::remove_dir_all(path.join("out")).unwrap();
    let ran = mesh(path, "p7.nii", &["--settings", text(&settings)]);
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    assert_eq!(cavities(path), first);
    assert_eq!(
        fs::read_to_string(path.join("out/preparation.json")).unwrap(),
        kept
    );
}

#[test]
fn every_command_takes_images_directly() {
    let folder = tempfile::tempdir().unwrap();
    let [image, out] = ["p7.nii", "measured"].map(|name| folder.path().join(name));
    fs::write(&image, spect(STATED)).unwrap();
    let ran = cardiomorph(&["measure", text(&image), "--out", text(&out)]);
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    let table = fs::read_to_string(out.join("subjects.csv")).unwrap();
    assert!(table.lines().nth(1).unwrap().starts_with("p7,"), "{table}");
}

#[test]
fn distances_that_the_file_does_not_say_are_asked_for_by_their_option() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("p7.nii"), spect(UNSAID)).unwrap();
    let ran = mesh(path, "p7.nii", &[]);
    assert_eq!(code(&ran), 1);
    assert!(said(&ran).contains("--spacing X,Y,Z"), "{}", said(&ran));
    assert!(!path.join("out").exists());
    let ran = mesh(path, "p7.nii", &["--spacing", "4,4,4"]);
    assert_eq!(code(&ran), 0, "{}", said(&ran));
    let typed = cavities(path);
    fs::write(path.join("p7.nii"), spect(STATED)).unwrap();
    fs::remove_dir_all(path.join("out")).unwrap();
    assert_eq!(code(&mesh(path, "p7.nii", &[])), 0);
    assert_eq!(cavities(path), typed);
}

#[test]
fn labels_of_any_name_are_asked_for_and_taken_and_a_lid_closes_each_surface() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("heart.nii"), labels(STATED)).unwrap();
    let ran = mesh(path, "heart.nii", &[]);
    assert_eq!(code(&ran), 1);
    assert!(
        said(&ran).contains("--labels cavity=N,wall=N"),
        "{}",
        said(&ran)
    );
    let vertices = |more: &[&str]| {
        let mut options = vec!["--json", "--labels", "cavity=5,wall=6"];
        options.extend(more);
        let made = json_of(&mesh(path, "heart.nii", &options));
        assert_eq!(made["subjects"][0]["road"], "masks");
        made["subjects"][0]["vertices"].as_u64().unwrap()
    };
    let open = vertices(&[]);
    assert_eq!(vertices(&["--base-end", "closed"]), open + 2);
    let half = |[a, c]: [f64; 2]| 2.0 / 3.0 * std::f64::consts::PI * a * a * c / 1000.0;
    for (volume, axes) in cavities(path).into_iter().zip(AXES) {
        // Half a slice of the base is cavity, too.
        assert!((volume / half(axes[0]) - 1.0).abs() < 0.08, "{volume}");
    }
}

#[test]
fn cine_asks_for_its_points_and_takes_negative_coordinates() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("sa.nii"), spect([1.5, 1.5, 8.0])).unwrap();
    let ran = mesh(
        path,
        "sa.nii",
        &["--road", "cine", "--apex", "-23,-1.5,200"],
    );
    assert_eq!(code(&ran), 1, "{}", said(&ran));
    let message = said(&ran);
    assert!(
        message.contains("--base X,Y,Z") && message.contains("--blood X,Y,Z"),
        "{message}"
    );
    assert!(!message.contains("--apex"), "{message}");
}

#[test]
fn a_folder_of_studies_is_a_cohort_and_one_that_fails_is_one_error() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let images = path.join("images");
    fs::create_dir(&images).unwrap();
    fs::write(images.join("a.nii"), spect(STATED)).unwrap();
    fs::write(images.join("b.nii"), spect(STATED)).unwrap();
    let dark = nifti([32, 32, 30], STATED, |_, _| 0.5);
    fs::write(images.join("dark.nii"), dark).unwrap();
    let ran = mesh(path, "images", &["--json"]);
    assert_eq!(code(&ran), 1);
    let made: serde_json::Value = serde_json::from_slice(&ran.stdout).unwrap();
    let ids = made["subjects"]
        .as_array()
        .unwrap()
        .iter()
        .map(|s| s["id"].as_str().unwrap());
    assert_eq!(ids.collect::<Vec<_>>(), ["a", "b"]);
    assert_eq!(made["errors"].as_array().unwrap().len(), 1);
    assert!(
        made["errors"][0].as_str().unwrap().starts_with("dark: "),
        "{made}"
    );
}

#[test]
fn options_that_cannot_be_are_wrong_usage() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    fs::write(path.join("p7.nii"), spect(STATED)).unwrap();
    for wrong in [
        &["--blur", "200"][..],
        &["--threshold", "1.5"],
        &["--cycle", "3"],
        &["--spacing", "1,2"],
        &["--spacing", "1,2,0"],
        &["--apex", "1,2,x"],
        &["--road", "xray"],
        &["--road", "spect", "--labels", "cavity=1,wall=2"],
    ] {
        let ran = mesh(path, "p7.nii", wrong);
        assert_eq!(code(&ran), 2, "{wrong:?}: {}", said(&ran));
    }
    let settings = path.join("settings.json");
    fs::write(&settings, r#"{"road": "spect", "blur": 3}"#).unwrap();
    let ran = mesh(path, "p7.nii", &["--settings", text(&settings)]);
    assert_eq!(code(&ran), 1);
    assert!(said(&ran).contains("unknown field"), "{}", said(&ran));
}
