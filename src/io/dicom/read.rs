//! From files, folders and archives to series of volumes, with a report of what was left out and why.

use std::path::PathBuf;
use std::sync::Arc;

use rayon::prelude::*;

use super::assembly::Assembly;
use super::contents::{Contents, contents};
use super::reading::DicomReading;
use super::sources::{Source, Sources};
use crate::io::image_file::ReadImageError;
use crate::io::limits::Limits;
use crate::progress::{Progress, Stopped};

/// Reads DICOM files, folders of them, and archives (`.zip`) of them. Bytes, files and voxels are bounded by `limits`.
///
/// Values are rescaled; padding is NaN. Series are made by geometry first, then by time. No name, number or text of a
/// patient, and no free text, is in what is returned; the unique names of images are only for finding them again.
///
/// # Errors
/// If it was asked to stop. What cannot be read is told in the result.
pub fn read_dicom(
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
) -> Result<DicomReading, Stopped> {
    read_sources(Sources::look_through(paths, limits), limits, progress)
}

/// Reads one DICOM file or archive whose bytes are at hand; `name` is that of the file. As [`read_dicom`].
///
/// # Errors
/// If it was asked to stop.
pub fn read_dicom_bytes(
    name: &str,
    bytes: Arc<[u8]>,
    limits: &Limits,
    progress: &Progress,
) -> Result<DicomReading, Stopped> {
    read_sources(Sources::of_bytes(name, bytes, limits), limits, progress)
}

fn read_sources(
    sources: Sources,
    limits: &Limits,
    progress: &Progress,
) -> Result<DicomReading, Stopped> {
    progress.begin_phase("reading DICOM files", 0.0, 0.7);
    progress.expect_steps(sources.files.len());
    let read = sources.files.into_par_iter().enumerate();
    let read: Vec<(String, Result<Contents, ReadImageError>)> = read
        .map(|(number, source)| {
            let held = contents_of(source, number, limits);
            progress.step().map(|()| held)
        })
        .collect::<Result<_, Stopped>>()?;
    progress.begin_phase("stacking slices", 0.7, 1.0);
    let mut assembly = Assembly::new(limits, progress);
    let mut refused = sources.refused;
    let files = read.iter().map(|(name, _)| name.clone()).collect();
    let alone = read.len() == 1;
    for (name, held) in read {
        if let Err(reason) = held.and_then(|held| assembly.take(held)) {
            refused.push((name, reason));
        }
    }
    let mut reading = assembly.finish(alone)?;
    reading.files = files;
    reading.count_refused(refused);
    Ok(reading)
}

fn contents_of(
    source: Source,
    number: usize,
    limits: &Limits,
) -> (String, Result<Contents, ReadImageError>) {
    let name = source.name.clone();
    let held = source
        .bytes()
        .and_then(|bytes| contents(bytes, number, limits));
    (name, held)
}
