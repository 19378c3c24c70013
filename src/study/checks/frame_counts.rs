//! How many of something each frame has: the frames that have any, and the largest count.

/// Frames with faults of one kind.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct FrameCounts {
    /// Frames that have any.
    pub frames: Vec<usize>,
    /// The largest count among them.
    pub most: usize,
}

impl FrameCounts {
    /// From the count of every frame.
    pub fn of(counts: impl IntoIterator<Item = usize>) -> Self {
        let mut found = Self::default();
        for (frame, count) in counts.into_iter().enumerate() {
            if count > 0 {
                found.frames.push(frame);
                found.most = found.most.max(count);
            }
        }
        found
    }
}
