//! What the steps of a path cost, and the slopes of that along lengths, areas and curvatures.

use crate::numeric::{Arithmetic, Lanes, both, three};

use super::corner::{dot, minus};
use super::face_charge::{FaceCharge, of_corners, of_sides};
use super::measure::points;
use super::pose::regulariser_factor;
use super::rows::onto_poses;
use super::state::{Along, Factor, Plan, Slopes};
use super::{Corners, Form, MetricKind, rigid_steps};

/// Weight of an item as scale × area + offset, where steps begin and where they end.
#[derive(Clone, Copy)]
struct Weights {
    scale: [Lanes; 2],
    offset: Lanes,
}

impl Weights {
    #[inline(always)]
    fn new(along: &Along, by_area: bool, block: usize) -> Self {
        let one = Lanes::splat(1.0);
        if by_area {
            Self {
                scale: both(|side| one.over(along.total_area.both(0, block)[side])),
                offset: Lanes::default(),
            }
        } else {
            Self {
                scale: [Lanes::default(); 2],
                offset: one,
            }
        }
    }

    #[inline(always)]
    fn of(&self, areas: [Lanes; 2]) -> [Lanes; 2] {
        both(|side| self.scale[side] * areas[side] + self.offset)
    }
}

/// Energies of all steps into `along`, their direct slopes into `slopes`.
#[inline(always)]
pub(super) fn charge_steps(plan: &Plan, along: &mut Along, slopes: &mut Slopes) {
    slopes.stretch.fill([Lanes::default(); 2]);
    slopes.length2.fill(Lanes::default());
    slopes.curvature_change.fill(Lanes::default());
    along.own.fill([Lanes::default(); 2]);
    let printed = plan.params.form == Form::Printed;
    match (plan.params.kind, plan.factor(), plan.raw(), printed) {
        (MetricKind::Rigid, ..) => slopes.face_area.fill(Lanes::default()),
        (MetricKind::Isometric, _, raw, _) => {
            faces(plan, along, slopes, raw, Factor::One, |f, s, l, _| {
                of_sides(s, l, three(|e| Lanes::splat(plan.side_parts[f][e])))
            });
        }
        // The default, which the compiler makes a loop of its own.
        (_, Factor::One, false, false) => {
            faces(plan, along, slopes, false, Factor::One, |_, s, _, _| {
                of_corners(s, None, None, false)
            });
        }
        (_, factor, raw, printed) => {
            faces(plan, along, slopes, raw, factor, |_, s, l, k| {
                of_corners(s, l, k, printed)
            });
        }
    }
    vertices(plan, along, slopes);
    if plan.params.kind == MetricKind::Rigid {
        rigid_steps::charge(plan, along, slopes);
    }
    total_area_slopes(plan, along, slopes);
}

#[inline(always)]
fn faces(
    plan: &Plan,
    along: &mut Along,
    slopes: &mut Slopes,
    raw: bool,
    factor: Factor,
    charge_of: impl Fn(usize, [Lanes; 3], Option<[Lanes; 3]>, Option<[Lanes; 3]>) -> FaceCharge<Lanes>,
) {
    let (mesh, blocks) = (&plan.mesh, plan.blocks);
    for (f, (triangle, edges)) in mesh.triangles.iter().zip(&mesh.face_edges).enumerate() {
        let mut carry = 0.0;
        for b in (0..blocks).rev() {
            let weights = Weights::new(along, plan.params.area_weights, b);
            let weight = weights.of(along.face_area.both(f, b));
            let s = three(|e| along.stretch[edges[e] as usize * blocks + b]);
            let lengths = three(|e| {
                if raw {
                    along.length2.both(edges[e] as usize, b)
                } else {
                    [Lanes::default(); 2]
                }
            });
            let k = match factor {
                Factor::One => None,
                Factor::Change => Some(three(|c| {
                    along.curvature_change[triangle[c] as usize * blocks + b]
                })),
                Factor::Frozen => Some(three(|c| Lanes::splat(plan.frozen[triangle[c] as usize]))),
            };
            let found = both(|side| {
                let l = raw.then(|| three(|e| lengths[e][side]));
                charge_of(f, three(|e| s[e][side]), l, k)
            });
            let mut along_area = [Lanes::default(); 2];
            for side in 0..2 {
                along.own[b][side] += weight[side] * found[side].charge;
                along_area[side] = weights.scale[side] * found[side].charge;
            }
            slopes.face_area[f * blocks + b] = onto_poses(along_area, &mut carry);
            for c in 0..3 {
                let at = &mut slopes.stretch[edges[c] as usize * blocks + b];
                for side in 0..2 {
                    at[side] += weight[side] * found[side].stretch[c];
                }
                if factor == Factor::Change {
                    let at = &mut slopes.curvature_change[triangle[c] as usize * blocks + b];
                    for side in 0..2 {
                        if let Some(slope) = found[side].factor {
                            *at += weight[side] * slope[c];
                        }
                    }
                }
            }
            if raw {
                lengths_slopes(plan, slopes, edges, b, weight, &found);
            }
        }
    }
}

/// Slopes along the squared lengths of the sides of a face: those of the end belong to the pose of the
/// lane, those of the beginning to the one before; pose 0 has none.
#[inline(always)]
fn lengths_slopes(
    plan: &Plan,
    slopes: &mut Slopes,
    edges: &[u32; 3],
    block: usize,
    weight: [Lanes; 2],
    found: &[FaceCharge<Lanes>; 2],
) {
    for c in 0..3 {
        let at = edges[c] as usize * plan.blocks + block;
        let [begins, ends] = both(|side| {
            let slope = found[side].length2.map_or(Lanes::default(), |l| l[c]);
            weight[side] * slope
        });
        slopes.length2[at] += ends + begins.earlier(0.0);
        if block > 0 {
            slopes.length2[at - 1].0[3] += begins.0[0];
        }
    }
}

/// Curvature change and regulariser: sums over vertices.
#[inline(always)]
fn vertices(plan: &Plan, along: &mut Along, slopes: &mut Slopes) {
    let blocks = plan.blocks;
    let mu = Lanes::splat(plan.mu());
    let two = Lanes::splat(2.0);
    along.rest.fill([Lanes::default(); 2]);
    for v in 0..plan.mesh.vertex_count {
        let (mut carry_area, mut carry) = (0.0, [0.0; 3]);
        for b in (0..blocks).rev() {
            let at = v * blocks + b;
            let areas = along.vertex_area.both(v, b);
            let of_curvature = Weights::new(along, plan.params.area_weights, b);
            let of_rest = Weights::new(along, plan.regulariser_by_area(), b);
            let lambda = lambda(plan, along, b);
            let (w, r) = (of_curvature.of(areas), of_rest.of(areas));
            let change = along.curvature_change[at];
            let bend = mu * change * change;
            let [before, after] = points(along, v as u32, b);
            let x = minus(after, before);
            let length2 = dot(x, x);
            let mut along_area = [Lanes::default(); 2];
            for side in 0..2 {
                along.own[b][side] += w[side] * bend;
                along.rest[b][side] += lambda[side] * r[side] * length2;
                along_area[side] =
                    of_curvature.scale[side] * bend + lambda[side] * of_rest.scale[side] * length2;
            }
            slopes.vertex_area[at] = onto_poses(along_area, &mut carry_area);
            slopes.curvature_change[at] += two * mu * change * (w[0] + w[1]);
            let pull = two * (lambda[0] * r[0] + lambda[1] * r[1]);
            for axis in 0..3 {
                let slope = pull * x[axis];
                slopes.points[at][axis] = onto_poses([-slope, slope], &mut carry[axis]);
            }
        }
    }
}

/// Factor of the regulariser where steps begin and where they end.
#[inline(always)]
fn lambda(plan: &Plan, along: &Along, block: usize) -> [Lanes; 2] {
    if let Some(factor) = plan.rest_factor {
        return [Lanes::splat(factor); 2];
    }
    let total = along.total_area.both(0, block);
    both(|side| total[side].map(|total| regulariser_factor(&plan.params, total)))
}

/// Weights are areas over the whole area, and the unit of the regulariser may be that area too: the
/// slope of a charge along the whole area is that charge over −area, once for each.
#[inline(always)]
fn total_area_slopes(plan: &Plan, along: &Along, slopes: &mut Slopes) {
    let once = |does: bool| Lanes::splat(if does { 1.0 } else { 0.0 });
    let own = once(plan.params.area_weights);
    let by_area = plan.regulariser_by_area();
    let own_unit = plan.rest_factor.is_none();
    let relative = by_area && own_unit && plan.params.corners == Corners::ScaleFree;
    let rest = once(by_area) + once(relative);
    let mut carry = 0.0;
    for b in (0..plan.blocks).rev() {
        let total = along.total_area.both(0, b);
        let slope =
            both(|side| -(own * along.own[b][side] + rest * along.rest[b][side]).over(total[side]));
        slopes.total_area[b] = onto_poses(slope, &mut carry);
    }
}
