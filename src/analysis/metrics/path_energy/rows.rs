//! Numbers of vertices, edges or faces at every pose of a path.

use crate::numeric::{LANES, Lanes};

/// For each item its values at poses 0, 1, 2 …: a block of steps reads those where it begins and,
/// one place later, those where it ends.
#[derive(Clone, Debug)]
pub(in crate::analysis::metrics) struct Rows {
    values: Vec<f64>,
    stride: usize,
}

impl Rows {
    pub fn new(items: usize, blocks: usize) -> Self {
        // One more than lanes: a step begins at the pose that the step before it ends with.
        let stride = LANES * blocks + 1;
        Self {
            values: vec![0.0; items * stride],
            stride,
        }
    }

    /// Values where the steps of a block begin and where they end.
    #[inline(always)]
    pub fn both(&self, item: usize, block: usize) -> [Lanes; 2] {
        let at = item * self.stride + LANES * block;
        let row = &self.values[at..at + LANES + 1];
        [
            Lanes([row[0], row[1], row[2], row[3]]),
            Lanes([row[1], row[2], row[3], row[4]]),
        ]
    }

    /// Values at the poses of a block, those where its steps end.
    #[inline(always)]
    pub fn ends(&self, item: usize, block: usize) -> Lanes {
        self.both(item, block)[1]
    }

    /// Stores values of the poses of a block; returns them with those where its steps begin.
    #[inline(always)]
    pub fn set(&mut self, item: usize, block: usize, ends: Lanes) -> [Lanes; 2] {
        let at = item * self.stride + LANES * block;
        let row = &mut self.values[at..at + LANES + 1];
        row[1..].copy_from_slice(&ends.0);
        [ends.later(row[0]), ends]
    }

    /// The value of an item at a pose.
    pub fn at(&self, item: usize, pose: usize) -> f64 {
        self.values[item * self.stride + pose]
    }

    /// Stores the value of an item at a pose.
    pub fn put(&mut self, item: usize, pose: usize, value: f64) {
        self.values[item * self.stride + pose] = value;
    }

    /// Lets pose 0 be as pose 1.
    pub fn keep_as_start(&mut self) {
        for row in self.values.chunks_exact_mut(self.stride) {
            row[0] = row[1];
        }
    }
}

/// A step adds to the gradient of the pose where it begins and of the one where it ends: the sum of both at the poses of
/// its block. `carry` brings the first pose of the block behind, which must be done before.
#[inline(always)]
pub(super) fn onto_poses(both: [Lanes; 2], carry: &mut f64) -> Lanes {
    let [begins, ends] = both;
    // A pose has the derivatives of the step that ends there and of the one that begins there.
    let onto = ends + begins.earlier(*carry);
    *carry = begins.0[0];
    onto
}
