//! The two triangulated surfaces of one instant: vertices of the template on the smooth wall, with the volumes of the masks.

use std::f64::consts::PI;

use crate::mesh::{CappedSheet, MeshError, Point3, Sheet, TriMesh};
use crate::study::built_in::WallGrid;

use super::FrameWallError;
use super::planes::{Place, Planes};
use super::shape::{Surface, WallShape};

/// The template with its lid, made once for all frames.
#[derive(Clone, Debug)]
pub(super) struct Template {
    grid: WallGrid,
    capped: CappedSheet,
}

/// The surfaces of one instant.
#[derive(Clone, Debug)]
pub(super) struct Sheets {
    pub endo: TriMesh,
    pub epi: TriMesh,
}

/// Rounds in which the epicardium gets its volume beside its distance from the endocardium; three suffice.
const ROUNDS: usize = 6;
/// Least distance between the surfaces within a slice, in pixels: less than a mask can show.
const MIN_WALL_PIXELS: f64 = 0.75;
/// Greatest correction of a surface's volume: beyond a quarter, the smooth surface is of another form than the mask.
const MAX_CORRECTION: f64 = 1.25;

impl Template {
    /// The finest template of at most `vertices` vertices.
    ///
    /// # Errors
    /// None for a count in range.
    pub fn new(vertices: usize) -> Result<Self, MeshError> {
        let grid = WallGrid::new(vertices)?;
        let triangles = grid.faces.triangles().to_vec();
        let sheet = Sheet {
            faces: (0..triangles.len()).collect(),
            triangles,
            turned: 0,
        };
        let capped = CappedSheet::new(grid.points.len(), &sheet)?;
        Ok(Self { grid, capped })
    }

    /// Volume between a surface and the plane of its rim.
    pub fn volume(&self, vertices: &[Point3]) -> f64 {
        self.capped.signed_volume(vertices)
    }

    /// Puts the template on a wall. Its first direction is `septal_rad`; radii are multiplied by one factor for each surface, so
    /// that the volume under the plane of the valve is that of the mask.
    ///
    /// # Errors
    /// If a volume would have to change by more than a quarter.
    pub fn on(
        &self,
        planes: &Planes,
        wall: &WallShape,
        septal_rad: f64,
    ) -> Result<Sheets, FrameWallError> {
        let place = |surface: &Surface| Spots::new(self, wall, surface, septal_rad);
        let (endo, epi) = (place(&wall.endo), place(&wall.epi));
        let endo_volume = self.volume(&endo.positions(planes, &endo.radii));
        let endo_scale = correction(wall.endo.mask_volume, endo_volume, "endocardium")?;
        let endo_radii: Vec<f64> = endo.radii.iter().map(|r| r * endo_scale).collect();

        // Flat faces of the epicardium cut through the air by so much of its radius.
        let sagitta = 1.0 - (PI / self.grid.rim.max(3) as f64).cos();
        let floor = |spot: &Spot| {
            let inner = endo_scale * wall.endo.radius(spot.angle, spot.height);
            let least = MIN_WALL_PIXELS * planes.pixel_mm();
            if inner > 0.0 {
                inner * (1.0 + 2.0 * sagitta) + least
            } else {
                0.0
            }
        };
        let floors: Vec<f64> = epi.spots.iter().map(floor).collect();
        let first_volume = self.volume(&epi.positions(planes, &epi.radii));
        let mut epi_scale = correction(wall.epi.mask_volume, first_volume, "epicardium")?;
        let mut epi_radii = Vec::new();
        for _ in 0..ROUNDS {
            let outside = epi.radii.iter().zip(&floors);
            epi_radii = outside
                .map(|(r, floor)| (r * epi_scale).max(*floor))
                .collect();
            let volume = self.volume(&epi.positions(planes, &epi_radii));
            epi_scale *= (wall.epi.mask_volume / volume).sqrt();
        }
        let mesh = |spots: &Spots, radii: &[f64]| {
            TriMesh::new(spots.positions(planes, radii), self.grid.faces.clone())
        };
        Ok(Sheets {
            endo: mesh(&endo, &endo_radii)?,
            epi: mesh(&epi, &epi_radii)?,
        })
    }
}

/// Places of the template's vertices around the axis.
struct Spots {
    spots: Vec<Spot>,
    radii: Vec<f64>,
}

struct Spot {
    height: f64,
    angle: f64,
    centre: Place,
}

impl Spots {
    fn new(template: &Template, wall: &WallShape, surface: &Surface, septal_rad: f64) -> Self {
        let length = wall.base - surface.apex;
        let spots: Vec<Spot> = (template.grid.points.iter())
            .map(|point| {
                let height = surface.apex + length * point.length_share();
                Spot {
                    height,
                    angle: septal_rad + point.around_rad,
                    centre: wall.centre(height),
                }
            })
            .collect();
        let radii = spots
            .iter()
            .map(|s| surface.radius(s.angle, s.height))
            .collect();
        Self { spots, radii }
    }

    fn positions(&self, planes: &Planes, radii: &[f64]) -> Vec<Point3> {
        let spots = self.spots.iter().zip(radii);
        spots
            .map(|(spot, radius)| {
                let (sin, cos) = spot.angle.sin_cos();
                planes.position(spot.centre + Place::new(cos, sin) * *radius, spot.height)
            })
            .collect()
    }
}

/// The factor for radii that gives a volume: volumes of rings in planes grow as its square.
fn correction(mask: f64, mesh: f64, surface: &'static str) -> Result<f64, FrameWallError> {
    let ratio = mask / mesh;
    if mesh > 0.0 && ratio < MAX_CORRECTION && ratio > 1.0 / MAX_CORRECTION {
        return Ok(ratio.sqrt());
    }
    Err(FrameWallError::Volume {
        surface,
        mesh_ml: mesh / 1000.0,
        mask_ml: mask / 1000.0,
    })
}
