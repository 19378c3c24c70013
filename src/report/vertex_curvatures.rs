//! Curvature at the vertices of a surface, as the `curvature` command writes it.

use super::column::{Column, column};
use super::table::Row;
use crate::analysis::curvature::{Curvature, SurfaceCurvature};

/// One vertex of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VertexCurvatureRow {
    /// Vertex, from 0.
    pub vertex: usize,
    /// How the surface bends there, if that could be found.
    pub curvature: Option<Curvature>,
}

impl VertexCurvatureRow {
    /// All vertices of a surface.
    pub fn of_surface(surface: &SurfaceCurvature) -> Vec<Self> {
        (surface.vertices.iter().enumerate())
            .map(|(vertex, &curvature)| Self { vertex, curvature })
            .collect()
    }

    fn number(&self, of: impl Fn(&Curvature) -> f64) -> Option<f64> {
        self.curvature.as_ref().map(of)
    }
}

/// Of curvatures, and of their product.
const PER_LENGTH: &str = "1 / unit of coordinates";
const PER_SQUARE: &str = "1 / square unit of coordinates";

impl Row for VertexCurvatureRow {
    const FILES: &'static [&'static str] = &["the file of `curvature --out`"];
    const ROW: &'static str =
        "Curvature of one surface, a row per vertex; empty where too few vertices surround it";
    const COLUMNS: &'static [Column<Self>] = &[
        column("vertex", "Vertex", |row: &Self| row.vertex.into())
            .plain("Vertex of the mesh, numbered from 0"),
        column("gaussian", "Gaussian curvature", |row: &Self| {
            row.number(Curvature::gaussian).into()
        })
        .plain("Product of the principal curvatures, K = k1 k2")
        .in_unit(PER_SQUARE),
        column("mean", "Mean curvature", |row: &Self| {
            row.number(Curvature::mean).into()
        })
        .plain("Mean of the principal curvatures, H = (k1 + k2) / 2")
        .in_unit(PER_LENGTH),
        column("k1", "Greatest curvature", |row: &Self| {
            row.number(|curvature| curvature.greatest).into()
        })
        .plain("Greatest normal curvature, positive where the surface bends as a sphere does")
        .in_unit(PER_LENGTH),
        column("k2", "Least curvature", |row: &Self| {
            row.number(|curvature| curvature.least).into()
        })
        .plain("Least normal curvature")
        .in_unit(PER_LENGTH),
        column("shape_index", "Shape index", |row: &Self| {
            (row.curvature.and_then(|curvature| curvature.shape_index())).into()
        })
        .plain("2/π atan((k1 + k2) / (k1 − k2)): −1 cup, 0 saddle, 0.5 ridge, 1 cap; empty where the surface is flat"),
        column("curvedness", "Curvedness", |row: &Self| {
            row.number(Curvature::curvedness).into()
        })
        .plain("√((k1² + k2²) / 2): how much the surface bends, in whatever shape")
        .in_unit(PER_LENGTH),
    ];
}
