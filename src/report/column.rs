//! One column of a table: its key, heading, unit, digits and explanation, written down once for all who show it.

use std::borrow::Cow;
use std::fmt::Write;

use serde_json::{Value, json};

use super::cell_text::cell_text;
use crate::units::LengthUnit;

/// What stands where there is no value.
pub const NO_VALUE: &str = "–";

/// A value of a row, borrowed from it where it is words.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell<'a> {
    /// No value.
    Empty,
    /// Words.
    Text(Cow<'a, str>),
    /// A count or a number of something in a list.
    Count(usize),
    /// A measured number.
    Number(f64),
    /// Yes or no: 1 or 0 in tables.
    Flag(bool),
}

impl Cell<'_> {
    /// Adds it as CSV files hold it: words escaped for spreadsheets, see [`cell_text()`], numbers as the shortest text that
    /// reads back as the same number.
    pub(super) fn add_to(&self, text: &mut String) {
        // Writing into a string cannot fail.
        match self {
            Self::Empty => Ok(()),
            Self::Text(words) => text.write_str(&cell_text(words)),
            Self::Count(count) => write!(text, "{count}"),
            Self::Number(number) => write!(text, "{number}"),
            Self::Flag(flag) => write!(text, "{}", u8::from(*flag)),
        }
        .ok();
    }

    /// As JSON holds it.
    pub(super) fn json(&self) -> Value {
        match self {
            Self::Empty => Value::Null,
            Self::Text(words) => json!(words),
            Self::Count(count) => json!(count),
            Self::Number(number) => json!(number),
            Self::Flag(flag) => json!(flag),
        }
    }
}

/// Values of rows become cells by `.into()`.
macro_rules! cell_from {
    ($($type:ty: $value:ident => $cell:expr;)*) => {
        $(impl<'a> From<$type> for Cell<'a> {
            fn from($value: $type) -> Self {
                $cell
            }
        })*
    };
}

cell_from! {
    &'a str: words => Self::Text(Cow::Borrowed(words));
    &'a String: words => Self::Text(Cow::Borrowed(words));
    String: words => Self::Text(Cow::Owned(words));
    usize: count => Self::Count(count);
    u32: count => Self::Count(count as usize);
    f64: number => if number.is_finite() { Self::Number(number) } else { Self::Empty };
    bool: flag => Self::Flag(flag);
}

impl<T: Into<Self>> From<Option<T>> for Cell<'_> {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Empty, Into::into)
    }
}

/// What the numbers of a column count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Nothing: words, counts, ratios.
    None,
    /// The same for every subject.
    Symbol(&'static str),
    /// A share from 0 to 1, shown in percent.
    Share,
    /// Percent already.
    Percent,
    /// A length in coordinates: mm, or units of the file.
    Length,
    /// cm², or square units of the file.
    Area,
    /// ml, or cubic units of the file.
    Volume,
}

impl Unit {
    /// Its symbol on screen, for a subject whose coordinates have this unit.
    pub fn symbol(self, of: LengthUnit) -> &'static str {
        match self {
            Self::None => "",
            Self::Symbol(symbol) => symbol,
            Self::Share | Self::Percent => "%",
            Self::Length => of.length_symbol(),
            Self::Area => of.area_symbol(),
            Self::Volume => of.volume_symbol(),
        }
    }

    /// In a dictionary of columns, where no subject is meant.
    fn words(self) -> &'static str {
        match self {
            Self::None => "",
            Self::Symbol(symbol) => symbol,
            Self::Share => "share, 0 to 1",
            Self::Percent => "%",
            Self::Length => "unit of coordinates",
            Self::Area => "cm², or square unit of coordinates",
            Self::Volume => "ml, or cubic unit of coordinates",
        }
    }
}

/// How many digits are shown; files have all of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// So many after the point.
    Places(usize),
    /// None, but one for what is below ten: areas and volumes.
    OneBelowTen,
}

impl Digits {
    /// A number with these digits and a true minus sign, but no minus zero.
    pub fn shown(self, number: f64) -> String {
        let places = match self {
            Self::Places(places) => places,
            // What is rounded to 10.0 is 10.
            Self::OneBelowTen => usize::from(number.abs() < 9.95),
        };
        let text = format!("{number:.places$}");
        match text.strip_prefix('-') {
            Some(digits) if digits.contains(|digit| ('1'..='9').contains(&digit)) => {
                format!("−{digits}")
            }
            Some(zero) => zero.to_owned(),
            None => text,
        }
    }
}

/// A column of a table with rows `R`.
#[derive(Debug)]
pub struct Column<R: 'static> {
    /// Its name in CSV and JSON files: a promise to scripts.
    pub key: &'static str,
    /// What people read above it.
    pub heading: &'static str,
    /// The same where there is little room.
    pub short_heading: &'static str,
    /// What its numbers count.
    pub unit: Unit,
    /// How they are shown.
    pub digits: Digits,
    /// What it is, in a sentence.
    pub explanation: &'static str,
    pub(super) cell: fn(&R) -> Cell<'_>,
}

/// A column that has neither unit nor explanation yet; one of its methods adds both.
pub(super) struct Named<R: 'static> {
    key: &'static str,
    heading: &'static str,
    cell: fn(&R) -> Cell<'_>,
}

/// Begins a column: its name in files, its heading, and the value of a row.
pub(super) const fn column<R>(
    key: &'static str,
    heading: &'static str,
    cell: fn(&R) -> Cell<'_>,
) -> Named<R> {
    Named { key, heading, cell }
}

impl<R: 'static> Named<R> {
    /// With this unit and so many digits on screen.
    pub const fn with(self, unit: Unit, digits: Digits, explanation: &'static str) -> Column<R> {
        Column {
            key: self.key,
            heading: self.heading,
            short_heading: self.heading,
            unit,
            digits,
            explanation,
            cell: self.cell,
        }
    }

    /// Words, counts, or numbers without a unit.
    pub const fn plain(self, explanation: &'static str) -> Column<R> {
        self.with(Unit::None, Digits::Places(2), explanation)
    }

    /// A coordinate without a unit: on a map, or of a direction.
    pub const fn coordinate(self, explanation: &'static str) -> Column<R> {
        self.with(Unit::None, Digits::Places(3), explanation)
    }

    /// A share from 0 to 1.
    pub const fn share(self, explanation: &'static str) -> Column<R> {
        self.with(Unit::Share, Digits::Places(0), explanation)
    }

    /// A number in percent.
    pub const fn percent(self, explanation: &'static str) -> Column<R> {
        self.with(Unit::Percent, Digits::Places(1), explanation)
    }

    /// A length in coordinates.
    pub const fn length(self, explanation: &'static str) -> Column<R> {
        self.with(Unit::Length, Digits::Places(1), explanation)
    }

    /// An area in the shown unit of the subject.
    pub const fn area(self, explanation: &'static str) -> Column<R> {
        self.with(Unit::Area, Digits::OneBelowTen, explanation)
    }

    /// A volume in the shown unit of the subject.
    pub const fn volume(self, explanation: &'static str) -> Column<R> {
        self.with(Unit::Volume, Digits::OneBelowTen, explanation)
    }
}

impl<R: 'static> Column<R> {
    /// With a unit that is the same for every subject.
    pub(super) const fn in_unit(self, symbol: &'static str) -> Self {
        Self {
            unit: Unit::Symbol(symbol),
            ..self
        }
    }

    /// With another heading where there is little room.
    pub(super) const fn or_short(self, short_heading: &'static str) -> Self {
        Self {
            short_heading,
            ..self
        }
    }

    /// The heading, and after a comma the unit if there is one.
    pub fn heading_with_unit(&self, of: LengthUnit) -> String {
        match self.unit.symbol(of) {
            "" => self.heading.to_owned(),
            symbol => format!("{}, {symbol}", self.heading),
        }
    }

    /// The value of a row as people read it, without its unit.
    pub fn shown(&self, row: &R) -> String {
        self.shown_value((self.cell)(row))
    }

    /// The same with other digits.
    pub fn shown_with(&self, digits: Digits, row: &R) -> String {
        self.text(digits, (self.cell)(row))
    }

    /// A value of this column that comes without its row.
    pub fn shown_value<'a>(&self, value: impl Into<Cell<'a>>) -> String {
        self.text(self.digits, value.into())
    }

    fn text(&self, digits: Digits, value: Cell<'_>) -> String {
        match value {
            Cell::Empty => NO_VALUE.to_owned(),
            Cell::Number(share) if self.unit == Unit::Share => digits.shown(100.0 * share),
            Cell::Number(number) => digits.shown(number),
            Cell::Flag(true) => "yes".to_owned(),
            Cell::Flag(false) => "no".to_owned(),
            words @ (Cell::Text(_) | Cell::Count(_)) => {
                let mut text = String::new();
                words.add_to(&mut text);
                text
            }
        }
    }

    /// The value of a row as people read it, with its unit if there is one.
    pub fn shown_with_unit(&self, row: &R, of: LengthUnit) -> String {
        let (value, symbol) = (self.shown(row), self.unit.symbol(of));
        if symbol.is_empty() || value == NO_VALUE {
            value
        } else {
            format!("{value} {symbol}")
        }
    }

    pub(super) fn described(&self) -> ColumnWords {
        ColumnWords {
            key: self.key,
            heading: self.heading,
            unit: self.unit.words(),
            explanation: self.explanation,
        }
    }
}

/// A column in words, whatever its rows are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ColumnWords {
    /// Its name in files.
    pub key: &'static str,
    /// What people read above it.
    pub heading: &'static str,
    /// What its numbers count; empty for none.
    pub unit: &'static str,
    /// What it is.
    pub explanation: &'static str,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_carry_no_more_digits_than_they_deserve_and_a_true_minus() {
        let few = |number| Digits::OneBelowTen.shown(number);
        assert_eq!([104.36, 4.31, 9.97].map(few), ["104", "4.3", "10"]);
        let whole = |number| Digits::Places(0).shown(number);
        assert_eq!([-3.4, -0.1, -10.0].map(whole), ["−3", "0", "−10"]);
        assert_eq!(Digits::Places(1).shown(-0.51), "−0.5");
    }

    #[test]
    fn shares_are_shown_in_percent_and_missing_values_without_a_unit() {
        let column: Column<Option<f64>> =
            column("share", "Share", |row: &Option<f64>| (*row).into()).share("A share");
        let mm = LengthUnit::Millimetre;
        assert_eq!(column.shown_with_unit(&Some(0.312), mm), "31 %");
        assert_eq!(column.shown_with_unit(&None, mm), "–");
        assert_eq!(column.heading_with_unit(mm), "Share, %");
        let mut text = String::new();
        (column.cell)(&Some(0.1 + 0.2)).add_to(&mut text);
        assert_eq!(text, "0.30000000000000004");
    }
}
