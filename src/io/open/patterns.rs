//! File patterns of a manifest: `n01/*.ply`, `?` for one letter, `[0-9]` for one of some, `**` for any folders.

use std::path::{Path, PathBuf};

use super::folder_contents::{FileRole, role};
use super::folders::{Folders, What, composed, existing};
use super::group_files::stem;
use super::read_file::name_of;
use super::readings::read_names;
use crate::io::limits::MAX_ENTRIES;
use crate::progress::{Progress, Stopped};
use crate::study::natural_order;

/// Whether a pattern stands for several names.
pub(super) fn has_wildcard(pattern: &str) -> bool {
    pattern.contains(['*', '?', '['])
}

/// The files that a pattern names, relative to `folder`: by frame, then in natural order.
///
/// # Errors
/// Inside: a sentence, where a file cannot be used or too many entries were looked at. Outside: [`Stopped`].
pub(super) fn files_of_pattern(
    folders: &mut Folders,
    folder: &Path,
    pattern: &str,
    progress: &Progress,
) -> Result<Result<Vec<PathBuf>, String>, Stopped> {
    let pattern = composed(&pattern.replace('\\', "/"));
    let mut walk = Walk {
        folders,
        progress,
        found: Vec::new(),
    };
    let start = if pattern.starts_with('/') {
        Path::new("/")
    } else {
        folder
    };
    let parts: Vec<&str> = pattern
        .split('/')
        .filter(|part| !part.is_empty() && *part != ".")
        .collect();
    match walk.collect(start, &parts) {
        Ok(()) => Ok(Ok(in_order_of_frames(walk.found))),
        Err(Interrupted::Stopped) => Err(Stopped),
        Err(Interrupted::Failed(reason)) => Ok(Err(reason)),
    }
}

/// By the frames in the names where each has one, else in natural order. Where all files have one name, the names of
/// their folders say the frame.
pub(super) fn in_order_of_frames(mut files: Vec<PathBuf>) -> Vec<PathBuf> {
    files.sort_by(|a, b| natural_order(&a.to_string_lossy(), &b.to_string_lossy()));
    files.dedup();
    let stems = telling_names(&files);
    let (names, _) = read_names(&stems.iter().map(String::as_str).collect::<Vec<_>>());
    if names.iter().all(|name| name.frame.is_some()) {
        let mut order: Vec<usize> = (0..files.len()).collect();
        // stable: files of one frame stay in natural order
        order.sort_by_key(|&place| names[place].frame);
        files = order
            .into_iter()
            .map(|place| files[place].clone())
            .collect();
    }
    files
}

/// The part of each path that tells the files apart: their names, or those of their folders where all have one name.
pub(super) fn telling_names(files: &[PathBuf]) -> Vec<String> {
    let stems: Vec<String> = files.iter().map(|path| stem(path)).collect();
    let all_equal = stems.windows(2).all(|pair| pair[0] == pair[1]);
    if files.len() < 2 || !all_equal {
        return stems.iter().map(|stem| composed(stem)).collect();
    }
    let folder = |path: &PathBuf| path.parent().map(name_of);
    files
        .iter()
        .map(|path| composed(&folder(path).unwrap_or_default()))
        .collect()
}

enum Interrupted {
    Stopped,
    Failed(String),
}

impl From<Stopped> for Interrupted {
    fn from(_: Stopped) -> Self {
        Self::Stopped
    }
}

struct Walk<'w> {
    folders: &'w mut Folders,
    progress: &'w Progress,
    found: Vec<PathBuf>,
}

impl Walk<'_> {
    fn collect(&mut self, folder: &Path, parts: &[&str]) -> Result<(), Interrupted> {
        let Some((part, rest)) = parts.split_first() else {
            return Ok(());
        };
        if !has_wildcard(part) {
            let path = existing(self.folders, folder, part, self.progress)?;
            if let Some(why) = self.folders.unusable(&path) {
                return Err(Interrupted::Failed(format!("{}: {why}", name_of(&path))));
            }
            if !rest.is_empty() {
                return self.collect(&path, rest);
            }
            return self.take_named(path);
        }
        if *part == "**" {
            self.collect(folder, rest)?;
        }
        let Ok(listing) = self.folders.list(folder, self.progress)? else {
            return Ok(());
        };
        let start: String = part
            .chars()
            .take_while(|c| !matches!(c, '*' | '?' | '['))
            .collect();
        for entry in listing.beginning_with(&start) {
            self.progress.check()?;
            self.folders.compared().ok_or_else(too_many)?;
            // As in a shell, a star is no hidden file: systems leave `._endo_0.obj` beside `endo_0.obj`.
            if entry.name.starts_with('.') && !part.starts_with('.') {
                continue;
            }
            if *part == "**" {
                // Links are not followed, so that a folder that holds itself ends.
                if entry.what == What::Folder {
                    self.collect(&entry.path, parts)?;
                }
            } else if matches(part, &entry.name) {
                match self.folders.followed(entry) {
                    What::File if rest.is_empty() => self.found.push(entry.path.clone()),
                    What::Folder | What::LinkedFolder if !rest.is_empty() => {
                        self.collect(&entry.path, rest)?;
                    }
                    What::Unusable(why)
                        if !rest.is_empty() || role(&entry.path) != FileRole::Other =>
                    {
                        return Err(Interrupted::Failed(format!("{}: {why}", entry.name)));
                    }
                    _ => {}
                }
            }
        }
        if listing.cut_short || self.folders.exhausted() {
            return Err(too_many());
        }
        Ok(())
    }

    /// A file that the manifest names in full.
    fn take_named(&mut self, path: PathBuf) -> Result<(), Interrupted> {
        if path.is_file() {
            self.found.push(path);
        } else if path.is_symlink() {
            let name = name_of(&path);
            return Err(Interrupted::Failed(format!("{name}: a link to nowhere")));
        }
        Ok(())
    }
}

fn too_many() -> Interrupted {
    Interrupted::Failed(format!(
        "the patterns of the study lead through too many files and folders (the limit is {MAX_ENTRIES})"
    ))
}

/// Whether a name fits a pattern of `*`, `?` and `[…]`.
fn matches(pattern: &str, name: &str) -> bool {
    let pattern: Vec<char> = pattern.chars().collect();
    let name: Vec<char> = name.chars().collect();
    // Where the last star stood, and how much of the name it has taken so far.
    let mut star: Option<(usize, usize)> = None;
    let (mut at, mut seen) = (0, 0);
    while seen < name.len() {
        match pattern.get(at) {
            Some('*') => {
                star = Some((at, seen));
                at += 1;
            }
            Some(_) => match one(&pattern[at..], name[seen]) {
                Some(length) => {
                    at += length;
                    seen += 1;
                }
                None => match star.as_mut() {
                    Some((place, taken)) => {
                        *taken += 1;
                        (at, seen) = (*place + 1, *taken);
                    }
                    None => return false,
                },
            },
            None => match star.as_mut() {
                Some((place, taken)) => {
                    *taken += 1;
                    (at, seen) = (*place + 1, *taken);
                }
                None => return false,
            },
        }
    }
    pattern[at..].iter().all(|&c| c == '*')
}

/// How many letters of the pattern fit this one letter of the name.
fn one(pattern: &[char], letter: char) -> Option<usize> {
    match pattern {
        ['?', ..] => Some(1),
        ['[', rest @ ..] => {
            let end = rest.iter().position(|&c| c == ']')?;
            let (within, negated) = match &rest[..end] {
                ['!' | '^', set @ ..] => (set, true),
                set => (set, false),
            };
            let mut fits = within.contains(&letter);
            for range in within.windows(3).filter(|range| range[1] == '-') {
                fits |= (range[0]..=range[2]).contains(&letter);
            }
            (fits != negated).then_some(end + 2)
        }
        [c, ..] if *c == letter => Some(1),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn names_fit_patterns() {
        for (pattern, name, fits) in [
            ("*.ply", "a.ply", true),
            ("*.ply", "a.plyx", false),
            ("endo_*.obj", "endo_12.obj", true),
            ("endo_?.obj", "endo_12.obj", false),
            ("a*b*c", "axxbxxbc", true),
            ("g[0-9].obj", "g7.obj", true),
            ("g[!0-9].obj", "g7.obj", false),
            ("", "", true),
            ("*", "", true),
        ] {
            assert_eq!(matches(pattern, name), fits, "{pattern} {name}");
        }
    }

    #[test]
    fn files_come_in_the_order_of_frames() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("n01")).unwrap();
        for name in ["g10.ply", "g2.ply", "ES.ply", "ED.ply"] {
            fs::write(folder.path().join("n01").join(name), "").unwrap();
        }
        let names = |pattern: &str| -> Vec<String> {
            let mut folders = Folders::new(&[folder.path().to_owned()], false);
            files_of_pattern(&mut folders, folder.path(), pattern, &Progress::default())
                .unwrap()
                .unwrap()
                .iter()
                .map(|path| stem(path))
                .collect()
        };
        assert_eq!(names("n01/g*.ply"), ["g2", "g10"]);
        assert_eq!(names("n01/E?.ply"), ["ED", "ES"]);
        assert_eq!(names("**/g*.ply"), ["g2", "g10"]);
        assert_eq!(names("n01/g2.ply"), ["g2"]);
        assert!(names("n02/*.ply").is_empty());
    }

    #[test]
    fn decimals_come_in_the_order_of_their_values() {
        let folder = tempfile::tempdir().unwrap();
        for name in [
            "e_0.05.obj",
            "e_0.1.obj",
            "e_0.15.obj",
            "e_0.0.obj",
            "._e_0.0.obj",
        ] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        for frame in ["t_0.1", "t_0.05"] {
            fs::create_dir(folder.path().join(frame)).unwrap();
            fs::write(folder.path().join(frame).join("wall.obj"), "").unwrap();
        }
        let mut folders = Folders::new(&[folder.path().to_owned()], false);
        let mut files = |pattern: &str| -> Vec<String> {
            files_of_pattern(&mut folders, folder.path(), pattern, &Progress::default())
                .unwrap()
                .unwrap()
                .iter()
                .map(|path| {
                    path.strip_prefix(folder.path())
                        .unwrap()
                        .display()
                        .to_string()
                })
                .collect()
        };
        assert_eq!(
            files("*.obj"),
            ["e_0.0.obj", "e_0.05.obj", "e_0.1.obj", "e_0.15.obj"]
        );
        assert_eq!(files("*/wall.obj"), ["t_0.05/wall.obj", "t_0.1/wall.obj"]);
    }

    #[test]
    fn patterns_of_one_study_share_one_budget() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a.obj"), "").unwrap();
        let mut folders = Folders::new(&[folder.path().to_owned()], false);
        let mut files = |pattern: &str| {
            files_of_pattern(&mut folders, folder.path(), pattern, &Progress::default()).unwrap()
        };
        assert_eq!(files("*.obj").unwrap().len(), 1);
        let outcomes: Vec<_> = (0..3).map(|_| files("/**/nothing")).collect();
        let refused = |outcome: &Result<_, String>| matches!(outcome, Err(reason) if reason.contains("too many"));
        // small machines have fewer files than the budget
        assert!(outcomes.iter().all(|o| refused(o) || o.is_ok()));
    }
}
