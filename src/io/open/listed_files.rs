//! The files that a list or another program's path means, on this machine.

use std::path::{Path, PathBuf};

use super::folders::{Folders, existing};
use crate::progress::{Progress, Stopped};

/// The file that a list means by a name, and whether it was found at another place than the name says.
///
/// Names may be percent-encoded addresses, have backslashes, and be absolute on the machine that wrote them: of such a
/// path, the longest end that is there from the list's folder is taken.
pub(super) fn listed_file(
    folders: &mut Folders,
    folder: &Path,
    name: &str,
    progress: &Progress,
) -> Result<Option<(PathBuf, bool)>, Stopped> {
    let name = name.trim();
    let literal = folder.join(name);
    if literal.is_file() {
        return Ok(Some((literal, false)));
    }
    let address = name.strip_prefix("file://").unwrap_or(name);
    let slashes = address.replace('\\', "/");
    let decoded = percent_decoded(&slashes);
    for spelling in [Some(slashes), decoded].into_iter().flatten() {
        let place = existing(folders, folder, &spelling, progress)?;
        if place.is_file() {
            return Ok(Some((place, false)));
        }
        let drive = spelling.as_bytes().get(1) == Some(&b':');
        if !spelling.starts_with('/') && !drive {
            continue;
        }
        let parts: Vec<&str> = spelling
            .split('/')
            .filter(|part| !part.is_empty())
            .collect();
        for start in 0..parts.len() {
            let end = parts[start..].join("/");
            let place = existing(folders, folder, &end, progress)?;
            if !end.contains("..") && place.is_file() {
                return Ok(Some((place, true)));
            }
        }
    }
    Ok(None)
}

/// `my%20endo.vtp` as `my endo.vtp`; `None` where nothing is encoded, or not as UTF-8.
fn percent_decoded(text: &str) -> Option<String> {
    let bytes = text.as_bytes();
    let mut decoded = Vec::with_capacity(bytes.len());
    let mut place = 0;
    while place < bytes.len() {
        let code = (bytes[place] == b'%')
            .then(|| text.get(place + 1..place + 3))
            .flatten()
            .and_then(|code| u8::from_str_radix(code, 16).ok());
        match code {
            Some(byte) => {
                decoded.push(byte);
                place += 3;
            }
            None => {
                decoded.push(bytes[place]);
                place += 1;
            }
        }
    }
    String::from_utf8(decoded)
        .ok()
        .filter(|decoded| decoded != text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn names_of_other_systems_are_found() {
        let root = tempfile::tempdir().unwrap();
        fs::create_dir(root.path().join("data")).unwrap();
        for name in ["data/e0.vtp", "my endo.vtp", "50%.vtp", "M\u{fc}.vtp"] {
            fs::write(root.path().join(name), "").unwrap();
        }
        let mut folders = Folders::new(&[root.path().to_owned()], false);
        let mut find = |name: &str| {
            let found = listed_file(&mut folders, root.path(), name, &Progress::default());
            let relative = |path: PathBuf| path.strip_prefix(root.path()).unwrap().to_owned();
            found.unwrap().map(|(path, moved)| (relative(path), moved))
        };
        let here = |name: &str| Some((PathBuf::from(name), false));
        let moved = |name: &str| Some((PathBuf::from(name), true));
        assert_eq!(find("data/e0.vtp"), here("data/e0.vtp"));
        assert_eq!(find("data\\e0.vtp"), here("data/e0.vtp"));
        assert_eq!(
            find("./data/e0.vtp").unwrap().0.file_name().unwrap(),
            "e0.vtp"
        );
        assert_eq!(find("my%20endo.vtp"), here("my endo.vtp"));
        assert_eq!(find("50%.vtp"), here("50%.vtp"));
        assert_eq!(find("M%C3%BC.vtp"), here("M\u{fc}.vtp"));
        assert_eq!(find("Mu\u{308}.vtp"), here("M\u{fc}.vtp"));
        assert_eq!(find("C:\\study\\data\\e0.vtp"), moved("data/e0.vtp"));
        assert_eq!(find("/elsewhere/data/e0.vtp"), moved("data/e0.vtp"));
        assert_eq!(find("data/e1.vtp"), None);
        assert_eq!(find(""), None);
    }
}
