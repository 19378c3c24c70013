//! Options of `mesh`, and what they set.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::analysis::preparation::{Asked, BaseEnd, Overrides, Preparation, Road, TypedTimes};
use crate::analysis::walls_from_masks::MaskLabels;
use crate::cli::outcome::CliError;
use crate::cli::words::Switch;
use crate::engine::{ImageWallSettings, read_preparations};
use crate::image::MarkedPoints;
use crate::mesh::Point3;

/// Options of `mesh`.
#[derive(Debug, Args)]
pub struct MeshArgs {
    /// Images: files, folders and archives of gated SPECT, cine MR with outlines or marked points, or masks such as
    /// patient001/patient001_frame01_gt.nii.gz and pairs NAME_endo, NAME_epi
    #[arg(value_name = "PATH", required = true)]
    pub paths: Vec<PathBuf>,
    /// Output folder; created if missing
    #[arg(long, value_name = "DIR")]
    pub out: PathBuf,
    /// How walls are found; otherwise what fits each study
    #[arg(long, value_enum, value_name = "WORD")]
    pub road: Option<RoadWord>,
    /// Values of label images: cavity and wall of the left ventricle, and cavity of the right one if there is one; by default
    /// cavity=3,wall=2,right=1
    #[arg(long, value_name = "NAME=VALUE,…", value_parser = labels)]
    pub labels: Option<MaskLabels>,
    /// Standard deviation of the blur in millimetres (SPECT)
    #[arg(long, value_name = "MM")]
    pub blur: Option<f64>,
    /// What is bright, as a share of the maximum (SPECT)
    #[arg(long, value_name = "SHARE")]
    pub threshold: Option<f64>,
    /// Tip of the ventricle, in millimetres of the image's world (left, posterior, superior)
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub apex: Option<Point3>,
    /// Middle of the mitral ring
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub base: Option<Point3>,
    /// A point of the septum or beyond it
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub septum: Option<Point3>,
    /// A point of the blood in the left ventricle
    #[arg(long, value_name = "X,Y,Z", value_parser = point, allow_hyphen_values = true)]
    pub blood: Option<Point3>,
    /// Maximum number of vertices per surface; 800 by default
    #[arg(long, value_name = "N")]
    pub vertices: Option<usize>,
    /// Distances between voxels along i, j and k in millimetres, where the files do not say them
    #[arg(long, value_name = "X,Y,Z", value_parser = triple)]
    pub spacing: Option<[f64; 3]>,
    /// Length of the beat in milliseconds, where the files do not say when the volumes were taken: equal parts of it
    #[arg(long, value_name = "MS")]
    pub cycle: Option<f64>,
    /// Whether surfaces end at the valve in a boundary, or are closed there by a lid
    #[arg(long, value_enum, value_name = "WORD")]
    pub base_end: Option<BaseEndWord>,
    /// Whether slices that stand beside their neighbours, because they were taken in another breath-hold, are put back; on by
    /// default
    #[arg(long, value_enum)]
    pub slice_shifts: Option<Switch>,
    /// Settings as preparation.json has them, of each subject or of all; other options win over them
    #[arg(long, value_name = "FILE")]
    pub settings: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    pub json: bool,
}

/// Words of `--road`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum RoadWord {
    /// The values are labels of tissues
    Masks,
    /// The myocardium is bright
    Spect,
    /// Blood is bright; with --apex, --base and --blood
    Cine,
    /// Outlines of another program lie beside the images
    Contours,
}

/// Words of `--base-end`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum BaseEndWord {
    /// A boundary
    Open,
    /// A lid
    Closed,
}

/// Bytes of a file of settings that are read: outlines of every slice of a thousand subjects take fewer.
const MAX_SETTINGS_BYTES: u64 = 256 << 20;

impl MeshArgs {
    /// How walls are made.
    ///
    /// # Errors
    /// If options exclude each other or are out of range, or the file of settings is none.
    pub(super) fn wall_settings(&self) -> Result<ImageWallSettings, CliError> {
        let over = self.overrides()?;
        let checked = over.over(Preparation::default()).check();
        checked.map_err(|error| CliError::Usage(error.to_string()))?;
        let settings = match &self.settings {
            Some(path) => read_settings(path)?,
            None => ImageWallSettings::default(),
        };
        Ok(ImageWallSettings { over, ..settings })
    }

    fn overrides(&self) -> Result<Overrides, CliError> {
        let road = self.road.map(|word| match word {
            RoadWord::Masks => Road::Masks(self.labels.unwrap_or_default()),
            RoadWord::Spect => Road::Spect,
            RoadWord::Cine => Road::Cine,
            RoadWord::Contours => Road::Contours,
        });
        if self.labels.is_some() && !matches!(road, None | Some(Road::Masks(_))) {
            let text = "--labels is for --road masks alone".to_owned();
            return Err(CliError::Usage(text));
        }
        Ok(Overrides {
            road,
            labels: self.labels,
            spacing_mm: self.spacing,
            times: self.cycle.map(TypedTimes::Cycle),
            blur_mm: self.blur,
            threshold: self.threshold,
            points: MarkedPoints {
                apex: self.apex,
                base: self.base,
                septum: self.septum,
                blood: self.blood,
            },
            vertices: self.vertices,
            base: self.base_end.map(|word| match word {
                BaseEndWord::Open => BaseEnd::Open,
                BaseEndWord::Closed => BaseEnd::Closed,
            }),
            correct_shifts: self.slice_shifts.map(|switch| switch == Switch::On),
        })
    }
}

fn read_settings(path: &Path) -> Result<ImageWallSettings, CliError> {
    let wrong = |reason: String| CliError::Unusable(format!("{reason}: {}", path.display()));
    let mut text = String::new();
    let file = File::open(path).map_err(|error| wrong(error.to_string()))?;
    let read = file.take(MAX_SETTINGS_BYTES + 1).read_to_string(&mut text);
    let bytes = read.map_err(|error| wrong(error.to_string()))? as u64;
    if bytes > MAX_SETTINGS_BYTES {
        let reason = format!("more than {MAX_SETTINGS_BYTES} bytes of settings");
        return Err(wrong(reason));
    }
    read_preparations(&text).map_err(wrong)
}

/// What is asked for, with the option that says it.
pub(super) fn with_option(asked: Asked) -> String {
    let option = match asked {
        Asked::Spacing => "--spacing X,Y,Z",
        Asked::Times => "--cycle MS",
        Asked::Labels => "--labels cavity=N,wall=N",
        Asked::Apex => "--apex X,Y,Z",
        Asked::Base => "--base X,Y,Z",
        Asked::Blood => "--blood X,Y,Z",
        Asked::Outlines => "files of outlines beside the images, or --settings FILE",
    };
    format!("{} ({option})", asked.words())
}

/// `1.5,1.5,8`.
fn triple(text: &str) -> Result<[f64; 3], String> {
    let numbers = text.split(',').map(|part| part.trim().parse::<f64>());
    let numbers: Result<Vec<f64>, _> = numbers.collect();
    let found = numbers
        .ok()
        .and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
    let finite = found.filter(|numbers| numbers.iter().all(|x| x.is_finite()));
    finite.ok_or_else(|| format!("{text:?} is not three numbers with commas between them"))
}

fn point(text: &str) -> Result<Point3, String> {
    triple(text).map(Point3::from)
}

/// `cavity=3,wall=2,right=1`.
fn labels(text: &str) -> Result<MaskLabels, String> {
    let mut labels = MaskLabels {
        right: None,
        ..MaskLabels::default()
    };
    let mut given = Vec::new();
    for part in text.split(',') {
        let wrong = || format!("{part:?} is not NAME=VALUE with a whole number");
        let (name, value) = part.split_once('=').ok_or_else(wrong)?;
        let value: i32 = value.trim().parse().map_err(|_| wrong())?;
        match name.trim() {
            "cavity" => labels.cavity = value,
            "wall" => labels.wall = value,
            "right" => labels.right = Some(value),
            other => {
                return Err(format!(
                    "{other:?} is unknown; cavity, wall and right are known"
                ));
            }
        }
        if given.contains(&name.trim()) {
            return Err(format!("{:?} stands twice", name.trim()));
        }
        given.push(name.trim());
    }
    let missing = ["cavity", "wall"]
        .into_iter()
        .find(|name| !given.contains(name));
    match missing {
        Some(name) => Err(format!("{name} is missing")),
        None => Ok(labels),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_pairs_of_known_names_and_whole_numbers() {
        let all = MaskLabels {
            cavity: 1,
            wall: 2,
            right: Some(3),
        };
        assert_eq!(labels("cavity=1,wall=2,right=3"), Ok(all));
        let without = MaskLabels { right: None, ..all };
        assert_eq!(labels("wall = 2, cavity = 1"), Ok(without));
        for wrong in [
            "",
            "cavity=3",
            "cavity=3,wall",
            "cavity=x,wall=2",
            "atrium=1",
            "wall=2,wall=2,cavity=3",
        ] {
            assert!(labels(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn points_are_three_finite_numbers() {
        assert_eq!(triple("-1, 2.5,3e1"), Ok([-1.0, 2.5, 30.0]));
        for wrong in ["", "1,2", "1,2,3,4", "1,2,x", "1,2,inf", "NaN,0,0", "1;2;3"] {
            assert!(triple(wrong).is_err(), "{wrong}");
        }
    }
}
