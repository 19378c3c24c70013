//! Measures every pose of a path: lengths, areas, angles, curvature; and what changes from step to step.

use crate::numeric::{Arithmetic, Lanes, three};

use super::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::corner::{
    Axes, angles_rad, cotangents, density, dot, face_shape, minus, stretch,
};

/// All measures of the poses as they lie in `state`.
#[inline(always)]
pub(super) fn measure(plan: &Plan, state: &mut PathState, gradients: &mut Gradients) {
    sides(plan, state);
    // Angles cost two arc tangents for each face, and only curvature needs them.
    if plan.needs_curvature() {
        faces::<true>(plan, state);
        curvature(plan, state, gradients);
    } else {
        faces::<false>(plan, state);
        for (v, at) in state.around.chunks_exact(plan.blocks).enumerate() {
            for (b, &[_, area]) in at.iter().enumerate() {
                state.vertex_area.set(v, b, area * Lanes::splat(1.0 / 3.0));
            }
        }
    }
}

/// A vertex where steps begin and where they end.
#[inline(always)]
pub(super) fn points(state: &PathState, vertex: u32, block: usize) -> [Axes<Lanes>; 2] {
    let [x, y, z] = three(|axis| state.points.both(3 * vertex as usize + axis, block));
    [[x[0], y[0], z[0]], [x[1], y[1], z[1]]]
}

#[inline(always)]
fn sides(plan: &Plan, state: &mut PathState) {
    let raw = plan.raw();
    for (e, &[p, q]) in plan.mesh.edges.iter().enumerate() {
        for b in 0..plan.blocks {
            let (p, q) = (points(state, p, b), points(state, q, b));
            let (before, after) = (minus(p[0], q[0]), minus(p[1], q[1]));
            let length2 = dot(after, after);
            if raw {
                state.length2.set(e, b, length2);
            }
            // `over` gives 0 for a side without length, which takes it out of every sum.
            let inverse = Lanes::splat(1.0).over(length2);
            let inverse = state.inverse_length2.set(e, b, inverse);
            state.stretch[e * plan.blocks + b] = stretch(before, after, inverse);
        }
    }
}

#[inline(always)]
fn faces<const ANGLES: bool>(plan: &Plan, state: &mut PathState) {
    state.around.fill([Lanes::default(); 2]);
    for b in 0..plan.blocks {
        let mut total = Lanes::default();
        for (f, triangle) in plan.mesh.triangles.iter().enumerate() {
            let [p, q, r] = three(|c| points(state, triangle[c], b)[1]);
            let shape = face_shape(p, q, r);
            let area = Lanes::splat(0.5) * shape.0;
            total += area;
            state.face_area.set(f, b, area);
            // Kept: the derivatives of area and of angles need the same numbers on the way back.
            state.cotangents[f * plan.blocks + b] = cotangents(shape);
            let angles = if ANGLES {
                angles_rad(shape)
            } else {
                [Lanes::default(); 3]
            };
            for (&vertex, angle) in triangle.iter().zip(angles) {
                let at = &mut state.around[vertex as usize * plan.blocks + b];
                if ANGLES {
                    at[0] += angle;
                }
                at[1] += area;
            }
        }
        state.total_area.set(0, b, total);
    }
}

/// K of each vertex as the density of the metric or the angle deficit, and its change.
#[inline(always)]
fn curvature(plan: &Plan, state: &mut PathState, gradients: &mut Gradients) {
    let (mesh, blocks) = (&plan.mesh, plan.blocks);
    for v in 0..mesh.vertex_count {
        for b in 0..blocks {
            let [angles, area] = state.around[v * blocks + b];
            let (turn, area) = (
                Lanes::splat(mesh.flat_rad[v]) - angles,
                area * Lanes::splat(1.0 / 3.0),
            );
            state.vertex_area.set(v, b, area);
            // At the rim the turn depends on where the surface was cut, so it gives nothing to the mean.
            state.around[v * blocks + b] = if plan.params.area_weights && !mesh.inside[v] {
                [Lanes::default(); 2]
            } else {
                [turn, area]
            };
        }
    }
    if plan.params.area_weights {
        let rings = plan.params.curvature.rings(mesh.vertex_count);
        mesh.gather(&mut state.around, &mut gradients.spare, blocks, rings);
    }
    for v in 0..mesh.vertex_count {
        for b in 0..blocks {
            let [turn, area] = state.around[v * blocks + b];
            let found = if plan.params.area_weights {
                density(turn, area, state.total_area.ends(0, b))
            } else {
                turn
            };
            let [before, after] = state.curvature.set(v, b, found);
            state.curvature_change[v * blocks + b] = after - before;
        }
    }
}
