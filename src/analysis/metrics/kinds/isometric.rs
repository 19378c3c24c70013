//! The isometric metric: change of edge lengths (2.3.6).

use nalgebra::Matrix3;

use crate::analysis::metrics::face_energy::of_sides;
use crate::analysis::metrics::face_shares::add_face_shares;
use crate::analysis::metrics::metric::{Metric, PairScratch};
use crate::analysis::metrics::pair_sums::{Both, stretches};
use crate::analysis::metrics::params::{Corners, CurvatureRole, Form, MetricParams};
use crate::analysis::metrics::path_energy::faces::add_faces;
use crate::analysis::metrics::path_energy::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::pose::PreparedPose;
use crate::mesh::Vector3;
use crate::numeric::{Arithmetic, Lanes, three};

use super::metric_terms::{MetricTerms, MetricWords, Motion};

pub(super) struct Isometric;

impl MetricTerms for Isometric {
    fn words(&self) -> MetricWords {
        MetricWords {
            name: "Isometric",
            id: "isometric",
            summary: "Change of edge lengths",
            ignores: "position, rotation and bending without stretch",
            penalises: "changes of lengths on the surface",
            term: "change of lengths",
            forms: &[("isometric", Form::Additive)],
        }
    }

    /// As strong as paths need, see [`MetricParams::of_paths`]; a fifth of the energy of real beats or less.
    fn lambda(&self) -> f64 {
        0.5
    }

    fn ignores_scale(&self) -> bool {
        false
    }

    fn is_inner_product(&self, _: Form) -> bool {
        true
    }

    fn path_energy_can_vanish(&self, _: &MetricParams) -> bool {
        false
    }

    fn pair(
        &self,
        metric: &Metric,
        [a, b]: [&PreparedPose; 2],
        (rotation, _): Motion,
        scratch: &mut PairScratch,
    ) -> Both {
        stretches(a, b, rotation, &mut scratch.stretch);
        let raw = metric.params.corners == Corners::Raw;
        let weights = [metric.edge_weights(a), metric.edge_weights(b)];
        let mut sums = [0.0; 2];
        for (e, both) in scratch.stretch.iter().enumerate() {
            for (side, pose) in [a, b].into_iter().enumerate() {
                let unit = if raw { pose.length2[e] } else { 1.0 };
                // Raw, s l² is the printed product; the square of its length is divided out otherwise.
                sums[side] += weights[side][e] * (both[side] * unit).powi(2);
            }
        }
        sums
    }

    /// Σ_e w_e ⟨X_p − X_q, p − q⟩⟨Y_p − Y_q, p − q⟩, each factor over |p − q|² where corners are scale-free.
    fn product(&self, metric: &Metric, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64 {
        let weights = metric.edge_weights(at);
        let rates = (metric.field_stretch(at, x).into_iter()).zip(metric.field_stretch(at, y));
        let raw = metric.params.corners == Corners::Raw;
        (rates.zip(weights).enumerate())
            .map(|(e, ((x, y), weight))| {
                let unit = if raw { at.length2[e] } else { 1.0 };
                weight * (x * unit) * (y * unit)
            })
            .sum()
    }

    fn add_coordinates(
        &self,
        metric: &Metric,
        at: &PreparedPose,
        field: &[Vector3],
        coordinates: &mut Vec<f64>,
    ) {
        let rates = metric.field_stretch(at, field).into_iter();
        let raw = metric.params.corners == Corners::Raw;
        let weighted = rates.zip(metric.edge_weights(at)).enumerate();
        coordinates.extend(weighted.map(|(e, (rate, weight))| {
            let unit = if raw { at.length2[e] } else { 1.0 };
            weight.sqrt() * rate * unit
        }));
    }

    fn add_face_shares(
        &self,
        metric: &Metric,
        poses: [&PreparedPose; 2],
        rotation: &Matrix3<f64>,
        scratch: &mut PairScratch,
        shares: &mut [f64],
    ) {
        stretches(poses[0], poses[1], rotation, &mut scratch.stretch);
        let parts: Vec<_> = metric.mesh.side_parts(metric.params.area_weights).collect();
        add_face_shares(metric, poses, &scratch.stretch, shares, |f, s, l| {
            of_sides(s, l, parts[f]).energy
        });
    }

    fn add_face_energies(&self, plan: &Plan, state: &mut PathState, gradients: &mut Gradients) {
        let (raw, role) = (plan.raw(), CurvatureRole::Unused);
        add_faces(plan, state, gradients, raw, role, |f, s, l, _| {
            of_sides(s, l, three(|e| Lanes::splat(plan.side_parts[f][e])))
        });
    }

    fn side_stiffness(
        &self,
        params: &MetricParams,
        length2: [f64; 3],
        _: Option<[f64; 3]>,
    ) -> Option<[[f64; 3]; 3]> {
        // An edge belongs to two faces, or counts a third in each of them.
        let part = if params.area_weights { 1.0 / 3.0 } else { 0.5 };
        let mut form = [[0.0; 3]; 3];
        for (side, length2) in length2.into_iter().enumerate() {
            form[side][side] = part
                * match params.corners {
                    Corners::Raw => length2 * length2,
                    Corners::ScaleFree => 1.0,
                };
        }
        Some(form)
    }
}
