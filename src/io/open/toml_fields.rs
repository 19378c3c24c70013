//! Fields of one TOML table, read by name and kind; every complaint names its line.

use std::collections::BTreeSet;

use toml::de::{DeTable, DeValue};

/// Where the lines of a text begin, so that a manifest of many subjects is not counted through for each of them.
pub(super) struct Lines {
    ends: Vec<usize>,
}

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self {
            ends: ends.map(|(place, _)| place).collect(),
        }
    }

    /// The line of a byte, counted from 1.
    pub(super) fn at(&self, byte: usize) -> usize {
        1 + self.ends.partition_point(|&end| end < byte)
    }
}

/// A table of a TOML text, and which of its keys were asked for.
pub(super) struct Fields<'t> {
    lines: &'t Lines,
    table: &'t DeTable<'t>,
    known: BTreeSet<&'static str>,
}

impl<'t> Fields<'t> {
    pub(super) fn new(lines: &'t Lines, table: &'t DeTable<'t>) -> Self {
        Self {
            lines,
            table,
            known: BTreeSet::new(),
        }
    }

    /// The line of a key, counted from 1.
    pub(super) fn line_of(&self, key: &str) -> Option<usize> {
        self.table
            .iter()
            .find(|(name, _)| name.get_ref().as_ref() == key)
            .map(|(name, _)| self.lines.at(name.span().start))
    }

    /// Keys that nobody asked for, with their lines and the key that was perhaps meant.
    pub(super) fn unknown(&self) -> Vec<(usize, String, Option<&'static str>)> {
        self.table
            .iter()
            .filter(|(name, _)| !self.known.contains(name.get_ref().as_ref()))
            .map(|(name, _)| {
                let key = name.get_ref().to_string();
                let meant = self
                    .known
                    .iter()
                    .copied()
                    .find(|known| nearly_equal(known, &key));
                (self.lines.at(name.span().start), key, meant)
            })
            .collect()
    }

    /// The value of a key.
    pub(super) fn value(&mut self, key: &'static str) -> Option<&'t DeValue<'t>> {
        self.known.insert(key);
        self.table
            .iter()
            .find(|(name, _)| name.get_ref().as_ref() == key)
            .map(|(_, value)| value.get_ref())
    }

    pub(super) fn string(&mut self, key: &'static str) -> Result<Option<String>, String> {
        self.read(key, "a string in quotes", |value| {
            value.as_str().map(str::to_owned)
        })
    }

    /// One text, or a list of texts.
    pub(super) fn strings(&mut self, key: &'static str) -> Result<Option<Vec<String>>, String> {
        self.read(key, "a string in quotes or a list of strings", |value| {
            if let Some(one) = value.as_str() {
                return Some(vec![one.to_owned()]);
            }
            value
                .as_array()?
                .iter()
                .map(|item| item.get_ref().as_str().map(str::to_owned))
                .collect()
        })
    }

    /// False where it is not said.
    pub(super) fn flag(&mut self, key: &'static str) -> Result<bool, String> {
        let flag = self.read(key, "true or false", DeValue::as_bool)?;
        Ok(flag.unwrap_or(false))
    }

    /// A number above zero.
    pub(super) fn positive(&mut self, key: &'static str) -> Result<Option<f64>, String> {
        self.read(key, "a number above zero", |value| {
            number(value).filter(|&number| number > 0.0)
        })
    }

    pub(super) fn numbers(&mut self, key: &'static str) -> Result<Option<Vec<f64>>, String> {
        self.read(key, "a list of numbers", numbers)
    }

    /// A frame's number, from 0.
    pub(super) fn index(&mut self, key: &'static str) -> Result<Option<usize>, String> {
        self.read(key, "the number of a frame, from 0", |value| {
            let integer = value.as_integer()?;
            usize::from_str_radix(integer.as_str(), integer.radix()).ok()
        })
    }

    /// Three coordinates.
    pub(super) fn point(&mut self, key: &'static str) -> Result<Option<[f64; 3]>, String> {
        self.read(key, "a point [x, y, z]", |value| {
            numbers(value)?.try_into().ok()
        })
    }

    pub(super) fn table(&mut self, key: &'static str) -> Result<Option<Fields<'t>>, String> {
        let lines = self.lines;
        self.read(key, "a table", |value| {
            value.as_table().map(|table| Fields::new(lines, table))
        })
    }

    fn read<T>(
        &mut self,
        key: &'static str,
        needed: &str,
        read: impl FnOnce(&'t DeValue<'t>) -> Option<T>,
    ) -> Result<Option<T>, String> {
        let Some(value) = self.value(key) else {
            return Ok(None);
        };
        read(value).map(Some).ok_or_else(|| {
            let line = self.line_of(key).unwrap_or(1);
            format!("line {line}: {key} must be {needed}")
        })
    }
}

/// Whether two keys differ only in case, in `_` and `-`, or in what one has behind the other (`rr` and `rr_ms`).
fn nearly_equal(known: &str, key: &str) -> bool {
    let plain = |text: &str| text.to_lowercase().replace(['_', '-', ' '], "");
    let (known, key) = (plain(known), plain(key));
    key.len() > 1 && (known.starts_with(&key) || key.starts_with(&known))
}

fn number(value: &DeValue) -> Option<f64> {
    let word = match value {
        DeValue::Float(float) => float.as_str(),
        DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str(),
        _ => return None,
    };
    word.parse().ok().filter(|number: &f64| number.is_finite())
}

fn numbers(value: &DeValue) -> Option<Vec<f64>> {
    value
        .as_array()?
        .iter()
        .map(|item| number(item.get_ref()))
        .collect()
}
