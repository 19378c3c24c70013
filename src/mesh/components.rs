//! Sheets of a surface: faces joined across edges, wound the same way round.

use std::collections::VecDeque;

use rayon::prelude::*;

use super::{Edge, Faces};

/// Why a surface has no inside.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SheetError {
    /// More than two faces meet on an edge, so that the surface branches.
    #[error("{edges} edges have more than two faces, the first between vertices {from} and {to}")]
    Branches {
        /// How many such edges.
        edges: usize,
        /// Lower vertex of the first.
        from: u32,
        /// Its other vertex.
        to: u32,
    },
    /// A sheet has only one side, as a Möbius strip.
    #[error("the surface has only one side: its faces cannot be wound the same way round")]
    OneSided,
}

/// One sheet: faces that are connected, with consistent winding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sheet {
    /// Indices of its faces in the surface, ascending.
    pub faces: Vec<usize>,
    /// Its triangles in that order, all wound as the first face is in the surface.
    pub triangles: Vec<[u32; 3]>,
    /// How many faces had to be turned round.
    pub turned: usize,
}

/// Splits a surface into sheets of faces joined across edges, in the order of their first face,
/// and turns faces round until neighbours agree: neighbours run along their edge in opposite
/// directions.
///
/// # Errors
/// If the surface branches or has only one side.
pub fn sheets(faces: &Faces) -> Result<Vec<Sheet>, SheetError> {
    let triangles = faces.triangles();
    let neighbours = neighbours(triangles)?;
    let mut turned: Vec<Option<bool>> = vec![None; triangles.len()];
    let mut found = Vec::new();
    for start in 0..triangles.len() {
        if turned[start].is_some() {
            continue;
        }
        turned[start] = Some(false);
        let mut members = vec![start];
        let mut queue = VecDeque::from([start]);
        while let Some(face) = queue.pop_front() {
            let here = turned[face] == Some(true);
            for &(other, same_direction) in neighbours[face].iter().flatten() {
                let there = here != same_direction;
                match turned[other] {
                    None => {
                        turned[other] = Some(there);
                        members.push(other);
                        queue.push_back(other);
                    }
                    Some(known) if known != there => return Err(SheetError::OneSided),
                    Some(_) => {}
                }
            }
        }
        members.sort_unstable();
        let wound = |&face: &usize| {
            let [a, b, c] = triangles[face];
            if turned[face] == Some(true) {
                [a, c, b]
            } else {
                [a, b, c]
            }
        };
        found.push(Sheet {
            triangles: members.iter().map(wound).collect(),
            turned: members.iter().filter(|&&f| turned[f] == Some(true)).count(),
            faces: members,
        });
    }
    Ok(found)
}

/// A face across an edge, and whether both run along it in the same direction.
type Neighbour = (usize, bool);

/// The faces across the three sides of each face.
fn neighbours(triangles: &[[u32; 3]]) -> Result<Vec<[Option<Neighbour>; 3]>, SheetError> {
    // (edge, whether the side runs upwards, face, side)
    let mut sides: Vec<(Edge, bool, usize, usize)> = Vec::with_capacity(3 * triangles.len());
    for (face, &[a, b, c]) in triangles.iter().enumerate() {
        for (side, [from, to]) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
            sides.push(([from.min(to), from.max(to)], from < to, face, side));
        }
    }
    sides.par_sort_unstable();
    let mut neighbours = vec![[None; 3]; triangles.len()];
    let mut branching = Vec::new();
    for run in sides.chunk_by(|a, b| a.0 == b.0) {
        match *run {
            [_] => {}
            [(_, up, face, side), (_, other_up, other, other_side)] => {
                let same_direction = up == other_up;
                neighbours[face][side] = Some((other, same_direction));
                neighbours[other][other_side] = Some((face, same_direction));
            }
            _ => branching.push(run[0].0),
        }
    }
    match branching.first() {
        Some(&[from, to]) => Err(SheetError::Branches {
            edges: branching.len(),
            from,
            to,
        }),
        None => Ok(neighbours),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    #[test]
    fn a_sphere_is_one_sheet_and_two_spheres_are_two() {
        let sphere = phantom::sphere(2, 1.0);
        assert_eq!(sheets(sphere.faces()).unwrap().len(), 1);
        let both = Faces::joined(&[sphere.faces(), sphere.faces()]);
        let found = sheets(&both).unwrap();
        assert_eq!(found.len(), 2);
        assert_eq!(found[1].faces.len(), sphere.triangles().len());
    }

    #[test]
    fn faces_that_were_turned_round_are_turned_back() {
        let sphere = phantom::sphere(2, 1.0);
        let mut triangles = sphere.triangles().to_vec();
        for face in [3, 17, 100] {
            triangles[face].swap(1, 2);
        }
        let damaged = Faces::new(sphere.vertices().len(), triangles).unwrap();
        let found = sheets(&damaged).unwrap();
        assert_eq!(found[0].turned, 3);
        let mut directed: Vec<_> = Faces::new(sphere.vertices().len(), found[0].triangles.clone())
            .unwrap()
            .directed_edges()
            .collect();
        directed.sort_unstable();
        assert!(directed.windows(2).all(|pair| pair[0] != pair[1]));
    }

    #[test]
    fn a_moebius_strip_has_one_side() {
        // Five vertices: faces (i, i+1, i+2) modulo 5 make a strip with a half twist.
        let strip = (0..5).map(|i| [i, (i + 1) % 5, (i + 2) % 5]).collect();
        let faces = Faces::new(5, strip).unwrap();
        assert_eq!(sheets(&faces), Err(SheetError::OneSided));
    }

    #[test]
    fn three_faces_on_an_edge_branch() {
        let faces = Faces::new(5, vec![[0, 1, 2], [0, 1, 3], [1, 0, 4]]).unwrap();
        assert_eq!(
            sheets(&faces),
            Err(SheetError::Branches {
                edges: 1,
                from: 0,
                to: 1
            })
        );
    }
}
