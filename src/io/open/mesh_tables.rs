//! Which CSV files are meshes: tables of other numbers lie beside meshes everywhere.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use super::file_name::mesh_name;
use super::group_files::stem;
use super::read_file::read_head;
use crate::io::csv_mesh::begins_as_mesh;
use crate::io::text_encoding::without_mark;

/// Bytes in which a first row of points or faces stands, even after a long header.
const HEAD_BYTES: u64 = 16 << 10;

/// Those of some CSV files that hold points and faces by their first rows, and those that are named as further frames
/// of these: a frame that cannot be read has to be told, whatever it holds, never left out.
pub(super) fn mesh_tables<'a>(tables: impl Iterator<Item = &'a PathBuf>) -> HashSet<PathBuf> {
    let (meshes, others): (Vec<&PathBuf>, Vec<&PathBuf>) =
        tables.partition(|path| looks_like_mesh(path));
    let sequences: HashSet<_> = meshes.iter().filter_map(|path| sequence(path)).collect();
    let is_frame = |path: &PathBuf| sequence(path).is_some_and(|name| sequences.contains(&name));
    let frames = others.into_iter().filter(|path| is_frame(path));
    meshes.iter().copied().chain(frames).cloned().collect()
}

fn looks_like_mesh(path: &Path) -> bool {
    // what never ends is not waited for
    let head = path.is_file().then(|| read_head(path, HEAD_BYTES));
    head.and_then(Result::ok)
        .is_some_and(|head| without_mark(&head).is_ok_and(|text| begins_as_mesh(&text.bytes)))
}

/// What is the same in the names of the frames of a sequence; none of a file without a frame.
fn sequence(path: &Path) -> Option<(PathBuf, String)> {
    let name = mesh_name(&stem(path));
    name.frame?;
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    Some((folder, format!("{:?} {}", name.surface, name.case)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_that_cannot_be_read_are_meshes_and_other_tables_are_none() {
        let folder = tempfile::tempdir().unwrap();
        let files: [(&str, &[u8]); 9] = [
            ("endo_0.csv", b"v,0,0,0\nv,1,0,0\nv,0,1,0\nf,0,1,2\n"),
            ("endo_1.csv", b"x,y,z\nv,nan,0,0\n"),
            ("endo_2.csv", b""),
            ("endo_3.csv", b"<html>"),
            ("endo_4.csv", b"v\0,\0001\0,\0001\0,\0001\0"),
            ("volumes.csv", b"time,volume\n0,120\n"),
            ("volume_1.csv", b"1,2,3\n"),
            ("endo.csv", b"time,volume\n"),
            ("epi_0.csv", b"f;0;1;2\n"),
        ];
        for (name, bytes) in files {
            std::fs::write(folder.path().join(name), bytes).unwrap();
        }
        let paths: Vec<PathBuf> = files
            .iter()
            .map(|(name, _)| folder.path().join(name))
            .collect();
        let meshes = mesh_tables(paths.iter());
        let found: Vec<bool> = paths.iter().map(|path| meshes.contains(path)).collect();
        assert_eq!(
            found,
            [true, true, true, true, true, false, false, false, true]
        );
    }
}
