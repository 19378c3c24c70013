//! A parsed VTP file, and what its arrays need to be decoded.

use std::cell::Cell;

use roxmltree::Node;

use super::appended::Appended;
use super::encoded::Encoding;
use crate::io::mesh_draft::FilePosition;
use crate::io::xml::LineIndex;

/// A parsed file and what its arrays need to be decoded.
pub(super) struct VtpFile<'a> {
    pub(super) lines: LineIndex,
    pub(super) appended: Option<Appended<'a>>,
    pub(super) encoding: Encoding<'a>,
    /// Bytes that arrays may still unpack to, all together.
    pub(super) budget: Cell<u64>,
}

impl VtpFile<'_> {
    /// The line on which an element begins.
    pub(super) fn place(&self, node: Node<'_, '_>) -> FilePosition {
        FilePosition::Line(self.lines.line(node.range().start))
    }
}
