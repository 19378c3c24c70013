//! Points and faces in one CSV file.
//!
//! A row is `v,x,y,z` for a vertex or `f,a,b,c` for a face (or more corners), with vertices
//! counted from 0 in the order of their rows. Faces may stand before their vertices. A first row of
//! words is a header; empty rows and rows that begin with `#` are passed over. Quotes may
//! stand around any cell. Cells may be parted by semicolons, with decimal points or commas, or by tabs, too.

use std::borrow::Cow;

use super::mesh_draft::{FilePosition, MeshDraft};
use super::text_lines::{TextLines, count, number, shown, three_numbers, without_end_mark};
use super::{Limits, MeshFile, ReadMeshError};

/// Reads rows of vertices and faces.
pub(super) fn read_csv_mesh(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let mut draft = MeshDraft::new(limits, 0);
    let mut corners = Vec::new();
    let mut header_may_come = true;
    let separator = separator(bytes);
    for (line, text) in TextLines::new(without_end_mark(bytes)) {
        let place = FilePosition::Line(line);
        let text = &*with_points(text, separator);
        let Some(row) = cells(text, separator) else {
            continue;
        };
        let mut cells = row.clone();
        match cells.next() {
            Some(b"v" | b"V") => {
                draft.point(three_numbers(&mut cells, place)?, place)?;
                if cells.next().is_some() {
                    return Err(place.error("vertex has more than 3 coordinates"));
                }
            }
            Some(b"f" | b"F") => {
                corners.clear();
                for cell in cells {
                    let index = count(cell, place)?;
                    corners.push(u32::try_from(index).map_err(|_| {
                        place.error(format!("{index} is not the index of a vertex"))
                    })?);
                    draft.check_corners(corners.len() as u64, place)?;
                }
                draft.polygon(&corners, place)?;
            }
            // How a spreadsheet says what parts its cells.
            Some(word) if header_may_come && word.starts_with(b"sep=") => continue,
            _ if header_may_come && is_header(&row, place) => {}
            word => {
                return Err(place.error(format!(
                    "a row begins with {}, but \"v\" (vertex) or \"f\" (face) is needed",
                    shown(word.unwrap_or_default())
                )));
            }
        }
        header_may_come = false;
    }
    draft.finish()
}

/// What stands between the cells of the first vertex or face: a comma, a semicolon or a tab.
pub(super) fn separator(bytes: &[u8]) -> u8 {
    let of_row = |text: &[u8]| {
        let row = text.trim_ascii();
        let rest = row.strip_prefix(b"\"").unwrap_or(row);
        let rest = rest.strip_prefix(b"v").or(rest.strip_prefix(b"V"));
        let rest = rest.or(row.strip_prefix(b"f")).or(row.strip_prefix(b"F"))?;
        let rest = rest.strip_prefix(b"\"").unwrap_or(rest);
        let mut signs = rest.iter().filter(|b| **b != b' ');
        signs.next().filter(|b| b",;\t".contains(b)).copied()
    };
    let mut found = TextLines::new(bytes).filter_map(|(_, text)| of_row(text));
    found.next().unwrap_or(b',')
}

/// A row of a vertex with decimal points. Spreadsheets part cells by semicolons where a comma is the decimal sign.
fn with_points(text: &[u8], separator: u8) -> Cow<'_, [u8]> {
    let first = text.split(|&b| b == separator).next().map(unquoted);
    if separator == b';' && first.is_some_and(|cell| cell.eq_ignore_ascii_case(b"v")) {
        text.iter()
            .map(|&b| if b == b',' { b'.' } else { b })
            .collect()
    } else {
        Cow::Borrowed(text)
    }
}

/// A row of words.
fn is_header<'a>(row: &(impl Iterator<Item = &'a [u8]> + Clone), place: FilePosition) -> bool {
    !row.clone().any(|cell| number(cell, place).is_ok())
}

/// The cells of a row up to the last that is not empty; none for a row that says nothing.
fn cells(text: &[u8], separator: u8) -> Option<impl Iterator<Item = &[u8]> + Clone> {
    let blank = |b: &u8| b.is_ascii_whitespace() || *b == separator;
    let end = text.iter().rposition(|b| !blank(b))? + 1;
    let row = &text[..end];
    let remark = row.trim_ascii_start().starts_with(b"#");
    (!remark).then(|| row.split(move |&b| b == separator).map(unquoted))
}

fn unquoted(cell: &[u8]) -> &[u8] {
    let cell = cell.trim_ascii();
    let inner = cell
        .strip_prefix(b"\"")
        .and_then(|cell| cell.strip_suffix(b"\""));
    inner.unwrap_or(cell).trim_ascii()
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: &str = "v,0,0,0\nv,1,0,0\nv,0,1,0\n";

    fn read(text: &str) -> Result<MeshFile, ReadMeshError> {
        read_csv_mesh(text.as_bytes(), &Limits::default())
    }

    #[test]
    fn rows_are_read_in_either_case_quoted_or_not() {
        let text = format!("kind,x,y,z\n# points\n\n{POINTS}f,0,1,2\n");
        let expected = read(&text).unwrap();
        assert_eq!(expected.frames[0].triangles(), [[0, 1, 2]]);
        for other in [
            text.replace(',', " , "),
            text.replace('\n', "\r"),
            text.replace('\n', ",,\r\n"),
            text.replace('v', "V").replace("f,", "F,"),
            text.replace("v,", "\"v\",").replace("f,0", "\"f\",\"0\""),
            text.replace("kind,x,y,z", "\"\",\"V1\",\"V2\",\"V3\""),
            text.replace("kind,x,y,z\n", ""),
            text.replace(',', ";"),
            text.replace(',', "\t"),
            text.replace("f,0,1,2", "f,0.0,1.000e+00,2"),
            format!("sep=,\n{text}\x1a\r\n"),
        ] {
            assert_eq!(read(&other).unwrap(), expected, "{other}");
        }
    }

    #[test]
    fn a_missing_cell_or_another_row_is_an_error_with_its_line() {
        for (row, expected) in [
            ("v,1,,0", "line 4: \"\" is not a number"),
            ("v,1,,2,3", "line 4: \"\" is not a number"),
            ("v,1,2,", "line 4: 2 coordinates, but 3 are needed"),
            (
                "v,1,5,2,5,3,5",
                "line 4: vertex has more than 3 coordinates",
            ),
            ("v;1,5;2,5;3,5", "line 4: a row begins with \"v;1\""),
            ("v,1,-1.#IND,0", "line 4: \"-1.#IND\" is not a number"),
            ("v,nan,0,0", "line 4: coordinate NaN is not a finite number"),
            (
                "v,1e999,0,0",
                "line 4: coordinate inf is not a finite number",
            ),
            ("f,0,1,,2", "line 4: \"\" is not a count"),
            ("f,0,1,1.5", "line 4: \"1.5\" is not a count"),
            (",0,1,2", "line 4: a row begins with \"\", but"),
        ] {
            let error = read(&format!("{POINTS}{row}\nf,0,1,2\n")).unwrap_err();
            assert!(error.to_string().starts_with(expected), "{row}: {error}");
        }
        let error = read("v;0;0;0\nv,0,0,0\n").unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("line 2: a row begins with \"v,0,0,0\"")
        );
        let error = read(&format!("w,0,0,0\n{POINTS}f,0,1,2\n")).unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("line 1: a row begins with \"w\"")
        );
    }
}
