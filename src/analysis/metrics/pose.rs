//! What a pair needs of one pose, computed once per pose.

use crate::mesh::{Point3, Vector3, angle_deficits_rad};

use super::compared_curvature::{Areas, curvature_density};
use super::connectivity::Connectivity;
use super::params::{CheckedMetricParams, Corners, Regulariser};
use super::rigid::Moments;

/// A pose with everything that does not depend on what it is compared with.
///
/// Coordinates are kept axis by axis, so that a pair is a stream over plain arrays.
#[derive(Clone, Debug)]
pub struct PreparedPose {
    pub(super) axes: [Vec<f64>; 3],
    pub(super) centroid: Vector3,
    /// p − q of each edge pq, axis by axis.
    pub(super) edge_axes: [Vec<f64>; 3],
    /// 1 / |p − q|², 0 where an edge has no length and so no rate of length.
    pub(super) inverse_length2: Vec<f64>,
    /// |p − q|², kept only where corners are raw.
    pub(super) length2: Vec<f64>,
    /// Weight of each face in sums over faces.
    pub(super) face_weight: Vec<f64>,
    /// Share of the whole area around each vertex.
    pub(super) vertex_share: Vec<f64>,
    /// The curvature that is compared: density, or angle deficit where areas do not count.
    pub(super) curvature: Vec<f64>,
    /// Factor of the regulariser, λ and the unit of length included.
    pub(super) regulariser_factor: f64,
    /// Of the vertices, for metrics of displacement.
    pub(super) moments: Option<Moments>,
}

impl PreparedPose {
    pub(super) fn new(
        mesh: &Connectivity,
        params: &CheckedMetricParams,
        with_curvature: bool,
        points: &[Point3],
    ) -> Self {
        let areas = Areas::new(mesh, points);
        let edge = |&[p, q]: &[u32; 2]| points[p as usize] - points[q as usize];
        let edge_axes = [0, 1, 2].map(|axis| mesh.edges.iter().map(|e| edge(e)[axis]).collect());
        let length2: Vec<f64> = mesh.edges.iter().map(|e| edge(e).norm_squared()).collect();
        // A pose without area has no shares.
        let share = |area: f64| {
            if areas.total > 0.0 {
                area / areas.total
            } else {
                0.0
            }
        };
        let curvature = if !with_curvature {
            Vec::new()
        } else if params.area_weights {
            curvature_density(
                mesh,
                points,
                &areas,
                params.curvature.rings(mesh.vertex_count),
            )
        } else {
            angle_deficits_rad(points, &mesh.triangles, &mesh.flat_rad)
        };
        let vertex_share: Vec<f64> = areas.of_vertices.iter().map(|&area| share(area)).collect();
        let moments = params.kind.penalises_displacement().then(|| {
            let weight = |&share: &f64| if params.area_weights { share } else { 1.0 };
            let weights = vertex_share.iter().map(weight);
            Moments::of(points.iter().map(|point| point.coords).zip(weights))
        });
        Self {
            axes: [0, 1, 2].map(|axis| points.iter().map(|p| p[axis]).collect()),
            centroid: points.iter().map(|p| p.coords).sum::<Vector3>() / points.len().max(1) as f64,
            edge_axes,
            // A side without length has no rate of length: 0 takes it out of every sum.
            inverse_length2: length2
                .iter()
                .map(|&l| if l > 0.0 { 1.0 / l } else { 0.0 })
                .collect(),
            // Scale-free corners never read it, and a cohort keeps all of its poses in memory.
            length2: if params.corners == Corners::Raw {
                length2
            } else {
                Vec::new()
            },
            face_weight: (areas.of_faces.iter())
                .map(|&area| {
                    if params.area_weights {
                        share(area)
                    } else {
                        1.0
                    }
                })
                .collect(),
            vertex_share,
            curvature,
            regulariser_factor: regulariser_factor(params, areas.total),
            moments,
        }
    }

    /// Coordinates axis by axis, one entry per vertex.
    pub fn axes(&self) -> [&[f64]; 3] {
        [&self.axes[0], &self.axes[1], &self.axes[2]]
    }

    /// Memory that it holds.
    pub fn bytes(&self) -> usize {
        let lists = [
            &self.inverse_length2,
            &self.length2,
            &self.face_weight,
            &self.vertex_share,
            &self.curvature,
        ];
        let axes = self.axes.iter().chain(&self.edge_axes);
        let numbers: usize = axes.chain(lists).map(Vec::len).sum();
        size_of::<Self>() + numbers * size_of::<f64>()
    }

    /// Mean of the vertices.
    pub fn centroid(&self) -> Vector3 {
        self.centroid
    }

    pub(super) fn point(&self, vertex: usize) -> Point3 {
        Point3::new(
            self.axes[0][vertex],
            self.axes[1][vertex],
            self.axes[2][vertex],
        )
    }

    pub(super) fn points(&self) -> Vec<Point3> {
        (0..self.vertex_share.len())
            .map(|v| self.point(v))
            .collect()
    }
}

/// λ, over the squared radius of the sphere of equal area where sizes must not matter: then the
/// regulariser penalises displacement relative to size, as the corners penalise relative change.
pub(super) fn regulariser_factor(params: &CheckedMetricParams, total_area: f64) -> f64 {
    match (params.regulariser, params.corners) {
        // In radii of a sphere of the same area, so that scaling a subject changes no distance.
        (Regulariser::Area, Corners::ScaleFree) if total_area > 0.0 => {
            params.lambda * 4.0 * std::f64::consts::PI / total_area
        }
        (Regulariser::Area, Corners::ScaleFree) => 0.0,
        _ => params.lambda,
    }
}
