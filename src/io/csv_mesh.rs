//! Points and faces in one CSV file.
//!
//! A row is `v,x,y,z` for a vertex or `f,a,b,c` for a face (or more corners), with vertices
//! counted from 0 in the order of their rows. Faces may stand before their vertices. A first row of
//! words is a header; empty rows and rows that begin with `#` are passed over. Tabs or semicolons
//! may stand for the commas, quotes around any cell.

use super::mesh_draft::{MeshDraft, Place};
use super::text_lines::{TextLines, count, number, shown, three_numbers};
use super::{Limits, MeshFile, ReadMeshError};

/// Reads rows of vertices and faces.
pub(super) fn read_csv_mesh(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let mut draft = MeshDraft::new(limits, 0);
    let mut corners = Vec::new();
    let mut header_may_come = true;
    for (line, text) in TextLines::new(bytes) {
        let place = Place::Line(line);
        let Some(row) = cells(text) else { continue };
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
            _ if header_may_come && !row.clone().any(|cell| number(cell, place).is_ok()) => {}
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

/// Whether a text begins as points and faces do: with a row of either, perhaps after a header. What is wrong further
/// down is for the reader to tell.
pub(super) fn begins_as_mesh(head: &[u8]) -> bool {
    let rows = TextLines::new(head).filter_map(|(_, text)| cells(text));
    rows.take(2).any(|mut row| {
        let is_kind = matches!(row.next(), Some(b"v" | b"V" | b"f" | b"F"));
        is_kind && row.count() >= 2
    })
}

/// The cells of a row up to the last that is not empty; none for a row that says nothing.
fn cells(text: &[u8]) -> Option<impl Iterator<Item = &[u8]> + Clone> {
    let text = text.trim_ascii();
    let empty = text.iter().all(|b| b",;\t\" ".contains(b));
    if empty || text.starts_with(b"#") {
        return None;
    }
    let kind_and_rest = unquoted(text.split(|b| b",;\t".contains(b)).next().unwrap_or(text));
    let between = text.iter().find(|b| b",;\t".contains(b)).copied();
    // a header may hold any of them
    let between = between.filter(|_| kind_and_rest.len() == 1).unwrap_or(b',');
    let mut end = text.len();
    while end > 0 && (text[end - 1] == between || text[end - 1].is_ascii_whitespace()) {
        end -= 1;
    }
    Some(text[..end].split(move |&b| b == between).map(unquoted))
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
    fn cells_are_between_commas_semicolons_or_tabs_quoted_or_not() {
        let text = format!("kind,x,y,z\n# points\n\n{POINTS}f,0,1,2\n");
        let expected = read(&text).unwrap();
        assert_eq!(expected.frames[0].triangles(), [[0, 1, 2]]);
        for other in [
            text.replace(',', ";"),
            text.replace(',', "\t"),
            text.replace(',', " , "),
            text.replace('\n', "\r"),
            text.replace('\n', ",,\r\n"),
            text.replace('v', "V").replace("f,", "F,"),
            text.replace("v,", "\"v\",").replace("f,0", "\"f\",\"0\""),
            text.replace("kind,x,y,z", "\"\",\"V1\",\"V2\",\"V3\""),
            text.replace("kind,x,y,z\n", ""),
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
            ("v;1,5;2,5;3,5", "line 4: \"1,5\" is not a number"),
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
        let error = read(&format!("w,0,0,0\n{POINTS}f,0,1,2\n")).unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("line 1: a row begins with \"w\"")
        );
    }

    #[test]
    fn a_table_is_told_from_points_and_faces_by_its_first_rows() {
        for mesh in [
            "v,nan,0,0\n",
            "kind,x,y,z\nV;1;2;",
            "# a\n\n\"f\",0,1,2",
            "\r\rv\t0\t0\t0",
        ] {
            assert!(begins_as_mesh(mesh.as_bytes()), "{mesh}");
        }
        for table in ["", "time,volume\n0,1\nv,1,2,3", "v,volume\nv,1", "\0\u{1}v"] {
            assert!(!begins_as_mesh(table.as_bytes()), "{table}");
        }
    }
}
