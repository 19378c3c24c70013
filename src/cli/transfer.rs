//! `transfer`: the motion of one subject transported onto another.

use std::path::Path;
use std::sync::Arc;

use serde_json::json;

use crate::analysis::transport::{
    CheckedTransportParams, FoundPath, TransportParams, transport_deformation,
};
use crate::cli::args::TransferArgs;
use crate::cli::corresponding::{laying, read};
use crate::cli::input::opened_study;
use crate::cli::interpolate::pose_files;
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::words::{AlignWord, Switch};
use crate::cli::work::run_work;
use crate::engine::write_files;
use crate::mesh::{FaceOrder, Faces, Point3};
use crate::study::Subject;

pub(super) fn transfer(args: &TransferArgs) -> Result<(), CliError> {
    let params = checked(args)?;
    let from = only_subject(&args.from)?;
    let faces = Arc::new(from.sequence.joined_faces());
    let onto = target(&args.onto, &faces)?;
    let frames = 0..from.sequence.frame_count();
    let mut source: Vec<Vec<Point3>> = frames.filter_map(|f| from.sequence.pose(f)).collect();
    let first = source.first().cloned().unwrap_or_default();
    let lay = laying(&onto, &first, args.align)?;
    for point in source.iter_mut().flatten() {
        *point = lay(point);
    }
    let (work_faces, work_onto) = (Arc::clone(&faces), onto);
    let transported = run_work(move |progress| {
        progress.begin_phase("transporting the motion", 0.0, 1.0);
        transport_deformation(&work_faces, &source, &work_onto, &params, progress)
    })?;
    let (poses, account) = (&transported.poses, &transported.account);
    write_files(pose_files(&faces, poses, &args.out)?).map_err(CliError::Unusable)?;
    if args.json {
        return print_json(&json!({
            "poses": poses.len(),
            "vertices": faces.vertex_count(),
            "align": align_word(args.align),
            "geodesics": account.paths.iter().map(path_json).collect::<Vec<_>>(),
            "norm_change": account.norm_change(),
            "product_change": account.product_change(),
        }));
    }
    print(&format!(
        "{} poses, the sequence {}, {}; norms changed by at most {:.1e}, products with the direction by {:.1e}: {}",
        poses.len(),
        match args.align {
            AlignWord::None => "not aligned with the mesh",
            AlignWord::Rigid => "aligned with the mesh by the best rigid motion of its first pose",
            AlignWord::Similarity =>
                "aligned with the mesh by the best similarity of its first pose, scale included (--align none or rigid for another)",
        },
        account.path_words(),
        account.norm_change(),
        account.product_change(),
        args.out.display()
    ))
}

fn path_json(path: &FoundPath) -> serde_json::Value {
    json!({
        "energy": path.energy,
        "energy_linear": path.energy_linear,
        "iterations": path.iterations,
        "converged": path.converged,
    })
}

fn align_word(align: AlignWord) -> &'static str {
    match align {
        AlignWord::None => "none",
        AlignWord::Rigid => "rigid",
        AlignWord::Similarity => "similarity",
    }
}

fn checked(args: &TransferArgs) -> Result<CheckedTransportParams, CliError> {
    let default = TransportParams::default();
    let params = TransportParams {
        metric: args.metric.of_paths(),
        interpolated_poses: args
            .interpolated_poses
            .unwrap_or(default.interpolated_poses),
        keep_norm: args.keep_norm == Switch::On,
        geodesics: args.geodesics.into(),
        max_vertices: match args.coarse_vertices {
            Some(vertices) => Some(vertices).filter(|&vertices| vertices > 0),
            None => default.max_vertices,
        },
        tolerance: args.tolerance.unwrap_or(default.tolerance),
        ..default
    };
    let checked = params.check();
    checked.map_err(|error| CliError::Usage(error.to_string()))
}

/// The one subject that a path holds.
fn only_subject(path: &Path) -> Result<Arc<Subject>, CliError> {
    let study = opened_study(&[path.to_owned()])?;
    match study.subjects.as_slice() {
        [subject] => Ok(Arc::clone(subject)),
        subjects => Err(CliError::Unusable(format!(
            "{} subjects, but exactly one is needed: {}",
            subjects.len(),
            path.display()
        ))),
    }
}

/// The vertices to transport onto: of a mesh file, or of the first frame of a folder's only subject.
fn target(path: &Path, faces: &Faces) -> Result<Vec<Point3>, CliError> {
    let (points, mesh) = if path.is_dir() {
        let sequence = &only_subject(path)?.sequence;
        (
            sequence.pose(0).unwrap_or_default(),
            sequence.joined_faces(),
        )
    } else {
        let mesh = read(path)?;
        (mesh.vertices().to_vec(), Faces::clone(mesh.faces()))
    };
    if FaceOrder::of(faces, &mesh).is_same_surface() {
        return Ok(points);
    }
    Err(CliError::Unusable(format!(
        "the mesh has {} vertices and {} faces, the sequence {} and {}, or different faces: {}",
        mesh.vertex_count(),
        mesh.triangles().len(),
        faces.vertex_count(),
        faces.triangles().len(),
        path.display()
    )))
}
