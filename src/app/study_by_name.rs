//! Where a study lies of which only the name is known.

use std::path::{Path, PathBuf};

use crate::io::read_head;

/// A manifest that names its study is no larger.
const MAX_MANIFEST_BYTES: u64 = 4 << 20;

/// Where a study of this name lies: among what was opened before, latest first, or around the picture. Only names are
/// looked at; whether the subject is there shows when it is open.
pub fn study_named(name: &str, recent: &[PathBuf], picture: &Path) -> Option<PathBuf> {
    let around = picture.ancestors().skip(1).take(3).map(Path::to_owned);
    let places = recent.iter().cloned().chain(around);
    let mut places = places.filter(|place| place.exists());
    places.find(|place| has_name(place, name))
}

fn has_name(place: &Path, name: &str) -> bool {
    let manifest = if place.is_dir() {
        place.join("study.toml")
    } else {
        place.to_owned()
    };
    let is_manifest = manifest.extension().is_some_and(|ending| ending == "toml");
    let text = (is_manifest
        .then(|| read_head(&manifest, MAX_MANIFEST_BYTES).ok())
        .flatten())
    .and_then(|bytes| String::from_utf8(bytes).ok());
    let own = text.and_then(|text| text.parse::<toml::Table>().ok());
    let own = own.and_then(|table| Some(table.get("name")?.as_str()?.to_owned()));
    let last = if place.is_dir() {
        place.file_name()
    } else {
        place.file_stem()
    };
    let last = last.unwrap_or_default().to_string_lossy().into_owned();
    own.is_some_and(|own| own == name)
        || !last.is_empty() && (name == last || name.ends_with(&format!("/{last}")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::{ExportFile, write_files};

    #[test]
    fn a_study_is_found_by_its_name_among_recent_ones_or_around_the_picture() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let texts = [
            ("one/study.toml", "name = \"Ward 3\"\n"),
            ("two/study.toml", "units = \"mm\"\n"),
            ("two/figures/P07.png", ""),
        ];
        let files = texts.map(|(name, text)| ExportFile::text(folder.path(), name, text.into()));
        write_files(files.into()).unwrap();
        let recent = [at("gone"), at("one")];
        let picture = at("two/figures/P07.png");
        let found = |name: &str| study_named(name, &recent, &picture);
        assert_eq!(found("Ward 3"), Some(at("one")));
        assert_eq!(found("two"), Some(at("two")), "around the picture");
        assert_eq!(found("Ward 4"), None);
        assert!(has_name(&at("one/study.toml"), "Ward 3"));
    }
}
