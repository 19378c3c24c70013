//! A surface that a template is laid onto: one oriented sheet with its opening, made of whatever a file holds.

use crate::mesh::{
    CappedSheet, ClosestPoint, Faces, Nearest, Point3, Sheet, TriMesh, Vector3, area, bounding_box,
    face_normals, sheets,
};

use super::TargetError;

/// Fewest faces of a surface that has a form.
const MIN_FACES: usize = 16;
/// Area of a piece, as a share of the largest, from which on it cannot be left out as a speck.
const MAX_SPECK: f64 = 0.2;
/// Length of an opening, as a share of the longest, below which it is a hole and not another end of the ventricle.
const MIN_END: f64 = 0.5;
/// Distance from an edge, as a share of its length, within which a point lies on it.
const ON_EDGE: f64 = 1e-9;

/// One sheet of a surface, wound so that normals point away from the inside where it can be wound at all.
#[derive(Clone, Debug)]
pub(super) struct TargetSurface {
    vertices: Vec<Point3>,
    triangles: Vec<[u32; 3]>,
    tree: ClosestPoint,
    /// Unit normal of each face; `None` where the surface branches or has one side.
    normals: Option<Vec<Vector3>>,
    /// For each face which of its sides have no neighbour.
    open_sides: Vec<[bool; 3]>,
    /// The closed chain of vertices around the opening at the base; empty of a closed surface.
    rim: Vec<u32>,
    /// Volume within the sheet and a lid on its opening, where the sheet has one opening at most.
    volume: Option<f64>,
    /// What was done to it.
    pub notes: Vec<String>,
}

impl TargetSurface {
    /// The largest piece of a surface.
    ///
    /// # Errors
    /// If it has too few faces, no extent, or two pieces of similar size.
    pub fn new(mesh: &TriMesh) -> Result<Self, TargetError> {
        let mut notes = Vec::new();
        let (triangles, oriented) = largest_piece(mesh, &mut notes)?;
        Self::of_piece(mesh.vertices(), &triangles, oriented, notes)
    }

    /// Of faces that are one piece; `oriented` if they are wound the same way round.
    pub fn of_piece(
        vertices: &[Point3],
        triangles: &[[u32; 3]],
        oriented: bool,
        notes: Vec<String>,
    ) -> Result<Self, TargetError> {
        if triangles.len() < MIN_FACES {
            return Err(TargetError::FewFaces {
                faces: triangles.len(),
                needed: MIN_FACES,
            });
        }
        let (vertices, mut triangles) = compact(vertices, triangles);
        let extent = bounding_box(&vertices).map_or(0.0, |[low, high]| (high - low).norm());
        let whole = area(&vertices, &triangles);
        // Products of lengths of greater coordinates overflow.
        if !(whole > 0.0 && extent < 1e100 && whole.is_finite()) {
            return Err(TargetError::NoExtent);
        }
        let faces = Faces::new(vertices.len(), triangles.clone())?;
        let loops = by_length(faces.boundary_loops(), &vertices);
        let longest = loops.first().map_or(0.0, |(length, _)| *length);
        let ends = loops
            .iter()
            .filter(|(length, _)| *length >= MIN_END * longest);
        let ends = ends.count();
        if ends > 1 {
            return Err(TargetError::SeveralOpenings { openings: ends });
        }
        let mut volume = None;
        if oriented {
            let sheet = Sheet {
                faces: (0..triangles.len()).collect(),
                triangles: triangles.clone(),
                turned: 0,
            };
            let capped = CappedSheet::new(vertices.len(), &sheet)?;
            let signed = capped.signed_volume(&vertices);
            if signed < 0.0 {
                for triangle in &mut triangles {
                    triangle.swap(1, 2);
                }
            }
            volume = (capped.loop_count() <= 1).then_some(signed.abs());
        }
        let mut notes = notes;
        if loops.len() > 1 {
            notes.push(match loops.len() - 1 {
                1 => "a hole was bridged".to_owned(),
                holes => format!("{holes} holes were bridged"),
            });
        }
        let open_sides = open_sides(&triangles);
        let normals = oriented.then(|| face_normals(&vertices, &triangles));
        let tree = ClosestPoint::new(&vertices, &triangles).ok_or(TargetError::NoExtent)?;
        let rim = loops
            .into_iter()
            .next()
            .map_or_else(Vec::new, |(_, rim)| rim);
        Ok(Self {
            vertices,
            triangles,
            tree,
            normals,
            open_sides,
            rim,
            volume,
            notes,
        })
    }

    pub fn vertices(&self) -> &[Point3] {
        &self.vertices
    }

    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Positions around the opening at the base; none of a closed surface.
    pub fn rim(&self) -> Vec<Point3> {
        let at = |&v: &u32| self.vertices[v as usize];
        self.rim.iter().map(at).collect()
    }

    /// Volume within the sheet and a lid, if it has no holes.
    pub fn volume(&self) -> Option<f64> {
        self.volume
    }

    /// Whether it has an outside.
    pub fn is_oriented(&self) -> bool {
        self.normals.is_some()
    }

    pub fn nearest(&self, point: Point3) -> Nearest {
        self.tree.nearest(point)
    }

    /// Outward normal of a face, if the surface has an outside.
    pub fn normal(&self, face: usize) -> Option<Vector3> {
        self.normals.as_ref().map(|normals| normals[face])
    }

    /// Whether a point that was found lies where the surface ends.
    pub fn is_on_boundary(&self, nearest: &Nearest) -> bool {
        let open = self.open_sides[nearest.face];
        let triangle = self.triangles[nearest.face].map(|v| self.vertices[v as usize]);
        (0..3).any(|side| {
            let [from, to] = [triangle[side], triangle[(side + 1) % 3]];
            open[side] && on_segment(&from, &to, &nearest.point)
        })
    }

    /// The last point in which the ray meets the surface.
    pub fn last_hit(&self, from: Point3, along: Vector3) -> Option<Point3> {
        let corners = |t: &[u32; 3]| t.map(|v| self.vertices[v as usize]);
        let hits = self
            .triangles
            .iter()
            .filter_map(|t| hit(&corners(t), from, along));
        let farthest = hits.reduce(f64::max)?;
        Some(from + along * farthest)
    }
}

/// Triangles of the largest piece, and whether they are wound the same way round.
fn largest_piece(
    mesh: &TriMesh,
    notes: &mut Vec<String>,
) -> Result<(Vec<[u32; 3]>, bool), TargetError> {
    let triangles = mesh.triangles();
    let Ok(mut pieces) = sheets(mesh.faces()) else {
        notes.push("the surface branches or has one side: its inside is unknown".to_owned());
        return Ok((triangles.to_vec(), false));
    };
    let area_of = |sheet: &Sheet| area(mesh.vertices(), &sheet.triangles);
    // Stable, so that of equal ones the first stays first.
    pieces.sort_by(|a, b| area_of(b).total_cmp(&area_of(a)));
    let mut pieces = pieces.into_iter();
    let Some(largest) = pieces.next() else {
        return Err(TargetError::FewFaces {
            faces: 0,
            needed: MIN_FACES,
        });
    };
    let whole = area_of(&largest);
    let rest: Vec<Sheet> = pieces.collect();
    let large = rest
        .iter()
        .filter(|piece| area_of(piece) > MAX_SPECK * whole);
    match large.count() {
        0 => {}
        others => {
            return Err(TargetError::SeveralPieces { pieces: others + 1 });
        }
    }
    match rest.len() {
        0 => {}
        1 => notes.push("a small separate piece was left out".to_owned()),
        count => notes.push(format!("{count} small separate pieces were left out")),
    }
    if largest.turned > 0 {
        let turned = largest.turned.min(largest.triangles.len() - largest.turned);
        if turned > 0 {
            notes.push(format!("{turned} faces were turned round"));
        }
    }
    Ok((largest.triangles, true))
}

/// The vertices that triangles use, and the triangles over those.
fn compact(vertices: &[Point3], triangles: &[[u32; 3]]) -> (Vec<Point3>, Vec<[u32; 3]>) {
    let mut place = vec![u32::MAX; vertices.len()];
    let mut kept = Vec::new();
    for &v in triangles.iter().flatten() {
        if place[v as usize] == u32::MAX {
            place[v as usize] = 0;
        }
    }
    for (v, place) in place.iter_mut().enumerate() {
        if *place == 0 {
            *place = kept.len() as u32;
            kept.push(vertices[v]);
        }
    }
    let triangles = triangles.iter().map(|t| t.map(|v| place[v as usize]));
    (kept, triangles.collect())
}

/// Loops with their lengths, the longest first.
fn by_length(loops: Vec<Vec<u32>>, vertices: &[Point3]) -> Vec<(f64, Vec<u32>)> {
    let length = |rim: &[u32]| {
        let side = |i: usize| {
            let [a, b] = [rim[i], rim[(i + 1) % rim.len()]].map(|v| vertices[v as usize]);
            (b - a).norm()
        };
        (0..rim.len()).map(side).sum::<f64>()
    };
    let mut found: Vec<(f64, Vec<u32>)> =
        loops.into_iter().map(|rim| (length(&rim), rim)).collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found
}

fn open_sides(triangles: &[[u32; 3]]) -> Vec<[bool; 3]> {
    let mut sides: Vec<([u32; 2], usize, usize)> = Vec::with_capacity(3 * triangles.len());
    for (face, &[a, b, c]) in triangles.iter().enumerate() {
        for (side, [p, q]) in [[a, b], [b, c], [c, a]].into_iter().enumerate() {
            sides.push(([p.min(q), p.max(q)], face, side));
        }
    }
    sides.sort_unstable();
    let mut open = vec![[false; 3]; triangles.len()];
    for run in sides.chunk_by(|a, b| a.0 == b.0) {
        if let [(_, face, side)] = *run {
            open[face][side] = true;
        }
    }
    open
}

fn on_segment(from: &Point3, to: &Point3, point: &Point3) -> bool {
    let along = to - from;
    let share = along.dot(&(point - from)) / along.norm_squared().max(f64::MIN_POSITIVE);
    let nearest = from + along * share.clamp(0.0, 1.0);
    (nearest - point).norm() <= ON_EDGE * along.norm()
}

/// How far along the ray it meets the triangle.
///
/// Source: Möller and Trumbore (1997), J. Graphics Tools 2(1), 21–28.
fn hit([a, b, c]: &[Point3; 3], from: Point3, along: Vector3) -> Option<f64> {
    let (ab, ac) = (b - a, c - a);
    let p = along.cross(&ac);
    let determinant = ab.dot(&p);
    if determinant == 0.0 {
        return None;
    }
    let offset = from - a;
    let u = offset.dot(&p) / determinant;
    // A ray along an edge meets one of its faces, whatever rounding says.
    if !(-ON_EDGE..=1.0 + ON_EDGE).contains(&u) {
        return None;
    }
    let q = offset.cross(&ab);
    let v = along.dot(&q) / determinant;
    if v < -ON_EDGE || u + v > 1.0 + ON_EDGE {
        return None;
    }
    let distance = ac.dot(&q) / determinant;
    (distance > 0.0).then_some(distance)
}
