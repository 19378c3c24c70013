//! What is odd about a sequence: one file per invariant, each finding a sentence for the load report.
//!
//! A check looks and tells; it never changes a mesh. What holds for the connectivity is asked once,
//! as all frames share it; what depends on positions is asked at every frame and told in one
//! sentence for all frames that have it.

mod aligned_cohort;
mod boundary;
mod centred_frames;
mod components;
mod copies;
mod degenerate_faces;
mod duplicate_vertices;
mod enclosed_volume;
mod face_listing;
mod frame_counts;
mod inside;
mod landmarks;
mod manifold;
mod misplacement;
mod nesting;
mod orientation;
mod outward;
mod repeated_frames;
mod shared_rim;
mod stated_phases;
mod sudden_jumps;
mod unused_vertices;
mod volume_curve;
mod wall_doubt;
mod wall_extent;
mod wall_order;
mod words;

pub use aligned_cohort::AlignedCohort;
pub use boundary::Boundary;
pub use centred_frames::CentredFrames;
pub use components::Components;
pub use copies::Copies;
pub use degenerate_faces::DegenerateFaces;
pub use duplicate_vertices::DuplicateVertices;
pub use enclosed_volume::enclosed_volume;
pub use face_listing::FaceListing;
pub use landmarks::LandmarkDoubt;
pub use manifold::NonManifold;
pub use misplacement::Misplacement;
pub use orientation::InconsistentWinding;
pub use outward::InsideOut;
pub use repeated_frames::RepeatedFrames;
pub use shared_rim::SharedRim;
pub use stated_phases::{StatedPhases, both_phases_at};
pub use sudden_jumps::SuddenJumps;
pub use unused_vertices::UnusedVertices;
pub use volume_curve::VolumeCurve;
pub use wall_doubt::WallDoubt;
pub use wall_extent::WallExtent;
pub use wall_order::WallOrder;
pub use words::{all_of, counted, frames_phrase};

use super::{MeshSequence, Notice, Severity, Subject, SurfaceSequence};

/// Looks at one surface over the beat.
type SurfaceCheck = fn(&SurfaceSequence) -> Option<Notice>;
/// Looks at all surfaces of one subject.
type SequenceCheck = fn(&MeshSequence) -> Option<Notice>;

const SURFACE_CHECKS: &[SurfaceCheck] = &[
    |surface| Some(Boundary::of(surface).notice(surface)),
    |surface| NonManifold::of(surface).notice(surface),
    |surface| InconsistentWinding::of(surface).notice(surface),
    |surface| InsideOut::of(surface).notice(surface),
    |surface| Components::of(surface).notice(surface),
    |surface| DegenerateFaces::of(surface).notice(surface),
    |surface| DuplicateVertices::of(surface).notice(surface),
    |surface| UnusedVertices::of(surface).notice(surface),
    |surface| RepeatedFrames::of(surface).notice(surface),
    |surface| SuddenJumps::of(surface).notice(surface),
];

const SEQUENCE_CHECKS: &[SequenceCheck] = &[
    |sequence| WallOrder::of(sequence).notice(sequence),
    |sequence| SharedRim::of(sequence).notice(),
    |sequence| CentredFrames::of(sequence).notice(),
];

/// How often [`check_subject`] asks whether to go on, for a subject of so many surfaces.
pub fn check_count(surfaces: usize) -> usize {
    surfaces * SURFACE_CHECKS.len() + SEQUENCE_CHECKS.len() + 2
}

/// Everything that is odd about a subject, warnings first.
///
/// `keep_going` is asked between checks; its error ends the run and is passed on.
///
/// # Errors
/// Only what `keep_going` returns.
pub fn check_subject<E>(
    subject: &Subject,
    keep_going: impl Fn() -> Result<(), E>,
) -> Result<Vec<Notice>, E> {
    let mut notices = Vec::new();
    for surface in subject.sequence.surfaces() {
        for check in SURFACE_CHECKS {
            keep_going()?;
            notices.extend(check(surface));
        }
    }
    for check in SEQUENCE_CHECKS {
        keep_going()?;
        notices.extend(check(&subject.sequence));
    }
    notices.extend(StatedPhases::of(subject).notices(subject));
    keep_going()?;
    notices.extend(VolumeCurve::of(subject).notices());
    keep_going()?;
    let doubt = WallDoubt::of(&subject.sequence, subject.unit);
    notices.extend(doubt.map(|doubt| doubt.notice()));
    sort_warnings_first(&mut notices);
    Ok(notices)
}

/// Puts warnings before notes and keeps the order within each.
pub fn sort_warnings_first(notices: &mut [Notice]) {
    notices.sort_by_key(|notice| match notice.severity {
        Severity::Warning => 0,
        Severity::Info => 1,
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::SurfaceKind;
    use crate::units::LengthUnit;

    fn heart(kind: SurfaceKind, frames: Vec<crate::mesh::TriMesh>) -> Subject {
        let surface = SurfaceSequence::new(kind, frames).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        Subject::new("p", sequence, LengthUnit::Millimetre)
    }

    #[test]
    fn a_sound_cavity_brings_one_remark_and_no_warning() {
        let cavity = |radius| phantom::bowl(radius, 8, 16);
        let subject = heart(SurfaceKind::Endocardium, vec![cavity(30.0), cavity(25.0)]);
        let notices = check_subject(&subject, || Ok::<(), ()>(())).unwrap();
        assert_eq!(
            notices,
            [Notice::info(
                "endocardium: open at the base, one boundary loop of 16 vertices"
            )]
        );
    }

    #[test]
    fn a_check_that_is_told_to_stop_stops() {
        let subject = heart(SurfaceKind::Cavity, vec![phantom::sphere(1, 30.0)]);
        assert_eq!(check_subject(&subject, || Err("stop")), Err("stop"));
    }
}
