//! A cohort of masks on disk to a study of walls in correspondence.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use rayon::prelude::*;

use crate::analysis::preparation::{
    Preparation, PreparationError, Road, Segmented, TypedTimes, segmented_masks, stated_image,
    walls,
};
use crate::analysis::walls_from_masks::{MaskError, MaskLabels, Masks, SurfaceFit};
use crate::io::{
    ImageSeries, Limits, MaskFiles, MaskSeries, MaskStudyError, OpenError, find_mask_studies,
    read_masks, united_notices,
};
use crate::progress::{Progress, Stopped};
use crate::study::{CycleTiming, LabelClasses, Notice, Study, Subject};
use crate::units::{LengthUnit, Seconds};

/// How masks become walls; by default with the labels of ACDC.
#[derive(Clone, Debug, Default)]
pub struct MaskWallSettings {
    /// Settings of all subjects.
    pub all: Preparation,
    /// Settings of single subjects by their ids, in the place of those of all.
    pub each: BTreeMap<String, Preparation>,
}

/// Walls of a cohort.
#[derive(Clone, Debug, Default)]
pub struct MaskWalls {
    /// Subjects whose walls could be made.
    pub study: Study,
    /// How the surfaces lie on the masks, with the subject's id.
    pub fits: Vec<(String, SurfaceFit)>,
    /// One for each file or subject that gave no walls.
    pub errors: Vec<OpenError>,
    /// What the files of most subjects say alike.
    pub notices: Vec<Notice>,
    /// The settings that each subject was made with, by its id.
    pub preparations: Vec<(String, Preparation)>,
    /// Folders in which masks were found.
    pub folders: Vec<PathBuf>,
}

/// Why a subject has no walls.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
enum SubjectError {
    #[error(transparent)]
    Stopped(#[from] Stopped),
    #[error(transparent)]
    Read(MaskStudyError),
    #[error(transparent)]
    Masks(#[from] MaskError),
    #[error(transparent)]
    Walls(PreparationError),
}

impl From<MaskStudyError> for SubjectError {
    fn from(error: MaskStudyError) -> Self {
        match error {
            MaskStudyError::Stopped(stopped) => Self::Stopped(stopped),
            other => Self::Read(other),
        }
    }
}

impl From<PreparationError> for SubjectError {
    fn from(error: PreparationError) -> Self {
        match error {
            PreparationError::Stopped(stopped) => Self::Stopped(stopped),
            other => Self::Walls(other),
        }
    }
}

/// Labels of the ACDC challenge by their classes; hearts with an abnormal right ventricle alone are neither.
const NORMAL: [&str; 1] = ["NOR"];
const ABNORMAL: [&str; 3] = ["MINF", "DCM", "HCM"];

/// Makes the walls of all masks below paths. A subject that cannot be made is an error in the answer, and the rest
/// goes on.
///
/// # Errors
/// Only if it was asked to stop.
pub fn mask_walls(
    paths: &[PathBuf],
    settings: &MaskWallSettings,
    limits: &Limits,
    progress: &Progress,
) -> Result<MaskWalls, Stopped> {
    progress.begin_phase("looking for masks", 0.0, 0.02);
    let (found, errors) = find_mask_studies(paths, limits, progress)?;
    progress.begin_phase("walls from masks", 0.02, 1.0);
    progress.expect_steps(found.len());
    let made: Vec<Result<Walled, SubjectError>> = (found.par_iter())
        .map(|files| {
            let own = settings.each.get(&files.id).unwrap_or(&settings.all);
            let walled = walled(files, own, limits, &progress.within());
            progress.step()?;
            walled
        })
        .collect();
    let mut walls = MaskWalls {
        errors,
        folders: found.iter().map(|files| files.folder.clone()).collect(),
        ..MaskWalls::default()
    };
    let (mut subjects, mut of_files) = (Vec::new(), Vec::new());
    for (files, walled) in found.iter().zip(made) {
        match walled {
            Ok((subject, fits, said, preparation)) => {
                walls.preparations.push((subject.id.clone(), preparation));
                walls
                    .fits
                    .extend(fits.into_iter().map(|fit| (subject.id.clone(), fit)));
                subjects.push(subject);
                of_files.push(said);
            }
            Err(SubjectError::Stopped(stopped)) => return Err(stopped),
            Err(SubjectError::Read(MaskStudyError::File(error))) => walls.errors.push(OpenError {
                subject: Some(files.id.clone()),
                ..error
            }),
            Err(error) => walls.errors.push(OpenError {
                subject: Some(files.id.clone()),
                path: files.folder.clone(),
                reason: format!("{}: {error}", files.id),
            }),
        }
    }
    walls.notices = united_notices(&mut of_files);
    let whole = subjects
        .into_iter()
        .zip(of_files)
        .map(|(mut subject, said)| {
            subject.notices.splice(0..0, said);
            Arc::new(subject)
        });
    walls.study.subjects = whole.collect();
    walls.study.name = study_name(paths);
    walls.study.label_classes = label_classes(&walls.study.subjects);
    Ok(walls)
}

/// A subject, how its surfaces lie on its masks, what is said of the files, and the settings that it was made with.
type Walled = (Subject, Vec<SurfaceFit>, Vec<Notice>, Preparation);

fn walled(
    files: &MaskFiles,
    settings: &Preparation,
    limits: &Limits,
    progress: &Progress,
) -> Result<Walled, SubjectError> {
    let mut series = read_masks(files, limits, progress)?;
    let labels = labels_of(&series, settings);
    let mut preparation = settings.clone();
    preparation.road = Road::Masks(labels);
    state(&mut series, settings)?;
    let segmented = segmented_masks(joined(&series, &labels)?, &preparation)?;
    let walls = walls(&segmented, &preparation, progress)?;
    let Segmented {
        instants: drawn, ..
    } = segmented;
    let known = settings.spacing_mm.is_some();
    let unit = match known || series.images.iter().all(ImageSeries::spacing_known) {
        true => LengthUnit::Millimetre,
        false => LengthUnit::FileUnit,
    };
    let mut subject = Subject::new(files.id.clone(), walls.sequence, unit);
    let facts = &series.facts;
    subject.label = facts.label.clone();
    subject.height_cm = facts.height_cm;
    subject.weight_kg = facts.weight_kg;
    subject.anatomy = walls.anatomy;
    let numbers = numbers(&series, &drawn);
    let place = |number: Option<u32>| numbers.iter().position(|&n| Some(n) == number);
    subject.end_diastole = place(facts.end_diastole);
    subject.end_systole = place(facts.end_systole);
    subject.timing = timing(&series, settings, &drawn);
    let mut said: Vec<Notice> = Vec::new();
    for notice in series.images.iter().flat_map(|image| &image.notices) {
        if !said.contains(notice) {
            said.push(notice.clone());
        }
    }
    let all: usize = series
        .images
        .iter()
        .map(|image| image.image.volumes().len())
        .sum();
    if !series.pair && drawn.len() < all {
        subject.notices.push(Notice::info(format!(
            "{} of {all} volumes have a mask: the others were left out",
            drawn.len()
        )));
    }
    subject.notices.extend(files.notices.iter().cloned());
    subject.notices.extend(walls.notices);
    let labels = (!series.pair).then_some(&labels);
    subject.notices.extend(how_made(&walls.fits, labels));
    Ok((subject, walls.fits, said, preparation))
}

/// Gives images the distances that were typed, and where one file has all volumes, their times.
fn state(series: &mut MaskSeries, settings: &Preparation) -> Result<(), PreparationError> {
    let whole = series.pair || series.images.len() == 1;
    let stated = Preparation {
        times: settings.times.clone().filter(|_| whole),
        ..settings.clone()
    };
    for one in &mut series.images {
        one.image = stated_image(&one.image, &stated)?;
    }
    Ok(())
}

/// The labels of the settings; those that a file names itself, unless others than those of ACDC were asked for.
fn labels_of(series: &MaskSeries, settings: &Preparation) -> MaskLabels {
    let set = match settings.road {
        Road::Masks(labels) => labels,
        _ => MaskLabels::default(),
    };
    let named = series.labels.filter(|_| set == MaskLabels::default());
    named.map_or(set, |named| MaskLabels {
        cavity: named.cavity,
        wall: named.wall,
        right: named.right,
    })
}

/// That the walls come from masks, by which labels if there are some, and how near they are to them.
fn how_made(fits: &[SurfaceFit], labels: Option<&MaskLabels>) -> Option<Notice> {
    how_near(fits, &labels.map_or_else(|| "masks".to_owned(), masks_of))
}

/// Masks by their labels, in words.
pub(super) fn masks_of(labels: &MaskLabels) -> String {
    let right =
        (labels.right).map_or_else(String::new, |label| format!(", {label} right ventricle"));
    format!(
        "masks (label {} cavity, {} wall{right})",
        labels.cavity, labels.wall
    )
}

/// What walls were made from, and how near they are to the tissues that were found.
pub(super) fn how_near(fits: &[SurfaceFit], made_from: &str) -> Option<Notice> {
    let worst = |of: fn(&SurfaceFit) -> f64| fits.iter().map(of).reduce(f64::max);
    let (mean, p95) = (worst(|fit| fit.mean_mm)?, worst(|fit| fit.p95_mm)?);
    let volume = worst(|fit| (fit.volume_ml / fit.mask_volume_ml - 1.0).abs())?;
    Some(Notice::info(format!(
        "walls made from {made_from}: distance of their outlines from the surfaces at most {mean:.1} mm in the mean and {p95:.1} mm \
         at the 95th percentile, volumes within {:.1} %",
        100.0 * volume
    )))
}

/// The masks of all frames.
fn joined(series: &MaskSeries, labels: &MaskLabels) -> Result<Masks, MaskError> {
    if let (true, [endo, epi]) = (series.pair, series.images.as_slice()) {
        return Masks::from_pair(&endo.image, &epi.image);
    }
    let parts = series
        .images
        .iter()
        .map(|image| Masks::from_labels(&image.image, labels));
    Masks::joined(parts.collect::<Result<_, _>>()?)
}

/// The number of each frame that was kept: that of its file's name, or its place in the file counted from 1.
fn numbers(series: &MaskSeries, drawn: &[usize]) -> Vec<u32> {
    let one_each = series
        .images
        .iter()
        .all(|image| image.image.volumes().len() == 1);
    let named = |place: usize| match one_each && !series.pair {
        true => series.frame_numbers.get(place).copied().flatten(),
        false => None,
    };
    let number = |&place: &usize| named(place).or(u32::try_from(place + 1).ok()).unwrap_or(0);
    drawn.iter().map(number).collect()
}

/// Times of the frames that were kept, and the length of the beat, where one file with all volumes says them.
fn timing(series: &MaskSeries, settings: &Preparation, drawn: &[usize]) -> CycleTiming {
    let typed = match settings.times {
        Some(TypedTimes::Cycle(ms)) => Some(ms),
        _ => None,
    };
    let rr = |ms: f64| Seconds(ms / 1000.0);
    let without_times = CycleTiming {
        frame_times_s: None,
        rr: typed.map(rr),
    };
    let [first, rest @ ..] = series.images.as_slice() else {
        return without_times;
    };
    let Some(times) = first.image.times_ms() else {
        return without_times;
    };
    if !(series.pair || rest.is_empty()) {
        return without_times;
    }
    let kept: Option<Vec<f64>> = drawn
        .iter()
        .map(|&n| Some(times.get(n)? / 1000.0))
        .collect();
    let cycle_ms = first.gates.as_ref().and_then(|gates| gates.cycle_ms);
    CycleTiming {
        frame_times_s: kept.filter(|times| times.len() > 1),
        rr: typed.or(cycle_ms).map(rr),
    }
}

/// The name of the one folder or file, without its ending.
pub(super) fn study_name(paths: &[PathBuf]) -> String {
    match paths {
        [one] => one
            .file_stem()
            .map_or_else(String::new, |name| name.to_string_lossy().into_owned()),
        _ => "Walls from images".to_owned(),
    }
}

/// Classes of labels that are known, beside those that every study has.
pub(super) fn label_classes(subjects: &[Arc<Subject>]) -> LabelClasses {
    let mut classes = LabelClasses::default();
    let occurs = |name: &&&str| subjects.iter().any(|s| s.label.as_deref() == Some(**name));
    let [normal, abnormal] = [&NORMAL[..], &ABNORMAL[..]].map(|names| {
        names
            .iter()
            .filter(occurs)
            .map(|name| (*name).to_owned())
            .collect::<Vec<_>>()
    });
    if !normal.is_empty() || !abnormal.is_empty() {
        classes = LabelClasses { normal, abnormal };
    }
    classes
}
