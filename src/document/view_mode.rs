//! How many subjects the 3D view shows at once.

/// What the 3D view shows at once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ViewMode {
    /// One subject.
    #[default]
    Single,
    /// Two subjects with linked cameras and time.
    SideBySide,
    /// All frames of one subject.
    AllFrames,
}
