//! A matrix as a file of NumPy, format 1.0: numbers of eight bytes, row by row.

use crate::analysis::pose_distances::DistanceMatrix;

/// The bytes that begin the file of a square matrix with so many rows.
///
/// Source: <https://numpy.org/doc/stable/reference/generated/numpy.lib.format.html>. The header ends in a line end and is
/// filled up with blanks, so that the numbers begin at a multiple of 64 bytes.
pub fn npy_header(rows: usize) -> Vec<u8> {
    let words = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({rows}, {rows}), }}");
    const BEGIN: &[u8] = b"\x93NUMPY\x01\x00";
    let used = BEGIN.len() + 2 + words.len() + 1;
    let blanks = used.next_multiple_of(64) - used;
    // Far below the 65535 that the format can say.
    let length = (words.len() + blanks + 1) as u16;
    let mut bytes = BEGIN.to_vec();
    bytes.extend(length.to_le_bytes());
    bytes.extend(words.bytes());
    bytes.extend(std::iter::repeat_n(b' ', blanks));
    bytes.push(b'\n');
    bytes
}

/// The bytes of one of its rows.
pub fn npy_row(matrix: &DistanceMatrix, row: usize) -> Vec<u8> {
    let numbers = (0..matrix.size()).map(|column| matrix.get(row, column));
    numbers.flat_map(f64::to_le_bytes).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_file_is_what_numpy_writes() {
        let matrix = DistanceMatrix::from_upper(2, vec![0.1 + 0.2]).unwrap();
        let mut bytes = npy_header(2);
        assert_eq!(bytes.len(), 128);
        assert_eq!(&bytes[..10], b"\x93NUMPY\x01\x00v\x00");
        assert!(
            bytes[10..].starts_with(b"{'descr': '<f8', 'fortran_order': False, 'shape': (2, 2), }")
        );
        assert_eq!(bytes.last(), Some(&b'\n'));
        (0..2).for_each(|row| bytes.extend(npy_row(&matrix, row)));
        let numbers: Vec<f64> = (bytes[128..].chunks_exact(8))
            .map(|eight| f64::from_le_bytes(eight.try_into().unwrap()))
            .collect();
        assert_eq!(numbers, [0.0, 0.1 + 0.2, 0.1 + 0.2, 0.0]);
    }
}
