//! A cohort of meshes that do not correspond to a study in correspondence: one template laid onto all.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use rayon::prelude::*;

use crate::analysis::correspondence::{
    CheckedCorrespondenceParams, CorrespondenceError, FrameFit, SubjectLandmarks, SurfaceFrames,
    Targets, Template, correspond, propose_landmarks,
};
use crate::analysis::walls_from_masks::SurfaceFit;
use crate::io::{FramesRead, Limits, OpenError, SubjectFrames, open_paths};
use crate::progress::{Progress, Stopped};
use crate::study::built_in::{BUILT_IN_NAME, BuiltInError, BuiltInParams, cohort};
use crate::study::checks::{check_subject, sort_warnings_first};
use crate::study::{Notice, Study, Subject};

/// What is laid onto all subjects.
#[derive(Clone, Debug, PartialEq)]
pub enum TemplateSource {
    /// The first subject of the built-in cohort at end-diastole: endocardium and epicardium, apex, base and septum known.
    BuiltIn,
    /// The first subject of a study, or a mesh file, at the frame at which it starts.
    Path(PathBuf),
}

/// Why there is no template.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum TemplateError {
    /// Stopped.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// Its file cannot be read.
    #[error("the template cannot be read: {0}")]
    Unreadable(OpenError),
    /// There is no mesh in it.
    #[error("the template has no meshes: {}", .0.display())]
    Nothing(PathBuf),
    /// It cannot be laid onto anything.
    #[error(transparent)]
    Unusable(#[from] CorrespondenceError),
    /// The built-in cohort cannot be made.
    #[error(transparent)]
    BuiltIn(#[from] BuiltInError),
}

/// Reads the template.
///
/// # Errors
/// If it cannot be read, or shows no ventricle that is open at the base, or stopped.
pub fn read_template(
    source: &TemplateSource,
    limits: &Limits,
    progress: &Progress,
) -> Result<Template, TemplateError> {
    let TemplateSource::Path(path) = source else {
        let made = cohort(&BuiltInParams::default())?;
        let first = made.study.subjects.first();
        let first = first.ok_or_else(|| TemplateError::Nothing(BUILT_IN_NAME.into()))?;
        return Ok(Template::of_subject(first)?);
    };
    let opened = open_paths(std::slice::from_ref(path), limits, progress)?;
    let [first, ..] = opened.study.subjects.as_slice() else {
        let error = opened.errors.into_iter().next();
        return Err(error.map_or_else(
            || TemplateError::Nothing(path.clone()),
            TemplateError::Unreadable,
        ));
    };
    Ok(Template::of_subject(first)?)
}

/// How subjects are registered.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RegisterSettings {
    /// Settings of the map, and how badly it may fit.
    pub params: CheckedCorrespondenceParams,
    /// Landmarks of subjects, by their ids, in the place of those that are proposed.
    pub landmarks: BTreeMap<String, SubjectLandmarks>,
}

/// Subjects in correspondence.
#[derive(Clone, Debug, Default)]
pub struct RegisteredWalls {
    /// Subjects that the template could be laid onto.
    pub study: Study,
    /// How it lies on the meshes that were read, with the subject's id; their volumes stand where those of masks do.
    pub fits: Vec<(String, SurfaceFit)>,
    /// The landmarks that were used, with the subject's id.
    pub landmarks: Vec<(String, SubjectLandmarks)>,
    /// One for each file that cannot be read and each subject that was refused.
    pub errors: Vec<OpenError>,
    /// What was assumed about the study as a whole.
    pub notices: Vec<Notice>,
}

/// Lays the template onto all frames of all subjects that were read. A subject that is refused is an error in the answer,
/// and the rest goes on.
///
/// # Errors
/// Only if it was asked to stop.
pub fn registered_walls(
    read: FramesRead,
    template: &Template,
    settings: &RegisterSettings,
    progress: &Progress,
) -> Result<RegisteredWalls, Stopped> {
    progress.expect_steps(read.subjects.len());
    let made = (read.subjects.par_iter()).map(|frames| {
        let registered = registered(frames, template, settings, &progress.within());
        progress.step()?;
        match registered {
            Err(CorrespondenceError::Stopped(stopped)) => Err(stopped),
            other => Ok(other),
        }
    });
    let made: Vec<Result<Registered, CorrespondenceError>> =
        made.collect::<Result<_, Stopped>>()?;
    let mut walls = RegisteredWalls {
        errors: read.errors,
        notices: read.notices,
        ..RegisteredWalls::default()
    };
    for (frames, made) in read.subjects.iter().zip(made) {
        match made {
            Ok(Registered {
                subject,
                fits,
                landmarks,
            }) => {
                let id = || subject.id.clone();
                walls
                    .fits
                    .extend(fits.iter().map(|fit| (id(), as_row(fit))));
                walls.landmarks.push((id(), landmarks));
                walls.study.subjects.push(Arc::new(subject));
            }
            Err(error) => walls.errors.push(OpenError {
                subject: Some(frames.subject.id.clone()),
                path: frames.place.clone(),
                reason: format!("{}: {error}", frames.subject.id),
            }),
        }
    }
    walls.study.name = read.name;
    walls.study.label_classes = read.label_classes;
    Ok(walls)
}

struct Registered {
    subject: Subject,
    fits: Vec<FrameFit>,
    landmarks: SubjectLandmarks,
}

fn registered(
    frames: &SubjectFrames,
    template: &Template,
    settings: &RegisterSettings,
    progress: &Progress,
) -> Result<Registered, CorrespondenceError> {
    let surfaces = frames.surfaces.iter().map(|(kind, frames)| SurfaceFrames {
        kind: *kind,
        frames: frames.clone(),
    });
    let surfaces: Vec<SurfaceFrames> = surfaces.collect();
    let given = &frames.subject;
    let targets = Targets::new(template, &surfaces, given.anatomy.as_ref(), progress)?;
    let landmarks = match settings.landmarks.get(&given.id) {
        Some(landmarks) => landmarks.clone(),
        None => propose_landmarks(&targets, progress)?,
    };
    let made = correspond(template, &targets, &landmarks, &settings.params, progress)?;
    let mut subject = Subject {
        sequence: made.sequence,
        ..given.clone()
    };
    subject.notices.extend(made.notices);
    subject.notices.extend(how_made(&made.fits, template));
    let findings = check_subject(&subject, || progress.check())?;
    subject.notices.extend(findings);
    subject.notices.dedup();
    sort_warnings_first(&mut subject.notices);
    Ok(Registered {
        subject,
        fits: made.fits,
        landmarks,
    })
}

/// That the meshes are those of the template, and how near they are to what was read.
fn how_made(fits: &[FrameFit], template: &Template) -> Option<Notice> {
    let worst = |of: fn(&FrameFit) -> f64| fits.iter().map(of).reduce(f64::max);
    let (mean, p95) = (worst(|fit| fit.mean)?, worst(|fit| fit.p95)?);
    let foldovers: usize = fits.iter().map(|fit| fit.foldovers).sum();
    Some(Notice::info(format!(
        "meshes replaced by those of the template {}, laid onto each frame: distance from what was read at most {mean:.2} in the mean \
         and {p95:.2} at the 95th percentile, {foldovers} foldovers; torsion is not seen",
        template.name()
    )))
}

/// The row of a fit: the mesh that was read stands where masks do; its volume is no number where it has none.
fn as_row(fit: &FrameFit) -> SurfaceFit {
    SurfaceFit {
        frame: fit.frame,
        kind: fit.kind,
        mean_mm: fit.mean,
        p95_mm: fit.p95,
        foldovers: fit.foldovers,
        volume_ml: fit.volume / 1000.0,
        mask_volume_ml: fit
            .surface_volume
            .map_or(f64::NAN, |volume| volume / 1000.0),
    }
}
