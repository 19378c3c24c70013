//! The paths of one subject: one per patch, or that of all that is akinetic.

use crate::analysis::medial::{MedialBeat, MedialSurface};
use crate::analysis::segments::LongAxis;
use crate::analysis::thickening::Thickening;

use super::placement::{Frame, Placement};
use super::result::{AkineticPart, AkineticPath, NotMapped, PathStep, SubjectPaths};

/// Paths of the poses of one subject: one for each patch, from all of its atoms at every step (4.6.2); where there is
/// no patch, that of M̂, as the method has it (4.5). M̂ is another set in every step: all of the wall where even remote
/// myocardium hardly changes, as in diastasis, and little or nothing in contraction. So its path goes far, unless
/// all of the wall is akinetic in every step, as in a subject that hardly thickens at all.
///
/// # Errors
/// If nothing is akinetic in any step, or the subject has no extent.
pub fn subject_paths(
    beat: &MedialBeat,
    found: &Thickening,
    axis: Option<&LongAxis>,
) -> Result<SubjectPaths, NotMapped> {
    // Patches are what the map is about; without any, all that is akinetic is one path.
    let paths: Vec<AkineticPath> = if found.patches.is_empty() {
        let steps = found.steps.iter().filter_map(|step| {
            Some(PathStep {
                from: step.from,
                to: step.to,
                descriptor: step.descriptor?,
            })
        });
        vec![AkineticPath {
            part: AkineticPart::Whole,
            steps: steps.collect(),
        }]
    } else {
        let patches = found.patches.iter().enumerate();
        let path_of = |(index, patch): (usize, &crate::analysis::thickening::Patch)| {
            let steps = found.steps.iter().zip(&patch.path);
            let steps = steps.filter_map(|(step, descriptor)| {
                Some(PathStep {
                    from: step.from,
                    to: step.to,
                    descriptor: (*descriptor)?,
                })
            });
            AkineticPath {
                part: AkineticPart::Patch(index),
                steps: steps.collect(),
            }
        };
        patches.map(path_of).collect()
    };
    if paths.iter().all(|path| path.steps.is_empty()) {
        return Err(NotMapped::NothingAkinetic {
            steps: found.steps.len(),
        });
    }
    let centres = (beat.frames.get(found.end_diastole))
        .map(MedialSurface::positions)
        .unwrap_or_default();
    // In all frames: which one all subjects share is known only when all are there.
    let placements = Frame::ALL.map(|frame| Placement::new(frame, axis, &centres));
    if placements.iter().all(Option::is_none) {
        return Err(NotMapped::NoSize);
    }
    Ok(SubjectPaths { paths, placements })
}
