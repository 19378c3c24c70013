//! A figure as a PNG file that carries the settings it was made with.

use std::io::Cursor;

use crate::picture::figure::canvas::Canvas;

/// Settings of a figure in words, in the order in which they stand in the file.
pub type FigureSettings = Vec<(&'static str, String)>;

/// The bytes of a PNG file; each setting becomes a text chunk under its key.
///
/// The same figure gives the same bytes: no date is written.
///
/// # Errors
/// If the encoder refuses, which an intact canvas gives no reason for.
pub fn encoded_png(
    canvas: &Canvas,
    settings: &FigureSettings,
) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = png::Encoder::new(&mut bytes, canvas.width(), canvas.height());
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    for (key, value) in settings {
        encoder.add_itxt_chunk((*key).to_owned(), value.clone())?;
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(canvas.pixels())?;
    writer.finish()?;
    Ok(bytes.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_comes_back_with_its_settings() {
        let mut canvas = Canvas::filled(3, 2, [1.0, 0.5, 0.0], 1.0);
        canvas.cover(1, 1, [0.0, 0.0, 1.0], 1.0);
        let settings = vec![
            ("Subject", "P-041".to_owned()),
            ("Limits", "0–20 mm".to_owned()),
        ];
        let bytes = encoded_png(&canvas, &settings).unwrap();
        let mut reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        assert_eq!(pixels, canvas.pixels());
        let texts: Vec<_> = reader
            .info()
            .utf8_text
            .iter()
            .map(|chunk| (chunk.keyword.clone(), chunk.get_text().unwrap()))
            .collect();
        assert_eq!(texts[1], ("Limits".to_owned(), "0–20 mm".to_owned()));
        assert_eq!(bytes, encoded_png(&canvas, &settings).unwrap());
    }
}
