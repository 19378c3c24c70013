//! Sums over the faces of all poses of a path, with their gradients.

use crate::numeric::{Arithmetic, LANES, Lanes, both, three};

use crate::analysis::metrics::face_energy::FaceEnergy;
use crate::analysis::metrics::params::CurvatureRole;

use super::rows::onto_poses;
use super::state::{Gradients, PathState, Plan};

/// Weight of an item as scale × area + offset, where steps begin and where they end.
#[derive(Clone, Copy)]
pub(super) struct Weights {
    pub scale: [Lanes; 2],
    offset: Lanes,
}

impl Weights {
    #[inline(always)]
    pub fn new(state: &PathState, by_area: bool, block: usize) -> Self {
        let one = Lanes::splat(1.0);
        if by_area {
            Self {
                scale: both(|side| one.over(state.total_area.both(0, block)[side])),
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
    pub fn of(&self, areas: [Lanes; 2]) -> [Lanes; 2] {
        both(|side| self.scale[side] * areas[side] + self.offset)
    }
}

/// Adds the energy of every face at all steps, `energy_of` a face being given by the stretches of its sides, their squared
/// lengths where corners are raw, and the factors of its corners where curvature has the role of a factor.
#[inline(always)]
pub(in crate::analysis::metrics) fn add_faces(
    plan: &Plan,
    state: &mut PathState,
    gradients: &mut Gradients,
    raw: bool,
    role: CurvatureRole,
    energy_of: impl Fn(usize, [Lanes; 3], Option<[Lanes; 3]>, Option<[Lanes; 3]>) -> FaceEnergy<Lanes>,
) {
    let (mesh, blocks) = (&plan.mesh, plan.blocks);
    for (f, (triangle, edges)) in mesh.triangles.iter().zip(&mesh.face_edges).enumerate() {
        let mut carry = 0.0;
        // From the last block back: the first step of a block adds to the last pose of the block before.
        for b in (0..blocks).rev() {
            // Weights are shares of the area, which differs from pose to pose.
            let weights = Weights::new(state, plan.params.area_weights, b);
            let weight = weights.of(state.face_area.both(f, b));
            let s = three(|e| state.stretch[edges[e] as usize * blocks + b]);
            let lengths = three(|e| {
                if raw {
                    state.length2.both(edges[e] as usize, b)
                } else {
                    [Lanes::default(); 2]
                }
            });
            let k = match role {
                CurvatureRole::Unused | CurvatureRole::Term => None,
                CurvatureRole::StepFactor => Some(three(|c| {
                    state.curvature_change[triangle[c] as usize * blocks + b]
                })),
                CurvatureRole::FrozenFactor => {
                    Some(three(|c| Lanes::splat(plan.frozen[triangle[c] as usize])))
                }
            };
            let found = both(|side| {
                let l = raw.then(|| three(|e| lengths[e][side]));
                energy_of(f, three(|e| s[e][side]), l, k)
            });
            let mut along_area = [Lanes::default(); 2];
            for side in 0..2 {
                state.own[b][side] += weight[side] * found[side].energy;
                // The weight depends on the area of the face itself; its dependence on the whole area is added at the
                // end.
                along_area[side] = weights.scale[side] * found[side].energy;
            }
            gradients.face_area[f * blocks + b] = onto_poses(along_area, &mut carry);
            for c in 0..3 {
                let at = &mut gradients.stretch[edges[c] as usize * blocks + b];
                for side in 0..2 {
                    at[side] += weight[side] * found[side].stretch[c];
                }
                // Frozen factors depend on the ends alone and have no gradient.
                if role == CurvatureRole::StepFactor {
                    let at = &mut gradients.curvature_change[triangle[c] as usize * blocks + b];
                    for side in 0..2 {
                        if let Some(slope) = found[side].factor {
                            *at += weight[side] * slope[c];
                        }
                    }
                }
            }
            if raw {
                length_gradients(plan, gradients, edges, b, weight, &found);
            }
        }
    }
}

/// Gradients along the squared lengths of the sides of a face: those of the end belong to the pose of the
/// lane, those of the beginning to the one before; pose 0 has none.
#[inline(always)]
fn length_gradients(
    plan: &Plan,
    gradients: &mut Gradients,
    edges: &[u32; 3],
    block: usize,
    weight: [Lanes; 2],
    found: &[FaceEnergy<Lanes>; 2],
) {
    for c in 0..3 {
        let at = edges[c] as usize * plan.blocks + block;
        let [begins, ends] = both(|side| {
            let slope = found[side].length2.map_or(Lanes::default(), |l| l[c]);
            weight[side] * slope
        });
        // What crosses the border of a block is added to the block before, below.
        gradients.length2[at] += ends + begins.earlier(0.0);
        if block > 0 {
            gradients.length2[at - 1].0[LANES - 1] += begins.0[0];
        }
    }
}
