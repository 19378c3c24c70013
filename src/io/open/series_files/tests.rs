//! Lists as programs write them, right and wrong.

use super::*;
use crate::io::open::series_times::seconds;
use crate::study::SurfaceKind;
use std::fs;

/// Reads a list beside empty files of these names.
fn read(list: &str, text: &str, files: &[&str]) -> Result<Series, SeriesFault> {
    let folder = tempfile::tempdir().unwrap();
    for name in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "").unwrap();
    }
    let mut folders = Folders::new(&[folder.path().to_owned()], false);
    let path = folder.path().join(list);
    let series = read_series(&path, text, &mut folders, &Progress::default()).unwrap();
    let strip = |path: &PathBuf| path.strip_prefix(folder.path()).unwrap().to_owned();
    series
        .map(|mut series| {
            for part in &mut series.parts {
                part.files = part.files.iter().map(strip).collect();
            }
            series
        })
        .map_err(|fault| SeriesFault {
            listed: fault.listed.iter().map(strip).collect(),
            ..fault
        })
}

fn collection(entries: &str) -> String {
    format!("<VTKFile type=\"Collection\"><Collection>\n{entries}</Collection></VTKFile>")
}

fn names(part: &Part) -> Vec<String> {
    part.files
        .iter()
        .map(|file| file.display().to_string())
        .collect()
}

#[test]
fn a_collection_lists_its_files_by_time() {
    let text = collection(
        "<DataSet timestep=\"0.4\" part=\"0\" file=\"a.vtp\"/>\n\
         <DataSet timestep=\"0.1\" part=\"0\" file=\"b.vtp\"/>\n",
    );
    let series = read("x.pvd", &text, &["a.vtp", "b.vtp"]).unwrap();
    assert_eq!(names(&series.parts[0]), ["b.vtp", "a.vtp"]);
    assert_eq!(series.parts[0].times.as_ref().unwrap().values, [0.1, 0.4]);
    let fault = read("x.pvd", &text, &["a.vtp"]).unwrap_err();
    assert_eq!(fault.reason, "line 3: there is no file \"b.vtp\"");
    assert_eq!(
        fault.listed,
        [PathBuf::from("a.vtp")],
        "its other files are no frames by themselves"
    );
    let wrong = text.replace("0.4", "soon");
    assert_eq!(
        read("x.pvd", &wrong, &["a.vtp", "b.vtp"])
            .unwrap_err()
            .reason,
        "line 2: timestep \"soon\" is not a number"
    );
}

#[test]
fn a_json_series_lists_its_files_by_time() {
    let text = "{\"file-series-version\":\"1.0\",\n\"files\":[{\"name\":\"a.vtk\",\"time\":3}]}";
    let series = read("x.vtk.series", text, &["a.vtk"]).unwrap();
    assert_eq!(series.parts[0].times.as_ref().unwrap().values, [3.0]);
    let reason = |text: &str| read("x.vtk.series", text, &[]).unwrap_err().reason;
    assert!(reason("{\n\"files\": 3}").starts_with("line 2: invalid type"));
    assert_eq!(reason("{\"files\": []}"), "lists no files");
}

#[test]
fn several_surfaces_at_a_time_are_told_apart_by_part_or_name() {
    let files = ["endo_0.vtp", "epi_0.vtp", "endo_1.vtp", "epi_1.vtp"];
    for attributes in [
        [
            "timestep=\"0\"",
            "timestep=\"0\"",
            "timestep=\"0.4\"",
            "timestep=\"0.4\"",
        ],
        ["part=\"0\"", "part=\"1\"", "part=\"0\"", "part=\"1\""],
        ["", "", "", ""],
        [
            "timestep=\"0\"",
            "timestep=\"0\"",
            "timestep=\"0\"",
            "timestep=\"0\"",
        ],
        ["group=\"a\"", "group=\"b\"", "group=\"a\"", "group=\"b\""],
    ] {
        let entries: String = attributes
            .iter()
            .zip(files)
            .map(|(attributes, file)| format!("<DataSet {attributes} file=\"{file}\"/>\n"))
            .collect();
        let series = read("heart.pvd", &collection(&entries), &files).unwrap();
        let parts: Vec<_> = series
            .parts
            .iter()
            .map(|part| (part.surface, names(part)))
            .collect();
        assert_eq!(
            parts,
            [
                (
                    Some(SurfaceKind::Endocardium),
                    vec!["endo_0.vtp".to_owned(), "endo_1.vtp".to_owned()]
                ),
                (
                    Some(SurfaceKind::Epicardium),
                    vec!["epi_0.vtp".to_owned(), "epi_1.vtp".to_owned()]
                ),
            ],
            "{attributes:?}"
        );
    }
}

#[test]
fn files_at_one_time_that_nothing_tells_apart_are_refused() {
    let files = ["m0.vtp", "m1.vtp", "m2.vtp", "m3.vtp"];
    let entries: String = files
        .iter()
        .zip([0, 0, 1, 1])
        .map(|(file, time)| format!("<DataSet timestep=\"{time}\" file=\"{file}\"/>\n"))
        .collect();
    let fault = read("heart.pvd", &collection(&entries), &files).unwrap_err();
    assert!(
        fault.reason.contains("2 files at each time"),
        "{}",
        fault.reason
    );
    assert_eq!(fault.listed.len(), 4);
}

#[test]
fn parts_at_other_times_are_refused() {
    let text = collection(
        "<DataSet timestep=\"0\" part=\"0\" file=\"a.vtp\"/><DataSet timestep=\"0.3\" part=\"0\" file=\"b.vtp\"/>\
         <DataSet timestep=\"0.3\" part=\"1\" file=\"c.vtp\"/><DataSet timestep=\"0.6\" part=\"1\" file=\"d.vtp\"/>",
    );
    let fault = read("x.pvd", &text, &["a.vtp", "b.vtp", "c.vtp", "d.vtp"]).unwrap_err();
    assert_eq!(fault.reason, "its parts have different times");
}

#[test]
fn unusable_orders_and_repeated_entries_are_told() {
    let json = |times: [f64; 3]| {
        let entries: Vec<String> = (0..3)
            .map(|i| format!("{{\"name\":\"e{i}.vtp\",\"time\":{}}}", times[i]))
            .collect();
        format!("{{\"files\":[{}]}}", entries.join(","))
    };
    let files = ["e0.vtp", "e1.vtp", "e2.vtp"];
    let equal = read("e.vtp.series", &json([0.0, 0.2, 0.2]), &files).unwrap();
    let (times, notice) = seconds(equal.parts[0].times.as_ref().unwrap(), None);
    assert_eq!(times, None);
    assert!(notice.unwrap().text.contains("same time"));
    let falling = read("e.vtp.series", &json([0.4, 0.2, 0.0]), &files).unwrap();
    assert_eq!(names(&falling.parts[0]), ["e2.vtp", "e1.vtp", "e0.vtp"]);
    assert!(falling.notices[0].text.contains("sorted by time"));
    let twice = "{\"files\":[{\"name\":\"e0.vtp\",\"time\":0},{\"name\":\"e0.vtp\",\"time\":0},{\"name\":\"e1.vtp\",\"time\":0.3}]}";
    let twice = read("e.vtp.series", twice, &files).unwrap();
    assert_eq!(names(&twice.parts[0]), ["e0.vtp", "e1.vtp"]);
    assert!(twice.notices[0].text.contains("listed twice"));
    let some = "{\"files\":[{\"name\":\"e0.vtp\",\"time\":0},{\"name\":\"e1.vtp\"}]}";
    let some = read("e.vtp.series", some, &files).unwrap();
    assert_eq!(some.parts[0].times, None);
    assert!(some.notices[0].text.contains("without a time"));
}

#[test]
fn ten_thousand_entries_are_read_at_once() {
    let entries: String = (0..10_000)
        .map(|i| format!("<DataSet timestep=\"{i}\" file=\"a.vtp\"/>\n"))
        .collect();
    let series = read("x.pvd", &collection(&entries), &["a.vtp"]).unwrap();
    assert_eq!(series.parts[0].files.len(), 10_000);
}
