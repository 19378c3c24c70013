//! Why places on a subject cannot be determined.

/// Why a subject has no long axis, or a surface no places on it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SegmentError {
    /// The frame is past the last one.
    #[error("there is no frame {frame} in a sequence of {frames} frames")]
    NoFrame {
        /// The frame asked for.
        frame: usize,
        /// How many there are.
        frames: usize,
    },
    /// Nothing is said to be a ventricle.
    #[error("no surface is labelled endocardium, epicardium, cavity or wall")]
    NoHeart,
    /// A closed surface without landmarks: its base cannot be distinguished from its apex.
    #[error(
        "{kind} is closed and no landmarks are set, so that base and apex cannot be distinguished"
    )]
    NoRim {
        /// The word for the surface.
        kind: &'static str,
    },
    /// Nothing lies below the base.
    #[error("apex and base are {length} units apart, which makes no long axis")]
    NoLength {
        /// Their distance in coordinates.
        length: f64,
    },
}
