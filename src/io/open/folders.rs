//! What lies in the folders of a study: each folder is listed once, links are looked at, and the number of entries is
//! bounded for the whole study.

use std::collections::HashMap;
use std::fs::{self, DirEntry};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use unicode_normalization::UnicodeNormalization;

use super::read_file::reason;
use crate::io::limits::{MAX_COMPARED_NAMES, MAX_ENTRIES};
use crate::progress::{Progress, Stopped};

/// One name in a folder.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    /// As text, composed (NFC), so that one name is equal to itself whichever system wrote it.
    pub(super) name: String,
    pub(super) path: PathBuf,
    pub(super) what: What,
}

/// What a name in a folder stands for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum What {
    File,
    Folder,
    /// A link that was not looked at yet ([`Folders::followed`]).
    Link,
    /// A link to a folder of the study.
    LinkedFolder,
    /// Nothing that can be read; why.
    Unusable(String),
}

/// All names of one folder, in the order of their bytes.
#[derive(Debug, Default)]
pub(super) struct Listing {
    pub(super) entries: Vec<Entry>,
    /// Whether the folder holds more than could be looked at.
    pub(super) cut_short: bool,
}

impl Listing {
    /// Entries whose names begin so.
    pub(super) fn beginning_with<'l>(&'l self, start: &'l str) -> impl Iterator<Item = &'l Entry> {
        let first = self
            .entries
            .partition_point(|entry| entry.name.as_str() < start);
        let from = self.entries[first..].iter();
        from.take_while(move |entry| entry.name.starts_with(start))
    }

    /// The entry of this name, however its letters are composed.
    pub(super) fn named(&self, name: &str) -> Option<&Entry> {
        let name = composed(name);
        let place = self
            .entries
            .binary_search_by(|entry| entry.name.cmp(&name))
            .ok()?;
        self.entries.get(place)
    }
}

/// Lists folders, each once.
pub(super) struct Folders {
    /// What was asked for, without links: links that lead out of all of them are followed where `follow_links` says so alone.
    roots: Vec<PathBuf>,
    /// Whether links that lead out of all roots are followed.
    follow_links: bool,
    /// What was asked for, as it was written.
    stated: Vec<PathBuf>,
    known: HashMap<PathBuf, Arc<Listing>>,
    left: usize,
    left_to_compare: usize,
}

impl Folders {
    /// For a study of these paths.
    pub(super) fn new(paths: &[PathBuf], follow_links: bool) -> Self {
        let folder_of = |path: PathBuf| match path.parent() {
            Some(folder) if !path.is_dir() => folder.to_owned(),
            _ => path,
        };
        let real = |path: &PathBuf| path.canonicalize().ok().map(folder_of);
        let stated = |path: &PathBuf| std::path::absolute(path).ok().map(folder_of);
        Self {
            roots: paths.iter().filter_map(real).collect(),
            stated: paths.iter().filter_map(stated).collect(),
            follow_links,
            known: HashMap::new(),
            left: MAX_ENTRIES,
            left_to_compare: MAX_COMPARED_NAMES,
        }
    }

    /// Whether more was there than may be looked at.
    pub(super) fn exhausted(&self) -> bool {
        self.left == 0
    }

    /// Counts a name that a pattern is compared with; `None` once there were too many.
    pub(super) fn compared(&mut self) -> Option<()> {
        self.left_to_compare = self.left_to_compare.checked_sub(1)?;
        Some(())
    }

    /// Why a file that a manifest or a list names cannot be read, if that is known: it is no file, or a link on the way to it
    /// leads out of the study. A name that says itself that it lies elsewhere (`/data/a.obj`, `../a.obj`) is meant so.
    pub(super) fn unusable(&self, path: &Path) -> Option<String> {
        if fs::metadata(path).is_ok_and(|facts| !facts.is_file() && !facts.is_dir()) {
            return Some(SPECIAL.to_owned());
        }
        let within =
            |roots: &[PathBuf], path: &Path| roots.iter().any(|root| path.starts_with(root));
        let seems_inside = std::path::absolute(path).is_ok_and(|path| {
            let parts = path.components();
            within(&self.stated, &path)
                && !parts.into_iter().any(|part| part == Component::ParentDir)
        });
        let real = path.canonicalize().ok()?;
        let out = seems_inside && !self.follow_links && !within(&self.roots, &real);
        out.then(|| out_of_the_study(&real))
    }

    /// What a name stands for, with a link followed within what was asked for.
    pub(super) fn followed(&self, entry: &Entry) -> What {
        match &entry.what {
            What::Link => self.what_of_link(&entry.path),
            what => what.clone(),
        }
    }

    /// The names in a folder. Once too many were seen, the rest is left out ([`Listing::cut_short`]).
    ///
    /// # Errors
    /// Inside: a sentence, where the folder cannot be listed. Outside: [`Stopped`].
    pub(super) fn list(
        &mut self,
        folder: &Path,
        progress: &Progress,
    ) -> Result<Result<Arc<Listing>, String>, Stopped> {
        if let Some(known) = self.known.get(folder) {
            return Ok(Ok(Arc::clone(known)));
        }
        let found = match fs::read_dir(if folder.as_os_str().is_empty() {
            Path::new(".")
        } else {
            folder
        }) {
            Ok(found) => found,
            Err(error) => return Ok(Err(reason(&error))),
        };
        let mut listing = Listing::default();
        for entry in found.flatten() {
            progress.check()?;
            let Some(left) = self.left.checked_sub(1) else {
                listing.cut_short = true;
                break;
            };
            self.left = left;
            let path = folder.join(entry.file_name());
            listing.entries.push(Entry {
                name: composed(&entry.file_name().to_string_lossy()),
                what: what(&entry),
                path,
            });
        }
        let order = |a: &Entry, b: &Entry| (&a.name, &a.path).cmp(&(&b.name, &b.path));
        listing.entries.sort_by(order);
        let listing = Arc::new(listing);
        self.known.insert(folder.to_owned(), Arc::clone(&listing));
        Ok(Ok(listing))
    }

    /// Links are followed within what was asked for.
    fn what_of_link(&self, path: &Path) -> What {
        let shown =
            fs::read_link(path).map_or_else(|_| String::new(), |to| to.display().to_string());
        let target = match path.canonicalize() {
            Ok(target) => target,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
                return What::Unusable(format!("a link to {shown}, which is not there"));
            }
            Err(error) => {
                return What::Unusable(format!(
                    "a link to {shown} that cannot be followed: {}",
                    reason(&error)
                ));
            }
        };
        if !self.follow_links && !self.roots.iter().any(|root| target.starts_with(root)) {
            return What::Unusable(out_of_the_study(&target));
        }
        match fs::metadata(&target) {
            Ok(facts) if facts.is_dir() => What::LinkedFolder,
            Ok(facts) if facts.is_file() => What::File,
            Ok(_) => What::Unusable(SPECIAL.to_owned()),
            Err(error) => What::Unusable(reason(&error)),
        }
    }
}

fn what(entry: &DirEntry) -> What {
    match entry.file_type() {
        Ok(kind) if kind.is_symlink() => What::Link,
        Ok(kind) if kind.is_dir() => What::Folder,
        Ok(kind) if kind.is_file() => What::File,
        Ok(_) => What::Unusable(SPECIAL.to_owned()),
        Err(error) => What::Unusable(reason(&error)),
    }
}

fn out_of_the_study(target: &Path) -> String {
    format!(
        "a link out of the study, to {}, is not followed unless asked for (--follow-links, or File ▸ Open again, following links)",
        target.display()
    )
}

const SPECIAL: &str = "not a file but a pipe, a socket or a device: not read";

/// Text with its letters composed (NFC): `ü` is one letter, however a system stores it.
pub(super) fn composed(text: &str) -> String {
    if text.is_ascii() {
        return text.to_owned();
    }
    text.nfc().collect()
}

/// The file or folder that a relative path with `/` means from a folder, where the letters of a name may be composed
/// in another way on disk; the path as it is if nothing is there.
pub(super) fn existing(
    folders: &mut Folders,
    folder: &Path,
    name: &str,
    progress: &Progress,
) -> Result<PathBuf, Stopped> {
    let plain = folder.join(name);
    if name.is_ascii() || plain.symlink_metadata().is_ok() {
        return Ok(plain);
    }
    let mut place = if name.starts_with('/') {
        PathBuf::from("/")
    } else {
        folder.to_owned()
    };
    for part in name.split('/').filter(|part| !part.is_empty()) {
        let direct = place.join(part);
        if direct.symlink_metadata().is_ok() || part == ".." || part == "." {
            place = direct;
            continue;
        }
        let listing = folders.list(&place, progress)?;
        place = match listing
            .as_ref()
            .ok()
            .and_then(|listing| listing.named(part))
        {
            Some(entry) => entry.path.clone(),
            None => return Ok(plain),
        };
    }
    Ok(place)
}

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;
    use std::os::unix::fs::symlink;

    fn whats(root: &Path) -> Vec<(String, What)> {
        let mut folders = Folders::new(&[root.to_owned()], false);
        let listing = folders.list(root, &Progress::default()).unwrap().unwrap();
        let pairs = listing.entries.iter();
        pairs
            .map(|entry| (entry.name.clone(), folders.followed(entry)))
            .collect()
    }

    #[test]
    fn links_are_followed_within_the_study_only() {
        let (root, other) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
        fs::write(root.path().join("a"), "").unwrap();
        fs::write(other.path().join("b"), "").unwrap();
        symlink("a", root.path().join("inside")).unwrap();
        symlink(other.path().join("b"), root.path().join("outside")).unwrap();
        symlink("/", root.path().join("root")).unwrap();
        symlink("nowhere", root.path().join("broken")).unwrap();
        symlink("loop", root.path().join("loop")).unwrap();
        symlink(".", root.path().join("self")).unwrap();
        let whats: BTreeMap<String, What> = whats(root.path()).into_iter().collect();
        assert_eq!(whats["inside"], What::File);
        assert_eq!(whats["self"], What::LinkedFolder);
        for (name, why) in [
            ("outside", "out of the study"),
            ("root", "out of the study, to /,"),
            ("broken", "a link to nowhere"),
            ("loop", "cannot be followed"),
        ] {
            let What::Unusable(text) = &whats[name] else {
                panic!("{name} is usable");
            };
            assert!(text.contains(why), "{name}: {text}");
        }
        let mut both = Folders::new(&[root.path().to_owned(), other.path().to_owned()], false);
        let listing = both
            .list(root.path(), &Progress::default())
            .unwrap()
            .unwrap();
        assert_eq!(both.followed(listing.named("outside").unwrap()), What::File);
        let asked = Folders::new(&[root.path().to_owned()], true);
        assert_eq!(
            asked.followed(listing.named("outside").unwrap()),
            What::File
        );
        let root_of_all = listing.named("root").unwrap();
        assert_eq!(asked.followed(root_of_all), What::LinkedFolder);
    }

    #[test]
    fn a_name_is_found_in_either_spelling() {
        let root = tempfile::tempdir().unwrap();
        fs::create_dir(root.path().join("Mu\u{308}ller")).unwrap();
        fs::write(root.path().join("Mu\u{308}ller/a.obj"), "").unwrap();
        let mut folders = Folders::new(&[root.path().to_owned()], false);
        let found = existing(
            &mut folders,
            root.path(),
            "M\u{fc}ller/a.obj",
            &Progress::default(),
        );
        assert!(found.unwrap().is_file());
        let missing = existing(
            &mut folders,
            root.path(),
            "M\u{fc}ller/b.obj",
            &Progress::default(),
        );
        assert_eq!(missing.unwrap(), root.path().join("M\u{fc}ller/b.obj"));
    }
}
