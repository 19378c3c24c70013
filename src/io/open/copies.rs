//! Copies of files that browsers, desktops, editors and clouds make beside the original: `endo_1 (1).obj`,
//! `endo_1 - Copy.obj`, `endo_1~.obj`.

use std::path::{Path, PathBuf};

use super::file_name::mesh_name;
use super::folders::composed;
use super::group_files::stem;
use super::read_file::name_of;
use crate::study::Notice;

/// Words for a copy behind a name, in the languages of common desktops.
const WORDS: [&str; 18] = [
    "copy",
    "kopie",
    "copie",
    "copia",
    "cópia",
    "kopia",
    "kópia",
    "kopio",
    "kopi",
    "копия",
    "копія",
    "副本",
    "コピー",
    "복사본",
    "bak",
    "backup",
    "orig",
    "old",
];
/// Words for a copy before a name.
const BEFORE: [&str; 8] = [
    "copy of ",
    "kopie von ",
    "copie de ",
    "copia de ",
    "cópia de ",
    "kopia ",
    "kopie ",
    "~",
];

/// What stands for one frame: the file, and the name that says which.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct NamedFile {
    pub(super) path: PathBuf,
    /// The name without its ending, and without the mark of a copy.
    pub(super) stem: String,
}

/// The name that a copy was made of, if the name is marked as a copy's.
fn original_of(stem: &str) -> Option<String> {
    let lower = stem.to_lowercase();
    // lengths in bytes agree only where small letters are as long as capitals
    let same_length = lower.len() == stem.len();
    for before in BEFORE {
        if same_length && lower.starts_with(before) && stem.len() > before.len() {
            return Some(stem[before.len()..].to_owned());
        }
    }
    if let Some(rest) = stem.strip_suffix('~') {
        return Some(rest.to_owned()).filter(|rest| !rest.is_empty());
    }
    if let Some((rest, mark)) = stem.split_once(".sync-conflict-") {
        return (!mark.is_empty()).then(|| rest.to_owned());
    }
    if let Some((rest, mark)) = stem.rsplit_once(" (")
        && mark.to_lowercase().contains("conflicted copy")
    {
        return Some(rest.to_owned());
    }
    for word in WORDS {
        let numberless =
            lower.trim_end_matches(|c: char| c.is_ascii_digit() || matches!(c, ' ' | '(' | ')'));
        for whole in [lower.as_str(), numberless] {
            if let Some(rest) = whole.strip_suffix(word)
                && rest.ends_with(['_', '-', ' ', '.', '('])
                && same_length
            {
                let kept = rest.trim_end_matches(['_', '-', ' ', '.', '(']).len();
                return stem
                    .get(..kept)
                    .filter(|rest| !rest.is_empty())
                    .map(str::to_owned);
            }
        }
    }
    numbered_copy(stem)
}

/// `name (2)`, `name(2)`.
fn numbered_copy(stem: &str) -> Option<String> {
    let (rest, number) = stem.strip_suffix(')')?.rsplit_once('(')?;
    let short = (1..=3).contains(&number.len()) && number.bytes().all(|b| b.is_ascii_digit());
    let rest = rest.trim_end();
    (short && !rest.is_empty()).then(|| rest.to_owned())
}

/// Leaves out copies whose original lies beside them, each told in a warning; a copy without its original stands for it,
/// which is told too. `same_content` compares two files.
///
/// `name (2)` is a copy where `name` has a frame of its own or the same content; otherwise the number is the frame's.
pub(super) fn without_copies(
    files: Vec<PathBuf>,
    same_content: &dyn Fn(&Path, &Path) -> bool,
) -> (Vec<NamedFile>, Vec<(PathBuf, Notice)>) {
    let key = |path: &Path, stem: &str| {
        let ending = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .to_lowercase();
        (path.parent().map(Path::to_owned), composed(stem), ending)
    };
    let mut by_name: std::collections::HashMap<_, PathBuf> = files
        .iter()
        .map(|path| (key(path, &stem(path)), path.clone()))
        .collect();
    let (mut kept, mut notices) = (Vec::new(), Vec::new());
    for path in files {
        let name = composed(&stem(&path));
        let Some(original) = root_of(&name) else {
            kept.push(NamedFile { path, stem: name });
            continue;
        };
        let by_number = numbered_copy(&name).is_some();
        let has_frame = mesh_name(&original).frame.is_some();
        let shown = name_of(&path);
        match by_name.get(&key(&path, &original)) {
            Some(first) => {
                let same = same_content(first, &path);
                if by_number && !has_frame && !same {
                    kept.push(NamedFile { path, stem: name });
                    continue;
                }
                let content = if same {
                    "the same content"
                } else {
                    "other content"
                };
                let text = format!(
                    "{shown} is not read: by its name it is a copy of {}, with {content}",
                    name_of(first)
                );
                notices.push((first.clone(), Notice::warning(text)));
            }
            None if by_number && !has_frame => kept.push(NamedFile { path, stem: name }),
            None => {
                let text = format!(
                    "{shown} is read in place of {original:?}, of which it is a copy by its name and which is not there"
                );
                notices.push((path.clone(), Notice::warning(text)));
                by_name.insert(key(&path, &original), path.clone());
                kept.push(NamedFile {
                    path,
                    stem: original,
                });
            }
        }
    }
    (kept, notices)
}

/// The original of a copy of a copy.
fn root_of(stem: &str) -> Option<String> {
    let mut original = original_of(stem)?;
    while let Some(earlier) = original_of(&original) {
        original = earlier;
    }
    Some(original)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kept(names: &[&str], same: bool) -> (Vec<String>, Vec<String>) {
        let files = names.iter().map(PathBuf::from).collect();
        let (kept, notices) = without_copies(files, &|_, _| same);
        (
            kept.into_iter().map(|file| file.stem).collect(),
            notices.into_iter().map(|(_, notice)| notice.text).collect(),
        )
    }

    #[test]
    fn copies_beside_their_original_are_left_out_and_told() {
        for copy in [
            "endo_1 (1).obj",
            "endo_1(2).obj",
            "endo_1 - Copy.obj",
            "endo_1 - Copy (3).obj",
            "endo_1 copy.obj",
            "endo_1 copy 2.obj",
            "endo_1_copy.obj",
            "endo_1 - Kopie.obj",
            "endo_1 - Kopie (2).obj",
            "Copy of endo_1.obj",
            "Kopie von endo_1.obj",
            "endo_1~.obj",
            "endo_1.bak.obj",
            "endo_1_old.obj",
            "endo_1 - 副本.obj",
            "endo_1 (Ann's conflicted copy 2024-01-02).obj",
            "endo_1.sync-conflict-20240102-ABC.obj",
            "endo_1 - Copy - Copy.obj",
        ] {
            let (stems, texts) = kept(&["endo_0.obj", "endo_1.obj", copy], true);
            assert_eq!(stems, ["endo_0", "endo_1"], "{copy}");
            assert!(
                texts[0].contains(copy) && texts[0].contains("the same content"),
                "{texts:?}"
            );
        }
    }

    #[test]
    fn a_copy_without_its_original_stands_for_it() {
        let (stems, texts) = kept(&["endo_0.obj", "endo_1 (1).obj", "endo_1 (2).obj"], false);
        assert_eq!(stems, ["endo_0", "endo_1"]);
        assert!(texts[0].contains("in place of \"endo_1\""), "{texts:?}");
        assert!(texts[1].contains("endo_1 (2).obj is not read"), "{texts:?}");
    }

    #[test]
    fn a_number_in_brackets_is_a_frame_where_nothing_else_is() {
        let (stems, texts) = kept(&["endo (1).obj", "endo (2).obj"], false);
        assert_eq!((stems.len(), texts.len()), (2, 0));
        let (stems, texts) = kept(&["endo.obj", "endo (1).obj", "endo (2).obj"], false);
        assert_eq!((stems.len(), texts.len()), (3, 0));
        let (stems, texts) = kept(&["endo.obj", "endo (1).obj"], true);
        assert_eq!((stems.len(), texts.len()), (1, 1));
    }

    #[test]
    fn names_that_only_look_alike_stay() {
        let names = [
            "Copyright_0.obj",
            "threshold_1.obj",
            "a_gold.obj",
            "(1).obj",
            "copy.obj",
        ];
        let (stems, texts) = kept(&names, false);
        assert_eq!((stems.len(), texts.len()), (5, 0));
    }
}
