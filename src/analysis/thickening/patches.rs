//! Properties of a patch: area, segments, centroid, outline, and its path over the beat.

use crate::analysis::medial::MedialBeat;
use crate::analysis::medial_space::RatioForm;
use crate::analysis::segments::{LongAxis, Segment, segment};
use crate::mesh::{Faces, Point3, Vector3};
use crate::units::LengthUnit;

use super::diffusion::RegularMesh;
use super::result::{Patch, PatchSegment, ThickeningStep};
use super::steps::{descriptor_of, gap_of};
use super::temporal_consistency::temporal_consistency;

/// What patches are computed from.
pub(super) struct Wall<'a> {
    pub beat: &'a MedialBeat,
    /// With areas at end-diastole.
    pub mesh: &'a RegularMesh,
    pub end_diastole: usize,
    pub size: f64,
    pub unit: LengthUnit,
    pub steps: &'a [ThickeningStep],
    pub thickening: &'a [f64],
    /// Of every atom; empty without an axis.
    pub segments: Vec<Option<Segment>>,
    pub ratio: RatioForm,
}

/// Segments of the atoms at end-diastole; empty where the axis is not known.
pub(super) fn segments_of(
    beat: &MedialBeat,
    end_diastole: usize,
    axis: Option<&LongAxis>,
) -> Vec<Option<Segment>> {
    let Some(axis) = axis else { return Vec::new() };
    (beat.frames[end_diastole].atoms.iter())
        .map(|atom| segment(axis, atom.position))
        .collect()
}

impl Wall<'_> {
    /// The patch of these atoms.
    pub fn patch(&self, atoms: Vec<u32>, stability: f64) -> Patch {
        let area = self.area(&atoms);
        let weighted = |value: &dyn Fn(usize) -> f64| -> f64 {
            (atoms.iter().map(|&atom| atom as usize))
                .map(|atom| self.mesh.areas[atom] * value(atom))
                .sum()
        };
        let surface = &self.beat.frames[self.end_diastole];
        let centroid =
            [0, 1, 2].map(|axis| weighted(&|atom| surface.atoms[atom].position[axis]) / area);
        let path: Vec<_> = (self.steps.iter())
            .map(|step| descriptor_of(&self.beat.frames[step.from], &step.pt, &atoms, self.ratio))
            .collect();
        let gaps: Vec<_> = (self.steps.iter().zip(&path))
            .map(|(step, pose)| gap_of(self.beat, step.from, pose.as_ref()))
            .collect();
        Patch {
            area,
            area_cm2: self.in_cm2(area),
            share: area / self.mesh.whole,
            segments: self.segment_shares(&atoms, area),
            centroid: Point3::from(Vector3::from(centroid)),
            border: self.border(&atoms),
            thickening: weighted(&|atom| self.thickening[atom]) / area,
            stability,
            temporal_consistency: temporal_consistency(&path, &gaps, self.size),
            path,
            atoms,
        }
    }

    /// An area in cm², where the unit of coordinates is known.
    pub fn in_cm2(&self, area: f64) -> Option<f64> {
        (self.unit == LengthUnit::Millimetre).then(|| area * self.unit.area_from_square())
    }

    fn area(&self, atoms: &[u32]) -> f64 {
        atoms
            .iter()
            .map(|&atom| self.mesh.areas[atom as usize])
            .sum()
    }

    fn segment_shares(&self, atoms: &[u32], patch_area: f64) -> Vec<PatchSegment> {
        let mut areas = [[0.0; 2]; 17];
        for (place, area) in self.segments.iter().zip(&self.mesh.areas) {
            if let Some(segment) = place {
                areas[segment.index()][0] += area;
            }
        }
        for &atom in atoms {
            // Without an axis the list is empty, and the patch has no segments.
            if let Some(Some(segment)) = self.segments.get(atom as usize) {
                areas[segment.index()][1] += self.mesh.areas[atom as usize];
            }
        }
        let mut shares: Vec<PatchSegment> = Segment::all()
            .map(|segment| (segment, areas[segment.index()]))
            // Segments without a part of the patch would divide by zero, and say nothing.
            .filter(|(_, [_, within])| *within > 0.0)
            .map(|(segment, [whole, within])| PatchSegment {
                segment,
                of_segment: within / whole,
                of_patch: within / patch_area,
            })
            .collect();
        // The segment that holds most of the patch is the one that names it.
        shares.sort_by(|a, b| b.of_patch.total_cmp(&a.of_patch));
        shares
    }

    /// Closed chains of atoms around the faces that lie in the patch with all three corners.
    fn border(&self, atoms: &[u32]) -> Vec<Vec<u32>> {
        let mut inside = vec![false; self.mesh.areas.len()];
        atoms.iter().for_each(|&atom| inside[atom as usize] = true);
        let triangles: Vec<[u32; 3]> = (self.mesh.triangles.iter().copied())
            // The outline runs along atoms of the patch, not half-way to its neighbours.
            .filter(|triangle| triangle.iter().all(|&atom| inside[atom as usize]))
            .collect();
        // Faces of a mesh are faces, so that this never fails.
        Faces::new(inside.len(), triangles)
            .map_or_else(|_| Vec::new(), |faces| faces.boundary_loops())
    }
}
