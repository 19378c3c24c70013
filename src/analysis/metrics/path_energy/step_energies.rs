//! Energies of the steps of a path, and their gradients with respect to lengths, areas and curvatures.

use crate::numeric::{Arithmetic, Lanes, both};

use crate::analysis::metrics::corner::{dot, minus};
use crate::analysis::metrics::kinds::terms;
use crate::analysis::metrics::params::Corners;
use crate::analysis::metrics::pose::regulariser_factor;

use super::faces::Weights;
use super::measure::points;
use super::rows::onto_poses;
use super::state::{Gradients, PathState, Plan};

/// Adds the energies of all steps to `state`, and their derivatives along lengths, areas and curvatures to `gradients`.
#[inline(always)]
pub(super) fn add_step_energies(plan: &Plan, state: &mut PathState, gradients: &mut Gradients) {
    gradients.stretch.fill([Lanes::default(); 2]);
    gradients.length2.fill(Lanes::default());
    gradients.curvature_change.fill(Lanes::default());
    state.own.fill([Lanes::default(); 2]);
    let kind = terms(plan.params.kind);
    kind.add_face_energies(plan, state, gradients);
    vertices(plan, state, gradients);
    // After `vertices`, which overwrites the gradients that these are added to.
    kind.add_vertex_energies(plan, state, gradients);
    total_area_gradients(plan, state, gradients);
}

/// Curvature change and regulariser: sums over vertices.
#[inline(always)]
fn vertices(plan: &Plan, state: &mut PathState, gradients: &mut Gradients) {
    let blocks = plan.blocks;
    let mu = Lanes::splat(plan.mu());
    let two = Lanes::splat(2.0);
    state.regulariser.fill([Lanes::default(); 2]);
    for v in 0..plan.mesh.vertex_count {
        let (mut area_before, mut points_before) = (0.0, [0.0; 3]);
        // From the last block back, since the first step of a block adds to the last pose of the one before.
        for b in (0..blocks).rev() {
            let at = v * blocks + b;
            let areas = state.vertex_area.both(v, b);
            let of_curvature = Weights::new(state, plan.params.area_weights, b);
            let of_regulariser = Weights::new(state, plan.regulariser_by_area(), b);
            let lambda = lambda(plan, state, b);
            let (w, r) = (of_curvature.of(areas), of_regulariser.of(areas));
            let change = state.curvature_change[at];
            let bend = mu * change * change;
            let [before, after] = points(state, v as u32, b);
            let x = minus(after, before);
            let length2 = dot(x, x);
            let mut along_area = [Lanes::default(); 2];
            for side in 0..2 {
                state.own[b][side] += w[side] * bend;
                state.regulariser[b][side] += lambda[side] * r[side] * length2;
                along_area[side] = of_curvature.scale[side] * bend
                    + lambda[side] * of_regulariser.scale[side] * length2;
            }
            gradients.vertex_area[at] = onto_poses(along_area, &mut area_before);
            gradients.curvature_change[at] += two * mu * change * (w[0] + w[1]);
            // The displacement of a step is shared by both of its poses.
            let pull = two * (lambda[0] * r[0] + lambda[1] * r[1]);
            for axis in 0..3 {
                let slope = pull * x[axis];
                gradients.points[at][axis] = onto_poses([-slope, slope], &mut points_before[axis]);
            }
        }
    }
}

/// Factor of the regulariser where steps begin and where they end.
#[inline(always)]
fn lambda(plan: &Plan, state: &PathState, block: usize) -> [Lanes; 2] {
    // Fixed at the size of the ends, or a path would be cheaper where the subject is large.
    if let Some(factor) = plan.shared_regulariser_factor {
        return [Lanes::splat(factor); 2];
    }
    let total = state.total_area.both(0, block);
    both(|side| total[side].map(|total| regulariser_factor(&plan.params, total)))
}

/// Weights are areas over the whole area, and the unit of the regulariser may be that area too: the
/// derivative of an energy along the whole area is that energy over −area, once for each.
#[inline(always)]
fn total_area_gradients(plan: &Plan, state: &PathState, gradients: &mut Gradients) {
    let once = |does: bool| Lanes::splat(if does { 1.0 } else { 0.0 });
    let own = once(plan.params.area_weights);
    let by_area = plan.regulariser_by_area();
    let own_unit = plan.shared_regulariser_factor.is_none();
    // The factor itself is per area then, and has a derivative of its own.
    let relative = by_area && own_unit && plan.params.corners == Corners::ScaleFree;
    let rest = once(by_area) + once(relative);
    let mut points_before = 0.0;
    for b in (0..plan.blocks).rev() {
        let total = state.total_area.both(0, b);
        let slope = both(|side| {
            -(own * state.own[b][side] + rest * state.regulariser[b][side]).over(total[side])
        });
        gradients.total_area[b] = onto_poses(slope, &mut points_before);
    }
}
