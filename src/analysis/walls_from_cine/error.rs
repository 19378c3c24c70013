//! Why a cine image gives no contours.

use crate::progress::Stopped;

/// Why the contours of an image are not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CineError {
    /// A point that is needed is not marked.
    #[error(
        "{0} is not marked; needed are a point of the blood, the apex and the base of the left ventricle"
    )]
    Missing(&'static str),
    /// A point with coordinates that are not numbers.
    #[error("the coordinates of {0} are not numbers")]
    NotFinite(&'static str),
    /// A point far from any voxel.
    #[error("{0} lies outside of the image")]
    Outside(&'static str),
    /// Apex and base are no ventricle apart.
    #[error("apex and base are {length_mm:.0} mm apart; {} to {} mm are possible", range_mm[0], range_mm[1])]
    Length {
        /// Their distance.
        length_mm: f64,
        /// What is possible.
        range_mm: [f64; 2],
    },
    /// The long axis runs within the slices rather than across.
    #[error(
        "the line from apex to base makes {angle_deg:.0}° with the direction across the slices; at most {max_deg:.0}° are \
         possible: these are no short-axis slices, or the points are wrong"
    )]
    NotShortAxis {
        /// The angle found.
        angle_deg: f64,
        /// The greatest one.
        max_deg: f64,
    },
    /// No slice between the points.
    #[error("no slice lies between apex and base")]
    NoSlice,
    /// Too many slices and instants.
    #[error("{count} slices in all instants; {most} are possible")]
    TooMany {
        /// How many there are.
        count: usize,
        /// How many there may be.
        most: usize,
    },
    /// What was marked as blood is dark.
    #[error(
        "the marked blood has the value {value:.0}, but {usual:.0} is bright around it: blood is bright in cine MR, so the \
         point is not in the blood"
    )]
    Dark {
        /// Value around the point.
        value: f64,
        /// What is bright nearby.
        usual: f64,
    },
    /// Nothing ends the blood.
    #[error(
        "no clear edge is found around the marked blood: its height is {found_percent:.0} % of the difference between blood and muscle, and {min_percent:.0} % are needed"
    )]
    NoEdge {
        /// Mean height of the edge, as a share of the difference between blood and muscle.
        found_percent: f64,
        /// The least share.
        min_percent: f64,
    },
    /// An outline set by hand that has no place.
    #[error("outline {number} that was set by hand (instant {instant}): {reason}")]
    Edit {
        /// Its number among the outlines, from 0.
        number: usize,
        /// Its instant.
        instant: usize,
        /// What is wrong with it.
        reason: &'static str,
    },
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}
