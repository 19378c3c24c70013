//! XML of files that nobody has checked: parsed only if that takes little time and memory.

use roxmltree::{Document, ParsingOptions};

use super::ReadMeshError;
use super::limits::{
    MAX_XML_ATTRIBUTES, MAX_XML_ATTRIBUTES_IN_ALL, MAX_XML_NAMESPACES, MAX_XML_NODES,
};
use super::mesh_draft::{FilePosition, check_count};

/// Parses a whole file. A document type is passed over; entities of its own are refused, as they can be nested
/// until they fill any memory.
///
/// # Errors
/// With the line and the reason, or the limit that the text breaks.
pub(super) fn parse_xml(text: &str) -> Result<Document<'_>, ReadMeshError> {
    check_xml_size(text)?;
    let options = ParsingOptions {
        nodes_limit: MAX_XML_NODES,
        allow_dtd: !text.contains("<!ENTITY"),
        ..ParsingOptions::default()
    };
    Document::parse_with_options(text, options)
        .map_err(|error| FilePosition::Line(error.pos().row as usize).error(error.to_string()))
}

/// Refuses what the parser takes long or much memory for. Between one `<` and the next stand the attributes of at most
/// one element, each with a `=`.
pub(super) fn check_xml_size(text: &str) -> Result<(), ReadMeshError> {
    let (mut nodes, mut attributes) = (0_u64, 0);
    for part in text.as_bytes().split(|&b| b == b'<').skip(1) {
        nodes += 1;
        let equals = part.iter().filter(|&&b| b == b'=').count();
        attributes += equals;
        if !part.starts_with(b"!") && !part.starts_with(b"?") {
            let what = "XML attributes of one element";
            check_count(what, equals as u64, MAX_XML_ATTRIBUTES)?;
        }
    }
    // every element has at most two tags
    check_count("XML tags", nodes, 2 * MAX_XML_NODES as usize)?;
    let what = "XML attributes";
    check_count(what, attributes as u64, MAX_XML_ATTRIBUTES_IN_ALL)?;
    let namespaces = text.matches("xmlns").count();
    check_count("XML name spaces", namespaces as u64, MAX_XML_NAMESPACES)
}

/// The starts of all lines of a text, to tell the line of any byte at once. The parser's own way counts from the
/// start of the text each time.
pub(super) struct LineIndex {
    ends: Vec<u32>,
}

impl LineIndex {
    /// Of a text that the parser took, so that it has less than 4 GiB.
    pub(super) fn new(text: &str) -> Self {
        let bytes = text.as_bytes();
        let ends = (0..bytes.len()).filter(|&at| {
            bytes[at] == b'\n' || bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n')
        });
        Self {
            ends: ends.map(|at| at as u32).collect(),
        }
    }

    /// The line of a byte, from 1.
    pub(super) fn line(&self, byte: usize) -> usize {
        1 + self.ends.partition_point(|&end| (end as usize) < byte)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: &str) -> String {
        parse_xml(text).unwrap_err().to_string()
    }

    #[test]
    fn what_would_take_long_is_refused_before_it_is_parsed() {
        let attributes: String = (0..60_000).map(|k| format!(" a{k}=''")).collect();
        assert_eq!(
            error(&format!("<a{attributes}/>")),
            "60000 XML attributes of one element; the limit is 256"
        );
        assert_eq!(
            error(&format!("<a>{}</a>", "=".repeat(2_000_000))),
            "2000000 XML attributes of one element; the limit is 256"
        );
        assert_eq!(
            error(&format!("<a>{}</a>", "<b/>".repeat(200_000))),
            "200002 XML tags; the limit is 200000"
        );
        let spaces: String = (0..1_001).map(|k| format!("<a xmlns:b{k}='c'>")).collect();
        assert_eq!(error(&spaces), "1001 XML name spaces; the limit is 1000");
        let equals = "<!-- = -->".repeat(99) + &format!("<!--{}-->", "=".repeat(1_000_000));
        assert_eq!(
            error(&format!("{equals}<a/>")),
            "1000099 XML attributes; the limit is 1000000"
        );
    }

    #[test]
    fn a_document_type_is_passed_over_and_entities_are_refused() {
        assert!(parse_xml("<!DOCTYPE VTKFile SYSTEM \"vtk.dtd\"><VTKFile/>").is_ok());
        let lol = "<!DOCTYPE a [<!ENTITY b \"bbb\">]>\n<a>&b;</a>";
        assert!(error(lol).starts_with("line 1: "), "{}", error(lol));
        assert!(parse_xml("<!-- ==== --><a b='c'>1 &lt; &#50;</a>").is_ok());
    }

    #[test]
    fn lines_are_those_of_the_parser() {
        let text = "<a>\n<b/>\n\n<c/></a>";
        let document = parse_xml(text).unwrap();
        let lines = LineIndex::new(text);
        for node in document.descendants() {
            let row = document.text_pos_at(node.range().start).row as usize;
            assert_eq!(lines.line(node.range().start), row);
        }
    }
}
