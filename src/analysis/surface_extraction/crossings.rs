//! Which edges of a grid a surface crosses, as bits, and the number of the vertex on each of them.

use rayon::prelude::*;

/// Corners of the grid inside a surface, and the edges that it crosses, on a grid with one more layer outside all around.
///
/// Bits of a row (along i) stand in words of 64. The vertices on edges are numbered in the order of layers, rows,
/// directions and places, whatever the number of threads.
pub(super) struct Crossings {
    size: [usize; 3],
    words: usize,
    inside: Vec<u64>,
    /// Per row: the words of the edges along i, then j, then k, each with its lower end at the bit's place.
    crossed: Vec<u64>,
    /// Vertices before each word of `crossed`.
    before: Vec<u32>,
    vertices: u64,
}

impl Crossings {
    /// Of values on a grid of `size` voxels, i fastest: inside is what `is_inside` says.
    pub fn new(size: [usize; 3], values: &[f32], is_inside: impl Fn(f32) -> bool + Sync) -> Self {
        let padded = size.map(|n| n + 2);
        let [nx, ny, nz] = padded;
        let words = nx.div_ceil(64);
        let mut inside = vec![0_u64; words * ny * nz];
        let layers = inside[words * ny..].par_chunks_mut(words * ny);
        layers
            .zip(values.par_chunks(size[0] * size[1]))
            .for_each(|(layer, values)| {
                let rows = layer[words..].chunks_mut(words);
                for (row, values) in rows.zip(values.chunks(size[0])) {
                    fill(row, values, &is_inside);
                }
            });
        let mut made = Self {
            size: padded,
            words,
            crossed: vec![0; 3 * inside.len()],
            before: Vec::new(),
            inside,
            vertices: 0,
        };
        let mut crossed = std::mem::take(&mut made.crossed);
        (crossed.par_chunks_mut(3 * words * ny).enumerate())
            .for_each(|(k, layer)| made.cross(k, layer));
        made.crossed = crossed;
        made.before = Vec::with_capacity(made.crossed.len());
        for word in &made.crossed {
            // What does not fit is refused by its count before it is used.
            made.before.push(made.vertices as u32);
            made.vertices += u64::from(word.count_ones());
        }
        made
    }

    /// Corners along i, j and k: two more than voxels.
    pub fn size(&self) -> [usize; 3] {
        self.size
    }

    /// How many edges are crossed.
    pub fn vertex_count(&self) -> u64 {
        self.vertices
    }

    /// The crossed edges whose lower end lies in layer k, as axis and lower end, in the order of their vertices.
    pub fn edges(&self, k: usize) -> impl Iterator<Item = (usize, [usize; 3])> {
        let ny = self.size[1];
        let layer = &self.crossed[3 * self.words * ny * k..][..3 * self.words * ny];
        (layer.iter().enumerate()).flat_map(move |(at, &word)| {
            let (j, axis, part) = (at / (3 * self.words), at / self.words % 3, at % self.words);
            bits(word).map(move |bit| (axis, [64 * part + bit, j, k]))
        })
    }

    /// The vertex on the crossed edge along an axis from a corner.
    pub fn vertex(&self, axis: usize, [i, j, k]: [usize; 3]) -> u32 {
        let at = (3 * (j + self.size[1] * k) + axis) * self.words + i / 64;
        let below = self.crossed[at] & ((1 << (i % 64)) - 1);
        self.before[at] + below.count_ones()
    }

    /// The cells of a row that the surface runs through, by their place along i, with the bits of their corners inside.
    pub fn cells(&self, j: usize, k: usize) -> impl Iterator<Item = (usize, u8)> {
        let rows = [(j, k), (j + 1, k), (j, k + 1), (j + 1, k + 1)].map(|(j, k)| self.row(j, k));
        (0..self.words).flat_map(move |at| {
            let [any, all] = [or as fn(u64, u64) -> u64, and].map(|joined| {
                let over = |at: usize| {
                    rows.map(|row| row.get(at).copied().unwrap_or(0))
                        .into_iter()
                        .reduce(joined)
                        .unwrap_or(0)
                };
                joined(over(at), over(at) >> 1 | over(at + 1) << 63)
            });
            bits(any & !all).map(move |bit| {
                let i = 64 * at + bit;
                let mut pattern = 0;
                for (pair, row) in rows.iter().enumerate() {
                    let both = bit_at(row, i) | bit_at(row, i + 1) << 1;
                    pattern |= both << (2 * pair);
                }
                (i, pattern)
            })
        })
    }

    fn row(&self, j: usize, k: usize) -> &[u64] {
        &self.inside[self.words * (j + self.size[1] * k)..][..self.words]
    }

    /// Fills the words of the crossed edges of layer k.
    fn cross(&self, k: usize, layer: &mut [u64]) {
        let [_, ny, nz] = self.size;
        for (j, words) in layer.chunks_mut(3 * self.words).enumerate() {
            let row = self.row(j, k);
            // Beyond the last row and layer there is no edge.
            let beside = if j + 1 < ny { self.row(j + 1, k) } else { row };
            let above = if k + 1 < nz { self.row(j, k + 1) } else { row };
            for (at, &word) in row.iter().enumerate() {
                let following = row.get(at + 1).copied().unwrap_or(0);
                words[at] = word ^ (word >> 1 | following << 63);
                words[self.words + at] = word ^ beside[at];
                words[2 * self.words + at] = word ^ above[at];
            }
        }
    }
}

fn or(a: u64, b: u64) -> u64 {
    a | b
}

fn and(a: u64, b: u64) -> u64 {
    a & b
}

fn bit_at(row: &[u64], i: usize) -> u8 {
    (row.get(i / 64).copied().unwrap_or(0) >> (i % 64) & 1) as u8
}

/// The places of the bits of a word, ascending.
fn bits(mut word: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = (word != 0).then(|| word.trailing_zeros() as usize)?;
        word &= word - 1;
        Some(lowest)
    })
}

/// Sets the bits of a row of values, from the second bit on: the first is padding.
fn fill(row: &mut [u64], values: &[f32], is_inside: &impl Fn(f32) -> bool) {
    // Gathers the lowest bits of eight bytes in the highest byte.
    const GATHER: u64 = 0x0102_0408_1020_4080;
    for (at, values) in values.chunks(64).enumerate() {
        let mut flags = [0_u8; 64];
        for (flag, &value) in flags.iter_mut().zip(values) {
            *flag = u8::from(is_inside(value));
        }
        let mut word = 0;
        for (eight, flags) in flags.as_chunks::<8>().0.iter().enumerate() {
            word |= (u64::from_le_bytes(*flags).wrapping_mul(GATHER) >> 56) << (8 * eight);
        }
        row[at] |= word << 1;
        if let Some(following) = row.get_mut(at + 1) {
            *following |= word >> 63;
        }
    }
}
