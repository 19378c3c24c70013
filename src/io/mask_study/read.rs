//! Reads the masks of one subject.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::find::{MaskFiles, MaskKind};
use super::info::MaskFacts;
use super::segmentation::{NamedLabels, is_segmentation, read_segmentation};
use crate::io::{ImageSeries, Limits, OpenError, read_image_file};
use crate::progress::{Progress, Stopped};

/// Masks of one subject as they are in the files.
#[derive(Clone, Debug, PartialEq)]
pub struct MaskSeries {
    /// One for each file: of labels in the order of the frames, or endocardium and epicardium.
    pub images: Vec<ImageSeries>,
    /// Whether `images` are endocardium and epicardium.
    pub pair: bool,
    /// For each file of labels, the number of its frame, where its name has one.
    pub frame_numbers: Vec<Option<u32>>,
    /// Which labels stand for which tissue, where all files say the same in words (DICOM segmentations).
    pub labels: Option<NamedLabels>,
    /// What is said beside the masks.
    pub facts: MaskFacts,
}

/// Why the masks of a subject cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MaskStudyError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// A file cannot be read.
    #[error(transparent)]
    File(#[from] OpenError),
    /// More files than a sequence may have frames.
    #[error("{files} files of masks; at most {most} frames are possible")]
    TooManyFrames {
        /// How many there are.
        files: usize,
        /// The limit.
        most: usize,
    },
    /// All files together have more voxels than are read.
    #[error("more than {most} voxels in all files of a subject")]
    TooManyVoxels {
        /// The limit.
        most: u64,
    },
}

/// Bytes of `Info.cfg` that are read; such files have some hundred.
const MAX_INFO_BYTES: u64 = 64 << 10;
/// The name of the file with facts about a subject.
const INFO: &str = "Info.cfg";

/// Reads all masks of a subject and what is said beside them.
///
/// # Errors
/// If a file cannot be read, there are too many, or it was asked to stop.
pub fn read_masks(
    files: &MaskFiles,
    limits: &Limits,
    progress: &Progress,
) -> Result<MaskSeries, MaskStudyError> {
    let (paths, frame_numbers, pair): (Vec<&Path>, Vec<Option<u32>>, bool) = match &files.kind {
        MaskKind::Labels(labels) => (
            labels.iter().map(|(_, path)| path.as_path()).collect(),
            labels.iter().map(|(number, _)| *number).collect(),
            false,
        ),
        MaskKind::Pair { endo, epi } => (vec![endo, epi], Vec::new(), true),
    };
    if paths.len() > limits.frames {
        return Err(MaskStudyError::TooManyFrames {
            files: paths.len(),
            most: limits.frames,
        });
    }
    let mut images = Vec::with_capacity(paths.len());
    let mut voxels = 0_u64;
    let mut labels = Vec::new();
    for path in paths {
        progress.check()?;
        let (series, named) = match is_segmentation(path) {
            true => read_segmentation(path, limits, &progress.within())??,
            false => (read_image_file(path, limits)?, None),
        };
        labels.push(named);
        let of_one = series.image.frame().voxel_count() as u64;
        voxels = voxels.saturating_add(of_one.saturating_mul(series.image.volumes().len() as u64));
        if voxels > limits.voxels_in_all {
            return Err(MaskStudyError::TooManyVoxels {
                most: limits.voxels_in_all,
            });
        }
        images.push(series);
    }
    Ok(MaskSeries {
        images,
        pair,
        frame_numbers,
        labels: (labels.first().copied().flatten())
            .filter(|_| labels.windows(2).all(|w| w[0] == w[1])),
        facts: facts(files),
    })
}

/// What `Info.cfg` says, where it lies beside the masks of this subject alone.
fn facts(files: &MaskFiles) -> MaskFacts {
    if !files.alone {
        return MaskFacts::default();
    }
    let mut bytes = Vec::new();
    let read = File::open(files.folder.join(INFO))
        .and_then(|file| file.take(MAX_INFO_BYTES).read_to_end(&mut bytes));
    match read {
        Ok(_) => MaskFacts::of_text(&String::from_utf8_lossy(&bytes)),
        Err(_) => MaskFacts::default(),
    }
}
