//! Values of the features of one subject: those of the wall are computed here, those of the whole heart in `whole_heart`.

use std::f64::consts::PI;

use crate::analysis::medial::MedialBeat;
use crate::analysis::thickening::{AKINETIC_PT, Patch, Thickening};
use crate::mesh::{Point3, area};

use super::feature::Feature;
use super::weighted::Weighted;

/// Share of the wall that is thinner than what counts as its greatest thickness.
const GREATEST: f64 = 0.95;

/// What the features of the wall are made of: one subject's medial surfaces and its thickening.
#[derive(Clone, Copy, Debug)]
pub struct VerdictInput<'a> {
    /// Medial surfaces over the beat.
    pub beat: &'a MedialBeat,
    /// What of them does not thicken.
    pub thickening: &'a Thickening,
}

/// All features of one subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Features([Option<f64>; Feature::ALL.len()]);

impl Features {
    /// Of one subject. Features of poses are `None` where no pose has a descriptor.
    pub(super) fn new(heart: &VerdictInput<'_>) -> Self {
        let VerdictInput { beat, thickening } = *heart;
        let rest = beat.frames[thickening.end_diastole].positions();
        let areas = regular_areas(beat, &rest);
        // Near a cut a ratio of thicknesses is not one of the same tissue, and still wall there means nothing.
        let away: Vec<f64> = (areas.iter().zip(&thickening.at_edge))
            .map(|(area, at_edge)| if *at_edge { 0.0 } else { *area })
            .collect();
        let values = Weighted::new(&thickening.averaged, &areas);
        let values_away = Weighted::new(&thickening.averaged, &away);
        let akinetic = AKINETIC_PT.ln();
        // The largest; smaller ones add to the share alone.
        let patch = thickening.patches.first();
        let temporal_consistency = patch.map_or(&thickening.temporal_consistency, |patch| {
            &patch.temporal_consistency
        });
        let remote = thickening.remote;
        let spread = values.deviation();
        let thickness = |pose: usize| {
            let thickness: Vec<f64> = (beat.frames[pose].atoms.iter())
                .map(|atom| 2.0 * atom.radius)
                .collect();
            Weighted::new(&thickness, &areas)
        };
        let at_end_diastole = thickness(thickening.end_diastole);
        let contracted = thickness(thickening.end_systole);
        Self(Feature::ALL.map(|feature| {
            match feature {
                Feature::AkineticShare => Some(values_away.share_below(akinetic)),
                Feature::Median => Some(values.quantile(0.5)),
                Feature::Spread => Some(spread),
                // Where hardly anything thickens a ratio to that would be noise.
                Feature::RelativeSpread => Some(spread / remote.max(akinetic)),
                Feature::TenthPercentile => Some(values.quantile(0.1)),
                Feature::Remote => Some(remote),
                Feature::UpperRange => Some(remote + 2.0 * spread),
                Feature::PatchShare => Some(
                    // Weighted by detection stability, so that a doubtful patch counts less.
                    (thickening.patches.iter())
                        .fold(0.0, |sum, patch| sum + patch.share * patch.stability),
                ),
                Feature::Confidence => Some(patch.map_or(0.0, |patch| patch.stability)),
                Feature::PatchThickening => {
                    Some(patch.map_or(1.0, |patch| patch.thickening / remote.max(akinetic)))
                }
                Feature::Compactness => Some(patch.map_or(0.0, |patch| compactness(patch, &rest))),
                Feature::MeanPoseDistance => temporal_consistency.pose_distance,
                Feature::NormalSpread => temporal_consistency.normal_spread_rad,
                Feature::MeanPositionDistance => temporal_consistency.gap,
                Feature::WallEd => Some(at_end_diastole.quantile(0.5)),
                Feature::ThickestEd => Some(at_end_diastole.quantile(GREATEST)),
                Feature::ThicknessRatio => {
                    Some(at_end_diastole.quantile(GREATEST) / at_end_diastole.quantile(0.5))
                }
                Feature::WallEs => Some(contracted.quantile(0.5)),
                Feature::ThickestEs => Some(contracted.quantile(GREATEST)),
                // Those of the whole heart are added from its surfaces.
                Feature::EjectionFraction
                | Feature::EdvIndex
                | Feature::EsvIndex
                | Feature::MassIndex
                | Feature::MassToVolume
                | Feature::SphericityEd
                | Feature::SphericityEs
                | Feature::InwardSpread
                | Feature::InwardTenth => None,
            }
        }))
    }

    /// One of them; `None` where it cannot be determined.
    pub fn get(&self, feature: Feature) -> Option<f64> {
        self.0[feature as usize]
    }

    /// The first that is known and not finite.
    pub(super) fn not_finite(&self) -> Option<Feature> {
        (Feature::ALL.into_iter())
            .find(|&feature| self.get(feature).is_some_and(|value| !value.is_finite()))
    }

    /// Says one of them, or that it is not known.
    pub(super) fn set(&mut self, feature: Feature, value: Option<f64>) {
        self.0[feature as usize] = value;
    }

    /// What is no finite number is not known.
    pub(super) fn without_infinite(&mut self) {
        for value in &mut self.0 {
            *value = value.filter(|value| value.is_finite());
        }
    }

    /// What the classifier reads, in the order of [`Feature::MODEL_FEATURES`].
    pub(super) fn model_features(&self) -> Vec<Option<f64>> {
        Feature::MODEL_FEATURES
            .map(|feature| self.get(feature))
            .to_vec()
    }
}

/// Volume of the wall at end-systole over that at end-diastole: Σ area · 2 r over regular atoms.
pub(super) fn wall_volume_ratio(beat: &MedialBeat, thickening: &Thickening) -> f64 {
    let volume = |pose: usize| -> f64 {
        let areas = regular_areas(beat, &beat.frames[pose].positions());
        (areas.iter().zip(&beat.frames[pose].atoms))
            .map(|(area, atom)| 2.0 * area * atom.radius)
            .sum()
    };
    // Relative to end-diastole: the size of the subject cancels.
    volume(thickening.end_systole) / volume(thickening.end_diastole)
}

/// A third of the area of the faces around each atom, of those whose atoms are all regular.
fn regular_areas(beat: &MedialBeat, positions: &[Point3]) -> Vec<f64> {
    let mut areas = vec![0.0; positions.len()];
    for triangle in beat.faces.triangles() {
        // A face with an end atom lies half outside the wall.
        if triangle.iter().all(|&atom| beat.regular[atom as usize]) {
            let third = area(positions, &[*triangle]) / 3.0;
            triangle
                .iter()
                .for_each(|&atom| areas[atom as usize] += third);
        }
    }
    areas
}

/// 4π A / L²: 1 for a disc in a plane, small for what is ragged or wound around the subject.
fn compactness(patch: &Patch, positions: &[Point3]) -> f64 {
    let at = |atom: u32| positions[atom as usize];
    let length: f64 = (patch.border.iter())
        .flat_map(|chain| {
            (0..chain.len()).map(move |i| (at(chain[(i + 1) % chain.len()]) - at(chain[i])).norm())
        })
        .sum();
    // No patch, or one of a single face along a seam, has no border to be compact against.
    if length > 0.0 {
        (4.0 * PI * patch.area / (length * length)).min(1.0)
    } else {
        0.0
    }
}
