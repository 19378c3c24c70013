//! One heart's wall on the bull's-eye: laid flat once, with values of any pose.

use serde::{Deserialize, Serialize};

use crate::analysis::segments::{
    Polar, Segment, flat_map, plot_point, polar, segment_means, vertex_areas,
};
use crate::engine::SubjectThickening;
use crate::mesh::Point3;
use crate::picture::medial::rounded;

/// What the bull's-eye shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BullsEyeQuantity {
    /// PT of the pose on screen against end-diastole.
    Ratio,
    /// Thickening from end-diastole to end-systole, as the whole beat tells it.
    #[default]
    Thickening,
}

impl BullsEyeQuantity {
    /// Both, in the order in which one key steps through them.
    pub const ALL: [Self; 2] = [Self::Thickening, Self::Ratio];

    /// The other one.
    pub fn next(self) -> Self {
        match self {
            Self::Ratio => Self::Thickening,
            Self::Thickening => Self::Ratio,
        }
    }
}

/// The medial surface at end-diastole in the unit disc, x to the right (lateral) and y up (anterior).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlatWall {
    /// Where atoms lie.
    pub points: Vec<[f64; 2]>,
    /// Faces over atoms.
    pub faces: Vec<[u32; 3]>,
    /// Closed borders of each patch.
    pub borders: Vec<Vec<Vec<[f64; 2]>>>,
    /// Whether septum and anterior wall are known, and so segments have names.
    pub oriented: bool,
    /// Area of each atom that takes part, 0 of others.
    weights: Vec<f64>,
}

/// Ratios of thickness on the bull's-eye, 1 for unchanged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FlatValues {
    /// Of each atom; not a number where it does not take part.
    pub values: Vec<f32>,
    /// Mean of each segment; `None` where the orientation is not known.
    pub segments: [Option<f64>; Segment::COUNT],
}

impl FlatWall {
    /// Lays the wall of a heart flat; `None` where it has no long axis.
    pub fn of(found: &SubjectThickening) -> Option<Self> {
        let beat = &found.beat;
        let rest = beat.frames.get(found.thickening.end_diastole)?;
        let axis = found.axis?;
        let centres: Vec<Point3> = rest.atoms.iter().map(|atom| atom.position).collect();
        let places: Vec<Polar> = centres.iter().map(|&centre| polar(&axis, centre)).collect();
        let triangles = beat.faces.triangles();
        let map = flat_map(&places, &centres, triangles);
        let mut weights = vertex_areas(&centres, triangles);
        for (weight, &regular) in weights.iter_mut().zip(&beat.regular) {
            if !regular {
                *weight = 0.0;
            }
        }
        let on_plot = |border: &Vec<u32>| {
            let places = border.iter().filter_map(|&atom| places.get(atom as usize));
            let corners: Vec<[f64; 2]> = places.map(|&place| plot_point(place)).collect();
            rounded(&corners)
        };
        let patches = found.thickening.patches.iter();
        Some(Self {
            borders: patches
                .map(|patch| patch.border.iter().map(on_plot).collect())
                .collect(),
            points: map.points,
            faces: map.faces,
            oriented: axis.is_oriented(),
            weights,
        })
    }

    /// What a quantity is at a frame, or over the whole beat.
    pub fn values(
        &self,
        found: &SubjectThickening,
        quantity: BullsEyeQuantity,
        frame: usize,
    ) -> FlatValues {
        let (beat, told) = (&found.beat, &found.thickening);
        let taking_part = |ratios: Vec<f64>| {
            let every = ratios.iter().zip(&beat.regular);
            every
                .map(|(&ratio, &on)| if on { ratio as f32 } else { f32::NAN })
                .collect()
        };
        let means = |numbers: &[f64]| segment_means(&found.segments, &self.weights, numbers);
        match quantity {
            BullsEyeQuantity::Ratio => {
                let radii = |frame: usize| -> Vec<f64> {
                    let atoms = beat.frames.get(frame).map_or(&[][..], |pose| &pose.atoms);
                    atoms.iter().map(|atom| atom.radius).collect()
                };
                let (now, rest) = (radii(frame), radii(told.end_diastole));
                if now.len() != self.weights.len() {
                    return FlatValues::default();
                }
                let ratios = now.iter().zip(&rest).map(|(now, rest)| now / rest);
                // The ratio of means, in which thin places do not weigh more.
                let [now, rest] = [means(&now), means(&rest)];
                FlatValues {
                    values: taking_part(ratios.collect()),
                    segments: std::array::from_fn(|index| Some(now[index]? / rest[index]?)),
                }
            }
            BullsEyeQuantity::Thickening => FlatValues {
                values: taking_part(told.thickening.iter().map(|ln| ln.exp()).collect()),
                segments: means(&told.thickening).map(|mean| mean.map(f64::exp)),
            },
        }
    }
}
