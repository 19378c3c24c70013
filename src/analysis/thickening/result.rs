//! Which part of the wall does not thicken, as plain values.

use crate::analysis::medial_space::PoseDescriptor;
use crate::analysis::segments::Segment;
use crate::mesh::Point3;

/// Half of the beat that a step belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum HalfBeat {
    /// From end-diastole to end-systole: remote myocardium thickens.
    Contraction,
    /// From end-systole to end-diastole: it thins.
    Expansion,
}

/// From one pose to the next; the last leads back to the first.
#[derive(Clone, Debug, PartialEq)]
pub struct ThickeningStep {
    /// Pose t₁.
    pub from: usize,
    /// Pose t₂.
    pub to: usize,
    /// Half of the beat.
    pub half: HalfBeat,
    /// PT = r(t₂) / r(t₁) of every atom, whether it takes part or not.
    pub pt: Vec<f64>,
    /// M̂: regular atoms with |ln PT| within the tolerance, ascending.
    pub akinetic: Vec<u32>,
    /// Share of the regular area that does what table 4.1 asks of remote myocardium: PT above one in
    /// contraction, below one in expansion, by more than the tolerance.
    pub remote_share: f64,
    /// Whether remote myocardium changes in this step by more than twice the tolerance: where even it
    /// hardly moves, as in diastasis, all of it is akinetic and M̂ tells nothing.
    pub telling: bool,
    /// (x̄, r̂, ρ, N̄) of M̂ at t₁; `None` where nothing is akinetic.
    pub descriptor: Option<PoseDescriptor>,
    /// From x̄ (MP) to the medial surface at t₁, in sizes of the subject.
    pub gap: Option<f64>,
}

/// How steady a path of poses is: small where a patch is, large where M̂ wanders (4.4.1, 4.4.2, 4.7).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TemporalConsistency {
    /// Poses that have a descriptor.
    pub poses: usize,
    /// Root mean square angle of ANV from its mean over the poses, in radians.
    pub normal_spread_rad: Option<f64>,
    /// Root mean square distance of MP from its mean over the poses, in sizes of the subject.
    pub position_spread: Option<f64>,
    /// Mean distance of MP from the medial surface, in sizes of the subject.
    pub gap: Option<f64>,
    /// Mean distance 4.5.1 between poses, positions in sizes of the subject.
    pub pose_distance: Option<f64>,
}

/// Share of one segment of the ventricle that a patch takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchSegment {
    /// The segment.
    pub segment: Segment,
    /// Which share of the segment's regular area lies in the patch.
    pub of_segment: f64,
    /// Which share of the patch's area lies in the segment.
    pub of_patch: f64,
}

/// One connected part of the wall that does not thicken over the beat.
#[derive(Clone, Debug, PartialEq)]
pub struct Patch {
    /// Its atoms, ascending.
    pub atoms: Vec<u32>,
    /// Area on the medial surface at end-diastole, in the square of the coordinates' unit.
    pub area: f64,
    /// Area in cm²; `None` where the unit of coordinates is not known.
    pub area_cm2: Option<f64>,
    /// Share of the regular medial surface, 0..=1.
    pub share: f64,
    /// Segments that it touches, by falling share of the patch; empty where the orientation is not known.
    pub segments: Vec<PatchSegment>,
    /// Area-weighted mean position of its atoms at end-diastole.
    pub centroid: Point3,
    /// Closed chains of atoms around its faces, in the order of their lowest atom.
    pub border: Vec<Vec<u32>>,
    /// Mean thickening, ln PT from end-diastole to end-systole from all poses.
    pub thickening: f64,
    /// Share of redraws of the noise in which it is detected again.
    pub stability: f64,
    /// Its descriptor at every step, from all of its atoms.
    pub path: Vec<Option<PoseDescriptor>>,
    /// How steady that path is.
    pub temporal_consistency: TemporalConsistency,
}

/// What the whole wall does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WallThickening {
    /// All of it thickens.
    Everywhere,
    /// All but the patches.
    AllButPatches,
    /// Hardly any of it: nothing stands out as a patch.
    HardlyAnywhere,
}

/// The smallest patch that is detected in 39 of 40 subjects like this one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmallestPatch {
    /// Share of the regular medial surface, 0..=1.
    pub share: f64,
    /// Area on the medial surface at end-diastole, in the square of the coordinates' unit.
    pub area: f64,
    /// Area in cm²; `None` where the unit of coordinates is not known.
    pub area_cm2: Option<f64>,
}

/// Thickening of one subject over the beat.
#[derive(Clone, Debug, PartialEq)]
pub struct Thickening {
    /// Pose of end-diastole, by volume, or by area of the medial surface where volume is not known.
    pub end_diastole: usize,
    /// Pose of end-systole.
    pub end_systole: usize,
    /// Tolerance of |ln PT| by which M̂ was determined.
    pub tolerance: f64,
    /// Standard deviation of the noise of ln r of one atom at one pose, estimated from its neighbours.
    pub noise: f64,
    /// From every pose to the next.
    pub steps: Vec<ThickeningStep>,
    /// How steady the path of M̂ is over the steps that tell.
    pub temporal_consistency: TemporalConsistency,
    /// PT from end-diastole to end-systole, r(ES) / r(ED), of every atom.
    pub ed_to_es: Vec<f64>,
    /// Thickening of every atom, ln PT from end-diastole to end-systole from all poses, averaged over its
    /// neighbourhood; 0 where an atom does not take part.
    pub averaged: Vec<f64>,
    /// Atoms near the edge at which the wall was cut open: what does not thicken there alone is no patch.
    pub at_edge: Vec<bool>,
    /// Thickening of remote myocardium.
    pub remote: f64,
    /// ln r of remote myocardium over the beat, less that at end-diastole, as the subject's own curve has it.
    pub remote_curve: Vec<f64>,
    /// Least area that made a patch, as a share of the regular medial surface: twice the setting where fewer than
    /// four poses tell.
    pub min_share: f64,
    /// Area over which thickening was averaged, as a share of the regular medial surface.
    pub averaged_share: f64,
    /// Standard deviation of the noise of averaged thickening.
    pub averaged_noise: f64,
    /// Area of the regular medial surface at end-diastole, in the square of the coordinates' unit.
    pub regular_area: f64,
    /// Largest side of the box of the medial surface at end-diastole: the subject's size.
    pub size: f64,
    /// The smallest round patch without any thickening that is detected in 39 of 40 subjects like this one, given
    /// the noise of its thickening, the area that it is averaged over and its atoms; smaller ones may be there unseen. `None` where noise hides
    /// even a patch of three fifths, or hardly anything thickens.
    pub smallest: Option<SmallestPatch>,
    /// What the whole wall does.
    pub wall_thickening: WallThickening,
    /// By falling area.
    pub patches: Vec<Patch>,
}
