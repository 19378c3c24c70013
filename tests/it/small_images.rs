//! The smallest files of every format of images and of every way in which each packs its voxels, made here byte by byte.

#[cfg(test)]
pub mod dicom;
#[cfg(test)]
mod volumes;

use self::dicom::Dicom;

/// One file, and those that it names.
pub struct SmallImage {
    pub name: &'static str,
    pub bytes: Vec<u8>,
    /// Files that stand beside it, by their names.
    pub beside: Vec<(&'static str, Vec<u8>)>,
    /// Volumes over all its series.
    pub volumes: usize,
}

impl SmallImage {
    fn alone(name: &'static str, bytes: Vec<u8>, volumes: usize) -> Self {
        Self {
            name,
            bytes,
            beside: Vec::new(),
            volumes,
        }
    }

    /// Whether it is read as DICOM or as an archive of such files.
    pub fn is_dicom(&self) -> bool {
        self.name.ends_with(".dcm") || self.name.ends_with(".zip")
    }
}

/// All of them.
pub fn small_images() -> Vec<SmallImage> {
    let mut all = volumes::small_volumes();
    all.extend(dicom_files());
    all
}

/// JPEG, process 14, first-order prediction: 100, 200, … of 3 × 2 pixels (by imagecodecs 2026.3.6, as the two below).
pub const JPEG_LOSSLESS_STREAM: &str = "ffd8ffc40018000100030100000000000000000000000007090f0810ffc3000b100002000301001100ffda0008010000\
    060000e646492cc017bce8ffd9";
pub const JPEG_LS_STREAM: &str = "ffd8ffe800205350494646000200000100000002000000030a1006010000012c0000012cffe8000800000001ffd8fff7\
    000b100002000301011100fff8000d01ffff0012004301140040ffda0008010100000000a63cc7cb19847950ffd9";
/// The head of this stream says that its numbers have no sign.
pub const JPEG_2000_STREAM: &str = "ff4fff5100290000000000030000000200000000000000000000000300000002000000000000000000010f0101ff5200\
    0c00000001000004040001ff5c00044080ff640025000143726561746564206279204f70656e4a504547207665727369\
    6f6e20322e352e34ff90000a0000000000200001ff93dff8907007a20b4037b4c0cb8dc4fade918bffd9";
/// What the three hold, with a sign.
pub const UNPACKED: [f32; 6] = [0.0, 100.0, 200.0, 300.0, -5.0, -2000.0];

/// The bytes that hexadecimal digits stand for.
pub fn from_hex(digits: &str) -> Vec<u8> {
    let digits: Vec<u8> = (digits.chars())
        .map(|digit| digit.to_digit(16).unwrap() as u8)
        .collect();
    let (pairs, _) = digits.as_chunks::<2>();
    pairs.iter().map(|&[high, low]| 16 * high + low).collect()
}

fn dicom_files() -> Vec<SmallImage> {
    let image = Dicom::image(0.0, 0);
    let signed = image.clone().words(0x0028, 0x0103, &[1]);
    let packed = |syntax: &str, stream: Vec<u8>| signed.clone().packed(&[&stream]).file(syntax);
    let mut run = [&1_u32.to_le_bytes()[..], &64_u32.to_le_bytes()].concat();
    run.resize(64, 0);
    run.extend([5, 1, 2, 3, 4, 5, 6, 0x80]);
    let bytes = (image.clone().words(0x0028, 0x0100, &[8]))
        .words(0x0028, 0x0101, &[8])
        .words(0x0028, 0x0102, &[7]);
    let slices = [0.0, 8.0].map(|z| Dicom::image(z, z as u16).file(dicom::EXPLICIT));
    let alone = SmallImage::alone;
    vec![
        alone("explicit.dcm", image.file(dicom::EXPLICIT), 1),
        alone("implicit.dcm", image.file(dicom::IMPLICIT), 1),
        alone("big.dcm", image.file(dicom::BIG), 1),
        alone("deflated.dcm", image.file(dicom::DEFLATED), 1),
        alone("enhanced.dcm", Dicom::enhanced().file(dicom::EXPLICIT), 2),
        alone("gated.dcm", Dicom::gated().file(dicom::IMPLICIT), 2),
        alone("segments.dcm", Dicom::segments().file(dicom::EXPLICIT), 1),
        alone("contours.dcm", Dicom::contours().file(dicom::EXPLICIT), 0),
        alone("runs.dcm", bytes.packed(&[&run]).file(dicom::RLE), 1),
        alone(
            "jpeg.dcm",
            packed(dicom::JPEG, from_hex(JPEG_LOSSLESS_STREAM)),
            1,
        ),
        alone(
            "jpeg_ls.dcm",
            packed(dicom::JPEG_LS, from_hex(JPEG_LS_STREAM)),
            1,
        ),
        alone(
            "jpeg_2000.dcm",
            packed(dicom::JPEG_2000, from_hex(JPEG_2000_STREAM)),
            1,
        ),
        alone("slices.zip", dicom::archive(&slices), 1),
    ]
}
