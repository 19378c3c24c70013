//! A page as a PNG file that contains the settings it was made with.

use std::io::{BufRead, Cursor, Seek};

use crate::picture::page::FigureSettings;
use crate::render::Picture;

/// Key of the setting from which the window restores a view.
pub const VIEW_KEY: &str = "Cardiomorph view";

/// The picture could not be encoded, which an intact one gives no reason for, or a file is no picture.
#[derive(Debug, thiserror::Error)]
pub enum PngError {
    /// The encoder refused.
    #[error(transparent)]
    Encoding(#[from] png::EncodingError),
    /// The file is no PNG picture, or is damaged.
    #[error("not a PNG picture: {0}")]
    Decoding(#[from] png::DecodingError),
}

/// The bytes of a PNG file; each setting becomes a text chunk under its key.
///
/// The same picture gives the same bytes: no date is written.
///
/// # Errors
/// If the encoder refuses.
pub fn encoded_png(raster: &Picture, settings: &FigureSettings) -> Result<Vec<u8>, PngError> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = png::Encoder::new(&mut bytes, raster.width, raster.height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    for (key, value) in settings {
        encoder.add_itxt_chunk((*key).to_owned(), value.clone())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&raster.rgba)?;
    writer.finish()?;
    Ok(bytes.into_inner())
}

/// The text that a PNG file holds under a key before its pixels; `None` where it holds none.
///
/// # Errors
/// If the file is no PNG picture.
pub fn png_text(file: impl BufRead + Seek, key: &str) -> Result<Option<String>, PngError> {
    let reader = png::Decoder::new(file).read_info()?;
    let info = reader.info();
    let found = info.utf8_text.iter().find(|chunk| chunk.keyword == key);
    Ok(found.map(|chunk| chunk.get_text()).transpose()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file() -> Vec<u8> {
        let raster = Picture {
            width: 3,
            height: 2,
            rgba: (0..24).collect(),
        };
        let settings = vec![
            ("Subject", "P-041".to_owned()),
            (VIEW_KEY, "0–20 mm".to_owned()),
        ];
        let bytes = encoded_png(&raster, &settings).unwrap();
        assert_eq!(bytes, encoded_png(&raster, &settings).unwrap());
        bytes
    }

    #[test]
    fn a_picture_comes_back_with_its_settings() {
        let bytes = file();
        let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, (0..24).collect::<Vec<u8>>());
        let text = |key| png_text(Cursor::new(&bytes), key).unwrap();
        assert_eq!(text(VIEW_KEY).as_deref(), Some("0–20 mm"));
        assert_eq!(text("Subject").as_deref(), Some("P-041"));
        assert_eq!(text("Frame"), None);
    }

    #[test]
    fn what_is_no_picture_is_refused() {
        let bytes = file();
        for cut in [0, 4, 20, 40] {
            assert!(
                png_text(Cursor::new(&bytes[..cut]), VIEW_KEY).is_err(),
                "{cut}"
            );
        }
        assert!(png_text(Cursor::new(b"solid heart"), VIEW_KEY).is_err());
    }
}
