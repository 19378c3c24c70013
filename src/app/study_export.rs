//! Writes a study with its edits.

use std::path::Path;
use std::sync::Arc;

use crate::document::state::State;
use crate::document::{Leaving, StudyExport};
use crate::engine::Engine;
use crate::io::{MeshFormat, write_study};
use crate::study::Study;
use crate::ui::text::counted;

use super::errors::push_card;

/// Writes a study with its edits into a folder, off the window's thread, and leaves it for `then` once that is done. A
/// folder that holds a study is refused: its meshes would be written over.
pub fn write_study_into(
    state: &mut State,
    engine: &mut Engine,
    study: Arc<Study>,
    folder: &Path,
    then: Option<Leaving>,
) {
    if !study.unread.is_empty() {
        let why = "the study is still being read: what is not read yet would be missing";
        return push_card(&mut state.errors, "Nothing was exported", why);
    }
    let manifest = folder.join("study.toml");
    // An export into the same place that failed or was stopped has left nothing there.
    state.exports.retain(|export| export.manifest != manifest);
    state.exports.push(StudyExport {
        manifest: manifest.clone(),
        revision: study.revision,
        then,
    });
    let folder = folder.to_owned();
    let words = counted(study.count(), "subject");
    engine.start_writing("Study", words, move |progress| {
        if manifest.exists() {
            return Err(format!(
                "a study is in this folder already; choose an empty one: {}",
                folder.display()
            ));
        }
        let format = MeshFormat::of_extension("ply").ok_or("meshes cannot be written")?;
        progress.begin_phase("writing meshes", 0.0, 1.0);
        write_study(&study, &folder, format, progress).map_err(|error| error.to_string())?;
        Ok(vec![manifest])
    });
}
