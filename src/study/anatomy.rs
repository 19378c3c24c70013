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

    /// Points from which it follows again.
    pub fn landmarks(&self) -> Landmarks {
        // As far out as the axis is long, so that digits serve both alike.
        let reach = (self.base - self.apex).norm();
        Landmarks {
            apex: Some(self.apex),
            base: Some(self.base),
            septum: Some(self.base + self.septal * reach),
            anterior: Some(self.base + self.anterior * reach),
        }
    }

    /// 1 where septum, anterior wall and base lie as in the body, −1 in its mirror image.
    pub(super) fn side(&self) -> f64 {
        (self.long_axis().cross(&self.septal))
            .dot(&self.anterior)
            .signum()
    }

    /// The same with all coordinates times a factor.
    #[must_use]
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            apex: self.apex * factor,
            base: self.base * factor,
            ..self
        }
    }

    /// Unit direction from apex to base.
    pub fn long_axis(&self) -> Vector3 {
        (self.base - self.apex)
            .try_normalize(0.0)
            .unwrap_or_else(Vector3::z)
    }
}

/// A point of a ventricle that says how it lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Landmark {
    /// The tip of the ventricle.
    Apex,
    /// The middle of the mitral ring.
    Base,
    /// The middle of the septum.
    Septum,
    /// The middle of the anterior wall.
    Anterior,
}

impl Landmark {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Apex, Self::Base, Self::Septum, Self::Anterior];

    /// The word in menus.
    pub fn name(self) -> &'static str {
        match self {
            Self::Apex => "apex",
            Self::Base => "base",
            Self::Septum => "septum",
            Self::Anterior => "anterior wall",
        }
    }
}

/// Landmarks as far as they are known, in the coordinates of the first frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Landmarks {
    /// The tip of the ventricle.
    pub apex: Option<Point3>,
    /// The middle of the mitral ring.
    pub base: Option<Point3>,
    /// A point towards the septum.
    pub septum: Option<Point3>,
    /// A point towards the anterior wall.
    pub anterior: Option<Point3>,
}

impl Landmarks {
    /// Sets one. Another septum lets go of the anterior wall, which stood square to the one before.
    pub(super) fn set(&mut self, landmark: Landmark, at: Point3) {
        let place = match landmark {
            Landmark::Apex => &mut self.apex,
            Landmark::Base => &mut self.base,
            Landmark::Septum => {
                self.anterior = None;
                &mut self.septum
            }
            Landmark::Anterior => &mut self.anterior,
        };
        *place = Some(at);
    }

    /// The anatomy that follows, with apex and base of `axis` where none are known; `side` says on which side of the
    /// septum the anterior wall is where it is not known, see [`Anatomy::side`]. `None` without septum or axis, or where
    /// landmarks coincide.
    pub(super) fn anatomy(&self, axis: Option<[Point3; 2]>, side: f64) -> Option<Anatomy> {
        let apex = self.apex.or(axis.map(|[apex, _]| apex))?;
        let base = self.base.or(axis.map(|[_, base]| base))?;
        let septum = self.septum?;
        let usual = || base + (base - apex).cross(&(septum - base)) * side;
        Anatomy::from_landmarks(apex, base, septum, self.anterior.unwrap_or_else(usual))
    }

    pub(super) fn scaled(self, factor: f64) -> Self {
        let scaled = |point: Option<Point3>| point.map(|point| point * factor);
        Self {
            apex: scaled(self.apex),
            base: scaled(self.base),
            septum: scaled(self.septum),
            anterior: scaled(self.anterior),
        }
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
