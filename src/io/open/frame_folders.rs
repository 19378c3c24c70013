//! Folders that hold one frame of a subject each: `p1/ED/endo.obj` beside `p1/ES/endo.obj`.

use std::path::PathBuf;

use super::file_name::mesh_name;
use super::find_sequences::Search;
use super::folder_contents::{FileRole, Loose, folder_name, role};
use super::folders::composed;
use super::group_files::stem;
use crate::progress::Stopped;
use crate::study::Notice;

impl Search<'_> {
    /// The files of folders whose names say a phase, a time or a number behind a word for "frame", and nothing else, if all
    /// of these folders are such and no file in them says a frame itself. Folders that are mere numbers may be patients.
    pub(super) fn frame_folders(
        &mut self,
        folders: &[PathBuf],
        beside: &[Loose],
    ) -> Result<Option<Vec<Loose>>, Stopped> {
        let is_mesh = |file: &Loose| role(&file.path) == FileRole::Mesh;
        let names: Vec<String> = folders.iter().map(|path| folder_name(path)).collect();
        let says_frame = |name: &String| {
            let found = mesh_name(&composed(name));
            let other = found.surface.is_some() || found.structure.is_some() || found.left;
            found.frame.is_some() && found.case.is_empty() && !other
        };
        let bare = |name: &String| name.bytes().all(|b| b.is_ascii_digit());
        if names.len() < 2
            || beside.iter().any(is_mesh)
            || !names.iter().all(says_frame)
            || names.iter().all(bare)
        {
            return Ok(None);
        }
        let mut found = Vec::new();
        for (folder, name) in folders.iter().zip(&names) {
            let Ok(entries) = self.entries(folder)? else {
                return Ok(None);
            };
            let files: Vec<Loose> = entries.files.into_iter().filter(is_mesh).collect();
            let own = |file: &Loose| mesh_name(&composed(&stem(&file.path))).frame.is_some();
            if files.is_empty() || !entries.folders.is_empty() || files.iter().any(own) {
                return Ok(None);
            }
            found.extend(files.into_iter().map(|file| Loose {
                frame: Some(name.clone()),
                ..file
            }));
        }
        self.plan.notices.push(Notice::info(format!(
            "folders {}, … are read as frames of one subject",
            names[..2].join(", ")
        )));
        Ok(Some(found))
    }
}
