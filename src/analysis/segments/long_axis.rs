//! The long axis of the ventricle with the directions across it, as far as they are known.

use crate::mesh::{Point3, Vector3};

/// From the apex to the middle of the base, with the directions of septum and anterior wall if known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LongAxis {
    /// The outer tip of the ventricle.
    pub apex: Point3,
    /// Centre of the rim at the base.
    pub base: Point3,
    /// Where the cavity ends, as a share of the way from base to apex, in (0, 1].
    pub cavity_share: f64,
    /// Unit direction from the axis to the middle of the septum, at right angles to the axis.
    pub septal: Option<Vector3>,
    /// Unit direction to the middle of the anterior wall, at right angles to axis and `septal`.
    pub anterior: Option<Vector3>,
    /// Unit direction across the axis that is drawn to the left: the septum where it is known,
    /// otherwise that of a vertex of the rim, so that maps of one subject over time agree.
    pub left: Vector3,
}

impl LongAxis {
    /// The axis between two points; `left` is drawn to the left. The cavity reaches to the apex.
    ///
    /// `None` if the points coincide or `left` runs along the axis.
    pub fn new(apex: Point3, base: Point3, left: Vector3) -> Option<Self> {
        let up = (base - apex).try_normalize(0.0)?;
        Some(Self {
            apex,
            base,
            cavity_share: 1.0,
            septal: None,
            anterior: None,
            left: across(up, left)?,
        })
    }

    /// The axis with known directions of septum and anterior wall, made square to it.
    ///
    /// `None` if the points coincide, or the directions are parallel to each other or the axis.
    pub fn oriented(
        apex: Point3,
        base: Point3,
        septal: Vector3,
        anterior: Vector3,
    ) -> Option<Self> {
        let axis = Self::new(apex, base, septal)?;
        let septal = axis.left;
        let anterior = across(axis.direction(), anterior)?;
        // The septum is kept and the anterior wall turned: segments are counted from their border.
        let anterior = (anterior - septal * septal.dot(&anterior)).try_normalize(1e-9)?;
        Some(Self {
            septal: Some(septal),
            anterior: Some(anterior),
            ..axis
        })
    }

    /// The axis with the cavity ending where `points`, of the inner surface, reach furthest down.
    #[must_use]
    pub fn with_cavity(self, points: &[Point3]) -> Self {
        let deepest = points
            .iter()
            .map(|&point| self.share(point))
            .fold(0.0, f64::max);
        Self {
            // An inner surface above its own base tells nothing; the cavity then reaches to the apex.
            cavity_share: if deepest > 0.0 { deepest.min(1.0) } else { 1.0 },
            ..self
        }
    }

    /// Unit direction from apex to base.
    pub fn direction(&self) -> Vector3 {
        (self.base - self.apex)
            .try_normalize(0.0)
            .unwrap_or_else(Vector3::z)
    }

    /// From apex to base, in coordinates.
    pub fn length(&self) -> f64 {
        (self.base - self.apex).norm()
    }

    /// Whether septum and anterior wall are known, and so segments have names.
    pub fn is_oriented(&self) -> bool {
        self.septal.is_some() && self.anterior.is_some()
    }

    /// Unit direction across the axis that is drawn upwards: the anterior wall where it is known,
    /// otherwise such that left, up and base make a right-handed frame as septum, anterior wall and
    /// base do in the body.
    pub fn up(&self) -> Vector3 {
        self.anterior
            .unwrap_or_else(|| self.direction().cross(&self.left))
    }

    /// Distance below the base along the axis over the distance from base to the end of the
    /// cavity: 0 at the base, 1 where the cavity ends, negative above the base.
    pub fn depth(&self, point: Point3) -> f64 {
        self.share(point) / self.cavity_share
    }

    /// Share of the way from base (0) to apex (1) along the axis.
    fn share(&self, point: Point3) -> f64 {
        let down = self.apex - self.base;
        (point - self.base).dot(&down) / down.norm_squared()
    }

    /// Angle around the axis as the bull's-eye is drawn, in radians from −π to π: 0 to the right
    /// (lateral), π/2 up (anterior), ±π left (septum). 0 on the axis.
    pub fn angle_rad(&self, point: Point3) -> f64 {
        let offset = point - self.base;
        (self.up().dot(&offset)).atan2(-self.left.dot(&offset))
    }
}

/// The part of `direction` square to the unit vector `axis`, as a unit vector.
fn across(axis: Vector3, direction: Vector3) -> Option<Vector3> {
    // Nearly parallel, what is left of a direction is round-off.
    (direction - axis * axis.dot(&direction)).try_normalize(1e-9 * direction.norm())
}
