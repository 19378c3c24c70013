//! Archives as they leave an archive of images.

use std::io::{Cursor, Write};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

use super::writer::{image, read, said};
use crate::io::limits::Limits;
use crate::progress::Progress;

fn archive(files: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let options = SimpleFileOptions::default().compression_method(CompressionMethod::Deflated);
    for (name, bytes) in files {
        writer.start_file(*name, options).unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}

#[test]
fn an_archive_reads_as_its_folder() {
    let zip = archive(&[
        ("study/1/a", image(0.0, 0).file()),
        ("study/1/b", image(8.0, 10).file()),
        ("../../outside", image(16.0, 20).file()),
        ("study/notes.txt", b"notes".to_vec()),
        ("study/.hidden", image(24.0, 20).file()),
    ]);
    let reading = read(&zip);
    assert_eq!(reading.series.len(), 1);
    assert_eq!(reading.series[0].image.frame().size(), [3, 2, 3]);
    assert_eq!(reading.series[0].image.frame().spacing()[2], 8.0);
    assert_eq!(reading.left_out.len(), 1);
    assert_eq!(reading.left_out[0].file.as_deref(), Some("notes.txt"));
}

#[test]
fn what_unpacks_to_more_than_the_limit_or_to_too_many_files_is_refused() {
    let mut large = image(0.0, 0).file();
    large.resize(4 << 20, 0);
    let zip = archive(&[("bomb", large), ("small", image(0.0, 0).file())]);
    assert!(zip.len() < 20_000);
    let read = |limits: Limits| {
        let bytes = zip.clone().into();
        crate::io::dicom::read::read_dicom_bytes("a.zip", bytes, &limits, &Progress::default())
            .unwrap()
    };
    let limits = Limits {
        file_bytes: 1 << 20,
        ..Limits::default()
    };
    let reading = read(limits);
    assert_eq!(reading.series.len(), 1);
    assert!(said(&reading).contains("4194304 bytes; the limit is 1048576"));
    let limits = Limits {
        image_files: 1,
        ..Limits::default()
    };
    assert!(said(&read(limits)).contains("2 files in an archive; the limit is 1"));
}

#[test]
fn a_damaged_archive_is_refused() {
    let mut zip = archive(&[("a", image(0.0, 0).file())]);
    zip.truncate(zip.len() - 30);
    assert!(said(&read(&zip)).contains("damaged"));
}
