//! From derivatives along curvatures, areas and lengths to the gradient along the vertices.

use crate::numeric::{Arithmetic, Lanes, both, three};

use super::measure::points;
use super::rows::onto_poses;
use super::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::corner::{angle_gradient, minus};

/// Turns all derivatives into those along the coordinates of the poses, added to those of `gradients`.
#[inline(always)]
pub(super) fn backpropagate(plan: &Plan, state: &PathState, gradients: &mut Gradients) {
    if plan.needs_curvature() {
        curvature(plan, state, gradients);
        faces::<true>(plan, state, gradients);
    } else {
        // No curvature: what is known of vertices is the gradient on their areas.
        for (around, &area) in gradients.around.iter_mut().zip(&gradients.vertex_area) {
            *around = [Lanes::default(), area];
        }
        faces::<false>(plan, state, gradients);
    }
    // Last: areas and angles have by now added to the gradients on squared lengths that it distributes.
    edges(plan, state, gradients);
}

/// From curvature to the angles and areas around vertices.
///
/// With K = T / a · A / 4π of gathered turns T and areas a, the derivatives along T and a are those along K times
/// A / (4π a) and −K / a. Gathering is symmetric: its adjoint is gathering again.
#[inline(always)]
fn curvature(plan: &Plan, state: &PathState, gradients: &mut Gradients) {
    let (mesh, blocks) = (&plan.mesh, plan.blocks);
    let unit = Lanes::splat(1.0 / (4.0 * std::f64::consts::PI));
    let density = plan.params.area_weights;
    for v in 0..mesh.vertex_count {
        let mut carry = 0.0;
        for b in (0..blocks).rev() {
            let at = v * blocks + b;
            let change = gradients.curvature_change[at];
            let slope = onto_poses([-change, change], &mut carry);
            gradients.around[at] = if density {
                let (k, total) = (state.curvature.ends(v, b), state.total_area.ends(0, b));
                // The quotient rule of turn / area · whole area.
                let over_area = slope.over(state.around[at][1]);
                gradients.total_area[b] += (k * slope).over(total);
                [over_area * total * unit, -(k * over_area)]
            } else {
                [slope, Lanes::default()]
            };
        }
    }
    if density {
        let rings = plan.params.curvature.rings(mesh.vertex_count);
        // Gathering is symmetric, so that its adjoint is itself.
        mesh.gather(&mut gradients.around, &mut gradients.spare, blocks, rings);
    }
    for v in 0..mesh.vertex_count {
        let counts = !density || mesh.inside[v];
        for at in v * blocks..(v + 1) * blocks {
            let area = gradients.vertex_area[at];
            let [turn, gathered_area] = gradients.around[at];
            // A turn is what the angles lack.
            gradients.around[at] = if counts {
                [-turn, area + gathered_area]
            } else {
                [Lanes::default(), area]
            };
        }
    }
}

/// From angles and areas to squared lengths of sides: with A = ¼ Σ cot · length² at fixed
/// cotangents, ∂A / ∂length² = ¼ cot of the corner across.
#[inline(always)]
fn faces<const ANGLES: bool>(plan: &Plan, state: &PathState, gradients: &mut Gradients) {
    let (mesh, blocks) = (&plan.mesh, plan.blocks);
    let (third, quarter) = (Lanes::splat(1.0 / 3.0), Lanes::splat(0.25));
    let half = Lanes::splat(0.5);
    for (f, (triangle, edges)) in mesh.triangles.iter().zip(&mesh.face_edges).enumerate() {
        for b in 0..blocks {
            let around = three(|c| gradients.around[triangle[c] as usize * blocks + b]);
            let area = gradients.face_area[f * blocks + b]
                + gradients.total_area[b]
                + third * (around[0][1] + around[1][1] + around[2][1]);
            let cotangents = state.cotangents[f * blocks + b];
            let turning = if ANGLES {
                angle_gradient(cotangents, three(|c| around[c][0]))
            } else {
                [Lanes::default(); 3]
            };
            for e in 0..3 {
                let edge = edges[e] as usize;
                // ∂A / ∂ℓ² is a fourth of the cotangent of the opposite corner.
                let mut slope = quarter * area * cotangents[(e + 2) % 3];
                if ANGLES {
                    // The rate of relative length is half that of length² over length².
                    slope += half * turning[e] * state.inverse_length2.ends(edge, b);
                }
                gradients.length2[edge * blocks + b] += slope;
            }
        }
    }
}

/// From squared lengths and stretches to vertices.
///
/// With r = ⟨w, d_A⟩ and r' = ⟨w, d_B⟩, w = d_B − d_A, stretches are s = r / |d_A|² and s' = r' / |d_B|².
/// So with g = ∂E/∂s / |d_A|² and g' likewise: the derivative along d_A is −2 g (1 + s) d_A + (g − g') d_B, along d_B
/// 2 g' (1 − s') d_B + (g − g') d_A.
#[inline(always)]
fn edges(plan: &Plan, state: &PathState, gradients: &mut Gradients) {
    let blocks = plan.blocks;
    let (one, two) = (Lanes::splat(1.0), Lanes::splat(2.0));
    for (e, &[p, q]) in plan.mesh.edges.iter().enumerate() {
        let (mut carry, mut carries) = (0.0, [0.0; 3]);
        for b in (0..blocks).rev() {
            let at = e * blocks + b;
            let (of_p, of_q) = (points(state, p, b), points(state, q, b));
            let [before, after] = both(|side| minus(of_p[side], of_q[side]));
            let inverse = state.inverse_length2.both(e, b);
            let (s, slope) = (state.stretch[at], gradients.stretch[at]);
            let g = both(|side| slope[side] * inverse[side]);
            let along_own = [-(two * g[0] * (one + s[0])), two * g[1] * (one - s[1])];
            let own = two * gradients.length2[at] + onto_poses(along_own, &mut carry);
            // A stretch depends on both poses of its step, each through the other’s side.
            let across = g[0] - g[1];
            for axis in 0..3 {
                let beside = [across * after[axis], across * before[axis]];
                let slope = own * after[axis] + onto_poses(beside, &mut carries[axis]);
                gradients.points[p as usize * blocks + b][axis] += slope;
                let at_q = &mut gradients.points[q as usize * blocks + b][axis];
                *at_q = *at_q - slope;
            }
        }
    }
}
