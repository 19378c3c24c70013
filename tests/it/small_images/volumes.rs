//! NIfTI, NRRD and MetaImage files of 2 × 3 × 2 voxels at two times, of the numbers 0 to 23.

use std::io::Write;

use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};

use super::SmallImage;

fn values(from: i16, to: i16) -> Vec<u8> {
    (from..to).flat_map(i16::to_le_bytes).collect()
}

fn gzipped(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

fn zlibbed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

const PIXDIM: [f32; 8] = [1.0, 2.0, 3.0, 5.0, 0.25, 1.0, 1.0, 1.0];
const SROW: [f32; 12] = [
    0.0, -3.0, 0.0, 10.0, 2.0, 0.0, 0.0, 20.0, 0.0, 0.0, 5.0, 30.0,
];

/// The header of NIfTI-1; `codes` of the qform and the sform.
fn nifti_1(magic: &[u8; 4], codes: [i16; 2]) -> Vec<u8> {
    let mut bytes = vec![0; 352];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, &348_i32.to_le_bytes());
    put(
        40,
        &[4_i16, 2, 3, 2, 2, 1, 1, 1].map(i16::to_le_bytes).concat(),
    );
    put(70, &[4_i16, 16].map(i16::to_le_bytes).concat());
    put(76, &PIXDIM.map(f32::to_le_bytes).concat());
    let offset: f32 = if magic == b"n+1\0" { 352.0 } else { 0.0 };
    put(108, &offset.to_le_bytes());
    put(123, &[2 | 8]);
    put(148, b"SEEDED^NAME");
    put(252, &codes.map(i16::to_le_bytes).concat());
    put(
        256,
        &[0.5_f32, 0.5, 0.5, 1.0, 2.0, 3.0]
            .map(f32::to_le_bytes)
            .concat(),
    );
    put(280, &SROW.map(f32::to_le_bytes).concat());
    put(344, magic);
    bytes
}

/// The header of NIfTI-2.
fn nifti_2() -> Vec<u8> {
    let mut bytes = vec![0; 544];
    let mut put = |at: usize, value: &[u8]| bytes[at..at + value.len()].copy_from_slice(value);
    put(0, &540_i32.to_le_bytes());
    put(4, b"n+2\0\r\n\x1a\n");
    put(12, &[4_i16, 16].map(i16::to_le_bytes).concat());
    put(
        16,
        &[4_i64, 2, 3, 2, 2, 1, 1, 1].map(i64::to_le_bytes).concat(),
    );
    put(104, &PIXDIM.map(|mm| f64::from(mm).to_le_bytes()).concat());
    put(168, &544_i64.to_le_bytes());
    put(240, b"SEEDED^NAME");
    put(344, &[0_i32, 1].map(i32::to_le_bytes).concat());
    put(400, &SROW.map(|mm| f64::from(mm).to_le_bytes()).concat());
    put(500, &(2_i32 | 8).to_le_bytes());
    bytes
}

fn nrrd(lines: &[&str], values: &[u8]) -> Vec<u8> {
    let head = "NRRD0005\n# SEEDED^NAME\ntype: short\ndimension: 4\nspace: RAS\nsizes: 2 3 2 2\n\
        space directions: (1,0,0) (0,1,0) (0,0,5) none\nspace origin: (1,2,3)\naxis 3 index values:=0 300\n";
    let lines = lines.join("\n");
    [format!("{head}{lines}\n\n").as_bytes(), values].concat()
}

fn metaimage(lines: &[&str], place: &str, values: &[u8]) -> Vec<u8> {
    let head = "ObjectType = Image\nComment = SEEDED^NAME\nNDims = 4\nDimSize = 2 3 2 2\nElementType = MET_SHORT\n\
        ElementSpacing = 2 3 5 0.25\nTransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1\nOffset = 1 2 3 0\n";
    let lines: String = lines.iter().map(|line| format!("{line}\n")).collect();
    [
        format!("{head}{lines}ElementDataFile = {place}\n").as_bytes(),
        values,
    ]
    .concat()
}

pub(super) fn small_volumes() -> Vec<SmallImage> {
    let all = values(0, 24);
    let words: Vec<String> = (0..24).map(|number| number.to_string()).collect();
    let text = words.join(" ");
    let single = [nifti_1(b"n+1\0", [0, 1]), all.clone()].concat();
    let alone = |name, bytes| SmallImage::alone(name, bytes, 2);
    let beside = |name, bytes, beside| SmallImage {
        beside,
        ..SmallImage::alone(name, bytes, 2)
    };
    let halves = || vec![("s1", values(0, 12)), ("s2", values(12, 24))];
    let list = nrrd(
        &["endian: little", "encoding: raw", "data file: s%d 1 2 1"],
        b"",
    );
    let msb = "BinaryDataByteOrderMSB = False";
    let packed = metaimage(&[msb, "CompressedData = True"], "LOCAL", &zlibbed(&all));
    vec![
        alone("packed.nii.gz", gzipped(&single)),
        alone("one.nii", single),
        alone("two.nii", [nifti_2(), all.clone()].concat()),
        alone(
            "turned.nii",
            [nifti_1(b"n+1\0", [1, 0]), all.clone()].concat(),
        ),
        beside(
            "pair.hdr",
            nifti_1(b"ni1\0", [0, 1]),
            vec![("pair.img", all.clone())],
        ),
        alone("raw.nrrd", nrrd(&["endian: little", "encoding: raw"], &all)),
        alone(
            "packed.nrrd",
            nrrd(&["endian: little", "encoding: gzip"], &gzipped(&all)),
        ),
        alone("text.nrrd", nrrd(&["encoding: text"], text.as_bytes())),
        beside("list.nhdr", list, halves()),
        alone("raw.mha", metaimage(&[msb], "LOCAL", &all)),
        alone("packed.mha", packed),
        alone(
            "text.mha",
            metaimage(&["BinaryData = False"], "LOCAL", text.as_bytes()),
        ),
        beside("list.mhd", metaimage(&[msb], "LIST", b"s1\ns2\n"), halves()),
    ]
}
