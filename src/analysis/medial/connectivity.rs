//! Connectivity of all surfaces of a wall as one mesh, prepared once for all frames.

use std::collections::HashMap;

use rayon::prelude::*;

use crate::mesh::{Faces, MeshError, Point3, TriMesh, sheets};

/// All surfaces one after the other, the template first: seams closed, sheets wound alike.
#[derive(Clone, Debug)]
pub(super) struct Connectivity {
    /// First vertex of each surface, and the number of all vertices at the end.
    pub offsets: Vec<u32>,
    /// The vertex that stands for each vertex: itself, but at closed seams.
    pub representative: Vec<u32>,
    /// Triangles over representatives.
    pub triangles: Vec<[u32; 3]>,
    /// Where each sheet's triangles begin, and the number of all triangles at the end.
    pub sheet_starts: Vec<usize>,
    /// The surface of each sheet.
    pub sheet_surfaces: Vec<usize>,
    /// Neighbours of each vertex along edges.
    pub rows: Rows,
    /// Whether a vertex lies on an edge of a single face.
    pub boundary: Vec<bool>,
}

/// Neighbours of vertices, with the places of each triangle's sides among them.
#[derive(Clone, Debug, Default)]
pub(super) struct Rows {
    /// Where each vertex's neighbours begin, and the number of all at the end.
    pub starts: Vec<u32>,
    /// Neighbours, ascending for each vertex.
    pub neighbours: Vec<u32>,
    /// Whether the edge to that neighbour has a single face.
    pub single: Vec<bool>,
    /// For side k of a triangle, from corner k to k + 1: the entry of its end in the row of its start, and of its start
    /// in the row of its end.
    pub sides: Vec<[[u32; 2]; 3]>,
}

impl Rows {
    /// Entries of a vertex.
    pub fn of(&self, vertex: usize) -> std::ops::Range<usize> {
        self.starts[vertex] as usize..self.starts[vertex + 1] as usize
    }

    fn new(vertex_count: usize, triangles: &[[u32; 3]]) -> Self {
        let mut starts = vec![0_u32; vertex_count + 1];
        for &corner in triangles.iter().flatten() {
            starts[corner as usize + 1] += 2;
        }
        for vertex in 0..vertex_count {
            starts[vertex + 1] += starts[vertex];
        }
        // Every corner has two neighbours in its face; counting first makes one array do for all rows.
        let mut crowd = vec![0_u32; 6 * triangles.len()];
        let mut next = starts.clone();
        for &[a, b, c] in triangles {
            for (from, others) in [(a, [b, c]), (b, [c, a]), (c, [a, b])] {
                let place = &mut next[from as usize];
                crowd[*place as usize..*place as usize + 2].copy_from_slice(&others);
                *place += 2;
            }
        }
        let mut rows = Self {
            starts: Vec::with_capacity(vertex_count + 1),
            neighbours: Vec::with_capacity(3 * triangles.len()),
            single: Vec::with_capacity(3 * triangles.len()),
            sides: Vec::new(),
        };
        for vertex in 0..vertex_count {
            rows.starts.push(rows.neighbours.len() as u32);
            let row = &mut crowd[starts[vertex] as usize..starts[vertex + 1] as usize];
            row.sort_unstable();
            for run in row.chunk_by(|a, b| a == b) {
                rows.neighbours.push(run[0]);
                // A neighbour named by one face only is across a boundary edge.
                rows.single.push(run.len() == 1);
            }
        }
        rows.starts.push(rows.neighbours.len() as u32);
        let sides = triangles
            .iter()
            .map(|&[a, b, c]| {
                [[a, b], [b, c], [c, a]].map(|[p, q]| [rows.entry(p, q), rows.entry(q, p)])
            })
            .collect();
        rows.sides = sides;
        rows
    }

    fn entry(&self, from: u32, to: u32) -> u32 {
        let start = self.starts[from as usize];
        let end = self.starts[from as usize + 1];
        let row = &self.neighbours[start as usize..end as usize];
        start + row.partition_point(|&vertex| vertex < to) as u32
    }
}

impl Connectivity {
    /// Joins the surfaces of a wall. `frames` holds, per frame, one mesh per surface, on the same faces in every frame.
    ///
    /// Boundary vertices of one surface that lie on the same place in every frame are one: the seams and poles of grids.
    ///
    /// # Errors
    /// None for meshes that exist.
    pub fn new(frames: &[Vec<&TriMesh>]) -> Result<Self, MeshError> {
        let first = frames.first().map_or(&[][..], Vec::as_slice);
        let mut offsets = vec![0_u32];
        for mesh in first {
            offsets.push(offsets[offsets.len() - 1] + mesh.vertices().len() as u32);
        }
        let vertex_count = offsets[offsets.len() - 1] as usize;
        let mut joined = Self {
            offsets,
            representative: (0..vertex_count as u32).collect(),
            triangles: Vec::new(),
            sheet_starts: vec![0],
            sheet_surfaces: Vec::new(),
            rows: Rows::default(),
            boundary: Vec::new(),
        };
        let surfaces: Vec<Surface> = (first.par_iter().enumerate())
            .map(|(surface, mesh)| {
                let poses: Vec<&[Point3]> = frames.iter().map(|f| f[surface].vertices()).collect();
                Surface::new(mesh.faces(), &poses)
            })
            .collect::<Result<_, MeshError>>()?;
        for (surface, part) in surfaces.into_iter().enumerate() {
            joined.append(surface, &part);
        }
        joined.rows = Rows::new(vertex_count, &joined.triangles);
        joined.boundary = (0..vertex_count)
            .map(|vertex| joined.rows.single[joined.rows.of(vertex)].contains(&true))
            .collect();
        Ok(joined)
    }

    /// Number of vertices of all surfaces.
    pub fn vertex_count(&self) -> usize {
        self.representative.len()
    }

    /// Triangles of a sheet.
    pub fn sheet(&self, sheet: usize) -> &[[u32; 3]] {
        &self.triangles[self.sheet_starts[sheet]..self.sheet_starts[sheet + 1]]
    }

    /// Number of sheets of all surfaces.
    pub fn sheet_count(&self) -> usize {
        self.sheet_surfaces.len()
    }

    /// Turns the faces of a sheet round.
    pub fn turn(&mut self, sheet: usize) {
        for face in self.sheet_starts[sheet]..self.sheet_starts[sheet + 1] {
            self.triangles[face].swap(1, 2);
            let [ab, bc, ca] = self.rows.sides[face];
            let back = |[there, back]: [u32; 2]| [back, there];
            self.rows.sides[face] = [back(ca), back(bc), back(ab)];
        }
    }

    fn append(&mut self, surface: usize, part: &Surface) {
        let offset = self.offsets[surface];
        for (vertex, &other) in part.stands_for.iter().enumerate() {
            self.representative[offset as usize + vertex] = offset + other;
        }
        for triangles in &part.sheets {
            self.triangles
                .extend(triangles.iter().map(|t| t.map(|v| v + offset)));
            self.sheet_starts.push(self.triangles.len());
            self.sheet_surfaces.push(surface);
        }
    }
}

/// One surface by itself.
struct Surface {
    /// The vertex that stands for each vertex.
    stands_for: Vec<u32>,
    sheets: Vec<Vec<[u32; 3]>>,
}

impl Surface {
    /// Closes seams and winds sheets alike. A surface that branches or has one side only is taken as one sheet, wound as it is.
    fn new(faces: &Faces, poses: &[&[Point3]]) -> Result<Self, MeshError> {
        let stands_for = closed_seams(faces, poses);
        let whole: Vec<[u32; 3]> = (faces.triangles().iter())
            .map(|t| t.map(|v| stands_for[v as usize]))
            // Closing a seam may fold a face onto an edge.
            .filter(|&[a, b, c]| a != b && b != c && c != a)
            .collect();
        let whole = Faces::new(faces.vertex_count(), whole)?;
        let sheets = match sheets(&whole) {
            Ok(found) => found.into_iter().map(|sheet| sheet.triangles).collect(),
            // A surface that is no manifold does not fall into sheets: it is taken as one.
            Err(_) => vec![whole.triangles().to_vec()],
        };
        Ok(Self { stands_for, sheets })
    }
}

/// The lowest boundary vertex that lies on the place of each boundary vertex in every frame.
fn closed_seams(faces: &Faces, poses: &[&[Point3]]) -> Vec<u32> {
    let mut stands_for: Vec<u32> = (0..faces.vertex_count() as u32).collect();
    let mut seen: HashMap<[u64; 3], Vec<u32>> = HashMap::new();
    let Some(first) = poses.first() else {
        return stands_for;
    };
    for (vertex, on_boundary) in faces.boundary_vertices().into_iter().enumerate() {
        // Coinciding vertices inside a surface are no seam; joining them could make it non-manifold.
        if !on_boundary {
            continue;
        }
        // Adding zero makes −0 and 0 one.
        // By bits: a seam repeats coordinates exactly, and near misses are small gaps that must stay.
        let key = [0, 1, 2].map(|axis| (first[vertex][axis] + 0.0).to_bits());
        let here = seen.entry(key).or_default();
        let same = |other: u32| {
            poses
                .iter()
                .all(|pose| pose[other as usize] == pose[vertex])
        };
        match here.iter().find(|&&other| same(other)) {
            Some(&other) => stands_for[vertex] = other,
            None => here.push(vertex as u32),
        }
    }
    stands_for
}
