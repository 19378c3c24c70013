//! The list of formats stands once, in `io`; what people read of it elsewhere agrees with it.

use std::fs;
use std::path::Path;

use cardiomorph::io::mesh_format_names;

fn source_texts(folder: &Path, texts: &mut Vec<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            source_texts(&path, texts);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            texts.push(fs::read_to_string(&path).unwrap());
        }
    }
}

#[test]
fn readme_and_empty_window_name_every_format_that_is_read() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    let paragraph = readme
        .lines()
        .find(|line| line.starts_with("Formats: "))
        .unwrap();
    for name in mesh_format_names() {
        assert!(
            paragraph.contains(name),
            "README does not name {name}: {paragraph}"
        );
    }
    let mut texts = Vec::new();
    source_texts(&root.join("src"), &mut texts);
    let window = "Mesh sequences of left ventricles (";
    let found = texts
        .iter()
        .find_map(|text| text.split_once(window))
        .unwrap()
        .1;
    let (names, _) = found.split_once(')').unwrap();
    assert_eq!(names, mesh_format_names().join(", "));
}
