//! What a person reads: every text of window, command line and reports, and the pages, hold no word that has a better one.
//!
//! `table.rs` is the list of words. All texts in one list, to be read through by a second pair of eyes:
//!
//! ```sh
//! cargo test --release --test words -- --ignored --nocapture print_all_strings
//! ```

#[cfg(test)]
mod lexer;
#[cfg(test)]
mod table;

#[cfg(test)]
mod tests {
    use std::fmt::Write as _;
    use std::fs;
    use std::path::{Path, PathBuf};

    use crate::lexer::{Found, Source, read};
    use crate::table::{EXCEPTIONS, FREE_IN_COMMENTS, NAME_STARTS, NAMES, PHRASES, Phrase};

    fn root() -> &'static Path {
        Path::new(env!("CARGO_MANIFEST_DIR"))
    }

    fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
        let mut found = Vec::new();
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                found.extend(files(&path, ending));
            } else if path.extension().is_some_and(|own| own == ending) {
                found.push(path);
            }
        }
        found.sort();
        found
    }

    /// The path below the root.
    fn shown(path: &Path) -> String {
        path.strip_prefix(root()).unwrap().display().to_string()
    }

    /// Source files with what they say, without the modules that are for tests alone.
    fn sources() -> Vec<(String, Source)> {
        let mut sources: Vec<(PathBuf, Source)> = (files(&root().join("src"), "rs").into_iter())
            .map(|path| {
                let source = read(&fs::read_to_string(&path).unwrap());
                (path, source)
            })
            .collect();
        let tests: Vec<PathBuf> = (sources.iter())
            .flat_map(|(path, source)| {
                let own = matches!(
                    path.file_name().and_then(|name| name.to_str()),
                    Some("mod.rs" | "lib.rs" | "main.rs")
                );
                let folder = if own {
                    path.parent().unwrap().to_owned()
                } else {
                    path.with_extension("")
                };
                let modules = source.test_modules.iter();
                modules
                    .map(move |module| folder.join(module))
                    .collect::<Vec<_>>()
            })
            .collect();
        sources.retain(|(path, _)| {
            let of = |test: &PathBuf| path.starts_with(test) || path.with_extension("") == *test;
            !tests.iter().any(of)
        });
        (sources.into_iter())
            .map(|(path, source)| (shown(&path), source))
            .collect()
    }

    /// Everything that people read, with its file: texts, the help of the command line, and pages.
    fn all_texts() -> Vec<(String, Found)> {
        let mut texts = Vec::new();
        for (file, source) in sources() {
            // Comments on options are what `--help` prints.
            let options = source.names.iter().any(|name| name.text == "clap");
            let help = if options { source.docs } else { Vec::new() };
            texts.extend(
                source
                    .texts
                    .into_iter()
                    .chain(help)
                    .map(|text| (file.clone(), text)),
            );
        }
        let pages = [
            files(&root().join("src"), "md"),
            files(&root().join("tests/bench"), "md"),
        ]
        .concat();
        let top = fs::read_dir(root())
            .unwrap()
            .map(|entry| entry.unwrap().path());
        let top = top.filter(|path| path.extension().is_some_and(|ending| ending == "md"));
        for page in pages.into_iter().chain(top) {
            let text = fs::read_to_string(&page).unwrap();
            let lines = text.lines().enumerate().map(|(at, line)| Found {
                line: at + 1,
                text: without_code(line),
            });
            texts.extend(lines.map(|line| (shown(&page), line)));
        }
        texts
    }

    /// A line of a page without what stands between backticks.
    fn without_code(line: &str) -> String {
        line.split('`').step_by(2).collect::<Vec<_>>().join("``")
    }

    /// Whether the words stand in a text of small letters, not as a part of longer ones.
    fn holds(text: &str, words: &str) -> bool {
        let part = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
        let letter = |c: Option<char>| c.is_some_and(char::is_alphanumeric);
        text.match_indices(words).any(|(at, _)| {
            let (before, after) = (&text[..at], &text[at + words.len()..]);
            let goes_on_before = letter(words.chars().next()) && part(before.chars().next_back());
            let goes_on_after = letter(words.chars().next_back()) && part(after.chars().next());
            !goes_on_before && !goes_on_after
        })
    }

    /// The phrases that a text holds, with what is said instead.
    fn said(text: &str) -> Vec<(Phrase, &'static str)> {
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        let small = text.to_lowercase();
        (PHRASES.iter().copied())
            .filter(|(phrase, _)| match phrase {
                Phrase::Part(words) => holds(&small, words),
                Phrase::Whole(words) => text == *words,
            })
            .collect()
    }

    #[test]
    fn no_text_holds_a_word_that_has_a_better_one() {
        let mut wrong = String::new();
        let mut count = 0;
        let mut used = vec![false; EXCEPTIONS.len()];
        for (file, found) in all_texts() {
            for (phrase, instead) in said(&found.text) {
                let exception = EXCEPTIONS.iter().position(|(place, words, _)| {
                    file.ends_with(place) && found.text.contains(words)
                });
                if let Some(at) = exception {
                    used[at] = true;
                    continue;
                }
                count += 1;
                writeln!(
                    wrong,
                    "{file}:{}: {phrase:?}, say {instead:?}: {}",
                    found.line, found.text
                )
                .unwrap();
            }
        }
        let idle = EXCEPTIONS.iter().zip(used).filter(|(_, used)| !used);
        for ((place, words, _), _) in idle {
            count += 1;
            writeln!(
                wrong,
                "{place} no longer says {words:?}: this exception can go"
            )
            .unwrap();
        }
        assert_eq!(count, 0, "\n{wrong}");
    }

    #[test]
    fn no_comment_of_the_documentation_holds_a_word_that_has_a_better_one() {
        let mut wrong = String::new();
        for (file, source) in sources() {
            for found in &source.docs {
                let held = said(&found.text)
                    .into_iter()
                    .filter(|(phrase, _)| match phrase {
                        Phrase::Part(words) => !FREE_IN_COMMENTS.contains(words),
                        Phrase::Whole(_) => false,
                    });
                for (phrase, instead) in held {
                    let (line, text) = (found.line, &found.text);
                    writeln!(wrong, "{file}:{line}: {phrase:?}, say {instead:?}: {text}").unwrap();
                }
            }
        }
        assert!(wrong.is_empty(), "\n{wrong}");
    }

    #[test]
    fn no_name_in_the_code_has_a_better_one() {
        let mut wrong = String::new();
        let mut count = 0;
        for (file, source) in sources() {
            for name in &source.names {
                let whole = (NAMES.iter())
                    .find(|(old, _, room)| name.text == *old && file.starts_with(room))
                    .map(|(_, instead, _)| instead);
                let start = (NAME_STARTS.iter())
                    .find(|(old, _)| name.text.starts_with(old))
                    .map(|(_, instead)| instead);
                if let Some(instead) = whole.or(start) {
                    count += 1;
                    writeln!(wrong, "{file}:{}: {}, say {instead}", name.line, name.text).unwrap();
                }
            }
        }
        assert_eq!(count, 0, "\n{wrong}");
    }

    #[test]
    fn words_are_found_whole_and_whatever_their_case() {
        let found = |text: &str| said(text).len();
        assert_eq!(found("Told apart\n by"), 1);
        assert_eq!((found("by chance, 12"), found("no_chance")), (1, 0));
        assert_eq!((found("balloon"), found("a ball.")), (0, 1));
        assert_eq!(found("1.2 × mean"), 1);
        assert_eq!(
            (found("Inner"), found("Inner side"), found("inner")),
            (1, 0, 0)
        );
        assert_eq!(found(&without_code("a `Notice` is shown")), 0);
    }

    #[test]
    #[ignore = "prints a list for reading through"]
    fn print_all_strings() {
        for (file, found) in all_texts() {
            let page = file.ends_with(".md");
            let words = found.text.chars().filter(|c| c.is_alphabetic()).count() > 1;
            if words && !page {
                println!("{file}:{}: {}", found.line, found.text);
            }
        }
    }
}
