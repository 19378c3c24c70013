//! What the DICOM files of the shared folder hold, from the descriptions beside them (numbers of pydicom 3.0.2).

/// A file or folder of one series. Lowest, highest and sum are of the numbers before they are rescaled.
#[derive(Clone, Copy)]
pub struct Row {
    pub place: &'static str,
    /// Columns, rows, slices, instants.
    pub size: [usize; 4],
    pub spacing: [f64; 3],
    pub low: f64,
    pub high: f64,
    pub sum: f64,
    pub slope: f64,
    pub intercept: f64,
}

const fn row(
    place: &'static str,
    size: [usize; 4],
    spacing: [f64; 3],
    [low, high, sum]: [f64; 3],
) -> Row {
    Row {
        place,
        size,
        spacing,
        low,
        high,
        sum,
        slope: 1.0,
        intercept: 0.0,
    }
}

const fn scaled(row: Row, slope: f64, intercept: f64) -> Row {
    Row {
        slope,
        intercept,
        ..row
    }
}

const SMALL: [usize; 4] = [64, 64, 1, 1];
const SMALL_MM: [f64; 3] = [0.3125, 0.3125, 0.8];
const SMALL_NUMBERS: [f64; 3] = [127.0, 2145.0, 2.12534e6];
const ENHANCED: [usize; 4] = [64, 64, 10, 1];
const ENHANCED_NUMBERS: [f64; 3] = [0.0, 467.0, 4.49328e6];
const GATED: [usize; 4] = [32, 32, 32, 8];
const GATED_VOXELS: f64 = 32.0 * 32.0 * 32.0 * 8.0;
const PAIR: [usize; 4] = [256, 256, 2, 1];
const PAIR_NUMBERS: [f64; 3] = [0.0, 254.0, 8.29811e6 + 8.33193e6];
const TINY: [usize; 4] = [23, 38, 3, 1];
const TINY_MM: [f64; 3] = [0.7, 0.7, 2.5];
const FEW: [usize; 4] = [16, 16, 3, 1];
const FEW_MM: [f64; 3] = [0.488281, 0.488281, 1.25];
const FLAT: [usize; 4] = [64, 28, 1, 1];
const FLAT_MM: [f64; 3] = [6.39995861053464, 4.0, 1.0];

#[rustfmt::skip] // A table.
pub const READ: &[Row] = &[
    row("gated_spect_dicom/p1/IM000003", GATED, [3.3; 3], [0.0, 2117.0, 527.898 * GATED_VOXELS]),
    row("gated_spect_dicom/p1/IM000002", [32, 32, 32, 1], [3.3; 3], [0.0, 13190.0, 4223.187 * GATED_VOXELS / 8.0]),
    row("gated_spect_dicom/p2/gated_rle.dcm", GATED, [3.3; 3], [0.0, 10200.0, 1869.323 * GATED_VOXELS]),
    row("gated_spect_dicom/p2/gated_timefast.dcm", GATED, [3.3; 3], [0.0, 10200.0, 1869.323 * GATED_VOXELS]),
    row("gated_spect_dicom/p2/gated_nogeom.dcm", GATED, [3.3; 3], [0.0, 10200.0, 1869.323 * GATED_VOXELS]),
    scaled(row("acdc_cine_dicom/study", [88, 88, 7, 12], [1.78571, 1.78571, 10.0], [0.0, 146.0, 40.5909 * 650_496.0]), 1.75, 0.0),
    row("sunnybrook_scd", [256, 256, 10, 2], [1.2891, 1.2891, 8.0], [0.0, 840.0, 1.008767e+08]),
    row("bivme_cine/single/Se2", [256, 208, 1, 1], [1.40625, 1.40625, 6.0], [0.0, 740.0, 5.77382e6]),
    row("bivme_cine/single/Se6", [256, 208, 1, 1], [1.40625, 1.40625, 6.0], [0.0, 845.0, 5.82737e6]),
    scaled(row("dicom_encodings/CT_small.dcm", [128, 128, 1, 1], [0.661468, 0.661468, 5.0], [128.0, 2191.0, 1.48263e7]), 1.0, -1024.0),
    scaled(row("dicom_encodings/ct_signed_private179.dcm", [128, 128, 1, 1], [0.661468, 0.661468, 5.0], [128.0, 2191.0, 1.48263e7]), 1.0, -1024.0),
    row("dicom_encodings/JPEG-LL.dcm", [256, 1024, 1, 1], [2.26, 2.26, 1.0], [0.0, 278.0, 3.59645e6]),
    row("dicom_encodings/MR_small.dcm", SMALL, SMALL_MM, SMALL_NUMBERS),
    row("dicom_encodings/MR_small_RLE.dcm", SMALL, SMALL_MM, SMALL_NUMBERS),
    row("dicom_encodings/MR_small_bigendian.dcm", SMALL, SMALL_MM, SMALL_NUMBERS),
    row("dicom_encodings/MR_small_expb.dcm", SMALL, SMALL_MM, SMALL_NUMBERS),
    row("dicom_encodings/MR_small_implicit.dcm", SMALL, SMALL_MM, SMALL_NUMBERS),
    row("dicom_encodings/MR_small_jp2klossless.dcm", SMALL, SMALL_MM, SMALL_NUMBERS),
    scaled(row("dicom_encodings/bad_sequence.dcm", [512, 512, 1, 1], [0.287109375, 0.287109375, 1.0], [13.0, 2267.0, 2.48349e8]), 1.0, -1024.0),
    row("dicom_encodings/emri_small.dcm", ENHANCED, [1.0; 3], ENHANCED_NUMBERS),
    row("dicom_encodings/emri_small_RLE.dcm", ENHANCED, [1.0; 3], ENHANCED_NUMBERS),
    row("dicom_encodings/emri_small_jpeg_2k_lossless.dcm", ENHANCED, [1.0; 3], ENHANCED_NUMBERS),
    row("dicom_encodings/MR_small_jpeg_ls_lossless.dcm", SMALL, SMALL_MM, SMALL_NUMBERS),
    row("dicom_encodings/emri_small_jpeg_ls_lossless.dcm", ENHANCED, [1.0; 3], ENHANCED_NUMBERS),
    row("dicom_encodings/JPEGLSNearLossless_16.dcm", [10, 50, 1, 1], [1.0; 3], [0.0, 65535.0, 6.00725e6]),
    row("dicom_series_quirks/mr_jpegls", PAIR, [1.0; 3], PAIR_NUMBERS),
    row("dicom_encodings/image_dfl.dcm", [512, 512, 1, 1], [1.0; 3], [0.0, 255.0, 3.33227e7]),
    row("dicom_encodings/parametric_map_float.dcm", [128, 128, 1, 1], [0.661468, 0.661468, 5.0], [0.0, 0.9415791630744934, 9617.09]),
    scaled(row("dicom_series_quirks/gantry_tilt.zip", [512, 512, 3, 1], [0.41796875, 0.41796875, 5.0], [0.0, 254.0, 3.32469e7 + 3.32899e7 + 3.32341e7]), 1.0, -1024.0),
    row("dicom_series_quirks/ge_4d", [64, 64, 4, 2], [3.0, 3.0, 3.6], [0.0, 254.0, 529_165.0 + 518_428.0 + 519_986.0 + 524_751.0 + 524_932.0 + 521_191.0 + 514_230.0 + 516_366.0]),
    row("dicom_series_quirks/hitachi_implicit_signed12", [64, 64, 4, 1], [2.34375, 2.34375, 4.0], [0.0, 1537.0, 1.55114e6 + 1.53751e6 + 1.48463e6 + 1.48841e6]),
    row("dicom_series_quirks/mr_j2k", PAIR, [1.0; 3], PAIR_NUMBERS),
    row("dicom_series_quirks/mr_jpeg/", PAIR, [1.0; 3], PAIR_NUMBERS),
    row("dicom_series_quirks/mr_rle", PAIR, [1.0; 3], PAIR_NUMBERS),
    row("dicom_series_quirks/mr_uncompressed", PAIR, [1.0; 3], [0.0, 254.0, 8.34613e6 + 8.34053e6]),
    scaled(row("dicom_series_quirks/mr_non_isotropic_signed/001.dcm", FLAT, FLAT_MM, [0.0, 254.0, 225_705.0]), 0.0010346139, 33.901196),
    scaled(row("dicom_series_quirks/mr_non_isotropic_signed/002.dcm", FLAT, FLAT_MM, [0.0, 254.0, 226_975.0]), 0.0010206557, 33.443825),
    scaled(row("dicom_series_quirks/mr_non_isotropic_signed/003.dcm", FLAT, FLAT_MM, [0.0, 254.0, 234_818.0]), 0.001298346, 42.542904),
    scaled(row("dicom_series_quirks/mr_non_isotropic_signed/004.dcm", FLAT, FLAT_MM, [0.0, 254.0, 227_723.0]), 0.0029214132, 95.725945),
    scaled(row("dicom_series_quirks/philips_enhanced_4d", [64, 64, 8, 4], [3.3125; 3], [0.0, 254.0, 1.66494e7]), 1.85934065934065, 0.0),
    row("seg_rtstruct/dcmqi/23x38x3/image", TINY, TINY_MM, [0.0, 1.0, 310.0]),
    row("seg_rtstruct/dcmqi/23x38x3/multiframe", TINY, TINY_MM, [0.0, 1.0, 310.0]),
    row("seg_rtstruct/dcmqi/23x38x3/seg", TINY, TINY_MM, [0.0, 1.0, 322.0]),
    row("seg_rtstruct/dcmqi/sparse-labelmap-ppv5.dcm", [24, 38, 3, 1], TINY_MM, [0.0, 1.0, 630.0]),
    row("seg_rtstruct/highdicom/seg_image_ct_binary.dcm", FEW, FEW_MM, [0.0, 1.0, 638.0]),
    scaled(row("seg_rtstruct/highdicom/seg_image_ct_binary_fractional.dcm", FEW, FEW_MM, [0.0, 255.0, 162_690.0]), 1.0 / 255.0, 0.0),
    row("seg_rtstruct/highdicom/seg_image_ct_binary_single_frame.dcm", [128, 128, 1, 1], [0.661468, 0.661468, 5.0], [0.0, 1.0, 1832.0]),
    scaled(row("seg_rtstruct/highdicom/seg_image_ct_true_fractional.dcm", FEW, FEW_MM, [0.0, 128.0, 83_136.0]), 1.0 / 255.0, 0.0),
    row("seg_rtstruct/pydicom/liver.dcm", [512, 512, 3, 1], [0.810547, 0.810547, 1.0], [0.0, 1.0, 107_098.0]),
];

/// Where the first voxel stands, and the step from a slice to the next.
#[rustfmt::skip] // A table.
pub const PLACED: &[(&str, [f64; 3], [f64; 3])] = &[
    ("gated_spect_dicom/p1/IM000003", [70.321, -98.008, 72.104], [-2.0518, 1.9856, 1.6546]),
    ("gated_spect_dicom/p1/IM000002", [70.321, -98.008, 72.104], [-2.0518, 1.9856, 1.6546]),
    ("gated_spect_dicom/p2/gated_rle.dcm", [17.485, -75.208, -91.364], [-2.3158, 1.8196, 1.4887]),
    ("gated_spect_dicom/p2/gated_timefast.dcm", [17.485, -75.208, -91.364], [-2.3158, 1.8196, 1.4887]),
    ("acdc_cine_dicom/study", [-60.0, 20.0, 95.0], [5.49863, -6.19845, -5.5986]),
];

/// Files that are no images of a place, or packed by a codec that is not read, with the words that say so.
#[rustfmt::skip] // A table.
pub const REFUSED: &[(&str, &str)] = &[
    ("dicom_encodings/ExplVR_BigEnd.dcm", "a picture in colours"),
    ("dicom_encodings/ExplVR_BigEndNoMeta.dcm", "a plan of radiotherapy"),
    ("dicom_encodings/ExplVR_LitEndNoMeta.dcm", "a plan of radiotherapy"),
    ("dicom_encodings/GDCMJ2K_TextGBR.dcm", "a picture in colours"),
    ("dicom_encodings/JPEG-lossy.dcm", "JPEG with loss of 12 bits"),
    ("dicom_encodings/JPGExtended.dcm", "JPEG with loss of 12 bits"),
    ("dicom_encodings/MR_truncated.dcm", "8192 bytes, but only 8130 are there"),
    ("dicom_encodings/SC_rgb_small_odd.dcm", "a picture in colours"),
    ("dicom_encodings/SC_rgb_small_odd_big_endian.dcm", "a picture in colours"),
    ("dicom_encodings/UN_sequence.dcm", "it holds no pixels"),
    ("dicom_encodings/badVR.dcm", "NumberOfFrames: it is no whole number"),
    ("dicom_encodings/empty_charset_LEI.dcm", "it holds no pixels"),
    ("dicom_encodings/meta_missing_tsyntax.dcm", "Rows"),
    ("dicom_encodings/nested_priv_SQ.dcm", "Rows"),
    ("dicom_encodings/no_meta_group_length.dcm", "it holds no pixels"),
    ("dicom_encodings/priv_SQ.dcm", "it holds no pixels"),
    ("dicom_encodings/reportsi.dcm", "a report"),
    ("dicom_series_quirks/rgb_secondary", "a picture in colours"),
    ("dicom_series_quirks/siemens_mosaic.zip", "a mosaic"),
];
