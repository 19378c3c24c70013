//! The metric of displacement along a path: what no rigid motion explains of each step, and its gradient.

use crate::mesh::{Point3, Vector3};
use crate::numeric::LANES;

use crate::analysis::metrics::rigid::rigid_part;

use super::state::{Gradients, PathState, Plan, RigidScratch};

/// Adds energies and their derivatives along vertices and areas of vertices.
///
/// The energy Σ w |X − k₁ − k₂ × p|² is least over k₁ and k₂, so its derivatives are those at fixed k: with X' what is
/// left of X, 2 w X' along X, −2 w X' × k₂ along p and |X'|² along w.
pub(in crate::analysis::metrics) fn add_energies(
    plan: &Plan,
    state: &mut PathState,
    gradients: &mut Gradients,
) {
    // Taken out, so that the gradients can be written to while it is in use.
    let mut scratch = std::mem::take(&mut gradients.rigid);
    for step in 0..plan.step_count() {
        for side in 0..2 {
            add_side(plan, state, gradients, step, side, &mut scratch);
        }
    }
    gradients.rigid = scratch;
}

fn add_side(
    plan: &Plan,
    state: &mut PathState,
    gradients: &mut Gradients,
    step: usize,
    side: usize,
    scratch: &mut RigidScratch,
) {
    let count = plan.mesh.vertex_count;
    let pose = step + side;
    let point = |state: &PathState, v: usize, pose: usize| {
        Point3::from([0, 1, 2].map(|axis| state.points.at(3 * v + axis, pose)))
    };
    let by_area = plan.params.area_weights;
    let total = state.total_area.at(0, pose);
    // Without area weights the derivative along the area is 0.
    let scale = if by_area && total > 0.0 {
        1.0 / total
    } else {
        0.0
    };
    let RigidScratch {
        points,
        weights,
        field,
    } = scratch;
    points.clear();
    points.extend((0..count).map(|v| point(state, v, pose)));
    field.clear();
    field.extend((0..count).map(|v| point(state, v, step + 1) - point(state, v, step)));
    weights.clear();
    weights.extend((0..count).map(|v| {
        if by_area {
            scale * state.vertex_area.at(v, pose)
        } else {
            1.0
        }
    }));
    let rigid = rigid_part(points, weights, field);
    let mut energy = 0.0;
    for v in 0..count {
        let left = field[v] - rigid.at(&points[v]);
        let length2 = left.norm_squared();
        energy += weights[v] * length2;
        // The rigid part is the best one, so that its own change adds nothing to first order.
        let along_field = left * (2.0 * weights[v]);
        let along_point = -along_field.cross(&rigid.k2);
        let mut add = |pose: usize, slope: Vector3| {
            if let Some((block, lane)) = place(pose) {
                let at = &mut gradients.points[v * plan.blocks + block];
                for axis in 0..3 {
                    at[axis].0[lane] += slope[axis];
                }
            }
        };
        add(step, -along_field);
        add(step + 1, along_field);
        add(pose, along_point);
        if let Some((block, lane)) = place(pose) {
            gradients.vertex_area[v * plan.blocks + block].0[lane] += scale * length2;
        }
    }
    state.own[step / LANES][side].0[step % LANES] += energy;
}

/// Block and lane of a pose; pose 0 is in none.
fn place(pose: usize) -> Option<(usize, usize)> {
    // Pose 0 is the fixed start and has no gradient.
    let inner = pose.checked_sub(1)?;
    Some((inner / LANES, inner % LANES))
}
