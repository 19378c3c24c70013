//! From where pictures count coordinates, so that a heart far from the origin is drawn as sharply as one near it.

use crate::mesh::{Point3, Vector3, bounding_box};
use crate::study::Subject;

/// Coordinates are counted from the heart where its middle lies further out than so many of its sizes. Graphics
/// cards have 24 bits a coordinate: at this distance a millionth of a heart's size is left of them, and hearts in a scanner lie
/// within ten sizes, where nothing is moved.
const FAR: f64 = 64.0;

/// What is subtracted from coordinates, in 64 bits, before they are drawn: zero for hearts near the origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PictureOrigin(Vector3);

impl PictureOrigin {
    /// The middle of the box around a subject's first frame, if that is far from the origin.
    pub fn of(subject: &Subject) -> Self {
        let surfaces = subject.sequence.surfaces().iter();
        let points = surfaces.flat_map(|surface| surface.frames()[0].vertices());
        let Some([low, high]) = bounding_box(points) else {
            return Self::default();
        };
        // Half of each first, so that no sum overflows.
        let middle = 0.5 * low.coords + 0.5 * high.coords;
        let far = middle.amax() > FAR * (high - low).norm();
        Self(if far { middle } else { Vector3::zeros() })
    }

    /// Whether coordinates are drawn as they are.
    pub fn is_zero(self) -> bool {
        self.0 == Vector3::zeros()
    }

    /// A point as it is counted in pictures.
    pub fn counted(self, point: Point3) -> Point3 {
        point - self.0
    }

    /// The point of the subject that a point of pictures is.
    pub fn in_subject(self, counted: Point3) -> Point3 {
        counted + self.0
    }

    /// The same as the graphics card has it.
    pub fn drawn(self, point: &Point3) -> [f32; 3] {
        (point.coords - self.0).cast::<f32>().into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom};
    use crate::picture::prepared::PreparedSubject;
    use crate::picture::quantity::Quantity;
    use crate::study::{MeshSequence, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;

    fn heart(shift: Vector3) -> Subject {
        let side = |kind, radii: [f64; 2]| {
            let frames = radii.map(|radius| {
                let bowl = phantom::bowl(radius, 6, 12);
                // Oval, so that rounding does not choose among axes that are all alike.
                let oval = |p: &Point3| Point3::new(1.3 * p.x, p.y, p.z) + shift;
                let points: Vec<Point3> = bowl.vertices().iter().map(oval).collect();
                TriMesh::new(points, bowl.faces().clone()).unwrap()
            });
            SurfaceSequence::new(kind, frames.to_vec()).unwrap()
        };
        let sequence = MeshSequence::new(vec![
            side(SurfaceKind::Endocardium, [20.0, 15.0]),
            side(SurfaceKind::Epicardium, [30.0, 28.0]),
        ])
        .unwrap();
        Subject::new("P", sequence, LengthUnit::Millimetre)
    }

    #[test]
    fn a_heart_in_a_scanner_is_drawn_where_it_lies() {
        let subject = heart(Vector3::new(120.0, -300.0, 450.0));
        assert!(PictureOrigin::of(&subject).is_zero());
    }

    #[test]
    fn a_heart_far_from_the_origin_is_drawn_as_one_near_it() {
        let prepared = |shift: f64| {
            let shift = Vector3::new(shift, -2.0 * shift, 0.5 * shift);
            PreparedSubject::new(&heart(shift), 0)
        };
        let near = prepared(0.0);
        for shift in [1e4, 1e6, 1e8] {
            let far = prepared(shift);
            let cameras = [&near, &far].map(|heart| heart.home_camera(1.25));
            assert!((cameras[0].half_height / cameras[1].half_height - 1.0).abs() < 1e-5);
            let places = |prepared: &PreparedSubject, target: glam::Vec3| -> Vec<glam::Vec3> {
                let points = prepared.all_positions();
                points
                    .map(|&point| glam::Vec3::from(point) - target)
                    .collect()
            };
            let (a, b) = (
                places(&near, cameras[0].target),
                places(&far, cameras[1].target),
            );
            let apart = a.iter().zip(&b).map(|(a, b)| (*a - *b).length());
            let apart = apart.fold(0.0, f32::max);
            assert!(apart < 1e-4, "{apart} at {shift:e}");
            for quantity in [Quantity::Displacement, Quantity::AreaRatio] {
                for (a, b) in near.surfaces.iter().zip(&far.surfaces) {
                    let values =
                        [a, b].map(|surface| &surface.scalars(quantity).unwrap().values[1]);
                    let pairs = values[0].iter().zip(values[1]);
                    assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-4));
                }
            }
        }
    }
}
