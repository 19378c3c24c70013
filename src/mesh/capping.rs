//! Closes an open sheet at its boundary loops, so that it has a volume.

use super::{Faces, MeshError, Point3, Sheet, area, mean_point, signed_volume, winding_number};

/// A sheet with a lid on each of its boundary loops: a flat fan from the loop to its centroid
/// (the mean of its vertices). A loop that is not flat gets a lid that is not flat either.
///
/// Made once per connectivity; answers for the positions of any frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CappedSheet {
    triangles: Vec<[u32; 3]>,
    loops: Vec<Vec<u32>>,
}

impl CappedSheet {
    /// Finds the loops of a consistently wound sheet of a surface of `vertex_count` vertices.
    ///
    /// # Errors
    /// If a triangle refers to a vertex that is not there.
    pub fn new(vertex_count: usize, sheet: &Sheet) -> Result<Self, MeshError> {
        let faces = Faces::new(vertex_count, sheet.triangles.clone())?;
        Ok(Self {
            loops: faces.boundary_loops(),
            triangles: sheet.triangles.clone(),
        })
    }

    /// Number of boundary loops; none if the sheet is closed.
    pub fn loop_count(&self) -> usize {
        self.loops.len()
    }

    /// Boundary loops, in the direction of their faces.
    pub fn loops(&self) -> &[Vec<u32>] {
        &self.loops
    }

    /// Triangles of the sheet, without lids.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Corners of all triangles at given positions, lids included: a closed surface.
    pub fn closed(&self, vertices: &[Point3]) -> Vec<[Point3; 3]> {
        self.corners(vertices).collect()
    }

    /// Vertices of the sheet, ascending.
    pub fn vertices(&self) -> Vec<u32> {
        let mut vertices: Vec<u32> = self.triangles.iter().flatten().copied().collect();
        vertices.sort_unstable();
        vertices.dedup();
        vertices
    }

    /// Area without lids.
    pub fn area(&self, vertices: &[Point3]) -> f64 {
        area(vertices, &self.triangles)
    }

    /// Volume inside sheet and lids; negative where normals point inwards.
    pub fn signed_volume(&self, vertices: &[Point3]) -> f64 {
        let origin = self
            .triangles
            .first()
            .map_or_else(Point3::origin, |t| vertices[t[0] as usize]);
        signed_volume(self.corners(vertices), origin)
    }

    /// How often sheet and lids wind around a point, counted positive for outward normals or
    /// not: 1 inside, 0 outside.
    pub fn winding_number(&self, vertices: &[Point3], point: Point3) -> f64 {
        winding_number(self.corners(vertices), point).abs()
    }

    /// Corners of all triangles, lids included.
    fn corners<'a>(&'a self, vertices: &'a [Point3]) -> impl Iterator<Item = [Point3; 3]> + 'a {
        let at = |v: u32| vertices[v as usize];
        let sheet = self.triangles.iter().map(move |t| t.map(at));
        let lids = self.loops.iter().flat_map(move |rim| {
            let centre = mean_point(rim.iter().map(|&v| at(v)));
            // A lid runs along the rim against the direction of the sheet's faces.
            (0..rim.len()).map(move |i| [at(rim[(i + 1) % rim.len()]), at(rim[i]), centre])
        });
        sheet.chain(lids)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom, sheets};
    use std::f64::consts::PI;

    fn capped(mesh: &TriMesh) -> CappedSheet {
        let found = sheets(mesh.faces()).unwrap();
        CappedSheet::new(mesh.vertices().len(), &found[0]).unwrap()
    }

    #[test]
    fn a_bowl_holds_half_a_sphere() {
        let errors: Vec<f64> = [20_u32, 40, 80]
            .map(|rings| {
                let bowl = phantom::bowl(1.5, rings, 4 * rings);
                let held = capped(&bowl).signed_volume(bowl.vertices());
                2.0 / 3.0 * PI * 1.5_f64.powi(3) - held
            })
            .to_vec();
        for pair in errors.windows(2) {
            assert!((3.8..4.2).contains(&(pair[0] / pair[1])), "{errors:?}");
        }
    }

    #[test]
    fn a_tube_with_two_open_ends_is_closed_at_both() {
        // A bowl without its lowest ring of faces.
        let bowl = phantom::bowl(1.0, 60, 240);
        let rest: Vec<_> = bowl.triangles()[240 + 2 * 240 * 29..].to_vec();
        let tube = TriMesh::new(
            bowl.shared_vertices(),
            Faces::new(bowl.vertices().len(), rest).unwrap(),
        )
        .unwrap();
        let sheet = capped(&tube);
        assert_eq!(sheet.loop_count(), 2);
        // Ball between z = −cos 45° and 0: π h (1 − h²/3).
        let height = (PI / 4.0).cos();
        let exact = PI * height * (1.0 - height * height / 3.0);
        let held = sheet.signed_volume(tube.vertices());
        assert!((held / exact - 1.0).abs() < 2e-3, "{held} {exact}");
    }

    #[test]
    fn inward_normals_change_only_the_sign() {
        let bowl = phantom::bowl(1.0, 10, 40);
        let inward: Vec<_> = bowl
            .triangles()
            .iter()
            .map(|&[a, b, c]| [a, c, b])
            .collect();
        let turned = TriMesh::new(
            bowl.shared_vertices(),
            Faces::new(bowl.vertices().len(), inward).unwrap(),
        )
        .unwrap();
        let held = capped(&bowl).signed_volume(bowl.vertices());
        assert!((capped(&turned).signed_volume(turned.vertices()) + held).abs() < 1e-12);
        let inside = Point3::new(0.0, 0.0, -0.3);
        for sheet in [capped(&bowl), capped(&turned)] {
            assert!((sheet.winding_number(bowl.vertices(), inside) - 1.0).abs() < 1e-9);
        }
    }
}
