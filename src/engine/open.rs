//! Where a study comes from: files and folders of meshes, masks or images, or the cohort that ships inside.

use std::path::{Path, PathBuf};

use crate::engine::image_walls::{ImageWallSettings, image_walls};
use crate::io::{Limits, OpenError, OpenListener, Opened, looks_like_image, open_paths_in_stages};
use crate::progress::{Progress, Stopped};
use crate::study::built_in::{self, BuiltInParams};

/// What to open.
#[derive(Clone, Debug, PartialEq)]
pub enum OpenSource {
    /// Studies, folders and files, together as one study.
    Paths(Vec<PathBuf>),
    /// The same, with links that lead out of them.
    PathsAndLinks(Vec<PathBuf>),
    /// The cohort that ships inside.
    BuiltIn(BuiltInParams),
}

impl OpenSource {
    /// These paths, or the built-in cohort if there are none.
    pub fn paths_or_built_in(paths: Vec<PathBuf>) -> Self {
        if paths.is_empty() {
            Self::BuiltIn(BuiltInParams::default())
        } else {
            Self::Paths(paths)
        }
    }

    /// What the activity list calls it.
    pub(crate) fn name(&self) -> &'static str {
        match self {
            Self::Paths(_) | Self::PathsAndLinks(_) => "Open files",
            Self::BuiltIn(_) => "Open the built-in cohort",
        }
    }

    /// What is opened, in words: the last part of each path, because folders above can name a person.
    pub(crate) fn words(&self) -> String {
        match self {
            Self::Paths(paths) | Self::PathsAndLinks(paths) => paths
                .iter()
                .map(|path| {
                    path.file_name()
                        .map_or_else(|| path.to_string_lossy(), |name| name.to_string_lossy())
                        .into_owned()
                })
                .collect::<Vec<_>>()
                .join(", "),
            Self::BuiltIn(_) => String::new(),
        }
    }
}

/// Opens a source. What cannot be read is an error in the answer, never the end of the rest.
///
/// # Errors
/// Only if it was asked to stop.
pub fn open(source: &OpenSource, limits: &Limits, progress: &Progress) -> Result<Opened, Stopped> {
    open_in_stages(source, limits, progress, &())
}

/// Walls from the images and masks below paths without a mesh; where there are none, what was `opened`, with what is wrong
/// with images.
fn walls_or(
    mut opened: Opened,
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
) -> Result<Opened, Stopped> {
    let made = image_walls(paths, &ImageWallSettings::default(), limits, progress)?;
    if !made.opened.study.subjects.is_empty() || !made.opened.images.is_empty() {
        return Ok(made.opened);
    }
    // That there are no images is no news to somebody who opens meshes.
    let is_of_images = |error: &OpenError| {
        error.subject.is_some() || (looks_like_image(&error.path) && !error.path.is_dir())
    };
    let errors = made.opened.errors.into_iter();
    let of_images: Vec<OpenError> = errors.filter(is_of_images).collect();
    // One file has one error: that of the reader that is meant for it.
    let about = |path: &Path| of_images.iter().any(|error| error.path == path);
    opened.errors.retain(|error| !about(&error.path));
    opened.errors.extend(of_images);
    Ok(opened)
}

/// The same, with subjects that are read from files handed to `listener` one by one.
pub(crate) fn open_in_stages(
    source: &OpenSource,
    limits: &Limits,
    progress: &Progress,
    listener: &dyn OpenListener,
) -> Result<Opened, Stopped> {
    match source {
        OpenSource::Paths(paths) => {
            progress.begin_phase("reading files", 0.0, 1.0);
            let opened = open_paths_in_stages(paths, limits, progress, listener)?;
            if opened.study.subjects.is_empty() {
                return walls_or(opened, paths, limits, progress);
            }
            Ok(opened)
        }
        OpenSource::PathsAndLinks(paths) => {
            let limits = Limits {
                follow_links: true,
                ..*limits
            };
            open(&OpenSource::Paths(paths.clone()), &limits, progress)
        }
        OpenSource::BuiltIn(params) => {
            progress.check()?;
            Ok(match built_in::cohort(params) {
                Ok(cohort) => Opened {
                    study: cohort.study,
                    ..Opened::default()
                },
                Err(error) => Opened {
                    errors: vec![OpenError {
                        subject: None,
                        path: PathBuf::from("built-in cohort"),
                        reason: error.to_string(),
                    }],
                    ..Opened::default()
                },
            })
        }
    }
}
