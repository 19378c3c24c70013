//! Pixels packed by JPEG-LS (ITU-T T.87), for which there is no crate in Rust alone.

use super::jpeg_ls_bits::Bits;
use super::jpeg_ls_head::{JpegLsHead, Presets};

/// How the steps of a run grow (T.87, A.7.1.1).
const RUN_STEPS: [u32; 32] = [
    0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 9, 10, 11, 12, 13,
    14, 15,
];
/// The contexts of ordinary samples; those of the ends of runs follow.
const CONTEXTS: usize = 365;

/// What was learned of the errors of prediction in one context (A.2).
#[derive(Clone, Copy)]
struct Context {
    /// Sum of their sizes: A.
    sizes: i32,
    /// Their bias: B.
    bias: i32,
    /// What is added to the prediction: C.
    correction: i32,
    /// How many there were: N.
    count: i32,
    /// How many were negative (ends of runs only): Nn.
    negative: i32,
}

/// A decoder of one scan of one component.
struct Scan<'a> {
    bits: Bits<'a>,
    presets: Presets,
    /// Greatest difference of a sample from what was packed: NEAR.
    near: i32,
    /// Number of different errors: RANGE.
    range: i32,
    /// Bits that hold one of them: qbpp.
    bits_of_error: u32,
    /// Longest code: LIMIT.
    limit: u32,
    contexts: Vec<Context>,
    run: usize,
}

/// The samples of the stream, row by row; `None` if its bytes are not those of the format, or end too early.
///
/// The size in the head was compared with that of the image: memory for it is granted.
pub(super) fn samples(bytes: &[u8], head: &JpegLsHead) -> Option<Vec<u32>> {
    let mut scan = Scan::new(bytes.get(head.scan..)?, head);
    let [width, height] = head.size;
    let mut samples = Vec::with_capacity(width.checked_mul(height)?);
    // One sample before the row and one behind it (A.2.1).
    let mut above = vec![0_i32; width + 2];
    let mut row = vec![0_i32; width + 2];
    for _ in 0..height {
        *above.last_mut()? = *above.get(width)?;
        *row.first_mut()? = *above.get(1)?;
        scan.row(&above, &mut row, width)?;
        samples.extend(row.get(1..=width)?.iter().map(|&sample| sample as u32));
        std::mem::swap(&mut above, &mut row);
    }
    Some(samples)
}

impl<'a> Scan<'a> {
    fn new(bytes: &'a [u8], head: &JpegLsHead) -> Self {
        let Presets { greatest, .. } = head.presets;
        let near = head.near;
        let range = (greatest + 2 * near) / (2 * near + 1) + 1;
        let ceil_log2 = |n: i32| 32 - (n - 1).max(0).leading_zeros();
        let bits = ceil_log2(greatest + 1).max(2);
        let context = Context {
            sizes: ((range + 32) / 64).max(2),
            bias: 0,
            correction: 0,
            count: 1,
            negative: 0,
        };
        Self {
            bits: Bits::new(bytes),
            presets: head.presets,
            near,
            range,
            bits_of_error: ceil_log2(range),
            limit: 2 * (bits + bits.max(8)),
            contexts: vec![context; CONTEXTS + 2],
            run: 0,
        }
    }

    fn row(&mut self, above: &[i32], row: &mut [i32], width: usize) -> Option<()> {
        let mut x = 0;
        while x < width {
            let (a, b) = (*row.get(x)?, *above.get(x + 1)?);
            let (c, d) = (*above.get(x)?, *above.get(x + 2)?);
            let gradients = [d - b, b - c, c - a];
            if gradients.iter().all(|gradient| gradient.abs() <= self.near) {
                x = self.run(above, row, x, width)?;
            } else {
                *row.get_mut(x + 1)? = self.sample(gradients, [a, b, c])?;
                x += 1;
            }
        }
        Some(())
    }

    /// A gradient in nine steps (A.3.3).
    fn step(&self, gradient: i32) -> i32 {
        let [t1, t2, t3] = self.presets.thresholds;
        let size = match gradient.abs() {
            g if g <= self.near => 0,
            g if g < t1 => 1,
            g if g < t2 => 2,
            g if g < t3 => 3,
            _ => 4,
        };
        size * gradient.signum()
    }

    /// An ordinary sample (A.4 to A.6).
    fn sample(&mut self, gradients: [i32; 3], [a, b, c]: [i32; 3]) -> Option<i32> {
        let [q1, q2, q3] = gradients.map(|gradient| self.step(gradient));
        let index = 81 * q1 + 9 * q2 + q3;
        let sign = if index < 0 { -1 } else { 1 };
        let context = self.contexts.get_mut(usize::try_from(sign * index).ok()?)?;
        let (low, high) = (a.min(b), a.max(b));
        let predicted = if c >= high {
            low
        } else if c <= low {
            high
        } else {
            a + b - c
        };
        let greatest = self.presets.greatest;
        let predicted = (predicted + sign * context.correction).clamp(0, greatest);
        let k = parameter(context.count, context.sizes)?;
        let coded = self.bits.limited(k, self.limit, self.bits_of_error)?;
        let turned = self.near == 0 && k == 0 && 2 * context.bias <= -context.count;
        let coded = if turned { coded ^ 1 } else { coded };
        let error = match coded & 1 {
            0 => coded >> 1,
            _ => -((coded + 1) >> 1),
        };
        context.learn(error, self.near, self.presets.reset);
        Some(self.reconstructed(predicted, sign * error))
    }

    /// A run of equal samples with the one that ends it (A.7). Returns where the next stands.
    fn run(&mut self, above: &[i32], row: &mut [i32], x: usize, width: usize) -> Option<usize> {
        let value = *row.get(x)?;
        let mut x = x;
        while self.bits.bit()? {
            let step = 1_usize << RUN_STEPS.get(self.run)?;
            let end = (x + step).min(width);
            row.get_mut(x + 1..=end)?.fill(value);
            if x + step <= width {
                self.run = (self.run + 1).min(RUN_STEPS.len() - 1);
            }
            x = end;
            if x == width {
                return Some(x);
            }
        }
        let steps = *RUN_STEPS.get(self.run)?;
        let end = x + self.bits.number(steps)? as usize;
        // A run to the end of the row has no sample that ends it.
        if end >= width {
            return None;
        }
        row.get_mut(x + 1..=end)?.fill(value);
        *row.get_mut(end + 1)? = self.end_of_run(value, *above.get(end + 1)?, steps)?;
        self.run = self.run.saturating_sub(1);
        Some(end + 1)
    }

    fn end_of_run(&mut self, a: i32, b: i32, steps: u32) -> Option<i32> {
        let alike = (a - b).abs() <= self.near;
        let context = self.contexts.get_mut(CONTEXTS + usize::from(alike))?;
        let expected = match alike {
            true => context.sizes.saturating_add(context.count / 2),
            false => context.sizes,
        };
        let k = parameter(context.count, expected)?;
        let limit = self.limit.checked_sub(steps + 1)?;
        let coded = self.bits.limited(k, limit, self.bits_of_error)?;
        let mapped = coded + i32::from(alike);
        let odd = mapped & 1 == 1;
        let size = (mapped + 1) >> 1;
        let negative = (k != 0 || 2 * context.negative >= context.count) == odd;
        let error = if negative { -size } else { size };
        if error < 0 {
            context.negative += 1;
        }
        let size = (coded + 1 - i32::from(alike)) >> 1;
        context.sizes = context.sizes.saturating_add(size);
        if context.count >= self.presets.reset {
            context.sizes >>= 1;
            context.count >>= 1;
            context.negative >>= 1;
        }
        context.count += 1;
        Some(match alike {
            true => self.reconstructed(a, error),
            false => self.reconstructed(b, if a > b { -error } else { error }),
        })
    }

    /// The sample of a prediction and its error, which counts modulo the range (A.4.4 and A.4.5).
    fn reconstructed(&self, predicted: i32, error: i32) -> i32 {
        let width = 2 * self.near + 1;
        let greatest = self.presets.greatest;
        let sample = predicted + error * width;
        let sample = if sample < -self.near {
            sample + self.range * width
        } else if sample > greatest + self.near {
            sample - self.range * width
        } else {
            sample
        };
        sample.clamp(0, greatest)
    }
}

/// The parameter of the code: the least k with N · 2ᵏ ≥ A (A.5.1).
fn parameter(count: i32, sizes: i32) -> Option<u32> {
    (0..24).find(|k| i64::from(count) << k >= i64::from(sizes))
}

impl Context {
    /// Takes an error into account (A.6).
    fn learn(&mut self, error: i32, near: i32, reset: i32) {
        self.bias = self.bias.saturating_add(error * (2 * near + 1));
        self.sizes = self.sizes.saturating_add(error.abs());
        if self.count >= reset {
            self.sizes >>= 1;
            // A shift halves negative numbers as the standard does, away from zero.
            self.bias >>= 1;
            self.count >>= 1;
        }
        self.count += 1;
        if self.bias <= -self.count {
            self.bias = (self.bias + self.count).max(1 - self.count);
            self.correction = (self.correction - 1).max(-128);
        } else if self.bias > 0 {
            self.bias = (self.bias - self.count).min(0);
            self.correction = (self.correction + 1).min(127);
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    const HEAD: &[u8] =
        b"\xff\xd8\xff\xf7\0\x0b\x08\0\x04\0\x04\x01\x01\x11\0\xff\xda\0\x08\x01\x01\0\0\0\0";

    /// The example of T.87, H.3.
    #[test]
    fn the_example_of_the_standard_is_unpacked() {
        let mut bytes = HEAD.to_vec();
        bytes.extend([
            0xc0, 0x00, 0x00, 0x6c, 0x80, 0x20, 0x8e, 0x01, 0xc0, 0x00, 0x00, 0x57, 0x40, 0x00,
            0x00, 0x6e, 0xe6, 0x00, 0x00, 0x01, 0xbc, 0x18, 0x00, 0x00, 0x05, 0xd8, 0x00, 0x00,
            0x91, 0x60, 0xff, 0xd9,
        ]);
        let head = JpegLsHead::new(&bytes).unwrap();
        assert_eq!((head.size, head.components, head.near), ([4, 4], 1, 0));
        let samples = samples(&bytes, &head).unwrap();
        let expected = [
            0, 0, 90, 74, 68, 50, 43, 205, 64, 145, 145, 145, 100, 145, 145, 145,
        ];
        assert_eq!(samples, expected);
    }

    #[test]
    fn streams_that_end_too_early_or_are_noise_are_refused() {
        for tail in [&[0xc0][..], &[0; 40], &[0x55; 6], &[0xff, 0xd9]] {
            let bytes = [HEAD, tail].concat();
            let head = JpegLsHead::new(&bytes).unwrap();
            assert_eq!(samples(&bytes, &head), None);
        }
        assert!(JpegLsHead::new(&HEAD[..20]).is_none());
    }
}
