//! Where the poses of a matrix come from: the subjects themselves, or one subject that moves like them.

use std::borrow::Cow;

use crate::analysis::alignment::Comparable;
use crate::analysis::transport::TransportedCohort;
use crate::mesh::Point3;

use super::PoseId;

/// A pose before anything is computed of it.
pub(super) struct Source<'a> {
    pub(super) pose: PoseId,
    points: Points<'a>,
}

enum Points<'a> {
    /// As measured; the size is yet to be normalised.
    Own(Comparable<'a>),
    /// After transport.
    Transported(&'a [Point3]),
}

impl Source<'_> {
    /// All vertices, the size normalised.
    pub(super) fn normalised(&self) -> Cow<'_, [Point3]> {
        match &self.points {
            Points::Own(member) => {
                let points = member.subject.sequence.pose(self.pose.frame);
                (points.unwrap_or_default().iter())
                    .map(|point| member.scale.normalised(point))
                    .collect()
            }
            // Transport has normalised them already.
            Points::Transported(points) => Cow::Borrowed(points),
        }
    }
}

/// All poses of some subjects: by subject, then by frame.
pub(super) fn poses_of(members: &[Comparable<'_>]) -> Vec<PoseId> {
    own_sources(members)
        .iter()
        .map(|source| source.pose)
        .collect()
}

/// The poses of the subjects themselves.
pub(super) fn own_sources<'a>(members: &[Comparable<'a>]) -> Vec<Source<'a>> {
    let of_member = |member: &Comparable<'a>| {
        let member = *member;
        (0..member.subject.sequence.frame_count()).map(move |frame| Source {
            pose: PoseId {
                subject: member.index,
                frame,
            },
            points: Points::Own(member),
        })
    };
    members.iter().flat_map(of_member).collect()
}

/// The poses of the one subject that moves like them.
pub(super) fn transported_sources(cohort: &TransportedCohort) -> Vec<Source<'_>> {
    (cohort.members.iter())
        .flat_map(|member| {
            (member.poses.iter().enumerate()).map(|(frame, points)| Source {
                pose: PoseId {
                    subject: member.subject,
                    frame,
                },
                points: Points::Transported(points),
            })
        })
        .collect()
}
