//! Polar map of one heart's wall: its atoms on the unit disc, with values of any pose.

use crate::analysis::segments::{Polar, Segment, flat_map, polar, segment_means};
use crate::analysis::verdicts::SubjectThickening;
use crate::mesh::{Point3, vertex_areas};
use crate::picture::bulls_eye::BullsEyeQuantity;
use crate::picture::bulls_eye::patches::{PolarPatch, polar_patch};
use crate::study::Subject;

/// The medial surface at end-diastole in the unit disc, x to the right (lateral) and y up (anterior).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolarMap {
    /// Where atoms lie.
    pub points: Vec<[f64; 2]>,
    /// Faces over atoms.
    pub faces: Vec<[u32; 3]>,
    /// The patches, in the order of their list.
    pub patches: Vec<PolarPatch>,
    /// Whether septum and anterior wall are known, and so segments have names.
    pub oriented: bool,
    /// Area of each atom that takes part, 0 of others.
    weights: Vec<f64>,
}

/// Numbers on the bull's-eye: ratios, 1 for unchanged, or lengths.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PolarValues {
    /// Of each atom; not a number where it does not take part.
    pub values: Vec<f32>,
    /// Mean of each segment; `None` where the orientation is not known.
    pub segments: [Option<f64>; Segment::COUNT],
}

impl PolarMap {
    /// Of one heart; `None` where it has no long axis.
    pub fn of(wall: &SubjectThickening) -> Option<Self> {
        let beat = &wall.beat;
        let rest = beat.frames.get(wall.thickening.end_diastole)?;
        let axis = wall.axis?;
        let centres = rest.positions();
        let places: Vec<Polar> = centres.iter().map(|&centre| polar(&axis, centre)).collect();
        let triangles = beat.faces.triangles();
        let map = flat_map(&places, &centres, triangles);
        let mut weights = vertex_areas(&centres, triangles);
        for (weight, &regular) in weights.iter_mut().zip(&beat.regular) {
            if !regular {
                *weight = 0.0;
            }
        }
        let patches = wall.thickening.patches.iter();
        Some(Self {
            patches: patches
                .map(|patch| polar_patch(&map.points, &map.faces, &patch.atoms))
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
        wall: &SubjectThickening,
        subject: &Subject,
        quantity: BullsEyeQuantity,
        frame: usize,
    ) -> PolarValues {
        let (beat, thickening) = (&wall.beat, &wall.thickening);
        let taking_part = |numbers: Vec<f64>| -> Vec<f32> {
            let every = numbers.iter().zip(&beat.regular);
            every
                .map(|(&number, &on)| if on { number as f32 } else { f32::NAN })
                .collect()
        };
        let means = |numbers: &[f64]| segment_means(&wall.segments, &self.weights, numbers);
        match quantity {
            BullsEyeQuantity::ThicknessRatio => {
                let atoms =
                    |frame: usize| beat.frames.get(frame).map_or(&[][..], |pose| &pose.atoms);
                let (now, rest) = (atoms(frame), atoms(thickening.end_diastole));
                if now.len() != self.weights.len() {
                    return PolarValues::default();
                }
                let ratios = (now.iter().zip(rest)).map(|(now, rest)| now.thickness_ratio(rest));
                // The ratio of means, in which thin places do not weigh more.
                let [now, rest] = [now, rest].map(|atoms| {
                    let radii: Vec<f64> = atoms.iter().map(|atom| atom.radius).collect();
                    means(&radii)
                });
                PolarValues {
                    values: taking_part(ratios.collect()),
                    segments: std::array::from_fn(|index| Some(now[index]? / rest[index]?)),
                }
            }
            BullsEyeQuantity::Thickening => PolarValues {
                values: taking_part(thickening.averaged.iter().map(|ln| ln.exp()).collect()),
                segments: means(&thickening.averaged).map(|mean| mean.map(f64::exp)),
            },
            BullsEyeQuantity::Displacement => {
                let places = |frame| self.template_places(wall, subject, frame);
                let (now, rest) = (places(frame), places(thickening.end_diastole));
                if now.len() != self.weights.len() || rest.len() != now.len() {
                    return PolarValues::default();
                }
                let ways: Vec<f64> = (now.iter().zip(&rest))
                    .map(|(now, rest)| (now - rest).norm())
                    .collect();
                PolarValues {
                    segments: means(&ways),
                    values: taking_part(ways),
                }
            }
            BullsEyeQuantity::AreaRatio => {
                let triangles = beat.faces.triangles();
                let areas = |frame| {
                    let places = self.template_places(wall, subject, frame);
                    (places.len() == self.weights.len()).then(|| vertex_areas(&places, triangles))
                };
                let (Some(now), Some(rest)) = (areas(frame), areas(thickening.end_diastole)) else {
                    return PolarValues::default();
                };
                let even: Vec<f64> = (self.weights.iter())
                    .map(|&weight| f64::from(weight > 0.0))
                    .collect();
                let ratios = now.iter().zip(&rest).map(|(now, rest)| now / rest);
                let [sum, before] =
                    [&now, &rest].map(|areas| segment_means(&wall.segments, &even, areas));
                PolarValues {
                    values: taking_part(ratios.collect()),
                    segments: std::array::from_fn(|index| Some(sum[index]? / before[index]?)),
                }
            }
        }
    }

    /// Where the vertices of the template surface are at a frame, in the order of atoms; empty where the subject is
    /// not the one that was assessed.
    fn template_places(
        &self,
        wall: &SubjectThickening,
        subject: &Subject,
        frame: usize,
    ) -> Vec<Point3> {
        let surface = subject.sequence.surface(wall.beat.surface);
        let mesh = surface.and_then(|surface| surface.frames().get(frame));
        let points = mesh.map_or(&[][..], |mesh| mesh.vertices());
        let places = wall.beat.vertices.iter();
        places
            .map_while(|&vertex| points.get(vertex as usize).copied())
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::measure_subject;
    use crate::analysis::medial::{MedialParams, medial_beat};
    use crate::analysis::thickening::ThickeningParams;
    use crate::analysis::verdicts::VerdictParams;
    use crate::mesh::phantom;
    use crate::progress::Progress;
    use crate::study::built_in::{BuiltInParams, cohort};
    use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
    use std::sync::Arc;

    #[test]
    fn every_quantity_has_its_mean_in_every_segment_and_rest_at_end_diastole() {
        let params = BuiltInParams {
            vertices: 400,
            ..BuiltInParams::default()
        };
        let study = cohort(&params).unwrap().study;
        let subject = &study.subjects[0];
        let progress = Progress::default();
        let spheres = MedialParams::default().check().unwrap();
        let wall = SubjectThickening::new(
            subject,
            Arc::new(medial_beat(subject, &spheres, &progress).unwrap()),
            &measure_subject(subject),
            &ThickeningParams::default().check().unwrap(),
            &VerdictParams::default().check().unwrap(),
            &progress,
        )
        .unwrap();
        let flat = PolarMap::of(&wall).unwrap();
        assert!(flat.oriented);
        let [diastole, systole] = [wall.thickening.end_diastole, wall.thickening.end_systole];
        let at = |quantity, frame| flat.values(&wall, subject, quantity, frame);
        for (quantity, rest, [least, most]) in [
            (BullsEyeQuantity::ThicknessRatio, 1.0, [1.1, 2.5]),
            (BullsEyeQuantity::Displacement, 0.0, [0.5, 25.0]),
            (BullsEyeQuantity::AreaRatio, 1.0, [0.3, 0.95]),
        ] {
            let (still, moved) = (at(quantity, diastole), at(quantity, systole));
            for segment in Segment::all() {
                let [still, moved] = [&still, &moved].map(|v| v.segments[segment.index()].unwrap());
                assert!((still - rest).abs() < 1e-9, "{quantity:?}: {still}");
                assert!((least..most).contains(&moved), "{quantity:?}: {moved}");
            }
            let valued = moved
                .values
                .iter()
                .filter(|value| value.is_finite())
                .count();
            let regular = wall.beat.regular.iter().filter(|&&on| on).count();
            assert_eq!(valued, regular, "{quantity:?}");
        }
        // Another heart's surfaces are not taken for these.
        let ball = vec![phantom::sphere(1, 20.0)];
        let ball = SurfaceSequence::new(SurfaceKind::Cavity, ball).unwrap();
        let other = Subject::new(
            "other",
            MeshSequence::new(vec![ball]).unwrap(),
            subject.unit,
        );
        let none = flat.values(&wall, &other, BullsEyeQuantity::Displacement, systole);
        assert_eq!(none, PolarValues::default());
    }
}
