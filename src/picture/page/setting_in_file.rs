//! Settings that a figure holds, read back from its file.

use std::io::Cursor;

use crate::picture::page::file_format::PageFormat;
use crate::picture::page::png_file::png_text;

impl PageFormat {
    /// The value of a setting in the bytes of a figure's file; `None` where it holds none. Of a PNG or SVG file the
    /// beginning is enough.
    ///
    /// # Errors
    /// If the file is none of this kind.
    pub fn setting_in(self, bytes: &[u8], key: &str) -> Result<Option<String>, String> {
        match self {
            Self::Png => png_text(Cursor::new(bytes), key).map_err(|error| error.to_string()),
            Self::Svg => {
                if !bytes.starts_with(b"<svg") {
                    return Err("not a drawing of Cardiomorph".to_owned());
                }
                Ok(setting_in_xml(bytes, ["<metadata>", "</metadata>"], key))
            }
            Self::Pdf => {
                if !bytes.starts_with(b"%PDF") {
                    return Err("not a PDF file".to_owned());
                }
                Ok(setting_in_xml(bytes, ["<x:xmpmeta", "</x:xmpmeta>"], key))
            }
        }
    }
}

/// The value behind `key: ` at the beginning of a line of the texts of an XML element, which begins and ends like this.
fn setting_in_xml(bytes: &[u8], [begin, end]: [&str; 2], key: &str) -> Option<String> {
    let from = place(bytes, begin)?;
    let length = place(&bytes[from..], end)? + end.len();
    let element = std::str::from_utf8(&bytes[from..from + length]).ok()?;
    let document = roxmltree::Document::parse(element).ok()?;
    let texts = document.descendants().filter_map(|node| node.text());
    let mut lines = texts.flat_map(str::lines);
    lines.find_map(|line| Some(line.strip_prefix(key)?.strip_prefix(": ")?.to_owned()))
}

fn place(bytes: &[u8], words: &str) -> Option<usize> {
    let mut windows = bytes.windows(words.len());
    windows.position(|window| window == words.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::page::{FigureFonts, Page, VIEW_KEY};

    #[test]
    fn every_kind_of_file_gives_its_settings_back() {
        let page = Page::new([40.0, 30.0], Some([1.0; 3]));
        let fonts = FigureFonts::load().unwrap();
        let value = "{\"id\":\"P<07> & “é”\",\"angle\":[0.5]}".to_owned();
        let settings = vec![("Title", "P07".to_owned()), (VIEW_KEY, value.clone())];
        for format in [PageFormat::Png, PageFormat::Svg, PageFormat::Pdf] {
            let bytes = format.file(&page, &settings, &fonts).unwrap();
            let read = |key| format.setting_in(&bytes, key).unwrap();
            assert_eq!(read(VIEW_KEY).as_ref(), Some(&value), "{format:?}");
            assert_eq!(read("Moment"), None);
            assert!(format.setting_in(b"solid heart", VIEW_KEY).is_err());
            for cut in [8, bytes.len() / 2] {
                // Damage is no value or an error, never a panic.
                format.setting_in(&bytes[..cut], VIEW_KEY).ok();
            }
        }
    }
}
