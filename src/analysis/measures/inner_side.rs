//! Which faces of a closed wall look into the cavity.

use crate::mesh::{CappedSheet, Faces, MeshError, Point3, Sheet, Vector3, sheets};

/// Why the inner side of a closed wall cannot be determined.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum InnerSideError {
    /// The middle of the surface lies in myocardium: this is no cup.
    #[error("the centre of the closed surface lies in the myocardium, not in a cavity")]
    NoCavity,
    /// Faces that look to the middle do not make one side with one rim.
    #[error(
        "the faces towards the centre form no single cup: \
         {part:.0} % of their area is connected, with {loops} boundary loops"
    )]
    NoSingleCup {
        /// Share of the largest piece, in percent.
        part: f64,
        /// Its boundary loops.
        loops: usize,
    },
    /// Its connectivity is broken.
    #[error(transparent)]
    Mesh(#[from] MeshError),
}

/// The inner side of a closed cup-shaped wall, closed by a lid on its rim.
///
/// With normals pointing out of the myocardium, a face is inner if n · (c − o) < 0, where c is its
/// centroid and o the area-weighted centroid of the whole surface. For a cup, o lies in
/// the cavity; every inner face looks to o if the cavity is star-shaped around o, every outer
/// one away, and the faces of the rim, which look past the base, away. Unambiguous means: o is
/// not in the myocardium (winding number below ½), and at least 98 % of the area of inner faces
/// is connected in one piece with one rim; single faces that look the other way, at a
/// crumpled rim, make up the rest.
pub(super) fn inner_side(
    vertices: &[Point3],
    sheet: &Sheet,
    whole: &CappedSheet,
) -> Result<CappedSheet, InnerSideError> {
    // Not tuned: a second cavity or a hole is some percent of the surface, a crumpled rim less.
    const MIN_PART: f64 = 0.98;
    // Files orient walls either way; what looks inwards is relative to that.
    let outward = whole.signed_volume(vertices).signum();
    let faces: Vec<FaceFrame> = sheet
        .triangles
        .iter()
        .map(|triangle| FaceFrame::new(triangle.map(|v| vertices[v as usize])))
        .collect();
    let all: f64 = faces.iter().map(FaceFrame::area).sum();
    let sum: Vector3 = faces.iter().map(|f| f.centre.coords * f.area()).sum();
    let middle = Point3::from(sum / all.max(f64::MIN_POSITIVE));
    // Above one half is inside the myocardium, below it in the cavity or outside.
    if whole.winding_number(vertices, middle) > 0.5 {
        return Err(InnerSideError::NoCavity);
    }
    let inner: Vec<[u32; 3]> = sheet
        .triangles
        .iter()
        .zip(&faces)
        .filter(|(_, face)| outward * face.area_vector.dot(&(face.centre - middle)) < 0.0)
        .map(|(&triangle, _)| triangle)
        .collect();
    let inner = Faces::new(vertices.len(), inner)?;
    let area = |piece: &Sheet| crate::mesh::area(vertices, &piece.triangles);
    // The pieces of an orientable surface are orientable.
    let pieces = sheets(&inner).unwrap_or_default();
    let inner_area: f64 = pieces.iter().map(area).sum();
    // Rough walls have single faces that look the other way; the cup is the large piece.
    let Some(largest) = pieces.iter().max_by(|a, b| area(a).total_cmp(&area(b))) else {
        return Err(InnerSideError::NoSingleCup {
            part: 0.0,
            loops: 0,
        });
    };
    let capped = CappedSheet::new(vertices.len(), largest)?;
    let part = area(largest) / inner_area.max(f64::MIN_POSITIVE);
    // One rim is the base; a second one would be a hole, and the volume a guess.
    if part < MIN_PART || capped.loop_count() != 1 {
        return Err(InnerSideError::NoSingleCup {
            part: 100.0 * part,
            loops: capped.loop_count(),
        });
    }
    Ok(capped)
}

/// Centroid of a face and half the cross product of its sides.
struct FaceFrame {
    centre: Point3,
    area_vector: Vector3,
}

impl FaceFrame {
    fn new([a, b, c]: [Point3; 3]) -> Self {
        Self {
            centre: Point3::from((a.coords + b.coords + c.coords) / 3.0),
            area_vector: 0.5 * (b - a).cross(&(c - a)),
        }
    }

    fn area(&self) -> f64 {
        self.area_vector.norm()
    }
}
