//! Measures of the poses of a path, and the gradient of its energy: all memory that an evaluation uses.

use crate::mesh::{Point3, Vector3};
use crate::numeric::{LANES, Lanes};

use crate::analysis::metrics::connectivity::Connectivity;
use crate::analysis::metrics::params::{CheckedMetricParams, Corners, CurvatureRole, Regulariser};

use super::rows::Rows;

/// What does not change between evaluations.
#[derive(Clone, Debug)]
pub(in crate::analysis::metrics) struct Plan {
    pub mesh: Connectivity,
    pub params: CheckedMetricParams,
    pub curvature: CurvatureRole,
    pub interpolated_poses: usize,
    /// Blocks of [`LANES`] steps; those past the end of the path repeat the last pose.
    pub blocks: usize,
    /// |ΔK| of the two ends, per vertex; empty unless the form is frozen.
    pub frozen: Vec<f64>,
    /// Factor of the regulariser where it is the same along the whole path; `None`: that of each pose.
    pub shared_regulariser_factor: Option<f64>,
    /// Part of a face's weight that each of its sides has; for the isometric metric.
    pub side_parts: Vec<[f64; 3]>,
}

impl Plan {
    /// Weight μ of the curvature change, 0 where it is no term of its own.
    pub fn mu(&self) -> f64 {
        match self.curvature {
            CurvatureRole::Term => self.params.mu,
            CurvatureRole::Unused | CurvatureRole::StepFactor | CurvatureRole::FrozenFactor => 0.0,
        }
    }

    pub fn needs_curvature(&self) -> bool {
        self.mu() > 0.0 || self.curvature == CurvatureRole::StepFactor
    }

    pub fn raw(&self) -> bool {
        self.params.corners == Corners::Raw
    }

    pub fn regulariser_by_area(&self) -> bool {
        self.params.regulariser == Regulariser::Area
    }

    pub fn step_count(&self) -> usize {
        self.interpolated_poses + 1
    }
}

/// Measures of all poses, and of the steps between them.
#[derive(Clone, Debug)]
pub(in crate::analysis::metrics) struct PathState {
    /// Coordinates x, y, z of each vertex, three rows.
    pub points: Rows,
    /// 1 / |p − q|² of each edge, 0 where it has no length.
    pub inverse_length2: Rows,
    /// |p − q|² of each edge, kept up only where corners are raw.
    pub length2: Rows,
    pub face_area: Rows,
    pub vertex_area: Rows,
    pub total_area: Rows,
    pub curvature: Rows,
    /// Of the corners of each face.
    pub cotangents: Vec<[Lanes; 3]>,
    /// Of each vertex: sum of angles and of areas of its faces, then angle deficit and area gathered.
    pub around: Vec<[Lanes; 2]>,
    /// Of each edge and step, where it begins and where it ends.
    pub stretch: Vec<[Lanes; 2]>,
    /// K(M_{i+1}) − K(M_i) of each vertex and step.
    pub curvature_change: Vec<Lanes>,
    /// Energy of the metric itself, where steps begin and where they end.
    pub own: Vec<[Lanes; 2]>,
    /// Energy of the regulariser, likewise.
    pub regulariser: Vec<[Lanes; 2]>,
}

/// Gradients of the energy along those measures.
#[derive(Clone, Debug)]
pub(in crate::analysis::metrics) struct Gradients {
    pub points: Vec<[Lanes; 3]>,
    pub stretch: Vec<[Lanes; 2]>,
    pub length2: Vec<Lanes>,
    pub face_area: Vec<Lanes>,
    pub vertex_area: Vec<Lanes>,
    pub total_area: Vec<Lanes>,
    pub curvature_change: Vec<Lanes>,
    /// Of each vertex: along its curvature's numerator and denominator, then along its angles and area.
    pub around: Vec<[Lanes; 2]>,
    /// Other half of gathering.
    pub spare: Vec<[Lanes; 2]>,
    pub rigid: RigidScratch,
}

/// Memory of the rigid metric for one side of a step.
#[derive(Clone, Debug, Default)]
pub(in crate::analysis::metrics) struct RigidScratch {
    pub points: Vec<Point3>,
    pub weights: Vec<f64>,
    pub field: Vec<Vector3>,
}

impl PathState {
    pub fn new(plan: &Plan) -> Self {
        let blocks = plan.blocks;
        let (vertices, edges, faces) = sizes(plan);
        Self {
            points: Rows::new(3 * vertices, blocks),
            inverse_length2: Rows::new(edges, blocks),
            // Scale-free corners read stretches only, and rows are the largest arrays here.
            length2: Rows::new(if plan.raw() { edges } else { 0 }, blocks),
            face_area: Rows::new(faces, blocks),
            vertex_area: Rows::new(vertices, blocks),
            total_area: Rows::new(1, blocks),
            curvature: Rows::new(vertices, blocks),
            cotangents: vec![[Lanes::default(); 3]; faces * blocks],
            around: vec![[Lanes::default(); 2]; vertices * blocks],
            stretch: vec![[Lanes::default(); 2]; edges * blocks],
            curvature_change: vec![Lanes::default(); vertices * blocks],
            own: vec![[Lanes::default(); 2]; blocks],
            regulariser: vec![[Lanes::default(); 2]; blocks],
        }
    }

    /// Squared norms of a step where it begins and where it ends.
    pub fn norms(&self, step: usize) -> [f64; 2] {
        let (block, lane) = (step / LANES, step % LANES);
        [0, 1].map(|side| self.own[block][side].0[lane] + self.regulariser[block][side].0[lane])
    }

    /// Keeps what was measured of pose 1 as that of pose 0.
    pub fn keep_as_start(&mut self) {
        for rows in [
            &mut self.inverse_length2,
            &mut self.length2,
            &mut self.face_area,
            &mut self.vertex_area,
            &mut self.total_area,
            &mut self.curvature,
        ] {
            rows.keep_as_start();
        }
    }
}

impl Gradients {
    pub fn new(plan: &Plan) -> Self {
        let blocks = plan.blocks;
        let (vertices, edges, faces) = sizes(plan);
        Self {
            points: vec![[Lanes::default(); 3]; vertices * blocks],
            stretch: vec![[Lanes::default(); 2]; edges * blocks],
            length2: vec![Lanes::default(); edges * blocks],
            face_area: vec![Lanes::default(); faces * blocks],
            vertex_area: vec![Lanes::default(); vertices * blocks],
            total_area: vec![Lanes::default(); blocks],
            curvature_change: vec![Lanes::default(); vertices * blocks],
            around: vec![[Lanes::default(); 2]; vertices * blocks],
            spare: vec![[Lanes::default(); 2]; vertices * blocks],
            rigid: RigidScratch::default(),
        }
    }
}

fn sizes(plan: &Plan) -> (usize, usize, usize) {
    let mesh = &plan.mesh;
    (mesh.vertex_count, mesh.edges.len(), mesh.triangles.len())
}
