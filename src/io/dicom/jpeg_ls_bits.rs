//! Bits of a JPEG-LS scan (ITU-T T.87, A.1 and A.5.3).

/// Bits, the highest of a byte first. A byte after 0xff holds seven: its highest is stuffed in, so that no marker appears.
pub(super) struct Bits<'a> {
    bytes: std::slice::Iter<'a, u8>,
    held: u32,
    left: u32,
    stuffed: bool,
}

impl<'a> Bits<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes: bytes.iter(),
            held: 0,
            left: 0,
            stuffed: false,
        }
    }

    /// The next bit; `None` at the end of the bytes or at a marker.
    pub(super) fn bit(&mut self) -> Option<bool> {
        if self.left == 0 {
            let byte = *self.bytes.next()?;
            if self.stuffed && byte >= 0x80 {
                return None;
            }
            self.left = if self.stuffed { 7 } else { 8 };
            self.held = u32::from(byte);
            self.stuffed = byte == 0xff;
        }
        self.left -= 1;
        Some(self.held >> self.left & 1 == 1)
    }

    /// A number of so many bits.
    pub(super) fn number(&mut self, bits: u32) -> Option<u32> {
        (0..bits).try_fold(0_u32, |number, _| {
            Some(number << 1 | u32::from(self.bit()?))
        })
    }

    /// A number in Golomb code of parameter k whose codes are at most `limit` bits long; longer ones are `bits` plain bits.
    pub(super) fn limited(&mut self, k: u32, limit: u32, bits: u32) -> Option<i32> {
        let longest = limit.checked_sub(bits + 1)?;
        let mut zeros = 0;
        while !self.bit()? {
            zeros += 1;
            if zeros > longest {
                return None;
            }
        }
        let number = if zeros < longest {
            zeros.checked_shl(k)? | self.number(k)?
        } else {
            self.number(bits)?.checked_add(1)?
        };
        // Beyond any error of 16 bits: damaged.
        i32::try_from(number)
            .ok()
            .filter(|&number| number < 1 << 18)
    }
}
