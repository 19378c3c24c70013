//! Fields of one TOML table, read by name and kind; every complaint names its line.

use std::collections::BTreeSet;

use toml::de::{DeTable, DeValue};

/// A table of a TOML text, and which of its keys were asked for.
pub(super) struct Fields<'t> {
    text: &'t str,
    table: &'t DeTable<'t>,
    known: BTreeSet<&'static str>,
}

impl<'t> Fields<'t> {
    pub(super) fn new(text: &'t str, table: &'t DeTable<'t>) -> Self {
        Self {
            text,
            table,
            known: BTreeSet::new(),
        }
    }

    /// The line of a key, counted from 1.
    pub(super) fn line_of(&self, key: &str) -> Option<usize> {
        self.table
            .iter()
            .find(|(name, _)| name.get_ref().as_ref() == key)
            .map(|(name, _)| line_at(self.text, name.span().start))
    }

    /// Keys that nobody asked for, with their lines.
    pub(super) fn unknown(&self) -> Vec<(usize, String)> {
        self.table
            .iter()
            .filter(|(name, _)| !self.known.contains(name.get_ref().as_ref()))
            .map(|(name, _)| {
                (
                    line_at(self.text, name.span().start),
                    name.get_ref().to_string(),
                )
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
        let text = self.text;
        self.read(key, "a table", |value| {
            value.as_table().map(|table| Fields::new(text, table))
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

/// The line of a byte, counted from 1.
pub(super) fn line_at(text: &str, byte: usize) -> usize {
    let before = text.as_bytes().get(..byte).unwrap_or(text.as_bytes());
    1 + before.iter().filter(|&&b| b == b'\n').count()
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
