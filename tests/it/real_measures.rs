//! Volumes and ejection fractions of real ventricles against the tables that came with them.

#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot read its input fails"
)]

use std::collections::HashMap;
use std::path::PathBuf;

use cardiomorph::analysis::measures::{SubjectMeasures, measure_study, unknown_volumes};
use cardiomorph::progress::Progress;
use cardiomorph::study::Study;

use crate::shared::{opened, shared_data};

fn measured(path: PathBuf) -> (Study, Vec<SubjectMeasures>) {
    let study = opened(path);
    let measures = measure_study(&study, &Progress::default()).unwrap();
    (study, measures)
}

/// Rows of a table by the names of its columns.
fn table(path: PathBuf) -> Vec<HashMap<String, String>> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    row[column].parse().unwrap()
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn gated_spect_ejection_fractions_are_those_of_the_table() {
    let folder = shared_data("gated_spect");
    let (study, measures) = measured(folder.join("meshes"));
    let rows = table(folder.join("subjects.csv"));
    assert_eq!(rows.len(), 20);
    assert_eq!(study.subjects.len(), 20);
    let mut worst = 0.0_f64;
    for row in &rows {
        let id = format!("{}_{}", row["subject"], row["state"]);
        let index = study.index_of(&id).unwrap_or_else(|| panic!("no {id}"));
        let error = measures[index].ef.unwrap() - number(row, "EF_mesh");
        worst = worst.max(error.abs());
        assert!(error.abs() < 0.03, "{id}: {error}");
    }
    println!("gated_spect: greatest error of EF {worst:.4}");
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn cine_mri_volumes_are_those_of_the_table_and_phases_its_extremes() {
    let folder = shared_data("cine_mri");
    let rows = table(folder.join("measures.csv"));
    let mut worst = [0.0_f64; 2];
    for (id, frames) in [("bivme_patient1", 25), ("bivme_testpatient2_EDES", 2)] {
        let (study, measures) = measured(folder.join(id));
        assert_eq!(study.subjects.len(), 1);
        let found = &measures[0];
        let rows: Vec<_> = rows.iter().filter(|row| row["subject"] == id).collect();
        assert_eq!((rows.len(), found.frames.len()), (frames, frames));
        for (row, frame) in rows.iter().zip(&found.frames) {
            let endo = frame.endo_volume.unwrap() / number(row, "LV_endo_ml") - 1.0;
            let epi = frame.epi_volume.unwrap() / number(row, "LV_epi_ml") - 1.0;
            worst = [worst[0].max(endo.abs()), worst[1].max(epi.abs())];
            assert!(endo.abs() < 0.005, "{id}: endo {endo}");
            assert!(epi.abs() < 0.03, "{id}: epi {epi}");
        }
        let volume = |row: &&&HashMap<String, String>| (number(row, "LV_endo_ml") * 1e6) as u64;
        let most = rows.iter().max_by_key(volume).unwrap();
        let least = rows.iter().min_by_key(volume).unwrap();
        assert_eq!(found.end_diastole.unwrap().to_string(), most["frame"]);
        assert_eq!(found.end_systole.unwrap().to_string(), least["frame"]);
    }
    println!(
        "cine_mri: greatest relative errors, endo {:.5}, epi {:.5}",
        worst[0], worst[1]
    );
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn acdc_ejection_fractions_are_those_of_the_table() {
    let folder = shared_data("acdc_walls");
    let (study, measures) = measured(folder.join("study.toml"));
    let rows = table(folder.join("subjects.csv"));
    assert_eq!((rows.len(), study.subjects.len()), (100, 100));
    let mut worst = [0.0_f64; 2];
    for row in &rows {
        let index = study.index_of(&row["patient"]).unwrap();
        let found = &measures[index];
        assert_eq!(study.subjects[index].label.as_ref(), Some(&row["group"]));
        let error = found.ef.unwrap() - number(row, "EF");
        let edv = found.edv.unwrap() / number(row, "endo_ED_ml") - 1.0;
        worst = [worst[0].max(error.abs()), worst[1].max(edv.abs())];
        assert!(error.abs() < 0.01, "{}: {error}", row["patient"]);
    }
    println!(
        "acdc_walls: greatest error of EF {:.5}, of EDV {:.5} relative",
        worst[0], worst[1]
    );
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_mean_wall_of_a_population_has_a_cavity_and_a_mass() {
    let folder = shared_data("population_mean");
    let (study, measures) = measured(folder.join("LV_ED_mean.vtk"));
    // Two open sheets in one file: the cavity is the inner one.
    assert!(unknown_volumes(&study.subjects[0]).is_empty());
    let (frame, mass) = (&measures[0].frames[0], measures[0].mass.unwrap().0);
    let (endo, epi) = (frame.endo_volume.unwrap(), frame.epi_volume.unwrap());
    println!(
        "population_mean: cavity {endo:.1} ml, within the epicardium {epi:.1} ml, mass {mass:.1} g"
    );
    // Healthy adults: no table comes with the mesh, so the bounds are those of a healthy heart.
    assert!((120.0..180.0).contains(&endo));
    assert!((80.0..140.0).contains(&mass));
}
