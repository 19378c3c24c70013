//! Writes finished files whole: what stands under a name is never half a file.

use std::fs::{self, File, OpenOptions};
use std::io::{BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// A file that is to be written.
#[derive(Debug)]
pub struct ExportFile {
    /// Where to.
    pub path: PathBuf,
    /// All of it.
    pub bytes: FileBytes,
}

impl ExportFile {
    /// A text under a name in a folder.
    pub fn text(folder: &Path, name: &str, text: String) -> Self {
        Self {
            path: folder.join(name),
            bytes: text.into_bytes().into(),
        }
    }
}

/// What a file holds.
#[derive(Debug)]
pub enum FileBytes {
    /// In memory.
    Held(Vec<u8>),
    /// Beside its place already, since it may be larger than memory.
    Written(PartialFile),
}

impl From<Vec<u8>> for FileBytes {
    fn from(bytes: Vec<u8>) -> Self {
        Self::Held(bytes)
    }
}

/// A file that grows under a partial name beside its place; dropped, it is gone.
///
/// A process that is killed leaves `.cardiomorph-PROCESS-NUMBER.partial` in the folder. Nobody removes such a file: whether its
/// process still runs is not known for one of another machine on a shared disk.
#[derive(Debug)]
pub struct PartialFile {
    place: PathBuf,
    partial: PathBuf,
    file: BufWriter<File>,
}

impl PartialFile {
    /// An empty one, making folders as needed.
    ///
    /// # Errors
    /// If it cannot be made: why, and which.
    pub fn create(place: PathBuf) -> Result<Self, String> {
        let made = make_folder(&place).and_then(|()| create_beside(&place));
        match made {
            Ok((partial, file)) => Ok(Self {
                file: BufWriter::new(file),
                place,
                partial,
            }),
            Err(error) => Err(cannot_write(&error, &place)),
        }
    }

    /// Adds bytes, such as text, at the end.
    ///
    /// # Errors
    /// If it cannot be written: why, and which.
    pub fn write(&mut self, bytes: impl AsRef<[u8]>) -> Result<(), String> {
        let written = self.file.write_all(bytes.as_ref());
        written.map_err(|error| cannot_write(&error, &self.place))
    }

    /// Where it will stand.
    pub(super) fn place(&self) -> &Path {
        &self.place
    }

    /// Gives it another place in the same folder than it was made for.
    pub(super) fn set_target(&mut self, place: PathBuf) {
        self.place = place;
    }

    /// Gives it its name.
    pub(super) fn finish(&mut self) -> std::io::Result<()> {
        self.file.flush()?;
        fs::rename(&self.partial, &self.place)
    }
}

impl Drop for PartialFile {
    fn drop(&mut self) {
        // Gone already where it has got its name.
        fs::remove_file(&self.partial).ok();
    }
}

/// Writes every file, making folders as needed, and returns the paths.
///
/// All are written beside their places under partial names first and renamed only then, so that a full disk or a crash
/// leaves the files that stood there before.
///
/// # Errors
/// At the first file that cannot be written: why, and which.
pub fn write_files(files: Vec<ExportFile>) -> Result<Vec<PathBuf>, String> {
    let mut staged = staged(files)?;
    for partial in &mut staged {
        let named = partial.finish();
        named.map_err(|error| cannot_write(&error, &partial.place))?;
    }
    Ok(staged.iter().map(|partial| partial.place.clone()).collect())
}

/// Files that are whole, but have their names still to come.
///
/// # Errors
/// If one cannot be written, or a folder lies at its place: why, and which.
pub(super) fn staged(files: Vec<ExportFile>) -> Result<Vec<PartialFile>, String> {
    let stage = |file: ExportFile| {
        if file.path.is_dir() {
            let taken = std::io::Error::from(ErrorKind::IsADirectory);
            return Err(cannot_write(&taken, &file.path));
        }
        let mut partial = match file.bytes {
            FileBytes::Written(partial) => partial,
            FileBytes::Held(bytes) => {
                let mut partial = PartialFile::create(file.path)?;
                partial.write(bytes)?;
                partial
            }
        };
        let flushed = partial.file.flush();
        flushed.map_err(|error| cannot_write(&error, &partial.place))?;
        Ok(partial)
    };
    files.into_iter().map(stage).collect()
}

pub(super) fn cannot_write(error: &std::io::Error, path: &Path) -> String {
    format!("cannot write: {error}: {}", path.display())
}

/// Makes the folder that a file is to stand in.
fn make_folder(path: &Path) -> std::io::Result<()> {
    let folder = path.parent();
    folder
        .filter(|folder| !folder.as_os_str().is_empty())
        .map_or(Ok(()), fs::create_dir_all)
}

/// A new, empty file beside `path` under a partial name that no other run has: a link that lies at such a name is not
/// followed.
fn create_beside(path: &Path) -> std::io::Result<(PathBuf, File)> {
    loop {
        let partial = free_name_beside(path);
        match OpenOptions::new()
            .write(true)
            .create_new(true)
            .open(&partial)
        {
            Ok(file) => return Ok((partial, file)),
            // Laid there meanwhile: the next number.
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
}

/// A partial name beside `path` at which nothing lies.
///
/// It holds the number of this process: two runs into one folder never share it. It does not hold the name of the file,
/// since one that is just short enough for the disk would no longer be.
pub(super) fn free_name_beside(path: &Path) -> PathBuf {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    let folder = path.parent().unwrap_or_else(|| Path::new(""));
    let mut names = std::iter::repeat_with(|| {
        let (process, number) = (std::process::id(), NEXT.fetch_add(1, Ordering::Relaxed));
        folder.join(format!(".cardiomorph-{process}-{number}.partial"))
    });
    let taken = |name: &PathBuf| fs::symlink_metadata(name).is_ok();
    names.find(|name| !taken(name)).unwrap_or_default()
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
            bytes: b"subject,frame\n".to_vec().into(),
        };
        assert_eq!(
            write_files(vec![file]).unwrap(),
            std::slice::from_ref(&path)
        );
        assert_eq!(fs::read(&path).unwrap(), b"subject,frame\n");
        let names: Vec<_> = fs::read_dir(path.parent().unwrap()).unwrap().collect();
        assert_eq!(names.len(), 1, "nothing partial is left behind");
    }

    #[test]
    fn a_place_that_cannot_be_written_is_named_last() {
        let folder = tempfile::tempdir().unwrap();
        let blocked = folder.path().join("taken");
        fs::create_dir(&blocked).unwrap();
        let error = write_files(vec![ExportFile {
            path: blocked.clone(),
            bytes: vec![1].into(),
        }])
        .unwrap_err();
        assert!(error.starts_with("cannot write: "), "{error}");
        assert!(error.ends_with(&blocked.display().to_string()), "{error}");
    }

    #[test]
    fn where_one_file_cannot_be_written_all_old_ones_stay() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::write(at("a.csv"), "old").unwrap();
        fs::create_dir(at("b.csv")).unwrap();
        let files =
            ["a.csv", "b.csv"].map(|name| ExportFile::text(folder.path(), name, "new".to_owned()));
        write_files(files.into()).unwrap_err();
        assert_eq!(fs::read_to_string(at("a.csv")).unwrap(), "old");
        let names = fs::read_dir(folder.path()).unwrap().count();
        assert_eq!(names, 2, "nothing partial is left behind");
    }

    #[test]
    fn a_file_that_grows_has_its_name_only_once_it_is_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("report/atoms.csv");
        let grown = || {
            let mut partial = PartialFile::create(path.clone()).unwrap();
            partial.write("subject\n").unwrap();
            partial.write("N01\n").unwrap();
            partial
        };
        let names = || fs::read_dir(path.parent().unwrap()).unwrap().count();
        let partial = grown();
        assert!(!path.exists() && names() == 1);
        drop(partial);
        assert_eq!(names(), 0, "what was given up is gone");
        let file = ExportFile {
            path: path.clone(),
            bytes: FileBytes::Written(grown()),
        };
        write_files(vec![file]).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"subject\nN01\n");
        assert_eq!(names(), 1, "nothing partial is left behind");
    }

    #[test]
    fn two_files_that_grow_at_one_place_do_not_write_into_each_other() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("atoms.csv");
        let mut first = PartialFile::create(path.clone()).unwrap();
        let mut second = PartialFile::create(path.clone()).unwrap();
        first.write("first\n").unwrap();
        second.write("second\n").unwrap();
        assert_ne!(first.partial, second.partial);
        for (grown, whole) in [(first, "first\n"), (second, "second\n")] {
            write_files(vec![ExportFile {
                path: path.clone(),
                bytes: FileBytes::Written(grown),
            }])
            .unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), whole);
        }
    }

    #[cfg(unix)]
    #[test]
    fn a_link_at_a_partial_name_is_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let (victim, place) = (folder.path().join("victim"), folder.path().join("t.csv"));
        fs::write(&victim, "untouched").unwrap();
        // Links at all names that the next files could take, as far as another test may have counted meanwhile.
        let probe = PartialFile::create(place.clone()).unwrap();
        let name = probe.partial.to_str().unwrap();
        let (head, number) = name.trim_end_matches(".partial").rsplit_once('-').unwrap();
        let number: u64 = number.parse().unwrap();
        for next in number + 1..number + 200 {
            let link = format!("{head}-{next}.partial");
            std::os::unix::fs::symlink(&victim, link).unwrap();
        }
        write_files(vec![ExportFile::text(
            folder.path(),
            "t.csv",
            "rows".to_owned(),
        )])
        .unwrap();
        assert_eq!(fs::read_to_string(&victim).unwrap(), "untouched");
        assert_eq!(fs::read_to_string(&place).unwrap(), "rows");
        assert!(!place.is_symlink());
    }

    #[test]
    fn a_name_as_long_as_the_disk_takes_can_be_written() {
        let folder = tempfile::tempdir().unwrap();
        let name = format!("{}.csv", "x".repeat(251));
        write_files(vec![ExportFile::text(folder.path(), &name, String::new())]).unwrap();
        assert!(folder.path().join(name).exists());
    }
}
