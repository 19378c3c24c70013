//! Meshes of commands that take single files, checked to correspond and aligned.

use std::path::Path;
use std::sync::Arc;

use crate::analysis::alignment::{rigid_motion, similarity};
use crate::cli::outcome::CliError;
use crate::cli::print::say;
use crate::cli::words::AlignWord;
use crate::engine::reading_limits;
use crate::io::read_mesh_file;
use crate::mesh::{FaceOrder, Point3, TriMesh};

/// Two meshes with the same faces.
///
/// # Errors
/// If one cannot be read, or they do not correspond.
pub(super) fn read_pair(a: &Path, b: &Path) -> Result<[TriMesh; 2], CliError> {
    let (mesh_a, mesh_b) = (read(a)?, read(b)?);
    match FaceOrder::of(mesh_a.faces(), mesh_b.faces()) {
        FaceOrder::Same => return Ok([mesh_a, mesh_b]),
        FaceOrder::Reordered | FaceOrder::Rewound | FaceOrder::Recut => {
            say(&format!(
                "cardiomorph: {} lists the same faces in another way than {}, whose faces are used",
                b.display(),
                a.display()
            ));
            let faces = Arc::clone(mesh_a.faces());
            let mesh_b =
                TriMesh::new(mesh_b.shared_vertices(), faces).map_err(CliError::unusable)?;
            return Ok([mesh_a, mesh_b]);
        }
        FaceOrder::Different => {}
    }
    let same_count = mesh_a.triangles().len() == mesh_b.triangles().len();
    Err(CliError::Unusable(format!(
        "the meshes do not correspond: {} has {} vertices and {} faces, {} has {} and {}{}",
        a.display(),
        mesh_a.vertices().len(),
        mesh_a.triangles().len(),
        b.display(),
        mesh_b.vertices().len(),
        mesh_b.triangles().len(),
        if same_count {
            ", with different faces"
        } else {
            ""
        }
    )))
}

/// The vertices of B, aligned with A as asked.
///
/// # Errors
/// If all vertices of one lie in one place.
pub(super) fn aligned(
    target: &[Point3],
    source: &[Point3],
    align: AlignWord,
) -> Result<Vec<Point3>, CliError> {
    let lay = laying(target, source, align)?;
    Ok(source.iter().map(lay).collect())
}

/// Where a point goes.
pub(super) type Laying = Box<dyn Fn(&Point3) -> Point3>;

/// The map that aligns the source with the target as asked.
///
/// # Errors
/// If all vertices of one lie in one place.
pub(super) fn laying(
    target: &[Point3],
    source: &[Point3],
    align: AlignWord,
) -> Result<Laying, CliError> {
    Ok(match align {
        AlignWord::None => Box::new(|point| *point),
        AlignWord::Rigid => {
            let motion = rigid_motion(source, target).map_err(CliError::unusable)?;
            Box::new(move |point| motion.apply(point))
        }
        AlignWord::Similarity => {
            let map = similarity(source, target).map_err(CliError::unusable)?;
            Box::new(move |point| map.apply(point))
        }
    })
}

/// The mesh in a file, or the first frame of a sequence in one.
///
/// # Errors
/// If it cannot be read.
pub(super) fn read(path: &Path) -> Result<TriMesh, CliError> {
    let wrong = |reason: String| CliError::Unusable(format!("{reason}: {}", path.display()));
    let file = read_mesh_file(path, &reading_limits()).map_err(wrong)?;
    for notice in &file.notices {
        say(&format!("{}: {}", path.display(), notice.text));
    }
    file.frames
        .into_iter()
        .next()
        .ok_or_else(|| wrong("holds no mesh".to_owned()))
}
