//! Passes over the corners of all faces, which both metrics of angles share.

use crate::analysis::metrics::face_energy::of_corners;
use crate::analysis::metrics::face_shares::add_face_shares;
use crate::analysis::metrics::metric::Metric;
use crate::analysis::metrics::pair_sums::Both;
use crate::analysis::metrics::params::{Corners, CurvatureRole, Form, MetricParams};
use crate::analysis::metrics::path_energy::faces::add_faces;
use crate::analysis::metrics::path_energy::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::pose::PreparedPose;

/// Energies of the corners at all steps of a path, with their gradients.
pub(super) fn add_corner_energies(plan: &Plan, state: &mut PathState, gradients: &mut Gradients) {
    let printed = plan.params.form == Form::Printed;
    let role = plan.curvature;
    if role.is_factor() || plan.raw() || printed {
        add_faces(plan, state, gradients, plan.raw(), role, |_, s, l, k| {
            of_corners(s, l, k, printed)
        });
    } else {
        // The default: with constants in these places the compiler makes a faster loop of it.
        let unused = CurvatureRole::Unused;
        add_faces(plan, state, gradients, false, unused, |_, s, _, _| {
            of_corners(s, None, None, false)
        });
    }
}

/// Adds to each face half the terms of its corners at both poses; `factors`, one per vertex, multiply them.
pub(super) fn add_corner_shares(
    metric: &Metric,
    poses: [&PreparedPose; 2],
    stretch: &[Both],
    factors: Option<&[f64]>,
    shares: &mut [f64],
) {
    let printed = metric.params.form == Form::Printed;
    add_face_shares(metric, poses, stretch, shares, |f, s, l| {
        let factors = factors.map(|k| metric.mesh.triangles[f].map(|v| k[v as usize]));
        of_corners(s, l, factors, printed).energy
    });
}

/// The quadratic form of squared corner terms on the relative rates of length of the sides ab, bc, ca.
pub(super) fn corner_stiffness(
    params: &MetricParams,
    length2: [f64; 3],
    corner_weights: Option<[f64; 3]>,
) -> [[f64; 3]; 3] {
    let mut form = [[0.0; 3]; 3];
    for c in 0..3 {
        // The corner between side c and the side before it.
        let last = (c + 2) % 3;
        let unit = match params.corners {
            Corners::Raw => (length2[c] * length2[last]).powi(2),
            Corners::ScaleFree => 1.0,
        };
        let weight = unit * corner_weights.map_or(1.0, |weights| weights[c]);
        form[c][c] += weight;
        form[last][last] += weight;
        form[c][last] -= weight;
        form[last][c] -= weight;
    }
    form
}
