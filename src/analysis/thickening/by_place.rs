//! Thickness and thickening of each segment or level of the ventricle.

use crate::analysis::medial::MedialBeat;
use crate::analysis::segments::{
    GroupThickening, Level, Segment, level_means, level_thickening, segment_means,
    segment_thickening,
};

use super::diffusion::RegularMesh;
use super::result::Thickening;

/// What the wall of one segment or level does, by the atoms that take part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaceThickening {
    /// Mean thickness 2 r, in coordinates.
    pub thickness: GroupThickening,
    /// Geometric mean of PT from end-diastole to end-systole, r(ES) / r(ED).
    pub pt: f64,
    /// Which share of its area lies in patches, 0..=1.
    pub patch_share: f64,
}

/// What each segment does; `segments` says per atom where it lies. `None` for a segment without atoms
/// that take part.
///
/// Means are weighted by areas of the medial surface at end-diastole.
pub fn thickening_of_segments(
    beat: &MedialBeat,
    found: &Thickening,
    segments: &[Option<Segment>],
) -> [Option<PlaceThickening>; Segment::COUNT] {
    let values = AtomValues::new(beat, found);
    let [ed, es] = &values.thickness;
    together(
        segment_thickening(segments, &values.areas, ed, es),
        segment_means(segments, &values.areas, &values.log_pt),
        segment_means(segments, &values.areas, &values.in_patch),
    )
}

/// [`thickening_of_segments`] of levels, for subjects whose orientation is not known.
pub fn thickening_of_levels(
    beat: &MedialBeat,
    found: &Thickening,
    levels: &[Option<Level>],
) -> [Option<PlaceThickening>; Level::ALL.len()] {
    let values = AtomValues::new(beat, found);
    let [ed, es] = &values.thickness;
    together(
        level_thickening(levels, &values.areas, ed, es),
        level_means(levels, &values.areas, &values.log_pt),
        level_means(levels, &values.areas, &values.in_patch),
    )
}

/// Per atom; one that does not take part has no area.
struct AtomValues {
    areas: Vec<f64>,
    thickness: [Vec<Option<f64>>; 2],
    log_pt: Vec<f64>,
    in_patch: Vec<f64>,
}

impl AtomValues {
    fn new(beat: &MedialBeat, found: &Thickening) -> Self {
        let centres = beat.frames[found.end_diastole].positions();
        let mesh = RegularMesh::new(beat.faces.triangles(), &centres, &beat.regular);
        let thickness = |pose: usize| {
            let atoms = &beat.frames[pose].atoms;
            atoms.iter().map(|atom| Some(2.0 * atom.radius)).collect()
        };
        let mut in_patch = vec![0.0; centres.len()];
        for &atom in found.patches.iter().flat_map(|patch| &patch.atoms) {
            in_patch[atom as usize] = 1.0;
        }
        Self {
            areas: mesh.areas,
            thickness: [thickness(found.end_diastole), thickness(found.end_systole)],
            // Means of logarithms: halving and doubling cancel.
            log_pt: found.ed_to_es.iter().map(|pt| pt.ln()).collect(),
            in_patch,
        }
    }
}

fn together<const N: usize>(
    thickness: [Option<GroupThickening>; N],
    log_pt: [Option<f64>; N],
    in_patch: [Option<f64>; N],
) -> [Option<PlaceThickening>; N] {
    std::array::from_fn(|place| {
        Some(PlaceThickening {
            thickness: thickness[place]?,
            pt: log_pt[place]?.exp(),
            patch_share: in_patch[place]?,
        })
    })
}
