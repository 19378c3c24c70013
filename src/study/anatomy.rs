//! Where apex, base, septum and anterior wall lie, when the input says so.

use crate::mesh::{Point3, Vector3};

/// Orientation landmarks of one subject, in the coordinates of its first frame.
///
/// Anatomical names are shown only for subjects that have one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anatomy {
    /// The tip of the ventricle.
    pub apex: Point3,
    /// Centre of the mitral ring.
    pub base: Point3,
    /// Unit direction from the long axis to the middle of the septum, perpendicular to the axis.
    pub septal: Vector3,
    /// Unit direction from the long axis to the middle of the anterior wall, perpendicular to
    /// the axis and to `septal`.
    pub anterior: Vector3,
}

impl Anatomy {
    /// Landmarks from an apex, a base centre, a point towards the septum and one towards the
    /// anterior wall; only the direction of the last two counts.
    ///
    /// `None` where two landmarks coincide or the directions are parallel to the axis.
    pub fn from_landmarks(
        apex: Point3,
        base: Point3,
        septum: Point3,
        anterior: Point3,
    ) -> Option<Self> {
        let axis = (base - apex).try_normalize(0.0)?;
        let across = |point: Point3| {
            let offset = point - base;
            (offset - axis * axis.dot(&offset)).try_normalize(1e-9 * offset.norm())
        };
        let septal = across(septum)?;
        let towards_anterior = across(anterior)?;
        let anterior =
            (towards_anterior - septal * septal.dot(&towards_anterior)).try_normalize(1e-9)?;
        Some(Self {
            apex,
            base,
            septal,
            anterior,
        })
    }

    /// Unit direction from apex to base.
    pub fn long_axis(&self) -> Vector3 {
        (self.base - self.apex)
            .try_normalize(0.0)
            .unwrap_or_else(Vector3::z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_unit_and_square_to_the_long_axis() {
        let anatomy = Anatomy::from_landmarks(
            Point3::new(0.0, 0.0, -80.0),
            Point3::origin(),
            Point3::new(30.0, 0.0, -20.0),
            Point3::new(5.0, 25.0, -20.0),
        )
        .unwrap();
        assert!((anatomy.septal - Vector3::x()).norm() < 1e-12);
        assert!((anatomy.anterior - Vector3::y()).norm() < 1e-12);
        assert!((anatomy.long_axis() - Vector3::z()).norm() < 1e-12);
    }

    #[test]
    fn landmarks_on_one_line_give_no_anatomy() {
        let on_axis = Point3::new(0.0, 0.0, 5.0);
        let tip = Point3::new(0.0, 0.0, -80.0);
        assert!(Anatomy::from_landmarks(tip, Point3::origin(), on_axis, on_axis).is_none());
    }
}
