//! Reading STL, text and binary: loose triangles whose equal corners become one vertex.

use std::collections::HashMap;

use super::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use super::mesh_draft::{FilePosition, MeshDraft};
use super::text_lines::{TextLines, TextWords, number, shown, three_numbers, without_end_mark};
use super::{Limits, MeshFile, ReadMeshError};
use crate::study::Notice;

const HEADER_BYTES: usize = 84;
const TRIANGLE_BYTES: usize = 50;

/// Reads either form. Corners with exactly equal coordinates become one vertex, numbered by
/// first occurrence, so that frames with triangles in the same order have the same vertices.
pub(super) fn read_stl(bytes: &[u8], limits: &Limits) -> Result<MeshFile, ReadMeshError> {
    let mut weld = Weld::new(limits);
    if is_text(bytes) {
        read_text(bytes, &mut weld)?;
    } else {
        read_binary(bytes, &mut weld)?;
    }
    weld.finish()
}

/// Text begins with "solid", but so do some binary headers: those have a size that fits their
/// count, or bytes that no text has.
fn is_text(bytes: &[u8]) -> bool {
    let text = without_padding(bytes);
    let head = &text[..text.len().min(512)];
    !is_whole_binary_stl(bytes) && !head.iter().any(|&b| b < b'\t')
}

/// Whether the size of a file is that of as many triangles as its header would announce.
pub(super) fn is_whole_binary_stl(bytes: &[u8]) -> bool {
    triangle_count(bytes).is_some_and(|count| {
        bytes.len() as u64 == HEADER_BYTES as u64 + count * TRIANGLE_BYTES as u64
    })
}

/// Some programs fill the last block of a file with zeros.
fn without_padding(bytes: &[u8]) -> &[u8] {
    let zeros = bytes.iter().rev().take_while(|&&b| b == 0).count();
    &bytes[..bytes.len() - zeros]
}

fn triangle_count(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(80..HEADER_BYTES)?;
    Some(Scalar::U32.number(count, ByteOrder::Little) as u64)
}

fn read_binary(bytes: &[u8], weld: &mut Weld) -> Result<(), ReadMeshError> {
    let mut count = triangle_count(bytes).ok_or_else(|| {
        FilePosition::Byte(bytes.len()).error("the file ends within the header of a binary STL")
    })?;
    // Programs that write triangles as they come leave the count as it was before the first.
    let (body, triangle) = (bytes.len() - HEADER_BYTES, TRIANGLE_BYTES);
    if [0, u64::from(u32::MAX)].contains(&count) && body > 0 && body.is_multiple_of(triangle) {
        let whole = (body / triangle) as u64;
        let text = format!("the header announces {count} triangles: all {whole} are read");
        weld.draft.notice(Notice::warning(text));
        count = whole;
    }
    weld.draft.expect_faces(count)?;
    let mut cursor = BinaryCursor::new(bytes, HEADER_BYTES);
    for _ in 0..count {
        let FilePosition::Byte(start) = cursor.place() else {
            break;
        };
        let record = cursor.take(TRIANGLE_BYTES as u64, "a triangle")?;
        for corner in 0..3 {
            let at = 12 + 12 * corner;
            let x = |axis: usize| Scalar::F32.number(&record[at + 4 * axis..], ByteOrder::Little);
            weld.corner([x(0), x(1), x(2)], FilePosition::Byte(start + at))?;
        }
        weld.triangle(FilePosition::Byte(start))?;
    }
    if !cursor.rest().is_empty() {
        let text = format!(
            "{} bytes after the last triangle ignored",
            cursor.rest().len()
        );
        weld.draft.notice(Notice::warning(text));
    }
    Ok(())
}

/// Keywords may be in any case, `end loop` in one word or two, numbers on any line. Lines that begin with `#`, `;` or
/// `//` are comments.
fn read_text(bytes: &[u8], weld: &mut Weld) -> Result<(), ReadMeshError> {
    let mut solid_open = false;
    let text = without_end_mark(without_padding(bytes));
    let mut words = TextWords::new(TextLines::new(text));
    let mut line_before = 0;
    while let Some(first) = words.next() {
        let place = words.place();
        let begins_line = words.line() > line_before;
        line_before = words.line();
        if begins_line
            && [&b"#"[..], b";", b"//"]
                .iter()
                .any(|sign| first.starts_with(sign))
        {
            words.skip_line();
            continue;
        }
        let mut keyword = first.to_ascii_lowercase();
        if keyword == b"end" {
            keyword.extend(words.next().unwrap_or_default().to_ascii_lowercase());
        }
        match keyword.as_slice() {
            b"solid" if !solid_open => {
                solid_open = true;
                skip_name(&mut words);
            }
            b"endsolid" if solid_open => {
                solid_open = false;
                if skip_name(&mut words) {
                    return Err(place.error("a facet on the line of \"endsolid\""));
                }
            }
            _ if !solid_open => {
                return Err(place.error(format!("{} outside a solid", shown(first))));
            }
            b"facet" => skip_normal(&mut words),
            b"vertex" => weld.corner(three_numbers(&mut words, place)?, place)?,
            b"outer" | b"loop" | b"endloop" => {}
            b"color" => words.skip_line(),
            b"endfacet" => weld.triangle(place)?,
            _ if number(first, place).is_ok() => {
                return Err(place.error("vertex has more than 3 coordinates"));
            }
            _ => return Err(place.error(format!("unknown keyword {}", shown(first)))),
        }
        line_before = words.line();
    }
    if solid_open || !weld.corners.is_empty() {
        return Err(words.place().error("the file ends within a solid"));
    }
    Ok(())
}

/// Goes past the name of a solid, which ends with its line, or before the first facet if all stands on one line;
/// whether it did.
fn skip_name(words: &mut TextWords<'_>) -> bool {
    loop {
        let mut ahead = words.clone();
        let Some(word) = ahead.next_on_line() else {
            return false;
        };
        let next = ahead.next_on_line().unwrap_or_default();
        if word.eq_ignore_ascii_case(b"facet") && next.eq_ignore_ascii_case(b"normal") {
            return true;
        }
        words.next_on_line();
    }
}

/// Goes past `normal` and its numbers, which may be no numbers where a triangle has no area.
fn skip_normal(words: &mut TextWords<'_>) {
    for _ in 0..4 {
        let next = words.clone().next();
        if next.is_none_or(|word| word.eq_ignore_ascii_case(b"outer")) {
            return;
        }
        words.next();
    }
}

/// Joins equal corners while triangles come in.
struct Weld {
    draft: MeshDraft,
    corners: Vec<u32>,
    vertex_at: HashMap<[u64; 3], u32>,
}

impl Weld {
    fn new(limits: &Limits) -> Self {
        Self {
            draft: MeshDraft::new(limits, 0),
            corners: Vec::new(),
            vertex_at: HashMap::new(),
        }
    }

    fn corner(&mut self, xyz: [f64; 3], place: FilePosition) -> Result<(), ReadMeshError> {
        // adding zero turns −0 into 0, which is the same place
        let bits = xyz.map(|x| (x + 0.0).to_bits());
        let next = self.draft.point_count() as u32;
        let vertex = *self.vertex_at.entry(bits).or_insert(next);
        if vertex == next {
            self.draft.point(xyz.map(|x| x + 0.0), place)?;
        }
        self.corners.push(vertex);
        Ok(())
    }

    fn triangle(&mut self, place: FilePosition) -> Result<(), ReadMeshError> {
        if self.corners.len() != 3 {
            let reason = format!("a facet has {} vertices, but needs 3", self.corners.len());
            return Err(place.error(reason));
        }
        let corners = std::mem::take(&mut self.corners);
        self.draft.polygon(&corners, place)?;
        self.corners = corners;
        self.corners.clear();
        Ok(())
    }

    fn finish(mut self) -> Result<MeshFile, ReadMeshError> {
        let vertices = self.draft.point_count();
        self.draft.notice(Notice::info(format!(
            "STL has no shared vertices: corners with exactly equal coordinates are merged into {vertices} vertices, numbered by first occurrence"
        )));
        self.draft.finish()
    }
}
