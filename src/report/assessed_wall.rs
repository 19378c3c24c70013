//! What the tables of one subject's wall are made of: atoms, patches, segments.
//!
//! Rows are made of one subject after the other, so that a cohort never is in memory as a whole.

use crate::analysis::medial::MedialBeat;
use crate::analysis::segments::{LongAxis, Segment};
use crate::analysis::thickening::Thickening;
use crate::units::LengthUnit;

/// One subject whose wall is assessed.
#[derive(Clone, Copy, Debug)]
pub struct AssessedWall<'a> {
    /// Its pseudonym.
    pub subject: &'a str,
    /// What one unit of its coordinates is.
    pub unit: LengthUnit,
    /// Its atoms over the beat.
    pub beat: &'a MedialBeat,
    /// How they thicken.
    pub thickening: &'a Thickening,
    /// Its long axis at end-diastole, where it is known.
    pub axis: Option<&'a LongAxis>,
    /// Per atom, its segment at end-diastole.
    pub segments: &'a [Option<Segment>],
}
