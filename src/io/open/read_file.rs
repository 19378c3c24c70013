//! Bytes of one file, within the limits, and what to say where they cannot be had.

use std::fs::File;
use std::io::{self, Read};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use super::seams::without_seams;
use crate::io::text_encoding::{without_mark, xml_text};
use crate::io::xml::check_xml_size;
use crate::io::{Limits, MeshFile, OpenError, ReadMeshError, read_mesh_with_siblings};
use crate::study::SurfaceKind;

/// The last part of a path as text.
pub(super) fn name_of(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// All bytes of a file that is not larger than the limit; its size is asked before it is read.
///
/// # Errors
/// A sentence without the file's name.
pub(super) fn read_bytes(path: &Path, limits: &Limits) -> Result<Vec<u8>, String> {
    let facts = std::fs::metadata(path).map_err(|error| reason(&error))?;
    if !facts.is_file() {
        return Err("not a file".to_owned());
    }
    let too_large = |size| {
        ReadMeshError::TooLarge {
            size,
            most: limits.file_bytes,
        }
        .to_string()
    };
    if facts.len() > limits.file_bytes {
        return Err(too_large(facts.len()));
    }
    let file = File::open(path).map_err(|error| reason(&error))?;
    let mut bytes = Vec::with_capacity(facts.len() as usize);
    // Special files tell a size of zero and never end.
    file.take(limits.file_bytes.saturating_add(1))
        .read_to_end(&mut bytes)
        .map_err(|error| reason(&error))?;
    if bytes.len() as u64 > limits.file_bytes {
        return Err(too_large(bytes.len() as u64));
    }
    Ok(bytes)
}

/// The first bytes of a file, at most so many.
///
/// # Errors
/// If it cannot be read.
pub fn read_head(path: &Path, most: u64) -> Result<Vec<u8>, OpenError> {
    let wrong = |reason: String| OpenError {
        subject: None,
        path: path.to_owned(),
        reason,
    };
    // A pipe would be waited for.
    if std::fs::metadata(path).is_ok_and(|facts| !facts.is_file()) {
        return Err(wrong("not a file".to_owned()));
    }
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(most).read_to_end(&mut bytes));
    match read {
        Ok(_) => Ok(bytes),
        Err(error) => Err(wrong(reason(&error))),
    }
}

/// A text file as UTF-8, without the mark that some editors put in front; XML in the encoding that it declares, if
/// it takes no long time to parse.
///
/// # Errors
/// A sentence without the file's name.
pub(super) fn read_text(path: &Path, limits: &Limits) -> Result<String, String> {
    let bytes = read_bytes(path, limits)?;
    let decoded = without_mark(&bytes).and_then(|text| {
        let decoded =
            xml_text(&text.bytes).map_err(|error| text.error_in_file(error, bytes.len()))?;
        if decoded.trim_start().starts_with('<') {
            check_xml_size(&decoded)?;
        }
        Ok(decoded.into_owned())
    });
    decoded.map_err(|error| error.to_string())
}

/// The meshes of one file, with its seams joined as in a study.
///
/// # Errors
/// A sentence without the file's name.
pub fn read_mesh_file(path: &Path, limits: &Limits) -> Result<MeshFile, String> {
    let bytes = read_bytes(path, limits)?;
    let mut file = read_mesh_at(path, &bytes, limits)?;
    let (frames, joined) = without_seams(SurfaceKind::Other, file.frames);
    file.frames = frames;
    file.notices.extend(joined);
    Ok(file)
}

/// The meshes of a file whose bytes were read, with the files beside it that it may name.
///
/// # Errors
/// A sentence without the file's name.
pub(super) fn read_mesh_at(path: &Path, bytes: &[u8], limits: &Limits) -> Result<MeshFile, String> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let sibling = |name: &str| {
        let relative = Path::new(name);
        let stays_inside = relative
            .components()
            .all(|part| matches!(part, std::path::Component::Normal(_)));
        if !stays_inside {
            return None;
        }
        read_bytes(&folder.join(relative), limits).ok()
    };
    let read = || read_mesh_with_siblings(&name_of(path), bytes, limits, &sibling);
    unless_it_panics(read)?.map_err(|error| error.to_string())
}

/// Parsers of other people may panic on damage that nobody foresaw; that must cost one file, not
/// all the others that are read beside it.
pub(super) fn unless_it_panics<T>(read: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(read))
        .map_err(|_| "too damaged to read (a fault of this program)".to_owned())
}

/// An error of the system, as it is said here.
pub(super) fn reason(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::PermissionDenied => "no permission to read it".to_owned(),
        kind => kind.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_over_the_limit_is_refused_by_its_size() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.obj");
        std::fs::write(&path, [0; 11]).unwrap();
        let limits = Limits {
            file_bytes: 10,
            ..Limits::default()
        };
        assert_eq!(
            read_bytes(&path, &limits).unwrap_err(),
            "11 bytes; the limit is 10"
        );
        assert_eq!(
            read_bytes(folder.path(), &limits).unwrap_err(),
            "not a file"
        );
        assert_eq!(
            read_bytes(&folder.path().join("b"), &limits).unwrap_err(),
            "there is no such file"
        );
    }

    #[test]
    fn a_reader_that_panics_costs_one_file() {
        let outcome = unless_it_panics(|| -> u8 { panic!("unforeseen") });
        assert!(outcome.unwrap_err().starts_with("too damaged"));
        assert_eq!(unless_it_panics(|| 3), Ok(3));
    }

    #[test]
    fn text_in_another_encoding_is_refused_at_its_byte() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("study.toml");
        std::fs::write(&path, b"name = \"\xe9\"").unwrap();
        assert_eq!(
            read_text(&path, &Limits::default()).unwrap_err(),
            "byte 8: not UTF-8 text"
        );
        std::fs::write(&path, "\u{feff}name").unwrap();
        assert_eq!(read_text(&path, &Limits::default()).unwrap(), "name");
        let list = b"<?xml version='1.0' encoding='ISO-8859-1'?><a b='\xe9'/>";
        std::fs::write(&path, list).unwrap();
        assert!(read_text(&path, &Limits::default()).unwrap().contains('é'));
        let attributes: String = (0..60_000).map(|k| format!(" a{k}=''")).collect();
        std::fs::write(&path, format!("<a{attributes}/>")).unwrap();
        assert_eq!(
            read_text(&path, &Limits::default()).unwrap_err(),
            "60000 XML attributes of one element; the limit is 256"
        );
    }
}
