//! What lies in a folder, and what each name is for.

use std::path::{Path, PathBuf};

use super::file_name::{MeshName, mesh_name};
use super::folders::composed;
use super::read_file::name_of;
use super::series_files::is_series;
use crate::io::formats::format_of_extension;
use crate::study::SurfaceKind;

/// What lies in a folder, without hidden files.
pub(super) struct Entries {
    /// Files with the reason why one cannot be read, if that is known.
    pub(super) files: Vec<Loose>,
    pub(super) folders: Vec<PathBuf>,
}

/// What a file is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FileRole {
    Manifest,
    Series,
    Mesh,
    /// A mesh only if its content says so.
    Table,
    Other,
}

pub(super) fn role(path: &Path) -> FileRole {
    let Some(ending) = path.extension().and_then(|ending| ending.to_str()) else {
        return FileRole::Other;
    };
    if name_of(path).eq_ignore_ascii_case("study.toml") {
        FileRole::Manifest
    } else if is_series(path) {
        FileRole::Series
    } else {
        match format_of_extension(ending) {
            Some(format) if format.often_other => FileRole::Table,
            Some(_) => FileRole::Mesh,
            None => FileRole::Other,
        }
    }
}

/// One file of a folder.
#[derive(Clone, Debug)]
pub(super) struct Loose {
    pub(super) path: PathBuf,
    /// Why it cannot be read, if that is known already.
    pub(super) unreadable: Option<String>,
    pub(super) origin: Origin,
    /// The name of its folder, where that says which frame it is.
    pub(super) frame: Option<String>,
    /// Whether it was named itself, not found in a folder.
    pub(super) asked_for: bool,
}

/// What the name of its folder says of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Origin {
    pub(super) surface: Option<SurfaceKind>,
    pub(super) structure: Option<&'static str>,
}

impl Origin {
    /// What a folder's name says, if it says nothing but a surface, a ventricle or another part of the heart.
    pub(super) fn of_folder(name: &str) -> Option<Self> {
        let MeshName {
            case,
            surface,
            frame,
            structure,
            left,
            ..
        } = mesh_name(&composed(name));
        let says = surface.is_some() || structure.is_some() || left;
        (case.is_empty() && frame.is_none() && says).then_some(Self { surface, structure })
    }
}

impl Loose {
    pub(super) fn new(path: PathBuf, unreadable: Option<String>) -> Self {
        Self {
            path,
            unreadable,
            origin: Origin::default(),
            frame: None,
            asked_for: false,
        }
    }

    /// A file that was named itself, whatever its ending.
    pub(super) fn asked_for(path: PathBuf) -> Self {
        Self {
            asked_for: true,
            ..Self::new(path, None)
        }
    }

    /// The same file, of a folder that says so much.
    pub(super) fn from(mut self, origin: Origin) -> Self {
        self.origin = origin;
        self
    }
}

/// The folders of a folder.
pub(super) struct Sheets {
    /// Those that hold a surface or a part of the heart, with what their names say.
    pub(super) sheets: Vec<(PathBuf, Origin)>,
    /// The others.
    pub(super) subjects: Vec<PathBuf>,
}

/// The last part of a folder's path, also of `.` and `..`.
pub(super) fn folder_name(folder: &Path) -> String {
    let name = name_of(folder);
    if !name.is_empty() {
        return name;
    }
    let whole = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    whole
        .canonicalize()
        .map(|path| name_of(&path))
        .unwrap_or_default()
}
