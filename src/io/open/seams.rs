//! Seams: a surface that another program cut open, for a texture or to give each face normals of its own, is joined again.

use std::collections::HashMap;
use std::sync::Arc;

use crate::mesh::{Faces, TriMesh, sheets};
use crate::study::checks::counted;
use crate::study::{Notice, SurfaceKind};

/// The frames with their seams joined, and what the load report says of it.
///
/// A seam runs where two boundary edges coincide exactly in all frames: their vertices become one. Left open, each
/// piece would be closed by lids of its own, and the volume would be that of what lies between surface and lids. Vertices
/// that only meet, as two openings do in one point, stay apart, and so do the two sheets of a wall along their common rim.
pub(super) fn without_seams(
    kind: SurfaceKind,
    frames: Vec<TriMesh>,
) -> (Vec<TriMesh>, Option<Notice>) {
    let Some((joined, kept)) = joined_vertices(&frames) else {
        return (frames, None);
    };
    let two_sheets = || frames.first().and_then(|mesh| sheets(mesh.faces()).ok());
    let may_be_wall = matches!(kind, SurfaceKind::Wall | SurfaceKind::Other);
    if may_be_wall && two_sheets().is_some_and(|sheets| sheets.len() == 2) {
        return (frames, None);
    }
    let Some(whole) = renumbered(&frames, &joined, &kept) else {
        return (frames, None);
    };
    let text = format!(
        "{}: {} along seams joined with those at the same places in all frames; vertices are numbered anew",
        kind.name(),
        counted(joined.len() - kept.len(), "vertex", "vertices")
    );
    (whole, Some(Notice::info(text)))
}

/// For each vertex the number that it gets, and the vertices that are left, ascending; `None` where nothing is joined.
fn joined_vertices(frames: &[TriMesh]) -> Option<(Vec<u32>, Vec<u32>)> {
    let faces = frames.first()?.faces();
    let count = faces.vertex_count();
    if frames.iter().any(|mesh| mesh.vertices().len() != count) {
        return None;
    }
    let rims = &faces.borders().rims;
    // Vertices of boundaries that are at one place in all frames so far have the same number.
    let mut places = vec![0_u32; count];
    let on_rims = || rims.iter().flatten().map(|&vertex| vertex as usize);
    for mesh in frames {
        let mut seen: HashMap<(u32, [u64; 3]), u32> = HashMap::new();
        let mut next = vec![None; count];
        for vertex in on_rims() {
            let point = mesh.vertices()[vertex];
            let bits = [point.x, point.y, point.z].map(|x| (x + 0.0).to_bits());
            let fresh = seen.len() as u32;
            next[vertex] = Some(*seen.entry((places[vertex], bits)).or_insert(fresh));
        }
        for (place, next) in places.iter_mut().zip(next) {
            *place = next.unwrap_or_default();
        }
    }
    let edge = |[a, b]: [u32; 2]| {
        let [a, b] = [places[a as usize], places[b as usize]];
        [a.min(b), a.max(b)]
    };
    let mut upon_each_other: HashMap<[u32; 2], usize> = HashMap::new();
    for &rim in rims {
        *upon_each_other.entry(edge(rim)).or_default() += 1;
    }
    let mut first_at: HashMap<u32, u32> = HashMap::new();
    let mut joined: Vec<u32> = (0..count as u32).collect();
    let mut on_seams: Vec<u32> = (rims.iter())
        .filter(|&&rim| upon_each_other.get(&edge(rim)).is_some_and(|&n| n > 1))
        .flatten()
        .copied()
        .collect();
    on_seams.sort_unstable();
    for vertex in on_seams {
        let first = first_at.entry(places[vertex as usize]).or_insert(vertex);
        joined[vertex as usize] = *first;
    }
    let kept: Vec<u32> = (0..count as u32)
        .filter(|&vertex| joined[vertex as usize] == vertex)
        .collect();
    if kept.len() == count {
        return None;
    }
    let mut numbers = vec![0; count];
    for (number, &vertex) in kept.iter().enumerate() {
        numbers[vertex as usize] = number as u32;
    }
    let joined = joined.iter().map(|&first| numbers[first as usize]);
    Some((joined.collect(), kept))
}

/// The frames with these numbers; `None` where nothing would be left of the faces.
fn renumbered(frames: &[TriMesh], joined: &[u32], kept: &[u32]) -> Option<Vec<TriMesh>> {
    let mut known: Option<(&Arc<Faces>, Arc<Faces>)> = None;
    let mut whole = Vec::with_capacity(frames.len());
    for mesh in frames {
        let faces = match &known {
            Some((before, faces)) if *before == mesh.faces() => Arc::clone(faces),
            _ => {
                // A face between the two sides of a seam has no area.
                let triangles = (mesh.triangles().iter())
                    .map(|triangle| triangle.map(|vertex| joined[vertex as usize]))
                    .filter(|[a, b, c]| a != b && b != c && a != c);
                let faces = Arc::new(Faces::new(kept.len(), triangles.collect()).ok()?);
                known = Some((mesh.faces(), Arc::clone(&faces)));
                faces
            }
        };
        let points = kept.iter().map(|&vertex| mesh.vertices()[vertex as usize]);
        let points: Vec<_> = points.collect();
        whole.push(TriMesh::new(points, faces).ok()?);
    }
    let empty = whole.iter().any(|mesh| mesh.triangles().is_empty());
    (!empty).then_some(whole)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{CappedSheet, Point3, phantom};

    /// The frames of a bowl that shrinks, with corners of their own for faces that `piece` tells apart.
    fn cut(piece: impl Fn(usize, &[Point3; 3]) -> usize) -> Vec<TriMesh> {
        let bowl = phantom::bowl(30.0, 6, 12);
        let mut number_of: HashMap<(usize, u32), u32> = HashMap::new();
        let mut old = Vec::new();
        let mut triangles = Vec::new();
        for (face, triangle) in bowl.triangles().iter().enumerate() {
            let piece = piece(face, &triangle.map(|v| bowl.vertices()[v as usize]));
            triangles.push(triangle.map(|vertex| {
                *number_of.entry((piece, vertex)).or_insert_with(|| {
                    old.push(vertex);
                    old.len() as u32 - 1
                })
            }));
        }
        let faces = Arc::new(Faces::new(old.len(), triangles).unwrap());
        let frame = |scale: f64| {
            let points = old.iter().map(|&v| bowl.vertices()[v as usize] * scale);
            TriMesh::new(points.collect::<Vec<_>>(), Arc::clone(&faces)).unwrap()
        };
        vec![frame(1.0), frame(0.8)]
    }

    fn volume(mesh: &TriMesh) -> f64 {
        let volume = |sheet| {
            let capped = CappedSheet::new(mesh.vertices().len(), sheet).unwrap();
            capped.signed_volume(mesh.vertices())
        };
        sheets(mesh.faces()).unwrap().iter().map(volume).sum()
    }

    #[test]
    fn a_bowl_that_was_cut_has_the_volume_of_the_whole() {
        let bowl = phantom::bowl(30.0, 6, 12);
        let quarter = |_: usize, corners: &[Point3; 3]| {
            let middle = corners
                .iter()
                .fold([0.0, 0.0], |[x, y], p| [x + p.x, y + p.y]);
            usize::from(middle[0] > 0.0) + 2 * usize::from(middle[1] > 0.0)
        };
        for (what, frames) in [
            ("each face", cut(|face, _| face)),
            ("quarters", cut(quarter)),
        ] {
            assert!(volume(&frames[0]) < 0.6 * volume(&bowl), "{what}");
            let (whole, notice) = without_seams(SurfaceKind::Endocardium, frames);
            assert_eq!(whole[0].vertices().len(), bowl.vertices().len(), "{what}");
            for (mesh, scale) in whole.iter().zip([1.0, 0.8_f64]) {
                let expected = volume(&bowl) * scale.powi(3);
                assert!((volume(mesh) / expected - 1.0).abs() < 1e-12, "{what}");
                assert_eq!(mesh.faces().boundary_loops().len(), 1);
            }
            assert!(Arc::ptr_eq(whole[0].faces(), whole[1].faces()));
            assert!(notice.unwrap().text.contains("along seams joined"));
        }
    }

    #[test]
    fn what_only_meets_or_parts_again_stays_apart() {
        let whole = cut(|_, _| 0);
        assert_eq!(
            without_seams(SurfaceKind::Endocardium, whole.clone()),
            (whole, None)
        );
        // In the second frame the pieces lie apart.
        let mut parted = cut(|face, _| face);
        let points: Vec<Point3> = (parted[1].vertices().iter().enumerate())
            .map(|(k, p)| Point3::new(p.x, p.y, p.z + k as f64))
            .collect();
        parted[1] = TriMesh::new(points, Arc::clone(parted[1].faces())).unwrap();
        assert_eq!(
            without_seams(SurfaceKind::Other, parted.clone()),
            (parted, None)
        );
        // Two triangles that share a corner and no edge.
        let points = [
            [0.0, 0.0],
            [1.0, 0.0],
            [0.0, 1.0],
            [0.0, 0.0],
            [-1.0, 0.0],
            [0.0, -1.0],
        ];
        let points: Vec<Point3> = points.map(|[x, y]| Point3::new(x, y, 0.0)).into();
        let faces = Faces::new(6, vec![[0, 1, 2], [3, 4, 5]]).unwrap();
        let bow_tie = vec![TriMesh::new(points, faces).unwrap()];
        assert_eq!(
            without_seams(SurfaceKind::Other, bow_tie.clone()),
            (bow_tie, None)
        );
    }

    #[test]
    fn the_sheets_of_a_wall_keep_their_rims() {
        let (inner, outer) = (phantom::bowl(20.0, 6, 12), phantom::bowl(20.0, 6, 12));
        let faces = Faces::joined(&[inner.faces(), outer.faces()]);
        let lower = outer.vertices().iter();
        let lower =
            lower.map(|p| Point3::new(p.x, p.y, if p.z.abs() < 1e-9 { p.z } else { 1.5 * p.z }));
        let points: Vec<Point3> = inner.vertices().iter().copied().chain(lower).collect();
        let wall = vec![TriMesh::new(points, faces).unwrap()];
        assert_eq!(without_seams(SurfaceKind::Wall, wall.clone()), (wall, None));
    }
}
