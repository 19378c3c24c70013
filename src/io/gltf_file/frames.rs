//! The frames of a glTF file: one, one per morph target, or one per key of its animation.

use std::collections::HashMap;

use super::animation::{WeightTrack, key_times_s};
use super::buffers::in_item;
use super::scene::{Corners, PlacedMesh, PlacedPart};
use crate::io::limits::MAX_DISPLACEMENTS;
use crate::io::mesh_draft::{FilePosition, MeshDraft, check_count};
use crate::io::{Limits, MeshFile, ReadMeshError};
use crate::mesh::{Point3, TriMesh};
use crate::study::Notice;

/// Which weights each frame gives the morph targets.
enum Beat<'a> {
    /// Frame 0 without any, then each target alone at full weight.
    Targets(usize),
    /// As the tracks of these nodes say at these times.
    Keys(HashMap<usize, &'a WeightTrack>, Vec<f64>),
}

impl Beat<'_> {
    fn frame_count(&self) -> usize {
        match self {
            Self::Targets(targets) => targets + 1,
            Self::Keys(_, times_s) => times_s.len(),
        }
    }

    /// Weights of a mesh's targets in one frame; missing ones are zero.
    fn weights(&self, mesh: &PlacedMesh, frame: usize) -> Vec<f64> {
        match self {
            Self::Targets(_) => {
                let mut weights = vec![0.0; mesh.targets];
                if let Some(weight) = frame.checked_sub(1).and_then(|at| weights.get_mut(at)) {
                    *weight = 1.0;
                }
                weights
            }
            Self::Keys(tracks, times_s) => tracks
                .get(&mesh.node)
                .map(|track| track.weights_at(times_s[frame]))
                .unwrap_or_default(),
        }
    }
}

/// Makes the frames of all meshes joined into one surface; `draft` holds the notes so far.
pub(super) fn make_frames(
    meshes: &[PlacedMesh],
    tracks: &[WeightTrack],
    limits: &Limits,
    mut draft: MeshDraft,
) -> Result<MeshFile, ReadMeshError> {
    let beat = beat(meshes, tracks)?;
    let frames = beat.frame_count();
    check_count("frames", frames as u64, limits.frames)?;
    let parts = || meshes.iter().flat_map(|mesh| &mesh.parts);
    let vertices: usize = parts().map(|part| part.points.len()).sum();
    check_count(
        "vertices of all frames",
        frames as u64 * vertices as u64,
        limits.vertices_of_all_frames,
    )?;
    if let (Beat::Targets(targets), true) = (&beat, frames > 1) {
        draft.notice(Notice::info(format!(
            "frame 0 is the mesh, frames 1 to {targets} each one of its morph targets at full weight"
        )));
    }
    let mut first_point = 0;
    let mut added = 0;
    let mut points = frame_points(meshes, &beat, 0, &mut added)?.into_iter();
    for part in parts() {
        for (at, point) in points.by_ref().take(part.points.len()).enumerate() {
            let xyz = [point.x, point.y, point.z];
            draft
                .point(xyz, FilePosition::Byte(0))
                .map_err(|error| in_part(error, part, at))?;
        }
        add_faces(&mut draft, part, first_point)?;
        first_point += part.points.len() as u32;
    }
    let (first, notices) = draft.finish_mesh()?;
    let mut meshes_over_time = vec![first.clone()];
    for frame in 1..frames {
        let points = frame_points(meshes, &beat, frame, &mut added)?;
        meshes_over_time.push(
            TriMesh::new(points, first.faces().clone())
                .map_err(|error| in_item(format!("frame {frame}"), error.to_string()))?,
        );
    }
    Ok(MeshFile {
        frames: meshes_over_time,
        times_s: match beat {
            Beat::Keys(_, times_s) => Some(times_s),
            Beat::Targets(_) => None,
        },
        notices,
    })
}

/// Points have no line or byte of their own once they are placed: errors name the primitive.
fn in_part(error: ReadMeshError, part: &PlacedPart, vertex: usize) -> ReadMeshError {
    match error {
        ReadMeshError::AtByte { reason, .. } => {
            in_item(&part.item, format!("vertex {vertex}: {reason}"))
        }
        other => other,
    }
}

fn beat<'a>(meshes: &[PlacedMesh], tracks: &'a [WeightTrack]) -> Result<Beat<'a>, ReadMeshError> {
    if !tracks.is_empty() {
        let of_nodes = tracks.iter().rev().map(|track| (track.node, track));
        return Ok(Beat::Keys(of_nodes.collect(), key_times_s(tracks)));
    }
    let mut moving = meshes.iter().filter(|mesh| mesh.targets > 0);
    let Some(first) = moving.next() else {
        return Ok(Beat::Targets(0));
    };
    if let Some(other) = moving.find(|mesh| mesh.targets != first.targets) {
        let reason = format!(
            "{} morph targets, but nodes[{}] has {}, and no animation says which belong together",
            other.targets, first.node, first.targets
        );
        return Err(in_item(format!("nodes[{}]", other.node), reason));
    }
    Ok(Beat::Targets(first.targets))
}

/// The points of a frame; `added` counts the displacements of all frames so far.
fn frame_points(
    meshes: &[PlacedMesh],
    beat: &Beat<'_>,
    frame: usize,
    added: &mut u64,
) -> Result<Vec<Point3>, ReadMeshError> {
    let mut points = Vec::new();
    for mesh in meshes {
        let weights = beat.weights(mesh, frame);
        for part in &mesh.parts {
            let start = points.len();
            points.extend_from_slice(&part.points);
            for (displacements, &weight) in part.displacements.iter().zip(&weights) {
                if weight != 0.0 {
                    *added += displacements.len() as u64;
                    check_count("displacements of all frames", *added, MAX_DISPLACEMENTS)?;
                    for (point, displacement) in points[start..].iter_mut().zip(displacements) {
                        *point += displacement * weight;
                    }
                }
            }
        }
    }
    Ok(points)
}

/// Adds the triangles of a part. A mirroring node turns them over (glTF 2.0, section 3.7.4), so
/// that their outer side stays outside.
fn add_faces(
    draft: &mut MeshDraft,
    part: &PlacedPart,
    first_point: u32,
) -> Result<(), ReadMeshError> {
    let mut add = |a: u32, b: u32, c: u32| {
        let [a, b, c] = [a, b, c].map(|corner| corner + first_point);
        let corners = if part.mirrored { [a, c, b] } else { [a, b, c] };
        draft.polygon(&corners, FilePosition::Byte(0))
    };
    for corners in &part.corners {
        match corners {
            Corners::Triangles(corners) => {
                if corners.len() % 3 != 0 {
                    let reason = format!("{} corners are not a multiple of three", corners.len());
                    return Err(in_item(&part.item, reason));
                }
                for three in corners.chunks_exact(3) {
                    add(three[0], three[1], three[2])?;
                }
            }
            Corners::Strip(corners) => {
                for (at, three) in corners.windows(3).enumerate() {
                    let (b, c) = if at % 2 == 0 { (1, 2) } else { (2, 1) };
                    add(three[0], three[b], three[c])?;
                }
            }
            Corners::Fan(corners) => {
                if let [first, rest @ ..] = corners.as_slice() {
                    for pair in rest.windows(2) {
                        add(*first, pair[0], pair[1])?;
                    }
                }
            }
        }
    }
    Ok(())
}
