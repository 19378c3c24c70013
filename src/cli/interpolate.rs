//! `interpolate`: the poses on the geodesic between two meshes.

use std::path::Path;
use std::sync::Arc;

use serde_json::json;

use crate::analysis::geodesics::{CheckedGeodesicParams, GeodesicParams, GeodesicPath, geodesic};
use crate::cli::args::InterpolateArgs;
use crate::cli::corresponding::{aligned, read_pair};
use crate::cli::outcome::CliError;
use crate::cli::print::{print, print_json};
use crate::cli::work::run_work;
use crate::engine::{ExportFile, write_files};
use crate::io::write_ply;
use crate::mesh::{Faces, Point3, TriMesh};
use crate::progress::Stopped;

pub(super) fn interpolate(args: &InterpolateArgs) -> Result<(), CliError> {
    let params = checked(args)?;
    let [a, b] = read_pair(&args.a, &args.b)?;
    let moved = aligned(a.vertices(), b.vertices(), args.align)?;
    let (faces, start) = (Arc::clone(a.faces()), a.shared_vertices());
    let path = run_work(move |progress| {
        progress.begin_phase("minimising energy", 0.0, 1.0);
        geodesic(&faces, &start, &moved, &params, progress)
    })?;
    write_files(pose_files(a.faces(), &path.poses, &args.out)?).map_err(CliError::Unusable)?;
    report(&path, args)?;
    // The best so far is written and reported, but it is not what was asked for.
    if path.stopped {
        Err(Stopped.into())
    } else {
        Ok(())
    }
}

fn checked(args: &InterpolateArgs) -> Result<CheckedGeodesicParams, CliError> {
    let default = GeodesicParams::default();
    let params = GeodesicParams {
        metric: args.metric.of_paths(),
        interpolated_poses: args.poses,
        tolerance: args.tolerance.unwrap_or(default.tolerance),
        ..default
    };
    let checked = params.check();
    checked.map_err(|error| CliError::Usage(error.to_string()))
}

fn report(path: &GeodesicPath, args: &InterpolateArgs) -> Result<(), CliError> {
    if args.json {
        return print_json(&json!({
            "energy_linear": path.energy_linear,
            "energy": path.energy,
            "iterations": path.iterations,
            "self_intersections": path.self_intersections,
            "step_lengths": path.step_lengths,
            "converged": path.converged,
            "straight_line": path.fell_back,
        }));
    }
    print(&format!(
        "energy {} (linear interpolation {}), {} iterations{}, {} pairs of faces intersect: {}",
        path.energy,
        path.energy_linear,
        path.iterations,
        match (path.converged, path.fell_back) {
            (true, _) => "",
            (false, true) => ", nothing cheaper found: the straight line, not a geodesic",
            (false, false) => ", not converged",
        },
        path.self_intersections,
        args.out.display()
    ))
}

/// `pose_000.ply`, `pose_001.ply`, … in a folder.
///
/// # Errors
/// If a pose is no mesh, which no analysis returns.
pub(super) fn pose_files(
    faces: &Arc<Faces>,
    poses: &[Vec<Point3>],
    folder: &Path,
) -> Result<Vec<ExportFile>, CliError> {
    let width = (poses.len().saturating_sub(1)).to_string().len().max(3);
    (poses.iter().enumerate())
        .map(|(index, pose)| {
            let mesh = TriMesh::new(pose.as_slice(), Arc::clone(faces));
            let mut bytes = Vec::new();
            write_ply(&mut bytes, &mesh.map_err(CliError::unusable)?)
                .map_err(CliError::unusable)?;
            Ok(ExportFile {
                path: folder.join(format!("pose_{index:0width$}.ply")),
                bytes: bytes.into(),
            })
        })
        .collect()
}
