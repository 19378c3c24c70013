//! One heart made ready for drawing, once: all its poses, normals and colour values.

use std::sync::Arc;

use crate::mesh::{Point3, vertex_normals};
use crate::picture::axes::HeartAxes;
use crate::picture::quantity::Quantity;
use crate::picture::wall_rim::{WallRim, wall_rim};
use crate::render::{Geometry, VertexScalars};
use crate::study::{Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

/// The part a surface plays in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SurfaceRole {
    /// The inner side of a wall that has an outer one too.
    Inner,
    /// The outer side, seen through.
    Outer,
    /// The cut between both at the base.
    Rim,
    /// A surface that stands for itself.
    Alone(SurfaceKind),
}

/// One surface with everything that colours can stand for.
#[derive(Clone, Debug)]
pub struct PreparedSurface {
    /// The part it plays.
    pub role: SurfaceRole,
    /// Its shape at every frame.
    pub geometry: Arc<Geometry>,
    displacement: Arc<VertexScalars>,
    area_ratio: Arc<VertexScalars>,
}

impl PreparedSurface {
    /// The numbers of a quantity; `None` for tissue.
    pub fn scalars(&self, quantity: Quantity) -> Option<&Arc<VertexScalars>> {
        match quantity {
            Quantity::Tissue => None,
            Quantity::Displacement => Some(&self.displacement),
            Quantity::AreaRatio => Some(&self.area_ratio),
        }
    }
}

/// One heart, ready for drawing at any pose. Made off the window's thread, then shared.
#[derive(Clone, Debug)]
pub struct PreparedSubject {
    /// What lengths are counted in.
    pub unit: LengthUnit,
    /// Number of frames.
    pub frame_count: usize,
    /// The frame that motion is counted from.
    pub reference_frame: usize,
    /// Which way it is turned.
    pub axes: HeartAxes,
    /// The surfaces: inner, outer, rim, or those that stand alone.
    pub surfaces: Vec<PreparedSurface>,
}

impl PreparedSubject {
    /// Prepares a heart; motion is counted from `reference_frame`, or from the first frame if
    /// there is no such frame.
    pub fn new(subject: &Subject, reference_frame: usize) -> Self {
        let sequence = &subject.sequence;
        let reference = if reference_frame < sequence.frame_count() {
            reference_frame
        } else {
            0
        };
        let inner = sequence.surface(SurfaceKind::Endocardium);
        let outer = sequence.surface(SurfaceKind::Epicardium);
        let both = inner.zip(outer);
        let mut surfaces: Vec<PreparedSurface> = sequence
            .surfaces()
            .iter()
            .map(|surface| {
                let role = match surface.kind() {
                    SurfaceKind::Endocardium if both.is_some() => SurfaceRole::Inner,
                    SurfaceKind::Epicardium if both.is_some() => SurfaceRole::Outer,
                    kind => SurfaceRole::Alone(kind),
                };
                prepared_surface(surface, role, reference)
            })
            .collect();
        if let Some((inner, outer)) = both
            && let Some(rim) = wall_rim(inner, outer)
        {
            let of = |role| surfaces.iter().find(|surface| surface.role == role);
            let sides = of(SurfaceRole::Inner).zip(of(SurfaceRole::Outer));
            let rim = sides.map(|(inner, outer)| prepared_rim(&rim, inner, outer));
            surfaces.extend(rim);
        }
        Self {
            unit: subject.unit,
            frame_count: sequence.frame_count(),
            reference_frame: reference,
            axes: HeartAxes::of(subject),
            surfaces,
        }
    }

    /// The surface that plays a part, if there is one.
    pub fn surface(&self, role: SurfaceRole) -> Option<&PreparedSurface> {
        self.surfaces.iter().find(|surface| surface.role == role)
    }

    /// Positions of all surfaces at all frames.
    pub fn all_positions(&self) -> impl Iterator<Item = &[f32; 3]> + Clone {
        self.surfaces
            .iter()
            .flat_map(|surface| surface.geometry.positions.iter().flatten())
    }
}

fn prepared_surface(
    surface: &SurfaceSequence,
    role: SurfaceRole,
    reference: usize,
) -> PreparedSurface {
    let triangles = surface.faces().triangles();
    let start = surface.frames()[reference].vertices();
    let start_areas = vertex_areas(start, triangles);
    let mut geometry = Geometry {
        triangles: triangles.to_vec(),
        ..Geometry::default()
    };
    let (mut displacement, mut area_ratio) = (Vec::new(), Vec::new());
    for frame in surface.frames() {
        let points = frame.vertices();
        geometry.positions.push(
            points
                .iter()
                .map(|p| p.coords.cast::<f32>().into())
                .collect(),
        );
        let normals = vertex_normals(points, triangles);
        geometry
            .normals
            .push(normals.iter().map(|n| n.cast::<f32>().into()).collect());
        let moved = points.iter().zip(start).map(|(a, b)| (a - b).norm() as f32);
        displacement.push(moved.collect());
        let areas = vertex_areas(points, triangles);
        let ratios = areas.iter().zip(&start_areas).map(|(now, then)| {
            // A vertex of no face, or of faces without area, has no ratio: grey.
            if *then > 0.0 {
                (now / then) as f32
            } else {
                f32::NAN
            }
        });
        area_ratio.push(ratios.collect());
    }
    PreparedSurface {
        role,
        geometry: Arc::new(geometry),
        displacement: Arc::new(VertexScalars {
            values: displacement,
        }),
        area_ratio: Arc::new(VertexScalars { values: area_ratio }),
    }
}

/// A third of the area of the faces around each vertex, in square coordinates.
fn vertex_areas(vertices: &[Point3], triangles: &[[u32; 3]]) -> Vec<f64> {
    let mut areas = vec![0.0; vertices.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|index| vertices[index as usize]);
        let third = (b - a).cross(&(c - a)).norm() / 6.0;
        for &corner in triangle {
            areas[corner as usize] += third;
        }
    }
    areas
}

fn prepared_rim(
    rim: &WallRim,
    inner: &PreparedSurface,
    outer: &PreparedSurface,
) -> PreparedSurface {
    let mut geometry = Geometry {
        triangles: rim.triangles.clone(),
        ..Geometry::default()
    };
    let frames = inner
        .geometry
        .positions
        .iter()
        .zip(&outer.geometry.positions);
    for (inner_points, outer_points) in frames {
        let points = gathered(rim, inner_points, outer_points);
        let exact: Vec<Point3> = points
            .iter()
            .map(|p| Point3::from(p.map(f64::from)))
            .collect();
        let normals = vertex_normals(&exact, &rim.triangles);
        geometry.positions.push(points);
        geometry
            .normals
            .push(normals.iter().map(|n| n.cast::<f32>().into()).collect());
    }
    let scalars = |of_inner: &VertexScalars, of_outer: &VertexScalars| {
        let frames = of_inner.values.iter().zip(&of_outer.values);
        Arc::new(VertexScalars {
            values: frames.map(|(a, b)| gathered(rim, a, b)).collect(),
        })
    };
    PreparedSurface {
        role: SurfaceRole::Rim,
        displacement: scalars(&inner.displacement, &outer.displacement),
        area_ratio: scalars(&inner.area_ratio, &outer.area_ratio),
        geometry: Arc::new(geometry),
    }
}

fn gathered<T: Copy>(rim: &WallRim, inner: &[T], outer: &[T]) -> Vec<T> {
    let of_inner = rim.inner.iter().map(|&vertex| inner[vertex as usize]);
    let of_outer = rim.outer.iter().map(|&vertex| outer[vertex as usize]);
    of_inner.chain(of_outer).collect()
}
