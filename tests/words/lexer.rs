//! Takes a source file apart: its texts, its names and the words of its help, without what is for tests alone.

/// Something found in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Found {
    /// Counted from 1.
    pub line: usize,
    pub text: String,
}

/// What a source file says.
#[derive(Debug, Default)]
pub struct Source {
    /// Literals as a person reads them: escapes resolved, what is filled in left out of its braces.
    pub texts: Vec<Found>,
    /// Identifiers.
    pub names: Vec<Found>,
    /// Doc comments, line by line.
    pub docs: Vec<Found>,
    /// Modules in files of their own that are for tests alone.
    pub test_modules: Vec<String>,
}

/// An item under `#[cfg(test)]` that is being passed over.
#[derive(Default)]
struct Passing {
    depth: usize,
    names: Vec<String>,
}

struct Lexer<'a> {
    rest: &'a str,
    line: usize,
    passing: Option<Passing>,
    source: Source,
}

/// Reads a file that compiles.
pub fn read(text: &str) -> Source {
    let mut lexer = Lexer {
        rest: text,
        line: 1,
        passing: None,
        source: Source::default(),
    };
    while !lexer.rest.is_empty() {
        lexer.step();
    }
    lexer.source
}

impl<'a> Lexer<'a> {
    /// Takes the first bytes, counting lines.
    fn take(&mut self, bytes: usize) -> &'a str {
        let (taken, rest) = self.rest.split_at(bytes);
        self.line += taken.matches('\n').count();
        self.rest = rest;
        taken
    }

    /// Takes all up to and with `end`.
    fn take_past(&mut self, end: &str) -> &'a str {
        let bytes = self
            .rest
            .find(end)
            .map_or(self.rest.len(), |at| at + end.len());
        self.take(bytes)
    }

    fn step(&mut self) {
        let Some(first) = self.rest.chars().next() else {
            return;
        };
        if self.rest.starts_with("//") {
            self.line_comment();
        } else if self.rest.starts_with("/*") {
            self.block_comment();
        } else if self.rest.starts_with("#[") || self.rest.starts_with("#![") {
            self.attribute();
        } else if first == '"' {
            self.take(1);
            self.text();
        } else if let Some(hashes) = raw_text(self.rest) {
            self.raw(hashes);
        } else if first == '\'' {
            self.quote();
        } else if first.is_alphanumeric() || first == '_' {
            self.name();
        } else {
            self.take(first.len_utf8());
            self.pass(first);
        }
    }

    fn line_comment(&mut self) {
        let line = self.line;
        let comment = self.take_past("\n");
        let doc = comment
            .strip_prefix("///")
            .or_else(|| comment.strip_prefix("//!"));
        if let (Some(text), None) = (doc, &self.passing) {
            let text = text.trim().to_owned();
            self.source.docs.push(Found { line, text });
        }
    }

    fn block_comment(&mut self) {
        self.take(2);
        let mut depth = 1;
        while depth > 0 && !self.rest.is_empty() {
            if self.rest.starts_with("/*") {
                depth += 1;
                self.take(2);
            } else if self.rest.starts_with("*/") {
                depth -= 1;
                self.take(2);
            } else {
                self.take(self.rest.chars().next().map_or(0, char::len_utf8));
            }
        }
    }

    /// Attributes are read by the compiler and by no person.
    fn attribute(&mut self) {
        let start = self.rest;
        let mut inner = Lexer {
            rest: self.rest,
            line: self.line,
            passing: None,
            source: Source::default(),
        };
        let open = inner.rest.find('[').unwrap_or(0);
        inner.take(open + 1);
        let mut depth = 1;
        while depth > 0 && !inner.rest.is_empty() {
            match inner.rest.chars().next() {
                Some('[') => depth += 1,
                Some(']') => depth -= 1,
                _ => {}
            }
            inner.step();
        }
        let text = &start[..start.len() - inner.rest.len()];
        self.take(text.len());
        if text == "#[cfg(test)]" && self.passing.is_none() {
            self.passing = Some(Passing::default());
        }
        // The help of an option may stand in its attribute; a lint's reason is for programmers.
        let for_people = ["#[error", "#[command", "#[arg", "#[value"];
        if self.passing.is_none() && for_people.iter().any(|start| text.starts_with(start)) {
            self.source.texts.extend(inner.source.texts);
        }
    }

    fn text(&mut self) {
        let line = self.line;
        let mut text = String::new();
        while let Some(c) = self.rest.chars().next() {
            self.take(c.len_utf8());
            match c {
                '"' => break,
                '\\' => self.escape(&mut text),
                c => text.push(c),
            }
        }
        self.keep(line, &text);
    }

    fn escape(&mut self, text: &mut String) {
        let Some(c) = self.rest.chars().next() else {
            return;
        };
        self.take(c.len_utf8());
        match c {
            'n' | 't' | 'r' => text.push(' '),
            '\n' => {
                let blank = self.rest.len() - self.rest.trim_start().len();
                self.take(blank);
            }
            'u' => {
                let code = self.take_past("}").trim_matches(['{', '}']);
                let code = u32::from_str_radix(code, 16).ok();
                text.extend(code.and_then(char::from_u32));
            }
            'x' => {
                self.take(2);
            }
            other => text.push(other),
        }
    }

    fn raw(&mut self, hashes: usize) {
        let line = self.line;
        self.take_past("\"");
        let end = format!("\"{}", "#".repeat(hashes));
        let text = self.take_past(&end);
        self.keep(line, text.trim_end_matches(end.as_str()));
    }

    fn keep(&mut self, line: usize, text: &str) {
        if self.passing.is_none() {
            let text = without_insertions(text);
            self.source.texts.push(Found { line, text });
        }
    }

    /// A character, or a lifetime.
    fn quote(&mut self) {
        let mut chars = self.rest.chars().skip(1);
        match (chars.next(), chars.next()) {
            (Some('\\'), Some(escaped)) => {
                self.take(2 + escaped.len_utf8());
                self.take_past("'");
            }
            (Some(c), Some('\'')) => {
                self.take(2 + c.len_utf8());
            }
            _ => {
                self.take(1);
            }
        }
    }

    fn name(&mut self) {
        let line = self.line;
        let end = |c: char| !(c.is_alphanumeric() || c == '_');
        let bytes = self.rest.find(end).unwrap_or(self.rest.len());
        let text = self.take(bytes).to_owned();
        match &mut self.passing {
            Some(passing) => passing.names.push(text),
            None => self.source.names.push(Found { line, text }),
        }
    }

    /// Looks for the end of an item that is passed over.
    fn pass(&mut self, sign: char) {
        let Some(passing) = &mut self.passing else {
            return;
        };
        match sign {
            '{' | '(' | '[' => passing.depth += 1,
            '}' | ')' | ']' => passing.depth -= 1,
            _ => {}
        }
        let ends = sign == '}' && passing.depth == 0;
        if ends || (sign == ';' && passing.depth == 0) {
            let names = std::mem::take(&mut passing.names);
            self.passing = None;
            let module = names.iter().position(|name| name == "mod");
            if let (Some(at), ';') = (module, sign) {
                self.source.test_modules.extend(names.get(at + 1).cloned());
            }
        }
    }
}

/// The hashes of a raw text that begins here; prefixes for bytes and C are as good.
fn raw_text(rest: &str) -> Option<usize> {
    let after = rest.strip_prefix(['b', 'c']).unwrap_or(rest);
    let after = after.strip_prefix('r')?;
    let hashes = after.len() - after.trim_start_matches('#').len();
    after[hashes..].starts_with('"').then_some(hashes)
}

/// What a program fills in is not read as it is named: `{share:.0} %` is `{} %`.
fn without_insertions(text: &str) -> String {
    let mut found = String::new();
    let mut inside = false;
    for c in text.chars() {
        match c {
            '{' => {
                inside = true;
                found.push(c);
            }
            '}' => {
                inside = false;
                found.push(c);
            }
            c if !inside => found.push(c),
            _ => {}
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::read;

    fn texts(source: &str) -> Vec<String> {
        read(source)
            .texts
            .into_iter()
            .map(|found| found.text)
            .collect()
    }

    #[test]
    fn literals_are_found_as_a_person_reads_them() {
        assert_eq!(texts(r#"f("a \"b\" \u{e9}"); // "no""#), [r#"a "b" é"#]);
        assert_eq!(
            texts("g(\"one \\\n     two\", '\"', 'x', &'a str)"),
            ["one two"]
        );
        assert_eq!(
            texts("let s = r#\"a \"quoted\" text\"#;"),
            ["a \"quoted\" text"]
        );
        assert_eq!(
            texts("format!(\"{share:.0} % of {whole}\")"),
            ["{} % of {}"]
        );
        assert_eq!(texts("/* \"no\" /* \"no\" */ */ b\"bytes\""), ["bytes"]);
    }

    #[test]
    fn attributes_are_passed_over_but_for_those_that_people_read() {
        assert_eq!(
            texts("#[expect(lint, reason = \"why [1]\")] #[error(\"not {0}\")] x(\"y\")"),
            ["not {}", "y"]
        );
    }

    #[test]
    fn tests_are_passed_over_and_the_rest_of_the_file_is_not() {
        let source = read(
            "#[cfg(test)]\nmod tests { fn f() { g(\"}\"); } }\n#[cfg(test)]\nmod other;\nx(\"seen\")",
        );
        assert_eq!(source.texts.len(), 1);
        assert_eq!(
            (source.texts[0].line, source.texts[0].text.as_str()),
            (5, "seen")
        );
        assert_eq!(source.test_modules, ["other"]);
    }
}
