//! Paths as a person types them: completed name by name, as shells do.

use std::path::{MAIN_SEPARATOR, PathBuf};

/// Names of a folder that are looked through; one with more is not completed by hand.
const MAX_NAMES: usize = 20_000;
/// Names to choose from that are returned.
const MAX_CHOICES: usize = 12;

/// How what was typed goes on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CompletedPath {
    /// What was typed, and more where only that can follow.
    pub text: String,
    /// Names that go on as it does, if there are several, or in words why there is none.
    pub choices: Vec<String>,
}

/// What was typed as a path: `~` is the home folder.
pub fn typed_path(text: &str) -> PathBuf {
    match text.strip_prefix('~') {
        Some(rest) if rest.is_empty() || rest.starts_with(['/', MAIN_SEPARATOR]) => {
            let home = std::env::home_dir().unwrap_or_default();
            home.join(rest.trim_start_matches(['/', MAIN_SEPARATOR]))
        }
        _ => PathBuf::from(text),
    }
}

/// The text with its last name as far as all names of that folder agree that begin so; names of files count only with
/// `files`. Hidden ones count where a dot was typed.
pub fn completed_path(text: &str, files: bool) -> CompletedPath {
    let split = text.rfind(['/', MAIN_SEPARATOR]).map_or(0, |at| at + 1);
    let (head, begun) = text.split_at(split);
    let folder = if head.is_empty() {
        PathBuf::from(".")
    } else {
        typed_path(head)
    };
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries
        .take(MAX_NAMES)
        .filter_map(|entry| {
            let name = entry.file_name().into_string().ok()?;
            let hidden = name.starts_with('.') && !begun.starts_with('.');
            if hidden || !name.starts_with(begun) {
                return None;
            }
            // A link to a folder is one.
            match entry.path().is_dir() {
                true => Some(name + std::path::MAIN_SEPARATOR_STR),
                false => files.then_some(name),
            }
        })
        .collect();
    names.sort();
    let Some(first) = names.first() else {
        return CompletedPath {
            text: text.to_owned(),
            choices: vec!["no such folder".to_owned()],
        };
    };
    let common = names.iter().fold(first.as_str(), |common, name| {
        let letters = common.char_indices().zip(name.chars());
        let same = letters.take_while(|((_, a), b)| a == b);
        let end = same
            .last()
            .map_or(0, |((at, letter), _)| at + letter.len_utf8());
        &common[..end]
    });
    let text = format!("{head}{common}");
    let more = names.len() > MAX_CHOICES;
    if names.len() == 1 {
        names.clear();
    }
    names.truncate(MAX_CHOICES);
    names.extend(more.then(|| "…".to_owned()));
    CompletedPath {
        text,
        choices: names,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder_with(names: &[&str]) -> (tempfile::TempDir, String) {
        let folder = tempfile::tempdir().unwrap();
        for name in names {
            match name.strip_suffix('/') {
                Some(name) => std::fs::create_dir(folder.path().join(name)).unwrap(),
                None => std::fs::write(folder.path().join(name), "x").unwrap(),
            }
        }
        let text = format!("{}/", folder.path().display());
        (folder, text)
    }

    #[test]
    fn names_are_completed_as_far_as_they_agree() {
        let (_folder, at) = folder_with(&["ward 3/", "ward 4/", "wards.txt", "übung/", ".git/"]);
        let go_on = |begun: &str, files| {
            let completed = completed_path(&format!("{at}{begun}"), files);
            (completed.text[at.len()..].to_owned(), completed.choices)
        };
        let two = ["ward 3/", "ward 4/"].map(str::to_owned);
        assert_eq!(go_on("w", false), ("ward ".to_owned(), two.to_vec()));
        assert_eq!(go_on("w", true).0, "ward");
        assert_eq!(go_on("ward 3", false), ("ward 3/".to_owned(), Vec::new()));
        assert_eq!(go_on("ü", false).0, "übung/");
        assert_eq!(go_on("", false).1.len(), 3, "hidden folders are left out");
        assert_eq!(go_on(".", false).0, ".git/");
        assert_eq!(
            go_on("x", false),
            ("x".to_owned(), vec!["no such folder".to_owned()])
        );
    }
}
