//! Numbers in binary files: a place that never runs past the end, and the scalar types of all formats.

use super::ReadMeshError;
use super::mesh_draft::FilePosition;

/// Which byte of a number comes first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ByteOrder {
    /// The least significant.
    Little,
    /// The most significant.
    Big,
}

/// How a number is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    /// Whole numbers with and without sign, by bits.
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    I64,
    U64,
    /// Floating point.
    F32,
    F64,
}

impl Scalar {
    /// Bytes of one number.
    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::I64 | Self::U64 | Self::F64 => 8,
        }
    }

    /// The number at the start of `bytes`; bytes that are missing count as zero.
    ///
    /// Whole numbers of 64 bits are exact up to 2⁵³, far beyond any index.
    pub(super) fn number(self, bytes: &[u8], order: ByteOrder) -> f64 {
        let mut word = [0; 8];
        let size = self.size();
        for (to, from) in word.iter_mut().zip(&bytes[..size.min(bytes.len())]) {
            *to = *from;
        }
        if order == ByteOrder::Big {
            word[..size].reverse();
        }
        let bits = u64::from_le_bytes(word);
        match self {
            Self::I8 => f64::from(bits as i8),
            Self::U8 => f64::from(bits as u8),
            Self::I16 => f64::from(bits as i16),
            Self::U16 => f64::from(bits as u16),
            Self::I32 => f64::from(bits as i32),
            Self::U32 => f64::from(bits as u32),
            Self::I64 => bits as i64 as f64,
            Self::U64 => bits as f64,
            Self::F32 => f64::from(f32::from_bits(bits as u32)),
            Self::F64 => f64::from_bits(bits),
        }
    }
}

/// A place in a binary file.
#[derive(Clone, Debug)]
pub(super) struct BinaryCursor<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> BinaryCursor<'a> {
    /// At byte `at`, or at the end if that is past it.
    pub(super) fn new(bytes: &'a [u8], at: usize) -> Self {
        Self {
            bytes,
            at: at.min(bytes.len()),
        }
    }

    /// Where it is.
    pub(super) fn place(&self) -> FilePosition {
        FilePosition::Byte(self.at)
    }

    /// What is left.
    pub(super) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// The next `count` bytes, which are `what`.
    pub(super) fn take(&mut self, count: u64, what: &str) -> Result<&'a [u8], ReadMeshError> {
        let rest = self.rest();
        if count > rest.len() as u64 {
            return Err(self.place().error(format!(
                "{what} needs {count} bytes, but only {} are left",
                rest.len()
            )));
        }
        let taken = &rest[..count as usize];
        self.at += taken.len();
        Ok(taken)
    }

    /// The next number, which is `what`.
    pub(super) fn number(
        &mut self,
        scalar: Scalar,
        order: ByteOrder,
        what: &str,
    ) -> Result<f64, ReadMeshError> {
        Ok(scalar.number(self.take(scalar.size() as u64, what)?, order))
    }
}

/// A number as the index of a vertex, counted from 0.
pub(super) fn vertex_index(number: f64, place: FilePosition) -> Result<u32, ReadMeshError> {
    if number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&number) {
        return Ok(number as u32);
    }
    Err(place.error(format!("{number} is not the index of a vertex")))
}

/// A number as a count.
pub(super) fn count(number: f64, place: FilePosition) -> Result<u64, ReadMeshError> {
    if number.fract() == 0.0 && number >= 0.0 {
        return Ok(number as u64);
    }
    Err(place.error(format!("{number} is not a count")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_every_type_are_read_in_both_orders() {
        let cases: [(Scalar, &[u8], f64); 6] = [
            (Scalar::I8, &[0xfe], -2.0),
            (Scalar::U16, &[1, 2], 513.0),
            (Scalar::I32, &[0xff, 0xff, 0xff, 0xff], -1.0),
            (Scalar::U64, &[0, 1, 0, 0, 0, 0, 0, 0], 256.0),
            (Scalar::F32, &1.5_f32.to_le_bytes(), 1.5),
            (Scalar::F64, &(-0.1_f64).to_le_bytes(), -0.1),
        ];
        for (scalar, little, expected) in cases {
            assert_eq!(scalar.number(little, ByteOrder::Little), expected);
            let big: Vec<u8> = little.iter().rev().copied().collect();
            assert_eq!(scalar.number(&big, ByteOrder::Big), expected);
        }
    }

    #[test]
    fn reading_past_the_end_says_where_and_how_much_is_missing() {
        let mut cursor = BinaryCursor::new(&[0; 10], 4);
        let error = cursor.take(u64::MAX, "a face").unwrap_err();
        assert_eq!(
            error.to_string(),
            "byte 4: a face needs 18446744073709551615 bytes, but only 6 are left"
        );
    }
}
