//! Files that their owner alone may read.

use std::fs::{self, OpenOptions};
use std::io::{ErrorKind, Result};
use std::path::Path;

/// Makes a file that its owner alone may read and write, empty if it is new; what is written into it later keeps that.
/// On systems without such rights the file stays as it is.
///
/// # Errors
/// If it or its folder cannot be made, or it is not the user's own.
pub fn make_private(path: &Path) -> Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let mut new = OpenOptions::new();
    new.write(true).create_new(true);
    restrict_new(&mut new);
    match new.open(path) {
        Ok(_) => Ok(()),
        Err(error) if error.kind() == ErrorKind::AlreadyExists => restrict(path),
        Err(error) => Err(error),
    }
}

#[cfg(unix)]
fn restrict_new(options: &mut OpenOptions) {
    std::os::unix::fs::OpenOptionsExt::mode(options, 0o600);
}

#[cfg(unix)]
fn restrict(path: &Path) -> Result<()> {
    fs::set_permissions(path, std::os::unix::fs::PermissionsExt::from_mode(0o600))
}

#[cfg(not(unix))]
fn restrict_new(_: &mut OpenOptions) {}

#[cfg(not(unix))]
fn restrict(_: &Path) -> Result<()> {
    Ok(())
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::fs::PermissionsExt;

    #[test]
    fn a_new_file_and_one_that_others_could_read_are_for_their_owner_alone() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a/app.ron");
        let mode = || fs::metadata(&path).unwrap().permissions().mode() & 0o777;
        make_private(&path).unwrap();
        assert_eq!(mode(), 0o600);
        // As the window writes: the same file, emptied first.
        fs::File::create(&path).unwrap();
        assert_eq!(mode(), 0o600);
        fs::set_permissions(&path, fs::Permissions::from_mode(0o644)).unwrap();
        fs::write(&path, "kept").unwrap();
        make_private(&path).unwrap();
        assert_eq!(mode(), 0o600);
        assert_eq!(fs::read_to_string(&path).unwrap(), "kept");
    }
}
