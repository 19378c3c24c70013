//! The table of all distances between poses, which grows beside its place since that of a large cohort does not fit into memory.

use std::path::Path;

use crate::analysis::embedding::PoseMap;
use crate::analysis::pose_distances::PoseDistanceParams;
use crate::engine::export::{ExportFile, FileBytes, PartialFile};
use crate::engine::queries::distance_words;
use crate::engine::store::Interrupted;
use crate::engine::wall_tables::WriteError;
use crate::progress::Progress;
use crate::report::{distances_csv, distances_json, npy_header, npy_row, pretty_json};
use crate::study::Study;

/// How distances of poses are written: their number grows with the square of that of the poses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum DistanceTable {
    /// `distances.csv`.
    #[default]
    Csv,
    /// `distances.npy`, binary, a fifth of the size; its rows are the poses of `poses_mds.csv`.
    Npy,
    /// Not at all.
    None,
}

impl DistanceTable {
    pub(super) fn file(self) -> Option<&'static str> {
        match self {
            Self::Csv => Some("distances.csv"),
            Self::Npy => Some("distances.npy"),
            Self::None => None,
        }
    }
}

/// The matrix of distances as the settings want it, and by which metric it is.
pub(super) fn distance_files(
    study: &Study,
    map: &PoseMap,
    table: DistanceTable,
    params: &PoseDistanceParams,
    folder: &Path,
    progress: &Progress,
) -> Result<Vec<ExportFile>, Interrupted> {
    let Some(name) = table.file() else {
        return Ok(Vec::new());
    };
    let path = folder.join(name);
    let mut file = PartialFile::create(path.clone()).map_err(WriteError)?;
    let distances = &map.distances;
    match table {
        DistanceTable::Npy => {
            let matrix = &distances.distances;
            file.write(npy_header(matrix.size())).map_err(WriteError)?;
            for row in 0..matrix.size() {
                progress.check()?;
                file.write(npy_row(matrix, row)).map_err(WriteError)?;
            }
        }
        DistanceTable::Csv | DistanceTable::None => {
            for line in distances_csv(study, distances) {
                progress.check()?;
                file.write(line).map_err(WriteError)?;
            }
        }
    }
    let metric = distances_json(study, params, &distance_words(params), name);
    let metric = pretty_json(&metric)?;
    let table = ExportFile {
        path,
        bytes: FileBytes::Written(file),
    };
    Ok(vec![
        table,
        ExportFile::text(folder, "distances.json", metric),
    ])
}
