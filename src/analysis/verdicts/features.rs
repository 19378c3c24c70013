//! What a verdict looks at: a few numbers per subject, free of its size and place.

use std::f64::consts::PI;

use crate::analysis::medial::MedialBeat;
use crate::analysis::thickening::{Patch, Thickening};
use crate::mesh::{Point3, area};

use super::weighted::Weighted;

/// PT from end-diastole to end-systole below which a wall is akinetic: "roughly equal to one" (4.4).
const AKINETIC_PT: f64 = 1.1;
/// Share of the wall that is thinner than what counts as its greatest thickness.
const GREATEST: f64 = 0.95;

/// What a verdict is made of: one subject's medial surfaces and its thickening.
#[derive(Clone, Copy, Debug)]
pub struct VerdictInput<'a> {
    /// Medial surfaces over the beat.
    pub beat: &'a MedialBeat,
    /// What of them does not thicken.
    pub thickening: &'a Thickening,
}

/// One feature of a subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Feature {
    /// Share of the wall, away from where it was cut, whose thickness grows by less than a tenth from end-diastole to end-systole.
    AkineticShare,
    /// Area-weighted median of thickening, ln PT from end-diastole to end-systole.
    Median,
    /// Area-weighted standard deviation of thickening over the wall, ln PT.
    Spread,
    /// The same over the thickening of remote myocardium, at least ln 1.1.
    RelativeSpread,
    /// Thickening that a tenth of the wall does not reach, ln PT.
    TenthPercentile,
    /// Thickening of remote myocardium, ln PT.
    Remote,
    /// Thickening of remote myocardium and twice the spread, ln PT: small where the whole wall is hypokinetic, large where
    /// a part does or none.
    UpperRange,
    /// Share of the wall in patches, each times its confidence.
    PatchShare,
    /// Confidence of the largest patch; 0 without one.
    Confidence,
    /// Thickening of the largest patch over that of remote myocardium; 1 without one.
    PatchThickening,
    /// Compactness of the largest patch, 4π area / length of its border², at most 1; 0 without one.
    Compactness,
    /// Mean distance 4.5.1 between poses, of the largest patch or of M̂ (4.7).
    MeanPoseDistance,
    /// Spread of ANV over the poses (4.4.1).
    NormalSpread,
    /// Mean distance of MP from the medial surface (4.4.2).
    MeanPositionDistance,
    /// Ejection fraction.
    EjectionFraction,
    /// End-diastolic volume over body surface, ml/m².
    EdvIndex,
    /// End-systolic volume over body surface, ml/m².
    EsvIndex,
    /// Mass of the myocardium over body surface, g/m².
    MassIndex,
    /// Mass of the myocardium over end-diastolic volume, g/ml.
    MassToVolume,
    /// Area-weighted median of wall thickness, the diameter of medial spheres, at end-diastole, mm.
    WallEd,
    /// Its 95th percentile, mm: a maximum that a single bump does not make.
    ThickestEd,
    /// The 95th percentile over the median: 1 for a wall of one thickness.
    ThicknessRatio,
    /// Median at end-systole, mm.
    WallEs,
    /// 95th percentile at end-systole, mm.
    ThickestEs,
    /// Volume of the cavity at end-diastole over that of a sphere as wide as the ventricle is long.
    SphericityEd,
    /// The same at end-systole.
    SphericityEs,
    /// Standard deviation over the inner side of its motion towards the centroid, as a share of the distance there.
    InwardSpread,
    /// 10th percentile of the same motion.
    InwardTenth,
}

/// How many there are.
const COUNT: usize = 28;

impl Feature {
    /// All of them, in the order of tables.
    pub const ALL: [Self; COUNT] = [
        Self::AkineticShare,
        Self::Median,
        Self::Spread,
        Self::RelativeSpread,
        Self::TenthPercentile,
        Self::Remote,
        Self::UpperRange,
        Self::PatchShare,
        Self::Confidence,
        Self::PatchThickening,
        Self::Compactness,
        Self::MeanPoseDistance,
        Self::NormalSpread,
        Self::MeanPositionDistance,
        Self::EjectionFraction,
        Self::EdvIndex,
        Self::EsvIndex,
        Self::MassIndex,
        Self::MassToVolume,
        Self::WallEd,
        Self::ThickestEd,
        Self::ThicknessRatio,
        Self::WallEs,
        Self::ThickestEs,
        Self::SphericityEd,
        Self::SphericityEs,
        Self::InwardSpread,
        Self::InwardTenth,
    ];

    /// Those that the classifier reads. The ones of 4.4–4.7 (compactness, closeness, ANV, MP) tell less and are shown as
    /// evidence: see [`verdicts`](super::verdicts()) for what was measured.
    pub const MODEL_FEATURES: [Self; 17] = [
        Self::AkineticShare,
        Self::Median,
        Self::RelativeSpread,
        Self::EjectionFraction,
        Self::EdvIndex,
        Self::EsvIndex,
        Self::MassIndex,
        Self::MassToVolume,
        Self::WallEd,
        Self::ThickestEd,
        Self::ThicknessRatio,
        Self::WallEs,
        Self::ThickestEs,
        Self::SphericityEd,
        Self::SphericityEs,
        Self::InwardSpread,
        Self::InwardTenth,
    ];

    /// Lengths, which mean something only in millimetres.
    pub(super) const THICKNESSES: [Self; 4] = [
        Self::WallEd,
        Self::ThickestEd,
        Self::WallEs,
        Self::ThickestEs,
    ];

    /// The model feature of a name, in any case.
    pub fn of_name(name: &str) -> Option<Self> {
        let mut all = Self::MODEL_FEATURES.into_iter();
        all.find(|feature| feature.name().eq_ignore_ascii_case(name.trim()))
    }

    /// What it is called in tables, on screen and in files of classifiers.
    pub const fn name(self) -> &'static str {
        match self {
            Self::AkineticShare => "Akinetic region",
            Self::Median => "Median thickening",
            Self::Spread => "SD of thickening",
            Self::RelativeSpread => "Thickening heterogeneity",
            Self::TenthPercentile => "10th percentile of thickening",
            Self::Remote => "Remote thickening",
            Self::UpperRange => "Upper range of thickening",
            Self::PatchShare => "Wall in patches",
            Self::Confidence => "Detection stability",
            Self::PatchThickening => "Ratio of patch to remote thickening",
            Self::Compactness => "Compactness",
            Self::MeanPoseDistance => "Mean pose distance",
            Self::NormalSpread => "Angular SD of ANV",
            Self::MeanPositionDistance => "Distance of MP",
            Self::EjectionFraction => "Ejection fraction",
            Self::EdvIndex => "EDV index",
            Self::EsvIndex => "ESV index",
            Self::MassIndex => "Mass index",
            Self::MassToVolume => "Mass / EDV",
            Self::WallEd => "Wall thickness at ED",
            Self::ThickestEd => "Greatest wall thickness at ED",
            Self::ThicknessRatio => "Greatest / median wall thickness",
            Self::WallEs => "Wall thickness at ES",
            Self::ThickestEs => "Greatest wall thickness at ES",
            Self::SphericityEd => "Sphericity at ED",
            Self::SphericityEs => "Sphericity at ES",
            Self::InwardSpread => "Heterogeneity of inward motion",
            Self::InwardTenth => "Least inward motion",
        }
    }

    /// What it is counted in; empty for a ratio.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Median
            | Self::Spread
            | Self::TenthPercentile
            | Self::Remote
            | Self::UpperRange => "ln PT",
            Self::NormalSpread => "rad",
            Self::EdvIndex | Self::EsvIndex => "ml/m²",
            Self::MassIndex => "g/m²",
            Self::MassToVolume => "g/ml",
            Self::WallEd | Self::ThickestEd | Self::WallEs | Self::ThickestEs => "mm",
            _ => "",
        }
    }
}

/// All features of one subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Features([Option<f64>; COUNT]);

impl Features {
    /// Of one subject. Features of poses are `None` where no pose has a descriptor.
    pub(super) fn new(heart: &VerdictInput<'_>) -> Self {
        let VerdictInput { beat, thickening } = *heart;
        let rest = positions(beat, thickening.end_diastole);
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
                        .fold(0.0, |sum, patch| sum + patch.share * patch.confidence),
                ),
                Feature::Confidence => Some(patch.map_or(0.0, |patch| patch.confidence)),
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
                _ => None,
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
        let areas = regular_areas(beat, &positions(beat, pose));
        (areas.iter().zip(&beat.frames[pose].atoms))
            .map(|(area, atom)| 2.0 * area * atom.radius)
            .sum()
    };
    // Relative to end-diastole: the size of the subject cancels.
    volume(thickening.end_systole) / volume(thickening.end_diastole)
}

fn positions(beat: &MedialBeat, pose: usize) -> Vec<Point3> {
    (beat.frames[pose].atoms.iter())
        .map(|atom| atom.position)
        .collect()
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
