//! How large an input may be before it is refused with a clear error.

/// Explicit bounds, so that a damaged or hostile header never decides how much memory is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Bytes of one file.
    pub file_bytes: u64,
    /// Vertices of one surface.
    pub vertices: usize,
    /// Faces of one surface.
    pub faces: usize,
    /// Frames of one sequence.
    pub frames: usize,
    /// Vertices of one surface over all frames that one file holds (glTF morph targets).
    pub vertices_of_all_frames: usize,
}

impl Default for Limits {
    /// 512 MiB a file, 5 million vertices, 10 million faces, 1,000 frames, 40 million vertices over
    /// all frames of one file: ten times the finest hearts that are published, and well inside
    /// the memory of a small machine.
    fn default() -> Self {
        Self {
            file_bytes: 512 << 20,
            vertices: 5_000_000,
            faces: 10_000_000,
            frames: 1_000,
            vertices_of_all_frames: 40_000_000,
        }
    }
}
