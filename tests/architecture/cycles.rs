//! No cycle of files within the crate: who uses whom leads down and never back.
//!
//! Edges come from `use` lines and from paths in the code. A path is followed through re-exports to the file that
//! defines the item. Declaring a module, or only re-exporting from it, is no use of it. Tests do not count.

use std::collections::{BTreeMap, BTreeSet};

use super::{SourceFile, source_files};

/// Path of a module from the root of the crate.
type Module = Vec<String>;

/// A name that a module brings in, and whether it passes it on.
struct Import {
    path: Vec<String>,
    name: String,
    re_exported: bool,
}

struct ModuleFile {
    place: String,
    /// Code without `use` items.
    body: String,
    imports: Vec<Import>,
}

/// Where a path leads.
enum Target {
    Item(Module),
    Module(Module),
}

struct Crate(BTreeMap<Module, ModuleFile>);

impl Crate {
    fn new() -> Self {
        let files = source_files();
        let files = files.into_iter().filter(|file| !is_test(file));
        Self(
            files
                .map(|file| (module_of(&file), ModuleFile::new(&file)))
                .collect(),
        )
    }

    /// The module that a path starts from, and the rest of the path; `None` if it leads out of the crate.
    fn start<'a>(&self, from: &Module, path: &'a [String]) -> Option<(Module, &'a [String])> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => Some((Module::new(), rest)),
            "self" => Some((from.clone(), rest)),
            "super" => {
                let mut parent = from.clone();
                parent.pop();
                if rest.first().is_some_and(|next| next == "super") {
                    return self.start(&parent, rest);
                }
                Some((parent, rest))
            }
            _ if self.0.contains_key(&child(from, first)) => Some((from.clone(), path)),
            _ => None,
        }
    }

    /// Follows a path down modules and through imports. `seen` guards against imports in a circle.
    fn follow(
        &self,
        mut module: Module,
        path: &[String],
        seen: &mut BTreeSet<(Module, String)>,
    ) -> Option<Target> {
        let mut rest = path;
        while let Some((next, after)) = rest.split_first() {
            let inner = child(&module, next);
            if self.0.contains_key(&inner) {
                (module, rest) = (inner, after);
                continue;
            }
            let file = self.0.get(&module)?;
            let import = file.imports.iter().find(|import| import.name == *next);
            let Some(import) = import.filter(|_| seen.insert((module.clone(), next.clone())))
            else {
                let passed_on = self.through_globs(&module, next, seen);
                return Some(Target::Item(passed_on.unwrap_or(module)));
            };
            let (start, path) = self.start(&module, &import.path)?;
            return match self.follow(start, path, seen)? {
                Target::Module(module) => self.follow(module, after, seen),
                item @ Target::Item(_) => Some(item),
            };
        }
        Some(Target::Module(module))
    }

    /// The module that defines a name which another one passes on with all others.
    fn through_globs(
        &self,
        module: &Module,
        name: &str,
        seen: &mut BTreeSet<(Module, String)>,
    ) -> Option<Module> {
        if self.0[module].defines(name) || !seen.insert((module.clone(), format!("*{name}"))) {
            return None;
        }
        let globs = self.0[module].imports.iter();
        let mut globs = globs.filter(|import| import.name == "*");
        globs.find_map(|glob| {
            let (start, path) = self.start(module, &glob.path[..glob.path.len() - 1])?;
            let Target::Module(inner) = self.follow(start, path, seen)? else {
                return None;
            };
            match self.follow(inner, &[name.to_owned()], seen)? {
                Target::Item(found) => self.0[&found].defines(name).then_some(found),
                Target::Module(_) => None,
            }
        })
    }

    fn target(&self, from: &Module, path: &[String]) -> Option<Target> {
        let (start, rest) = self.start(from, path)?;
        self.follow(start, rest, &mut BTreeSet::new())
    }

    /// Modules whose files a module uses.
    fn uses(&self, module: &Module) -> BTreeSet<Module> {
        let file = &self.0[module];
        let words: BTreeSet<&str> = (file.body)
            .split(|c: char| !(c.is_alphanumeric() || c == '_'))
            .collect();
        let mut used = BTreeSet::new();
        let mut aliases = BTreeMap::new();
        for import in &file.imports {
            if import.re_exported && !words.contains(import.name.as_str()) {
                continue;
            }
            let glob = import.name == "*";
            let path = &import.path[..import.path.len() - usize::from(glob)];
            match self.target(module, path) {
                Some(Target::Item(item)) => drop(used.insert(item)),
                Some(Target::Module(all)) if glob => drop(used.insert(all)),
                Some(Target::Module(other)) => drop(aliases.insert(import.name.clone(), other)),
                None => {}
            }
        }
        for path in paths_in(&file.body) {
            let target = match aliases.get(&path[0]) {
                Some(start) => self.follow(start.clone(), &path[1..], &mut BTreeSet::new()),
                None => self.target(module, &path),
            };
            if let Some(Target::Item(item)) = target {
                used.insert(item);
            }
        }
        used.remove(module);
        used
    }
}

impl ModuleFile {
    /// Whether an item of this name stands in the file.
    fn defines(&self, name: &str) -> bool {
        let words = (self.body).split(|c: char| !(c.is_alphanumeric() || c == '_'));
        let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
        let items = [
            "struct", "enum", "fn", "trait", "type", "const", "static", "union",
        ];
        words
            .windows(2)
            .any(|pair| items.contains(&pair[0]) && pair[1] == name)
    }

    fn new(file: &SourceFile) -> Self {
        let text = without_tests(&file.text);
        let (mut body, mut imports) = (String::new(), Vec::new());
        let mut item: Option<String> = None;
        for line in text.lines() {
            let code = line.split("//").next().unwrap_or_default();
            let trimmed = code.trim_start();
            let begins = trimmed.starts_with("use ")
                || trimmed.starts_with("pub")
                    && trimmed.contains(" use ")
                    && !trimmed.contains('=');
            if item.is_some() || begins {
                let item_text = item.get_or_insert_default();
                item_text.push_str(trimmed);
                if trimmed.contains(';') {
                    add_imports(item_text, &mut imports);
                    item = None;
                }
            } else {
                body.push_str(code);
                body.push('\n');
            }
        }
        Self {
            place: file.place.display().to_string(),
            body,
            imports,
        }
    }
}

fn is_test(file: &SourceFile) -> bool {
    let place = file.place.with_extension("");
    place.iter().any(|part| {
        let part = part.to_string_lossy();
        part == "tests" || part.ends_with("_tests")
    })
}

fn module_of(file: &SourceFile) -> Module {
    let place = file.place.with_extension("");
    let mut parts: Module = (place.iter())
        .map(|part| part.to_string_lossy().into_owned())
        .collect();
    if parts.last().is_some_and(|last| last == "mod") || parts == ["lib"] {
        parts.pop();
    }
    parts
}

fn child(module: &Module, name: &str) -> Module {
    let mut inner = module.clone();
    inner.push(name.to_owned());
    inner
}

/// Everything before the file's own tests, without items that only tests see.
fn without_tests(text: &str) -> String {
    let tests = [
        "#[cfg(test)]\nmod tests {",
        "#[cfg(test)]\npub(crate) mod tests {",
    ];
    let text = tests
        .iter()
        .fold(text, |text, begin| text.split(begin).next().unwrap());
    let mut kept = String::new();
    let mut skips = false;
    for line in text.lines() {
        if line.trim() == "#[cfg(test)]" {
            skips = true;
            continue;
        }
        let ends = line.contains(';') || line.trim_start().starts_with('}');
        if !skips {
            kept.push_str(line);
            kept.push('\n');
        }
        skips &= !ends;
    }
    kept
}

/// The names that one `use` item brings in, however deeply they are grouped.
fn add_imports(item: &str, imports: &mut Vec<Import>) {
    let re_exported = item.starts_with("pub");
    let tree = item
        .split_once("use ")
        .unwrap()
        .1
        .split(';')
        .next()
        .unwrap();
    let mut open: Vec<(Vec<String>, &str)> = vec![(Vec::new(), tree)];
    while let Some((prefix, tree)) = open.pop() {
        let tree = tree.trim();
        if let Some((head, group)) = tree.split_once('{') {
            let mut prefix = prefix;
            prefix.extend(
                head.split("::")
                    .map(str::trim)
                    .filter(|s| !s.is_empty())
                    .map(str::to_owned),
            );
            let group = group.trim_end().strip_suffix('}').unwrap_or(group);
            open.extend(
                parts_of_group(group)
                    .into_iter()
                    .map(|part| (prefix.clone(), part)),
            );
            continue;
        }
        if tree.is_empty() {
            continue;
        }
        let (path, alias) = match tree.split_once(" as ") {
            Some((path, alias)) => (path, Some(alias.trim().to_owned())),
            None => (tree, None),
        };
        let mut full = prefix;
        full.extend(path.split("::").map(|part| part.trim().to_owned()));
        full.pop_if(|last| last == "self");
        let name = alias.or(full.last().cloned()).unwrap_or_default();
        imports.push(Import {
            path: full,
            name,
            re_exported,
        });
    }
}

/// Parts of a group between its own commas.
fn parts_of_group(group: &str) -> Vec<&str> {
    let (mut parts, mut depth, mut from) = (Vec::new(), 0, 0);
    for (at, letter) in group.char_indices() {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                parts.push(&group[from..at]);
                from = at + 1;
            }
            _ => {}
        }
    }
    parts.push(&group[from..]);
    parts
}

/// Paths of two parts and more in code.
fn paths_in(body: &str) -> Vec<Vec<String>> {
    body.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'))
        .map(|word| word.trim_end_matches(':'))
        .filter(|word| word.contains("::") && !word.starts_with(':'))
        .map(|word| word.split("::").map(str::to_owned).collect())
        .collect()
}

/// Groups of modules each of which can be reached from every other one.
fn cycles(edges: &BTreeMap<Module, BTreeSet<Module>>) -> Vec<Vec<Module>> {
    let reached = |from: &Module| {
        let mut reached = BTreeSet::new();
        let mut open = vec![from];
        while let Some(module) = open.pop() {
            for next in edges.get(module).into_iter().flatten() {
                if reached.insert(next) {
                    open.push(next);
                }
            }
        }
        reached
    };
    let from_all: BTreeMap<&Module, BTreeSet<&Module>> = edges
        .keys()
        .map(|module| (module, reached(module)))
        .collect();
    let mut cycles: Vec<Vec<Module>> = Vec::new();
    for (module, reached) in &from_all {
        if !reached.contains(module) || cycles.iter().flatten().any(|other| other == *module) {
            continue;
        }
        let back = |other: &&&Module| from_all.get(**other).is_some_and(|r| r.contains(module));
        cycles.push(
            reached
                .iter()
                .filter(back)
                .map(|other| (*other).clone())
                .collect(),
        );
    }
    cycles
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let modules = Crate::new();
    let edges = modules
        .0
        .keys()
        .map(|m| (m.clone(), modules.uses(m)))
        .collect();
    let mut wrong = Vec::new();
    for cycle in cycles(&edges) {
        let files: Vec<&str> = cycle.iter().map(|m| modules.0[m].place.as_str()).collect();
        wrong.push(files.join(", "));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}
