//! Wavefront OBJ: reading polygons with the file's own vertex numbers, and writing.
//!
//! The reader is our own: tobj renumbers vertices by their first use and drops unused ones, which
//! would lose the correspondence of frames, and its errors name no line. Corners of triangles agree
//! with tobj's by their coordinates (`tests/it/obj_by_tobj.rs`).

use std::borrow::Cow;
use std::io::{self, Write};

use super::mesh_draft::{FilePosition, MeshDraft, missing_vertex};
use super::text_lines::{TextLines, shown, three_numbers, whole_number, without_end_mark, words};
use super::{Limits, MeshFile, ReadMeshError};
use crate::mesh::TriMesh;
use crate::study::Notice;

/// Keywords of what is read or counted.
const SHAPE: &[&[u8]] = &[b"v", b"f", b"fo", b"p", b"l", b"o"];

/// Keywords of the format that say nothing about where the surface is.
const WITHOUT_SHAPE: &[&[u8]] = &[
    b"vt",
    b"vn",
    b"vp",
    b"g",
    b"s",
    b"mg",
    b"usemtl",
    b"mtllib",
    b"usemap",
    b"maplib",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"cstype",
    b"deg",
    b"bmat",
    b"step",
    b"parm",
    b"trim",
    b"hole",
    b"scrv",
    b"sp",
    b"end",
    b"con",
];

/// How programs begin comments that do not know the format's own `#`.
const REMARKS: &[&[u8]] = &[b"//", b"%", b";"];

/// Keywords of curves and curved surfaces, which are left out.
const CURVED: &[&[u8]] = &[b"curv", b"curv2", b"surf"];

/// Reads all faces of all objects and groups as one surface. Keywords may be in any case.
pub(super) fn read_obj(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let mut draft = MeshDraft::new(limits, 1);
    let mut corners = Vec::new();
    let (mut objects, mut curved) = (0, 0);
    let mut lines = TextLines::new(without_end_mark(bytes));
    while let Some((line, text)) = lines.next() {
        let text = whole_line(text, &mut lines);
        let place = FilePosition::Line(line);
        let mut words = words(&text);
        let keyword = words.next().map(<[u8]>::to_ascii_lowercase);
        match keyword.as_deref() {
            None => {}
            Some(word) if REMARKS.iter().any(|sign| word.starts_with(sign)) => {}
            Some(b"v") => {
                draft.point(three_numbers(&mut words, place)?, place)?;
                check_rest_of_vertex(words, place)?;
            }
            Some(b"f" | b"fo") => {
                corners.clear();
                for word in words {
                    corners.push(vertex_index(word, draft.point_count(), place)?);
                    draft.check_corners(corners.len() as u64, place)?;
                }
                draft.polygon(&corners, place)?;
            }
            Some(b"p" | b"l") => draft.skip_points_and_lines(1),
            Some(b"o") => objects += 1,
            Some(word) if CURVED.contains(&word) => curved += 1,
            Some(word) if WITHOUT_SHAPE.contains(&word) => {}
            Some(word) => return Err(place.error(format!("unknown keyword {}", shown(word)))),
        }
    }
    if objects > 1 {
        draft.notice(Notice::info(format!(
            "{objects} objects joined into one surface"
        )));
    }
    if curved > 0 {
        draft.notice(Notice::warning(format!(
            "{curved} curves or curved surfaces ignored"
        )));
    }
    draft.finish()
}

/// The line up to its comment, with the lines that a backslash at its end joins to it. A backslash in a comment joins
/// nothing, nor does one before a line that says by its keyword what it is: `mtllib D:\hearts\` above a vertex is a path.
fn whole_line<'a>(text: &'a [u8], lines: &mut TextLines<'a>) -> Cow<'a, [u8]> {
    // Nearly all lines.
    if !text.iter().any(|byte| matches!(byte, b'#' | b'\\')) {
        return text.into();
    }
    let continued = |text: &[u8]| {
        without_comment(text).len() == text.len() && text.trim_ascii_end().ends_with(b"\\")
    };
    let mut joined = Cow::Borrowed(text);
    let mut part = text;
    while continued(part) {
        let whole = joined.to_mut();
        whole.truncate(whole.trim_ascii_end().len() - 1);
        let Some((_, next)) = lines.clone().next().filter(|(_, next)| !has_keyword(next)) else {
            break;
        };
        lines.next();
        whole.push(b' ');
        whole.extend_from_slice(next);
        part = next;
    }
    match joined {
        Cow::Borrowed(text) => without_comment(text).into(),
        Cow::Owned(text) => without_comment(&text).to_vec().into(),
    }
}

fn has_keyword(line: &[u8]) -> bool {
    let first = words(line).next().unwrap_or_default().to_ascii_lowercase();
    let first = first.as_slice();
    SHAPE.contains(&first) || WITHOUT_SHAPE.contains(&first) || CURVED.contains(&first)
}

/// A comment begins a word: the `#` of `-1.#IND`, which is how some C libraries print what is no number, begins none, and
/// such a number must be refused, not read as -1.
fn without_comment(text: &[u8]) -> &[u8] {
    let begins = |at: usize| at == 0 || text[at - 1].is_ascii_whitespace();
    let comment = (0..text.len()).find(|&at| text[at] == b'#' && begins(at));
    &text[..comment.unwrap_or(text.len())]
}

/// After x, y, z: nothing, a weight, or a colour of three or four parts.
fn check_rest_of_vertex<'a>(
    rest: impl Iterator<Item = &'a [u8]>,
    place: FilePosition,
) -> Result<(), ReadMeshError> {
    match rest.count() {
        0 | 1 | 3 | 4 => Ok(()),
        more => Err(place.error(format!("vertex has {} numbers", 3 + more))),
    }
}

/// `7`, `7/1`, `7//3`, `7/1/3` or `-1`: the vertex, counted from 0.
fn vertex_index(word: &[u8], defined: usize, place: FilePosition) -> Result<u32, ReadMeshError> {
    let mut parts = word.split(|&b| b == b'/');
    let number = whole_number(parts.next().unwrap_or_default(), place)?;
    if number > 0
        && parts.clone().next().is_none()
        && let Ok(index) = u32::try_from(number - 1)
    {
        return Ok(index);
    }
    let whole_or_none = |part: &[u8]| part.iter().all(|b| b.is_ascii_digit() || *b == b'-');
    if parts.clone().count() > 2 || !parts.all(whole_or_none) {
        return Err(place.error(format!("{} is not the corner of a face", shown(word))));
    }
    let index = match number {
        0 => return Err(place.error("face refers to vertex 0, but vertices count from 1")),
        1.. => number - 1,
        _ => defined as i64 + number,
    };
    u32::try_from(index).map_err(|_| match number {
        1.. => place.error(missing_vertex(number as u64, defined, 1)),
        _ => place.error(format!(
            "face refers to vertex {number}, but only {defined} are defined before it"
        )),
    })
}

/// Writes positions, exact to the last bit, and faces.
///
/// # Errors
/// If `out` cannot be written to.
pub fn write_obj(out: &mut impl Write, mesh: &TriMesh) -> io::Result<()> {
    for point in mesh.vertices() {
        writeln!(out, "v {:?} {:?} {:?}", point.x, point.y, point.z)?;
    }
    for [a, b, c] in mesh.triangles().iter().map(|t| t.map(|v| u64::from(v) + 1)) {
        writeln!(out, "f {a} {b} {c}")?;
    }
    Ok(())
}
