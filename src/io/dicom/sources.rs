//! Where the files of a study are: in folders, or in `.zip` archives as they leave an archive of images.

use std::fs::File;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use zip::ZipArchive;

use super::file::looks_like_dicom;
use crate::io::image_file::ReadImageError;
use crate::io::limits::{DICOM_BYTES_OF_A_VOXEL, Limits, MAX_IMAGE_FOLDER_DEPTH};

/// One file that may be DICOM.
#[derive(Clone, Debug)]
pub(super) struct Source {
    /// The last part of its path, for messages.
    pub(super) name: String,
    place: SourcePlace,
    /// Bytes that it takes when it is read, as far as they are stated.
    pub(super) size: u64,
}

#[derive(Clone, Debug)]
enum SourcePlace {
    Path(PathBuf),
    Bytes(Arc<[u8]>),
    Packed(ZipArchive<Cursor<Arc<[u8]>>>, usize),
}

/// Files that were found, and what could not be looked into with the reason.
#[derive(Debug, Default)]
pub(super) struct Sources {
    pub(super) files: Vec<Source>,
    pub(super) refused: Vec<(String, ReadImageError)>,
    bytes: u64,
}

/// As much of a file as tells what it is.
const HEAD: u64 = 256;

fn last_part(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}

fn is_zip(head: &[u8]) -> bool {
    head.starts_with(b"PK\x03\x04")
}

fn failed(error: &std::io::Error) -> ReadImageError {
    ReadImageError::Unsupported(format!("it cannot be read: {}", error.kind()))
}

impl Sources {
    /// Looks through files, folders and archives, in the order of their names.
    pub(super) fn look_through(paths: &[PathBuf], limits: &Limits) -> Self {
        let mut sources = Self::default();
        for path in paths {
            sources.add_path(path, 0, limits);
        }
        sources
    }

    /// A file whose bytes are at hand.
    pub(super) fn of_bytes(name: &str, bytes: Arc<[u8]>, limits: &Limits) -> Self {
        let mut sources = Self::default();
        match is_zip(&bytes) {
            true => sources.add_zip(name, bytes, limits),
            false => sources.add(
                Source {
                    name: name.to_owned(),
                    size: bytes.len() as u64,
                    place: SourcePlace::Bytes(bytes),
                },
                limits,
            ),
        }
        sources
    }

    fn full(&self, limits: &Limits) -> bool {
        self.files.len() + self.refused.len() >= limits.image_files
    }

    fn refuse(&mut self, path: &Path, error: ReadImageError) {
        self.refused.push((last_part(path), error));
    }

    fn add(&mut self, source: Source, limits: &Limits) {
        let most = limits.voxels_in_all.saturating_mul(DICOM_BYTES_OF_A_VOXEL);
        let size = source.size;
        let all = self.bytes.saturating_add(size);
        if size > limits.file_bytes || all > most {
            let (size, most) = match size > limits.file_bytes {
                true => (size, limits.file_bytes),
                false => (all, most),
            };
            self.refused
                .push((source.name, ReadImageError::TooLarge { size, most }));
            return;
        }
        self.bytes = all;
        self.files.push(source);
    }

    fn add_path(&mut self, path: &Path, depth: usize, limits: &Limits) {
        if self.full(limits) {
            return;
        }
        // What is named itself may be a link; what lies in a folder only where links are followed.
        let follow = depth == 0 || limits.follow_links;
        let about = match follow {
            true => std::fs::metadata(path),
            false => std::fs::symlink_metadata(path),
        };
        let about = match about {
            Ok(about) => about,
            Err(error) => return self.refuse(path, failed(&error)),
        };
        if about.is_dir() {
            return self.add_folder(path, depth, limits);
        }
        if !about.is_file() {
            return;
        }
        let mut head = Vec::new();
        let file = File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
        if let Err(error) = file {
            return self.refuse(path, failed(&error));
        }
        if is_zip(&head) {
            if about.len() > limits.file_bytes {
                let (size, most) = (about.len(), limits.file_bytes);
                return self.refuse(path, ReadImageError::TooLarge { size, most });
            }
            match read_up_to(path, limits.file_bytes) {
                Ok(bytes) => self.add_zip(&last_part(path), bytes.into(), limits),
                Err(error) => self.refuse(path, failed(&error)),
            }
        } else if looks_like_dicom(&head) {
            let source = Source {
                name: last_part(path),
                place: SourcePlace::Path(path.to_owned()),
                size: about.len(),
            };
            self.add(source, limits);
        } else {
            self.refuse(path, not_dicom());
        }
    }

    fn add_folder(&mut self, folder: &Path, depth: usize, limits: &Limits) {
        if depth >= MAX_IMAGE_FOLDER_DEPTH {
            return self.refuse(
                folder,
                too_many("folders within folders", depth + 1, MAX_IMAGE_FOLDER_DEPTH),
            );
        }
        let entries = match std::fs::read_dir(folder) {
            Ok(entries) => entries,
            Err(error) => return self.refuse(folder, failed(&error)),
        };
        let most = limits.image_files;
        let mut paths: Vec<PathBuf> = entries
            .take(most + 1)
            .filter_map(Result::ok)
            .map(|entry| entry.path())
            .filter(|path| !last_part(path).starts_with('.'))
            .collect();
        if paths.len() > most {
            self.refuse(
                folder,
                too_many("files in one folder, or more", paths.len(), most),
            );
            paths.truncate(most);
        }
        paths.sort();
        for path in paths {
            self.add_path(&path, depth + 1, limits);
        }
    }

    /// The files of an archive. Archives in it stay closed, and nothing is written anywhere.
    fn add_zip(&mut self, name: &str, bytes: Arc<[u8]>, limits: &Limits) {
        let archive = ZipArchive::new(Cursor::new(bytes));
        let Ok(mut archive) = archive else {
            let error = ReadImageError::Unsupported("an archive (.zip) that is damaged".to_owned());
            return self.refused.push((name.to_owned(), error));
        };
        if archive.len() > limits.image_files {
            let error = too_many("files in an archive", archive.len(), limits.image_files);
            return self.refused.push((name.to_owned(), error));
        }
        for index in 0..archive.len() {
            if self.full(limits) {
                return;
            }
            let Ok(entry) = archive.by_index_raw(index) else {
                continue;
            };
            if !entry.is_file() {
                continue;
            }
            let (size, locked) = (entry.size(), entry.encrypted());
            let own =
                (entry.name()).map_or_else(|_| name.to_owned(), |own| last_part(Path::new(&*own)));
            drop(entry);
            if own.starts_with('.') {
                continue;
            }
            if locked {
                let error = ReadImageError::Unsupported("locked by a password".to_owned());
                self.refused.push((own, error));
                continue;
            }
            let source = Source {
                name: own,
                place: SourcePlace::Packed(archive.clone(), index),
                size,
            };
            self.add(source, limits);
        }
    }
}

fn not_dicom() -> ReadImageError {
    ReadImageError::UnknownFormat {
        known: "DICOM".to_owned(),
    }
}

fn too_many(what: &'static str, count: usize, most: usize) -> ReadImageError {
    ReadImageError::TooMany {
        what,
        count: count as u64,
        most: most as u64,
    }
}

fn read_up_to(path: &Path, most: u64) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}

impl Source {
    /// The bytes of the file, at most as many as were stated.
    ///
    /// # Errors
    /// If it cannot be read or unpacked, or is not DICOM.
    pub(super) fn bytes(self) -> Result<Vec<u8>, ReadImageError> {
        match self.place {
            SourcePlace::Path(path) => read_up_to(&path, self.size).map_err(|error| failed(&error)),
            SourcePlace::Bytes(bytes) => Ok(bytes.to_vec()),
            SourcePlace::Packed(mut archive, index) => {
                let broken = || ReadImageError::Unsupported("it cannot be unpacked".to_owned());
                let mut entry = archive.by_index(index).map_err(|_| broken())?;
                let mut bytes = Vec::new();
                (entry.by_ref().take(HEAD))
                    .read_to_end(&mut bytes)
                    .map_err(|_| broken())?;
                if !looks_like_dicom(&bytes) {
                    return Err(not_dicom());
                }
                let left = self.size.saturating_sub(bytes.len() as u64);
                (entry.take(left))
                    .read_to_end(&mut bytes)
                    .map_err(|_| broken())?;
                Ok(bytes)
            }
        }
    }
}
