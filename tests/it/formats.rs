//! The list of formats stands once, in `io`; the README agrees with it.

use std::fs;
use std::path::Path;

use cardiomorph::io::mesh_format_names;

#[test]
fn the_readme_names_every_format_that_is_read() {
    let readme = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md"));
    let readme = readme.unwrap();
    let mut lines = readme.lines();
    let line = lines.find(|line| line.starts_with("Formats: ")).unwrap();
    for name in mesh_format_names() {
        assert!(line.contains(name), "README does not name {name}: {line}");
    }
}
