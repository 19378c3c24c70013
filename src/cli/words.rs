//! Words that options take.

use clap::ValueEnum;
use clap::builder::PossibleValue;

use crate::analysis::medial_space::RatioForm;
use crate::analysis::metrics::{Corners, Form, METRICS, MetricKind, Regulariser};
use crate::analysis::transport::Geodesics;
use crate::analysis::verdicts::Feature;
use crate::engine::DistanceTable;
use crate::picture::{AnatomicalView, Quantity};

/// Words of `--metric`, those of the list of metrics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MetricWord(MetricKind);

/// One word per metric, in the order of the list.
const METRIC_WORDS: [MetricWord; METRICS.len()] = {
    let mut words = [MetricWord(METRICS[0]); METRICS.len()];
    let mut index = 0;
    while index < METRICS.len() {
        words[index] = MetricWord(METRICS[index]);
        index += 1;
    }
    words
};

impl ValueEnum for MetricWord {
    fn value_variants<'a>() -> &'a [Self] {
        &METRIC_WORDS
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        let words = self.0.words();
        let word = PossibleValue::new(words.id).help(words.summary);
        Some(match self.0 {
            // What it was called before.
            MetricKind::Displacement => word.alias("rigid"),
            _ => word,
        })
    }
}

/// Words of `--form`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum FormWord {
    /// Absolute values as printed in the text
    Printed,
    /// Sums of products of the same terms
    Bilinear,
    /// Curvature weights frozen for the pair
    Frozen,
    /// Angle term plus µ times the curvature-change term
    Additive,
}

/// Words of `--corners`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CornersWord {
    /// As printed
    Raw,
    /// Scale-invariant
    ScaleFree,
}

/// Words of `--area-weights`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Switch {
    /// Yes
    On,
    /// No
    Off,
}

/// Words of `--compare`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum ComparisonWord {
    /// Motion relative to the own end-diastole, transported onto one shape
    #[default]
    Deformation,
    /// Deformation and end-diastolic shape, each over its median in the study
    #[value(name = "deformation+shape")]
    DeformationAndShape,
    /// End-diastolic shape alone
    Shape,
    /// Poses at equal phases with their shape, mapped as curves on the pose map
    Poses,
}

/// Words of `--distances`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DistancesWord {
    /// distances.csv
    Csv,
    /// distances.npy
    Npy,
    /// No file
    None,
}

impl From<DistancesWord> for DistanceTable {
    fn from(word: DistancesWord) -> Self {
        match word {
            DistancesWord::Csv => Self::Csv,
            DistancesWord::Npy => Self::Npy,
            DistancesWord::None => Self::None,
        }
    }
}

/// Words of `--regulariser`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RegulariserWord {
    /// All vertices with equal weight
    Uniform,
    /// Area-weighted
    Area,
}

/// Words of `--unit`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum UnitWord {
    /// Coordinates are millimetres
    Mm,
    /// The unit is not known: sizes are in units of the file
    File,
}

/// Words of `--align`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum AlignWord {
    /// No alignment
    None,
    /// Best rigid motion of B onto A
    Rigid,
    /// Best rigid motion and scale of B onto A
    Similarity,
}

/// Words of `--geodesics`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum GeodesicsWord {
    /// One geodesic, between the first poses; those of later poses are derived from it
    First,
    /// From every pose to the transported one, as in the text
    EveryStep,
}

impl From<GeodesicsWord> for Geodesics {
    fn from(word: GeodesicsWord) -> Self {
        match word {
            GeodesicsWord::First => Self::First,
            GeodesicsWord::EveryStep => Self::EveryStep,
        }
    }
}

/// Words of `--patch-ratio`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RatioWord {
    /// Independent of the number of atoms
    GeometricMean,
    /// As printed: grows with the number of atoms
    Product,
}

impl From<RatioWord> for RatioForm {
    fn from(word: RatioWord) -> Self {
        match word {
            RatioWord::GeometricMean => Self::GeometricMean,
            RatioWord::Product => Self::Product,
        }
    }
}

/// Words of `--input`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum EmbedInput {
    /// Square, symmetric, zero on the diagonal
    Distances,
    /// One item per row
    Points,
}

/// Words of `--method`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum EmbedMethod {
    /// Classical MDS
    Mds,
    /// Stress majorisation
    Smacof,
    /// Classical MDS of shortest paths between neighbours
    Isomap,
    /// Locally linear embedding; points only
    Lle,
    /// Principal components; points only
    Pca,
}

/// Words of `--colour`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum QuantityWord {
    /// Tissue colour
    Tissue,
    /// Displacement from end-diastole
    Displacement,
    /// Area relative to end-diastole
    AreaRatio,
    /// PT, wall thickness relative to end-diastole
    ThicknessRatio,
}

impl From<QuantityWord> for Quantity {
    fn from(word: QuantityWord) -> Self {
        match word {
            QuantityWord::Tissue => Self::Tissue,
            QuantityWord::Displacement => Self::Displacement,
            QuantityWord::AreaRatio => Self::AreaRatio,
            QuantityWord::ThicknessRatio => Self::ThicknessRatio,
        }
    }
}

/// Words of `--theme`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ThemeWord {
    /// Dark on white
    Light,
    /// Light on dark
    Dark,
}

/// Words of `--view`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ViewWord {
    /// From anterior
    Anterior,
    /// From inferior
    Inferior,
    /// From septal
    Septal,
    /// From lateral
    Lateral,
    /// From the apex
    Apex,
    /// From the base
    Base,
}

impl From<ViewWord> for AnatomicalView {
    fn from(word: ViewWord) -> Self {
        match word {
            ViewWord::Anterior => Self::Anterior,
            ViewWord::Inferior => Self::Inferior,
            ViewWord::Septal => Self::Septal,
            ViewWord::Lateral => Self::Lateral,
            ViewWord::Apex => Self::Apex,
            ViewWord::Base => Self::Base,
        }
    }
}

impl From<MetricWord> for MetricKind {
    fn from(word: MetricWord) -> Self {
        word.0
    }
}

impl From<FormWord> for Form {
    fn from(word: FormWord) -> Self {
        match word {
            FormWord::Printed => Self::Printed,
            FormWord::Bilinear => Self::Bilinear,
            FormWord::Frozen => Self::Frozen,
            FormWord::Additive => Self::Additive,
        }
    }
}

impl From<CornersWord> for Corners {
    fn from(word: CornersWord) -> Self {
        match word {
            CornersWord::Raw => Self::Raw,
            CornersWord::ScaleFree => Self::ScaleFree,
        }
    }
}

impl From<RegulariserWord> for Regulariser {
    fn from(word: RegulariserWord) -> Self {
        match word {
            RegulariserWord::Uniform => Self::Uniform,
            RegulariserWord::Area => Self::Area,
        }
    }
}

/// A model feature by its name in the file of a classifier.
pub fn feature(name: &str) -> Result<Feature, String> {
    let names = || Feature::MODEL_FEATURES.map(Feature::name).join(", ");
    Feature::of_name(name).ok_or_else(|| format!("the model features are {}", names()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_forms_are_the_names_that_files_have() {
        for word in FormWord::value_variants() {
            let value = word.to_possible_value().unwrap();
            assert_eq!(value.get_name(), Form::from(*word).id());
        }
    }
}
