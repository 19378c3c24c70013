//! Poses as points of R³ × R⁺ × S²: where, by how much and which way the akinetic region of the wall lies.

use serde::{Deserialize, Serialize};

use crate::mesh::{Point3, Vector3};

use super::mean::mean_direction;
use super::sphere::angle;

/// Point (x̄, r̂^ρ, N̄) of the shape space of 4.5 that stands for one pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseDescriptor {
    /// x̄ (MP): mean position of the akinetic atoms, in the unit of the atoms, or a share of the subject's
    /// size after [`PoseDescriptor::relative_to`].
    pub position: Point3,
    /// ln r̂. Kept as a logarithm because a product over thousands of atoms leaves the range of numbers.
    pub log_ratio: f64,
    /// ρ: mean angle between spokes and normals, in radians.
    pub rho: f64,
    /// N̄ (ANV): normalised mean normal; `None` where normals cancel.
    pub normal: Option<Vector3>,
}

/// What r̂ is made of the ratios of thickness.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RatioForm {
    /// The product over all atoms, as printed: grows with the number of atoms.
    Product,
    /// The geometric mean: the same for few and for many atoms.
    #[default]
    GeometricMean,
}

/// One atom of M̂, as far as the descriptor needs it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AkineticAtom {
    /// Its centre.
    pub position: Point3,
    /// ln PT of the step.
    pub log_pt: f64,
    /// Unit normal of the medial surface.
    pub normal: Vector3,
    /// Mean of the angles |Log_N(S₁)| and |Log_{−N}(S₀)|, in radians.
    pub spoke_angle_rad: f64,
}

/// Mean angle of two spokes [S₀, S₁] to the normal, in radians: (|Log_{−N}(S₀)| + |Log_N(S₁)|) / 2.
///
/// The text takes one spoke and the formula at the pole; its norm is the angle at any normal, and
/// spokes of both sides count here.
pub fn spoke_angle_rad(normal: &Vector3, spokes: &[Vector3; 2]) -> f64 {
    0.5 * (angle(&-normal, &spokes[0]) + angle(normal, &spokes[1]))
}

/// Descriptor of a pose from the atoms of M̂; `None` if there are none.
///
/// x̄ = mean of x; ln r̂ = Σ ln PT (printed) or its mean; ρ = mean of the angles between spoke and
/// normal: the printed mean of vectors of different tangent planes cannot be taken, and as an exponent ρ
/// must be a number; N̄ = Σ N / |Σ N|. Source: 4.4.1, 4.4.2 and 4.5.
pub fn pose_descriptor(atoms: &[AkineticAtom], form: RatioForm) -> Option<PoseDescriptor> {
    if atoms.is_empty() {
        return None;
    }
    let count = atoms.len() as f64;
    let position: Vector3 = atoms.iter().map(|atom| atom.position.coords).sum();
    let log_product: f64 = atoms.iter().map(|atom| atom.log_pt).sum();
    let angles: f64 = atoms.iter().map(|atom| atom.spoke_angle_rad).sum();
    let normal = mean_direction(atoms.iter().map(|atom| &atom.normal));
    Some(PoseDescriptor {
        position: Point3::from(position / count),
        log_ratio: match form {
            RatioForm::Product => log_product,
            RatioForm::GeometricMean => log_product / count,
        },
        rho: angles / count,
        normal: normal.map(|(direction, _)| direction),
    })
}

impl PoseDescriptor {
    /// r̂ itself; infinite where the product is.
    pub fn ratio(&self) -> f64 {
        self.log_ratio.exp()
    }

    /// The same with its position counted from `origin` in units of `size`, the largest side of
    /// the subject's box at end-diastole: so that it can be added to angles and compared over subjects.
    #[must_use]
    pub fn relative_to(&self, origin: &Point3, size: f64) -> Self {
        Self {
            position: Point3::from((self.position - origin) / size),
            ..*self
        }
    }
}

/// Distance of 4.5.1: √(|x̄₂ − x̄₁|² + (ρ₂ ln r̂₂ − ρ₁ ln r̂₁)² + angle(N̄₁, N̄₂)²).
///
/// Positions are taken as they are: those of [`PoseDescriptor::relative_to`] make the sum one of
/// numbers without unit. Where one normal has no direction a right angle stands for the angle,
/// the mean over all directions; where neither has, nothing differs.
pub fn pose_distance(a: &PoseDescriptor, b: &PoseDescriptor) -> f64 {
    let way = (b.position - a.position).norm_squared();
    // ln r̂^ρ = ρ ln r̂: the power is never formed, since it leaves the range of numbers.
    let ratio = b.rho * b.log_ratio - a.rho * a.log_ratio;
    // A direction that is missing must neither hide nor exaggerate a difference.
    let turn = match (&a.normal, &b.normal) {
        (Some(a), Some(b)) => angle(a, b),
        (None, None) => 0.0,
        _ => std::f64::consts::FRAC_PI_2,
    };
    (way + ratio * ratio + turn * turn).sqrt()
}
