//! Reading a glTF file from its bytes to its frames.

use super::accessors::Accessors;
use super::animation::read_animations;
use super::buffers::load_buffers;
use super::container::open;
use super::frames::make_frames;
use super::scene::scene_meshes;
use crate::io::mesh_draft::MeshDraft;
use crate::io::{Limits, MeshFile, ReadMeshError};
use crate::study::Notice;

/// Reads all meshes of the scene as one surface, with node transforms applied.
pub(crate) fn read_gltf(
    bytes: &[u8],
    limits: &Limits,
    sibling: &dyn Fn(&str) -> Option<Vec<u8>>,
) -> Result<MeshFile, ReadMeshError> {
    let container = open(bytes)?;
    let document = &container.document;
    let buffers = load_buffers(document, container.binary_chunk, limits, sibling)?;
    let accessors = Accessors { buffers: &buffers };
    let scene = scene_meshes(document, &accessors, limits)?;
    let mut targets = vec![0; document.nodes().len()];
    for mesh in &scene.meshes {
        targets[mesh.node] = mesh.targets;
    }
    let animations = read_animations(document, &accessors, limits, &|node| targets[node])?;
    let mut draft = MeshDraft::new(limits, 0);
    if container.bytes_behind > 0 {
        draft.notice(Notice::warning(format!(
            "{} bytes behind the length that the header gives ignored",
            container.bytes_behind
        )));
    }
    draft.skip_points_and_lines(scene.points_and_lines);
    if scene.meshes.len() > 1 {
        let text = format!("{} meshes joined into one surface", scene.meshes.len());
        draft.notice(Notice::info(text));
    }
    if scene.skinned > 0 {
        draft.notice(Notice::warning(format!(
            "{} skinned meshes in their rest pose: skins are not read",
            scene.skinned
        )));
    }
    if animations.left_out > 0 {
        draft.notice(Notice::warning(format!(
            "{} animation channels ignored: only the first animation's weights of morph targets are read",
            animations.left_out
        )));
    }
    make_frames(&scene.meshes, &animations.tracks, limits, draft)
}
