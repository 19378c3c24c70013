//! The settings of an import as a table of names, as files have it.

use std::sync::Arc;

use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::Road;
use super::settings::{BaseEnd, Preparation, SettingsError, TypedTimes};
use crate::analysis::walls_from_masks::MaskLabels;
use crate::image::{Contour, ContourPart, MarkedPoints, VolumeEdit};
use crate::mesh::Point3;

/// The table. What is left out is as by default; a name that is not known is an error, so that none is misspelt unseen.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct SettingsFile {
    road: RoadName,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    labels: Option<Labels>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    spacing_mm: Option<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    times_ms: Option<Vec<f64>>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    cycle_ms: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    blur_mm: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    threshold: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    vertices: Option<usize>,
    #[serde(default)]
    base_end: BaseEnd,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    slice_shifts: Option<bool>,
    #[serde(default)]
    points: Points,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    edits: Vec<VolumeEdit>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    contours: Vec<Outline>,
}

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum RoadName {
    Masks,
    Spect,
    Cine,
    Contours,
}

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Labels {
    cavity: i32,
    wall: i32,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    right: Option<i32>,
}

#[derive(Clone, Copy, Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Points {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    apex: Option<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    base: Option<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    septum: Option<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    blood: Option<[f64; 3]>,
}

#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Outline {
    instant: usize,
    part: PartName,
    points: Vec<[f64; 3]>,
}

#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum PartName {
    Endocardium,
    Epicardium,
    RightCavity,
}

fn numbers(point: Point3) -> [f64; 3] {
    [point.x, point.y, point.z]
}

impl Serialize for Preparation {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        SettingsFile::from(self.clone()).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Preparation {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let file = SettingsFile::deserialize(deserializer)?;
        Self::try_from(file).map_err(D::Error::custom)
    }
}

impl From<Preparation> for SettingsFile {
    fn from(settings: Preparation) -> Self {
        let (road, labels) = match settings.road {
            Road::Masks(labels) => (
                RoadName::Masks,
                Some(Labels {
                    cavity: labels.cavity,
                    wall: labels.wall,
                    right: labels.right,
                }),
            ),
            Road::Spect => (RoadName::Spect, None),
            Road::Cine => (RoadName::Cine, None),
            Road::Contours => (RoadName::Contours, None),
        };
        let (times_ms, cycle_ms) = match settings.times {
            Some(TypedTimes::Each(times)) => (Some(times), None),
            Some(TypedTimes::Cycle(cycle)) => (None, Some(cycle)),
            None => (None, None),
        };
        let points = settings.points;
        Self {
            road,
            labels,
            spacing_mm: settings.spacing_mm,
            times_ms,
            cycle_ms,
            blur_mm: Some(settings.blur_mm),
            threshold: settings.threshold,
            vertices: Some(settings.vertices),
            base_end: settings.base,
            slice_shifts: Some(settings.correct_shifts),
            points: Points {
                apex: points.apex.map(numbers),
                base: points.base.map(numbers),
                septum: points.septum.map(numbers),
                blood: points.blood.map(numbers),
            },
            edits: settings.edits,
            contours: settings.contours.iter().map(Outline::of).collect(),
        }
    }
}

impl TryFrom<SettingsFile> for Preparation {
    type Error = FileError;

    fn try_from(file: SettingsFile) -> Result<Self, FileError> {
        let road = match (file.road, file.labels) {
            (RoadName::Masks, None) => Road::ALL[0],
            (RoadName::Masks, Some(labels)) => Road::Masks(MaskLabels {
                cavity: labels.cavity,
                wall: labels.wall,
                right: labels.right,
            }),
            (_, Some(_)) => return Err(FileError::Labels),
            (RoadName::Spect, None) => Road::Spect,
            (RoadName::Cine, None) => Road::Cine,
            (RoadName::Contours, None) => Road::Contours,
        };
        let default = Self::of_road(road);
        let point = |numbers: Option<[f64; 3]>| numbers.map(Point3::from);
        let settings = Self {
            spacing_mm: file.spacing_mm,
            times: match (file.times_ms, file.cycle_ms) {
                (Some(_), Some(_)) => return Err(FileError::TimesTwice),
                (Some(times), None) => Some(TypedTimes::Each(times)),
                (None, cycle) => cycle.map(TypedTimes::Cycle),
            },
            blur_mm: file.blur_mm.unwrap_or(default.blur_mm),
            threshold: file.threshold,
            edits: file.edits,
            points: MarkedPoints {
                apex: point(file.points.apex),
                base: point(file.points.base),
                septum: point(file.points.septum),
                blood: point(file.points.blood),
            },
            contours: Arc::new(file.contours.iter().map(Outline::contour).collect()),
            vertices: file.vertices.unwrap_or(default.vertices),
            base: file.base_end,
            correct_shifts: file.slice_shifts.unwrap_or(default.correct_shifts),
            ..default
        };
        settings.check()?;
        Ok(settings)
    }
}

/// Why a table is not the settings of an import.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
enum FileError {
    #[error("labels are for the road masks alone")]
    Labels,
    #[error("times_ms and cycle_ms exclude each other")]
    TimesTwice,
    #[error(transparent)]
    Setting(#[from] SettingsError),
}

impl Outline {
    fn of(contour: &Contour) -> Self {
        Self {
            instant: contour.instant,
            part: match contour.part {
                ContourPart::Endocardium => PartName::Endocardium,
                ContourPart::Epicardium => PartName::Epicardium,
                ContourPart::RightCavity => PartName::RightCavity,
            },
            points: contour.points.iter().copied().map(numbers).collect(),
        }
    }

    fn contour(&self) -> Contour {
        Contour {
            instant: self.instant,
            part: match self.part {
                PartName::Endocardium => ContourPart::Endocardium,
                PartName::Epicardium => ContourPart::Epicardium,
                PartName::RightCavity => ContourPart::RightCavity,
            },
            points: self.points.iter().copied().map(Point3::from).collect(),
        }
    }
}
