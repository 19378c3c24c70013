//! What must not come out of real DICOM files, and what damaged copies of them must not do.

use cardiomorph::io::{Limits, read_dicom, read_dicom_bytes};
use cardiomorph::progress::Progress;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::shared::shared_data;

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn no_seeded_word_of_a_patient_is_in_what_is_read() {
    for place in ["gated_spect_dicom", "acdc_cine_dicom"] {
        let text = format!(
            "{:?}",
            read_dicom(
                &[shared_data(&format!("images/{place}"))],
                &Limits::default(),
                &Progress::default()
            )
            .unwrap()
        );
        for word in ["SEEDED", "19310723", "ZQX", "DELTA", "BETA"] {
            assert!(!text.contains(word), "{place}: {word}");
        }
    }
}

/// Damaged copies of small real files of every codec and syntax.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_thousand_damaged_copies_of_real_files_are_read_or_refused_in_no_time() {
    let files = [
        "dicom_encodings/MR_small_jp2klossless.dcm",
        "dicom_encodings/MR_small_RLE.dcm",
        "dicom_encodings/MR_small_jpeg_ls_lossless.dcm",
        "dicom_encodings/MR_small_implicit.dcm",
        "dicom_encodings/MR_small_bigendian.dcm",
        "dicom_encodings/JPEG-LL.dcm",
        "dicom_encodings/image_dfl.dcm",
        "dicom_series_quirks/mr_jpeg/IM-0001-0001-0001.dcm",
        "seg_rtstruct/dcmqi/23x38x3/seg/label.seg",
        "gated_spect_dicom/p2/gated_rle.dcm",
        "dicom_series_quirks/siemens_mosaic.zip",
    ];
    let files: Vec<Vec<u8>> = (files.iter())
        .map(|place| std::fs::read(shared_data(&format!("images/{place}"))).unwrap())
        .collect();
    for (seed, file) in (0..1000).zip(files.iter().cycle()) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mut bytes = file.clone();
        for _ in 0..random.random_range(1..8) {
            let within = if random.random() {
                bytes.len()
            } else {
                bytes.len().min(4000)
            };
            let at = random.random_range(0..within);
            match random.random_range(0..5) {
                0 => bytes.insert(at, random.random()),
                1 => drop(bytes.remove(at)),
                2 => bytes[at] ^= 1 << random.random_range(0..8),
                3 => bytes[at] = [0, 0xff, 0x7f, 0x80][random.random_range(0..4)],
                _ => bytes.truncate(at.max(200)),
            }
        }
        let limits = Limits::default();
        read_dicom_bytes("f", bytes.into(), &limits, &Progress::default()).unwrap();
    }
}

/// <https://github.com/pydicom/pydicom/issues/1149>: the head of a JPEG 2000 stream may say otherwise than the file
/// whether numbers have a sign. The bits count, and what they mean is said by the file.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_stream_that_contradicts_its_file_about_signs_keeps_its_bits() {
    let place = shared_data("images/dicom_encodings/MR_small_jp2klossless.dcm");
    let mut bytes = std::fs::read(place).unwrap();
    let values = |bytes: &[u8]| {
        let limits = Limits::default();
        let reading = read_dicom_bytes("f", bytes.into(), &limits, &Progress::default()).unwrap();
        reading.series[0].image.volumes()[0].to_vec()
    };
    let signed = values(&bytes);
    let head = bytes
        .windows(4)
        .position(|four| four == [0xff, 0x4f, 0xff, 0x51])
        .unwrap();
    let depth = &mut bytes[head + 42];
    assert_eq!(*depth, 0x8f);
    *depth = 0x0f;
    // Without a sign the decoder adds half the range, which 16 bits with a sign read as that much below.
    let unsigned: Vec<f32> = signed.iter().map(|value| value - 32_768.0).collect();
    assert_eq!(values(&bytes), unsigned);
}
