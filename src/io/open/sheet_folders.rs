//! Folders that hold one surface of a subject: `p1/endo/0.obj` beside `p1/epi/0.obj`.

use std::path::PathBuf;

use super::file_name::mesh_name;
use super::find_sequences::Search;
use super::folder_contents::{FileRole, Origin, Sheets, folder_name, role};
use super::group_files::stem;
use super::read_file::name_of;
use crate::progress::Stopped;
use crate::study::natural_order;

impl Search<'_> {
    /// Folders that are named after a surface or a part of the heart, and hold its frames; and the others.
    ///
    /// A patient may be called Endo: a folder whose files name another surface, or that stands among folders of
    /// patients and whose files name their surface, is a subject's.
    pub(super) fn sheets(&mut self, folders: Vec<PathBuf>) -> Result<Sheets, Stopped> {
        let (mut sheets, mut others) = (Vec::new(), Vec::new());
        for folder in folders {
            match Origin::of_folder(&folder_name(&folder)) {
                Some(origin) => sheets.push((folder, origin)),
                None => others.push(folder),
            }
        }
        if sheets.is_empty() {
            return Ok(Sheets {
                sheets,
                subjects: others,
            });
        }
        let mut among_subjects = false;
        for folder in &others {
            let entries = self.entries(folder)?;
            among_subjects |= entries.is_ok_and(|entries| {
                entries
                    .files
                    .iter()
                    .any(|file| role(&file.path) == FileRole::Mesh)
            });
        }
        let (mut kept, mut subjects) = (Vec::new(), Vec::new());
        for (folder, origin) in sheets {
            let entries = self.entries(&folder)?;
            let names: Vec<_> = entries.map_or_else(
                |_| Vec::new(),
                |entries| {
                    let files = entries.files.into_iter();
                    files
                        .filter(|file| role(&file.path) == FileRole::Mesh)
                        .map(|file| mesh_name(&stem(&file.path)).surface)
                        .collect()
                },
            );
            let others_named = origin.surface.is_some()
                && names
                    .iter()
                    .any(|name| name.is_some() && *name != origin.surface);
            let subject = others_named
                || (among_subjects && names.iter().any(Option::is_some))
                || (names.is_empty() && origin.surface.is_none());
            if subject {
                subjects.push(folder);
            } else {
                kept.push((folder, origin));
            }
        }
        others.extend(subjects);
        others.sort_by(|a, b| natural_order(&name_of(a), &name_of(b)));
        Ok(Sheets {
            sheets: kept,
            subjects: others,
        })
    }
}
