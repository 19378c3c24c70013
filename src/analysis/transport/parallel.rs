//! The discrete scheme of parallel transport, for whatever space its path lies in.

use crate::mesh::Vector3;

use super::Nearness;

/// Products at one sample of a field X and the path's velocity V.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Products {
    /// ⟨⟨X, X⟩⟩.
    pub field: f64,
    /// ⟨⟨X, V⟩⟩.
    pub mixed: f64,
    /// ⟨⟨V, V⟩⟩.
    pub velocity: f64,
}

/// A path known at samples, with the tangent spaces there.
pub trait SampledPath {
    /// Number of samples.
    fn samples(&self) -> usize;

    /// Velocity at a sample, of any length.
    fn velocity(&self, sample: usize) -> &[Vector3];

    /// Inner products of a field with itself and the velocity at a sample.
    fn products(&self, sample: usize, field: &[Vector3]) -> Products;

    /// The coordinates C with Σ_p C_p·X_p = ⟨⟨V, X⟩⟩ for all X, V the velocity at a sample.
    fn lowered_velocity(&self, sample: usize) -> Vec<Vector3>;

    /// Lays a field that was tangent at the sample before into the tangent space of this one. All
    /// displacements of a mesh are tangent everywhere, so nothing is to do there.
    fn make_tangent(&self, _sample: usize, _field: &mut [Vector3]) {}
}

/// ‖V‖² below this share of ‖X‖² times the square of V against X in coordinates is round-off: the
/// metric does not see the path move (as the rigid metric does not see a turn).
const UNSEEN: f64 = 1e-24;

/// ‖P‖² below this share of ‖X‖² is the round-off of their difference: the field points along the
/// path.
const ROUND_OFF: f64 = 1e-14;

/// Transports X from the first sample to the last: at each next sample i, X̄ is the field nearest to X
/// with ⟨⟨X̄, γ'⟩⟩ = α₀, where γ' is the velocity with norm 1 and α₀ = ⟨⟨X, γ'⟩⟩ at the first.
///
/// Nearest in the metric: X̄ = X + (α₀ − ⟨⟨X, γ'⟩⟩) γ'. Nearest in coordinates:
/// X̄ = X + (α₀ − ⟨⟨X, γ'⟩⟩) C / ‖C‖², C·Y = ⟨⟨γ', Y⟩⟩. To keep the norm, the part P = X̄ − α₀ γ' is
/// then scaled so that ‖P‖² = ‖X‖² − α₀² of the first sample.
///
/// Samples at which the metric sees no movement constrain nothing; a path of one sample returns
/// the field as it is. On a sphere the scheme is exact along great circles. In the space of poses
/// it is the scheme of the text, and not the Levi-Civita transport of the metric, whose
/// Christoffel part orthogonal to γ' it leaves out.
///
/// Source: V. Taimouri, *Shape Analysis in Shape Space*, section 3.3.2, where neither the norm of
/// nearness nor the keeping of ‖X‖ is printed ("rotates minimally").
pub fn parallel_transport(
    path: &impl SampledPath,
    field: &[Vector3],
    nearness: Nearness,
    keep_norm: bool,
) -> Vec<Vector3> {
    let mut field = field.to_vec();
    if path.samples() < 2 {
        return field;
    }
    let first = path.products(0, &field);
    // Transport keeps the angle to the path: α₀ is what every later sample must have again.
    let mut alpha = along(path, 0, &field, first);
    for sample in 1..path.samples() {
        path.make_tangent(sample, &mut field);
        let mut at = path.products(sample, &field);
        let Some(inner) = along(path, sample, &field, at) else {
            if keep_norm {
                // Without a direction the whole field is orthogonal, and its norm is what can be kept.
                scale(&mut field, (first.field / at.field).sqrt());
            }
            continue;
        };
        // The path begins to move here only: so does the constraint.
        let alpha = *alpha.get_or_insert(inner);
        let speed = at.velocity.sqrt();
        match nearness {
            Nearness::Metric => {
                let change = (alpha - inner) / speed;
                add(&mut field, change, path.velocity(sample));
                // ‖X + c γ'‖² by the binomial formula, which saves another pass over the mesh.
                at.field += (alpha - inner) * (alpha + inner);
            }
            Nearness::Coordinates => {
                let lowered = path.lowered_velocity(sample);
                let length2: f64 = lowered.iter().map(Vector3::norm_squared).sum();
                if length2 > 0.0 {
                    add(&mut field, (alpha - inner) * speed / length2, &lowered);
                    // C is not along γ', so that the norm has no such short cut.
                    at = path.products(sample, &field);
                }
            }
        }
        if keep_norm {
            let left = at.field - alpha * alpha;
            // A field along the path has no orthogonal part whose length could be restored.
            if left > ROUND_OFF * at.field {
                let wanted = first.field - alpha * alpha;
                let factor = if wanted > ROUND_OFF * first.field {
                    (wanted / left).sqrt()
                } else {
                    0.0
                };
                keep_orthogonal_norm(&mut field, path.velocity(sample), alpha / speed, factor);
            }
        }
    }
    field
}

/// ⟨⟨X, γ'⟩⟩, or `None` where the metric sees no movement.
fn along(
    path: &impl SampledPath,
    sample: usize,
    field: &[Vector3],
    products: Products,
) -> Option<f64> {
    let squares = |field: &[Vector3]| field.iter().map(Vector3::norm_squared).sum::<f64>();
    let (moved, length) = (squares(path.velocity(sample)), squares(field));
    let seen = products.velocity * length > UNSEEN * products.field * moved;
    (seen && products.velocity > 0.0).then(|| products.mixed / products.velocity.sqrt())
}

fn add(field: &mut [Vector3], factor: f64, other: &[Vector3]) {
    for (x, y) in field.iter_mut().zip(other) {
        *x += y * factor;
    }
}

fn scale(field: &mut [Vector3], factor: f64) {
    if factor.is_finite() {
        field.iter_mut().for_each(|x| *x *= factor);
    }
}

/// Scales what is left of the field without `share` of the velocity.
fn keep_orthogonal_norm(field: &mut [Vector3], velocity: &[Vector3], share: f64, factor: f64) {
    for (x, v) in field.iter_mut().zip(velocity) {
        let along = v * share;
        *x = along + (*x - along) * factor;
    }
}
