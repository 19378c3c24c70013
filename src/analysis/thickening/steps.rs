//! From one pose to the next: PT of every atom, the atoms that are akinetic, and their descriptor.

use crate::analysis::medial::{MedialBeat, MedialSurface};
use crate::analysis::medial_space::{
    AkineticAtom, PoseDescriptor, RatioForm, pose_descriptor, spoke_angle_rad,
};
use crate::mesh::Point3;
use crate::progress::{Progress, Stopped};

use super::diffusion::RegularMesh;
use super::result::{HalfBeat, ThickeningStep};
use super::temporal_consistency::gap;

/// PT = r(t₂) / r(t₁) of every atom, see [`Atom::thickness_ratio`](crate::analysis::medial::Atom::thickness_ratio); only
/// those of atoms that take part mean anything.
pub fn thickness_ratios(earlier: &MedialSurface, later: &MedialSurface) -> Vec<f64> {
    (earlier.atoms.iter().zip(&later.atoms))
        .map(|(earlier, later)| later.thickness_ratio(earlier))
        .collect()
}

/// Half of the beat of the step from a pose to the next: contraction from end-diastole to end-systole,
/// the beat taken as a circle.
pub fn half_beat_of(
    from: usize,
    end_diastole: usize,
    end_systole: usize,
    poses: usize,
) -> HalfBeat {
    // Counted from end-diastole around the cycle, wherever in the sequence that stands.
    let after_filling = |pose: usize| (pose + poses - end_diastole) % poses;
    if after_filling(from) < after_filling(end_systole) {
        HalfBeat::Contraction
    } else {
        HalfBeat::Expansion
    }
}

/// Criteria by which the atoms of a step are classified.
pub(super) struct StepCriteria<'a> {
    /// ln r of remote myocardium over the beat.
    pub remote_curve: &'a [f64],
    /// Of |ln PT|.
    pub tolerance: f64,
    /// What r̂ is made of.
    pub ratio: RatioForm,
}

/// Steps from every pose to the next and from the last to the first.
pub(super) fn steps(
    beat: &MedialBeat,
    mesh: &RegularMesh,
    [ed, es]: [usize; 2],
    criteria: &StepCriteria<'_>,
    progress: &Progress,
) -> Result<Vec<ThickeningStep>, Stopped> {
    let (poses, tolerance) = (beat.frames.len(), criteria.tolerance);
    let remote_at = |pose: usize| criteria.remote_curve[pose];
    (0..poses)
        .map(|from| {
            progress.step()?;
            // The beat is a circle: the last frame leads into the first.
            let to = (from + 1) % poses;
            let pt = thickness_ratios(&beat.frames[from], &beat.frames[to]);
            let half = half_beat_of(from, ed, es, poses);
            let takes_part = |&atom: &usize| mesh.areas[atom] > 0.0;
            let akinetic: Vec<u32> = (0..pt.len())
                .filter(takes_part)
                .filter(|&atom| pt[atom].ln().abs() <= tolerance)
                .map(|atom| atom as u32)
                .collect();
            let remote: f64 = (0..pt.len())
                .filter(takes_part)
                .filter(|&atom| changes_as_remote(half, pt[atom], tolerance))
                .map(|atom| mesh.areas[atom])
                .sum();
            let descriptor = descriptor_of(&beat.frames[from], &pt, &akinetic, criteria.ratio);
            Ok(ThickeningStep {
                from,
                to,
                half,
                // Twice the tolerance: remote myocardium then changes by more than what counts as akinetic.
                telling: (remote_at(to) - remote_at(from)).abs() > 2.0 * tolerance,
                remote_share: remote / mesh.whole,
                gap: gap_of(beat, from, descriptor.as_ref()),
                descriptor,
                pt,
                akinetic,
            })
        })
        .collect()
}

/// Table 4.1: remote myocardium thickens in contraction and thins in expansion.
fn changes_as_remote(half: HalfBeat, pt: f64, tolerance: f64) -> bool {
    match half {
        HalfBeat::Contraction => pt.ln() > tolerance,
        HalfBeat::Expansion => pt.ln() < -tolerance,
    }
}

/// Descriptor of a pose from some of its atoms.
pub(super) fn descriptor_of(
    surface: &MedialSurface,
    pt: &[f64],
    atoms: &[u32],
    form: RatioForm,
) -> Option<PoseDescriptor> {
    let akinetic: Vec<AkineticAtom> = (atoms.iter().map(|&atom| atom as usize))
        .map(|atom| AkineticAtom {
            position: surface.atoms[atom].position,
            log_pt: pt[atom].ln(),
            normal: surface.normals[atom],
            spoke_angle_rad: spoke_angle_rad(&surface.normals[atom], &surface.atoms[atom].spokes),
        })
        .collect();
    pose_descriptor(&akinetic, form)
}

/// From MP to the medial surface of its pose, in coordinates.
pub(super) fn gap_of(
    beat: &MedialBeat,
    pose: usize,
    descriptor: Option<&PoseDescriptor>,
) -> Option<f64> {
    let atoms = &beat.frames[pose].atoms;
    let position = |atom: u32| -> Point3 { atoms[atom as usize].position };
    descriptor.map(|descriptor| gap(&descriptor.position, position, beat.faces.triangles()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::medial::Atom;
    use crate::mesh::Vector3;

    #[test]
    fn contraction_goes_from_end_diastole_to_end_systole_around_the_beat() {
        let phases = |ed, es| -> Vec<bool> {
            (0..6)
                .map(|from| half_beat_of(from, ed, es, 6) == HalfBeat::Contraction)
                .collect()
        };
        assert_eq!(phases(0, 2), [true, true, false, false, false, false]);
        assert_eq!(phases(5, 2), [true, true, false, false, false, true]);
        assert_eq!(phases(3, 1), [true, false, false, true, true, true]);
        let two: Vec<HalfBeat> = (0..2).map(|from| half_beat_of(from, 0, 1, 2)).collect();
        assert_eq!(two, [HalfBeat::Contraction, HalfBeat::Expansion]);
    }

    #[test]
    fn a_missing_sphere_is_no_wall_that_keeps_its_thickness() {
        let surface = |radii: [f64; 3]| MedialSurface {
            atoms: (radii.iter())
                .map(|&radius| Atom {
                    position: Point3::origin(),
                    radius,
                    spokes: [Vector3::x(), -Vector3::x()],
                })
                .collect(),
            normals: vec![Vector3::x(); 3],
            end: vec![None; 3],
        };
        let ratios = thickness_ratios(&surface([4.0, 0.0, 0.0]), &surface([6.0, 5.0, 0.0]));
        assert_eq!(ratios[0], 1.5);
        assert!(ratios[1..].iter().all(|pt| !pt.is_finite()), "{ratios:?}");
    }

    #[test]
    fn a_well_wall_does_what_table_4_1_says() {
        for (pt, contracts, expands) in
            [(1.2, true, false), (0.8, false, true), (1.03, false, false)]
        {
            assert_eq!(
                changes_as_remote(HalfBeat::Contraction, pt, 0.05),
                contracts
            );
            assert_eq!(changes_as_remote(HalfBeat::Expansion, pt, 0.05), expands);
        }
    }
}
