//! The meshes of the scene, each where its nodes put it.

use std::collections::HashSet;

use gltf::mesh::Mode;
use gltf::{Document, Node, Primitive};
use nalgebra::{Matrix3, Matrix4};

use super::accessors::{Accessors, all_zero};
use super::buffers::in_item;
use crate::io::mesh_draft::{check_count, missing_vertex};
use crate::io::{Limits, ReadMeshError};
use crate::mesh::{Point3, Vector3};

/// A mesh at a node.
pub(super) struct PlacedMesh {
    /// The node, to which animations refer.
    pub(super) node: usize,
    /// Points and displacements per target, in scene coordinates.
    pub(super) parts: Vec<PlacedPart>,
    /// Number of morph targets of the mesh.
    pub(super) targets: usize,
}

/// The primitives of a mesh that have the same points.
pub(super) struct PlacedPart {
    /// Accessors of the positions and of those of each morph target.
    accessors: Vec<Option<usize>>,
    pub(super) points: Vec<Point3>,
    /// One list of displacements per morph target; empty if the target moves nothing.
    pub(super) displacements: Vec<Vec<Vector3>>,
    /// Of each primitive.
    pub(super) corners: Vec<Corners>,
    pub(super) mirrored: bool,
    /// Path of the first primitive, for errors.
    pub(super) item: String,
}

/// How the corners of a primitive make triangles.
pub(super) enum Corners {
    /// Three each.
    Triangles(Vec<u32>),
    /// Each with the two before it.
    Strip(Vec<u32>),
    /// All around the first.
    Fan(Vec<u32>),
}

/// The meshes found, and how many primitives are points or lines.
#[derive(Default)]
pub(super) struct SceneMeshes {
    pub(super) meshes: Vec<PlacedMesh>,
    pub(super) points_and_lines: usize,
    pub(super) skinned: usize,
    parts: u64,
    /// Meshes that were placed, and faces of those placed again.
    placed: HashSet<usize>,
    repeated_faces: u64,
    vertices: u64,
    faces: u64,
    moved_vertices: u64,
}

/// Walks the default scene, else the first, else all nodes that have no parent.
pub(super) fn scene_meshes(
    document: &Document,
    accessors: &Accessors<'_>,
    limits: &Limits,
) -> Result<SceneMeshes, ReadMeshError> {
    let scene = document
        .default_scene()
        .or_else(|| document.scenes().next());
    let roots: Vec<Node<'_>> = match scene {
        Some(scene) => scene.nodes().collect(),
        None => {
            let mut has_parent = vec![false; document.nodes().len()];
            for child in document.nodes().flat_map(|node| node.children()) {
                has_parent[child.index()] = true;
            }
            document
                .nodes()
                .filter(|node| !has_parent[node.index()])
                .collect()
        }
    };
    let mut found = SceneMeshes::default();
    let mut visited = vec![false; document.nodes().len()];
    let mut pending: Vec<_> = roots
        .into_iter()
        .map(|node| (node, Matrix4::identity()))
        .collect();
    pending.reverse();
    while let Some((node, scene_from_parent)) = pending.pop() {
        if std::mem::replace(&mut visited[node.index()], true) {
            let reason = "a node with two parents, or its own ancestor";
            return Err(in_item(format!("nodes[{}]", node.index()), reason));
        }
        let scene_from_node = scene_from_parent * parent_from_node(&node);
        found.skinned += usize::from(node.skin().is_some());
        found.add(&node, &scene_from_node, accessors, limits)?;
        let children: Vec<_> = node.children().collect();
        pending.extend(
            children
                .into_iter()
                .rev()
                .map(|child| (child, scene_from_node)),
        );
    }
    Ok(found)
}

fn parent_from_node(node: &Node<'_>) -> Matrix4<f64> {
    let columns = node.transform().matrix();
    Matrix4::from_fn(|row, column| f64::from(columns[column][row]))
}

impl SceneMeshes {
    fn add(
        &mut self,
        node: &Node<'_>,
        scene_from_node: &Matrix4<f64>,
        accessors: &Accessors<'_>,
        limits: &Limits,
    ) -> Result<(), ReadMeshError> {
        let Some(mesh) = node.mesh() else {
            return Ok(());
        };
        let again = !self.placed.insert(mesh.index());
        let faces_before = self.faces;
        let mut placed = PlacedMesh {
            node: node.index(),
            parts: Vec::new(),
            targets: 0,
        };
        for primitive in mesh.primitives() {
            let item = format!("meshes[{}].primitives[{}]", mesh.index(), primitive.index());
            let sort = match primitive.mode() {
                Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip => {
                    self.points_and_lines += 1;
                    continue;
                }
                Mode::Triangles => Corners::Triangles,
                Mode::TriangleStrip => Corners::Strip,
                Mode::TriangleFan => Corners::Fan,
            };
            self.parts += 1;
            check_count("parts of the scene", self.parts, limits.placed_parts)?;
            let same = accessors_of(&primitive, &item)?;
            let before = placed.parts.iter_mut().find(|part| part.accessors == same);
            if let Some(part) = before {
                let corners =
                    self.corners(&primitive, part.points.len(), accessors, limits, &item)?;
                part.corners.push(sort(corners));
                continue;
            }
            let mut part = self.part(&primitive, scene_from_node, accessors, limits, &item)?;
            let corners = self.corners(&primitive, part.points.len(), accessors, limits, &item)?;
            part.corners.push(sort(corners));
            part.accessors = same;
            let targets = part.displacements.len();
            if !placed.parts.is_empty() && targets != placed.targets {
                let reason = format!("{targets} morph targets, but {} before", placed.targets);
                return Err(in_item(part.item, reason));
            }
            placed.targets = targets;
            placed.parts.push(part);
        }
        if again {
            self.repeated_faces += self.faces - faces_before;
            let what = "faces of meshes that are placed again";
            check_count(what, self.repeated_faces, limits.repeated_faces())?;
        }
        if !placed.parts.is_empty() {
            self.meshes.push(placed);
        }
        Ok(())
    }

    /// Points and displacements; corners are still to come.
    fn part(
        &mut self,
        primitive: &Primitive<'_>,
        scene_from_node: &Matrix4<f64>,
        accessors: &Accessors<'_>,
        limits: &Limits,
        item: &str,
    ) -> Result<PlacedPart, ReadMeshError> {
        let positions = primitive.get(&gltf::Semantic::Positions);
        let positions = positions.ok_or_else(|| in_item(item, "has no POSITION"))?;
        self.vertices = self.vertices.saturating_add(positions.count() as u64);
        check_count("vertices", self.vertices, limits.vertices)?;
        let points = accessors.vectors(&positions)?;
        let linear: Matrix3<f64> = scene_from_node.fixed_view::<3, 3>(0, 0).into_owned();
        let targets = primitive.morph_targets();
        check_count("morph targets", targets.len() as u64, limits.frames)?;
        let mut displacements = Vec::new();
        for target in targets {
            let Some(accessor) = target.positions() else {
                displacements.push(Vec::new());
                continue;
            };
            if accessor.count() != points.len() {
                let reason = format!(
                    "{} displacements for {} points",
                    accessor.count(),
                    points.len()
                );
                return Err(accessors.error(&accessor, &reason));
            }
            if all_zero(&accessor) {
                displacements.push(Vec::new());
                continue;
            }
            self.moved_vertices += points.len() as u64;
            let most = limits.vertices_of_all_frames;
            check_count("vertices of all morph targets", self.moved_vertices, most)?;
            let vectors = accessors.vectors(&accessor)?;
            displacements.push(
                vectors
                    .into_iter()
                    .map(|v| linear * Vector3::from(v))
                    .collect(),
            );
        }
        let move_by = Vector3::new(
            scene_from_node[(0, 3)],
            scene_from_node[(1, 3)],
            scene_from_node[(2, 3)],
        );
        Ok(PlacedPart {
            accessors: Vec::new(),
            points: points
                .into_iter()
                .map(|xyz| Point3::from(linear * Vector3::from(xyz) + move_by))
                .collect(),
            displacements,
            corners: Vec::new(),
            mirrored: linear.determinant() < 0.0,
            item: item.to_owned(),
        })
    }

    fn corners(
        &mut self,
        primitive: &Primitive<'_>,
        points: usize,
        accessors: &Accessors<'_>,
        limits: &Limits,
        item: &str,
    ) -> Result<Vec<u32>, ReadMeshError> {
        let indices = primitive.indices();
        let corners = indices.as_ref().map_or(points, gltf::Accessor::count);
        let faces = match primitive.mode() {
            Mode::Triangles => corners / 3,
            _ => corners,
        };
        self.faces = self.faces.saturating_add(faces as u64);
        check_count("faces", self.faces, limits.faces)?;
        match indices {
            Some(indices) => vertex_indices(&accessors.scalars(&indices)?, points, item),
            None => Ok((0..points as u32).collect()),
        }
    }
}

/// What makes the points of a primitive: primitives of one mesh that share it share their vertices.
fn accessors_of(
    primitive: &Primitive<'_>,
    item: &str,
) -> Result<Vec<Option<usize>>, ReadMeshError> {
    let positions = primitive.get(&gltf::Semantic::Positions);
    let positions = positions.ok_or_else(|| in_item(item, "has no POSITION"))?;
    let targets = primitive.morph_targets();
    let of_targets = targets.map(|target| target.positions().map(|accessor| accessor.index()));
    Ok([Some(positions.index())]
        .into_iter()
        .chain(of_targets)
        .collect())
}

fn vertex_indices(values: &[f64], points: usize, item: &str) -> Result<Vec<u32>, ReadMeshError> {
    values
        .iter()
        .map(|&value| {
            if value.fract() == 0.0 && value >= 0.0 && value < points as f64 {
                Ok(value as u32)
            } else {
                Err(in_item(item, missing_vertex(value as u64, points, 0)))
            }
        })
        .collect()
}
