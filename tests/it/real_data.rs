//! Real ventricles of the shared folder, opened as a clinician would drop them.

use std::path::{Path, PathBuf};
use std::time::Instant;

use cardiomorph::io::{Limits, Opened, open_paths};
use cardiomorph::progress::Progress;

fn open(folder: &str) -> Option<Opened> {
    let path = PathBuf::from("/work/shared/data").join(folder);
    let start = Instant::now();
    let opened = open_paths(&[path], &Limits::default(), &Progress::default()).unwrap();
    println!("{:?}", cardiomorph::study::checks::AlignedCohort::of(&opened.study.subjects));
    println!("== {folder}: {:?}", start.elapsed());
    Some(opened)
}

#[test]
fn print_all() {
    for f in [
        "gated_spect/meshes",
        "gated_spect",
        "acdc_walls",
        "cine_mri",
        "mesa",
        "mesa/meshes",
        "horse_gallop",
        "population_mean",
        "population_mean/LV_ED_mean.vtk",
        "acdc",
        ".",
    ] {
        let o = open(f).unwrap();
        println!(
            "name {:?} subjects {} errors {:?} notices {:?}",
            o.study.name,
            o.study.subjects.len(),
            o.errors
                .iter()
                .take(4)
                .map(|e| e.to_string())
                .collect::<Vec<_>>(),
            o.notices
        );
        let mut seen = std::collections::BTreeMap::new();
        for s in &o.study.subjects {
            let key = format!(
                "{:?} {:?} {:?}",
                s.unit,
                s.sequence
                    .surfaces()
                    .iter()
                    .map(|s| s.kind())
                    .collect::<Vec<_>>(),
                s.notices
                    .iter()
                    .map(|n| format!("\n      {:?} {}", n.severity, n.text))
                    .collect::<String>()
            )
            .replace("\\n", "\n");
            seen.entry(key).or_insert_with(Vec::new).push(format!(
                "{} x{}",
                s.id,
                s.sequence.frame_count()
            ));
        }
        for (k, v) in seen.iter().take(2) {
            println!("  {} subjects, e.g. {}: {k}", v.len(), v[0]);
        }
        println!("  ({} kinds of reports)", seen.len());
    }
    let _ = Path::new("");
}
