//! Writes finished files whole: what stands under a name is never half a file.

use std::fs;
use std::path::{Path, PathBuf};

/// A file that is to be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExportFile {
    /// Where to.
    pub path: PathBuf,
    /// All of it.
    pub bytes: Vec<u8>,
}

/// Writes every file, making folders as needed, and returns the paths.
///
/// Each is written beside its place under a passing name and then renamed, so that a full disk
/// or a crash leaves the file that stood there before.
///
/// # Errors
/// At the first file that cannot be written: why, and which.
pub fn write_files(files: &[ExportFile]) -> Result<Vec<PathBuf>, String> {
    for file in files {
        write_whole(&file.path, &file.bytes)
            .map_err(|error| format!("cannot write: {error}: {}", file.path.display()))?;
    }
    Ok(files.iter().map(|file| file.path.clone()).collect())
}

fn write_whole(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if let Some(folder) = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty())
    {
        fs::create_dir_all(folder)?;
    }
    let mut passing = path.as_os_str().to_owned();
    passing.push(".partial");
    let passing = PathBuf::from(passing);
    let written = fs::write(&passing, bytes).and_then(|()| fs::rename(&passing, path));
    if written.is_err() {
        fs::remove_file(&passing).ok();
    }
    written
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_stand_whole_in_folders_that_were_missing() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("report/tables/frames.csv");
        let file = ExportFile {
            path: path.clone(),
            bytes: b"subject,frame\n".to_vec(),
        };
        assert_eq!(write_files(&[file]).unwrap(), std::slice::from_ref(&path));
        assert_eq!(fs::read(&path).unwrap(), b"subject,frame\n");
        let names: Vec<_> = fs::read_dir(path.parent().unwrap()).unwrap().collect();
        assert_eq!(names.len(), 1, "nothing passing is left behind");
    }

    #[test]
    fn a_place_that_cannot_be_written_is_named_last() {
        let folder = tempfile::tempdir().unwrap();
        let blocked = folder.path().join("taken");
        fs::create_dir(&blocked).unwrap();
        let error = write_files(&[ExportFile {
            path: blocked.clone(),
            bytes: vec![1],
        }])
        .unwrap_err();
        assert!(error.starts_with("cannot write: "), "{error}");
        assert!(error.ends_with(&blocked.display().to_string()), "{error}");
    }
}
