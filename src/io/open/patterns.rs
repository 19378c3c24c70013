//! File patterns of a manifest: `n01/*.ply`, `?` for one letter, `[0-9]` for one of some, `**` for any folders.

use std::path::{Path, PathBuf};

use super::file_name::mesh_name;
use super::natural_order::natural_order;

/// Folders and files that one pattern may look at, so that `/**/*` ends.
const MAX_ENTRIES: usize = 200_000;

/// The files that a pattern names, relative to `folder`: by frame, then in natural order.
///
/// # Errors
/// A sentence where the pattern leads through more than [`MAX_ENTRIES`] entries.
pub(super) fn files_of_pattern(folder: &Path, pattern: &str) -> Result<Vec<PathBuf>, String> {
    let mut found = Vec::new();
    let parts: Vec<&str> = pattern
        .split(['/', '\\'])
        .filter(|part| !part.is_empty() && *part != ".")
        .collect();
    let start = if pattern.starts_with('/') {
        Path::new("/")
    } else {
        folder
    };
    let mut budget = MAX_ENTRIES;
    collect(start, &parts, &mut found, &mut budget)
        .ok_or_else(|| format!("the pattern {pattern:?} matches too many files and folders"))?;
    found.sort_by(|a, b| {
        let key = |path: &Path| path.to_string_lossy().into_owned();
        let phase = |path: &Path| {
            mesh_name(&stem(path)).frame.map(|frame| match frame {
                super::file_name::FrameName::EndDiastole => 0,
                super::file_name::FrameName::EndSystole => 1,
                super::file_name::FrameName::Number(_) => 2,
            })
        };
        phase(a)
            .cmp(&phase(b))
            .then_with(|| natural_order(&key(a), &key(b)))
    });
    found.dedup();
    Ok(found)
}

fn stem(path: &Path) -> String {
    path.file_stem()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

/// `None` when the budget of entries is spent.
fn collect(
    folder: &Path,
    parts: &[&str],
    found: &mut Vec<PathBuf>,
    budget: &mut usize,
) -> Option<()> {
    let Some((part, rest)) = parts.split_first() else {
        return Some(());
    };
    if !part.contains(['*', '?', '[']) {
        let path = folder.join(part);
        if rest.is_empty() {
            if path.is_file() {
                found.push(path);
            }
            return Some(());
        }
        return collect(&path, rest, found, budget);
    }
    if *part == "**" {
        collect(folder, rest, found, budget)?;
    }
    let Ok(entries) = std::fs::read_dir(folder) else {
        return Some(());
    };
    for entry in entries.flatten() {
        *budget = budget.checked_sub(1)?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        let path = entry.path();
        if *part == "**" {
            // Links are not followed, so that a folder that holds itself ends.
            if entry.file_type().is_ok_and(|kind| kind.is_dir()) {
                collect(&path, parts, found, budget)?;
            }
        } else if matches(part, &name) {
            if rest.is_empty() {
                if path.is_file() {
                    found.push(path);
                }
            } else {
                collect(&path, rest, found, budget)?;
            }
        }
    }
    Some(())
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
            files_of_pattern(folder.path(), pattern)
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
}
