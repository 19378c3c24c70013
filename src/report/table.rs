//! Tables of rows as CSV and JSON: the one place where results become text for scripts.

use csv::{QuoteStyle, Writer, WriterBuilder};
use serde_json::{Map, Value};

use super::column::{Column, ColumnWords};

/// A row of a table. Keys and order of columns are a promise to scripts: new ones go to the end.
pub trait Row: Sized + 'static {
    /// Names of the files that hold this table.
    const FILES: &'static [&'static str];
    /// What one row is, in a sentence.
    const ROW: &'static str;
    /// From the first to the last.
    const COLUMNS: &'static [Column<Self>];
}

/// A table in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TableWords {
    /// Names of the files that hold it.
    pub files: &'static [&'static str],
    /// What one row is.
    pub row: &'static str,
    /// From the first to the last; tables of items and coordinates have more behind these.
    pub columns: Vec<ColumnWords>,
    /// What follows behind these columns, where their number depends on the data.
    pub further: Option<&'static str>,
}

/// Column keys, then rows.
pub fn csv<R: Row>(rows: &[R]) -> String {
    csv_header::<R>() + &csv_rows(rows)
}

/// The table under each of its names.
pub fn named_csv<R: Row>(rows: &[R]) -> impl Iterator<Item = (String, String)> {
    let text = csv(rows);
    let named = move |file: &&'static str| ((*file).to_owned(), text.clone());
    R::FILES.iter().map(named)
}

/// Column keys alone, for tables that grow.
pub fn csv_header<R: Row>() -> String {
    records(std::iter::once(R::COLUMNS.iter().map(|column| column.key)))
}

/// Rows alone, to be added to others.
pub fn csv_rows<R: Row>(rows: &[R]) -> String {
    let mut writer = writer();
    // One text for all cells: the tables of atoms have millions of them.
    let mut text = String::new();
    for row in rows {
        for column in R::COLUMNS {
            text.clear();
            (column.cell)(row).add_to(&mut text);
            // Memory takes every record, of any length.
            writer.write_field(&text).ok();
        }
        writer.write_record(None::<&[u8]>).ok();
    }
    written(writer)
}

/// A row as an object of JSON with the keys of its columns.
pub fn json_row<R: Row>(row: &R) -> Map<String, Value> {
    json_cells(row, R::COLUMNS)
}

/// Some columns of a row as an object of JSON.
pub(super) fn json_cells<'a, R: 'static>(
    row: &R,
    columns: impl IntoIterator<Item = &'a Column<R>>,
) -> Map<String, Value> {
    let cells = columns.into_iter();
    cells
        .map(|column| (column.key.to_owned(), (column.cell)(row).json()))
        .collect()
}

/// A table in words.
pub(super) fn described<R: Row>() -> TableWords {
    TableWords {
        files: R::FILES,
        row: R::ROW,
        columns: R::COLUMNS.iter().map(Column::described).collect(),
        further: None,
    }
}

/// An object of JSON as a file that people read.
///
/// # Errors
/// If it holds what JSON cannot hold, which no result of an analysis does.
pub fn pretty_json(value: &Value) -> Result<String, serde_json::Error> {
    Ok(serde_json::to_string_pretty(value)? + "\n")
}

/// Lines of cells, quoted where CSV asks for it.
pub(super) fn records<C: AsRef<[u8]>>(
    records: impl IntoIterator<Item = impl IntoIterator<Item = C>>,
) -> String {
    let mut writer = writer();
    for record in records {
        // Memory takes every record, of any length.
        writer.write_record(record).ok();
    }
    written(writer)
}

fn writer() -> Writer<Vec<u8>> {
    WriterBuilder::new()
        .flexible(true)
        .has_headers(false)
        .quote_style(QuoteStyle::Necessary)
        .from_writer(Vec::new())
}

fn written(writer: Writer<Vec<u8>>) -> String {
    let bytes = writer.into_inner().unwrap_or_default();
    // Cells are texts, and what stands between them is ASCII.
    String::from_utf8(bytes).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_quoted_only_where_they_must_be() {
        let lines = [vec!["P, \"1\"", "", "#2"], vec!["two\nlines", " a ", "é"]];
        assert_eq!(
            records(lines),
            "\"P, \"\"1\"\"\",,#2\n\"two\nlines\", a ,é\n"
        );
    }
}
