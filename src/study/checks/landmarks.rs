//! Do the stated orientation landmarks belong to the surfaces?

use crate::mesh::{Point3, Vector3, bounding_box};
use crate::study::{Anatomy, Notice, Subject, SurfaceKind};

/// Shares of the diagonal of the surfaces' box that apex and base may lie apart. Of ventricles they lie 0.4 to 0.8 apart.
const LENGTH: std::ops::RangeInclusive<f64> = 0.2..=1.5;
/// Share of the diagonal by which a landmark may lie outside the box.
const OUTSIDE: f64 = 0.25;

/// An opening is at the apex where it is by this factor nearer to it than to the base.
const NEARER: f64 = 0.5;

/// Why orientation landmarks cannot be those of a subject.
///
/// Why it matters: they make the long axis, and the names of all segments follow from it. Landmarks in another unit, of
/// another scan or with apex and base exchanged name segments that lie elsewhere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LandmarkDoubt {
    /// Apex and base lie so many times the size of the surfaces apart.
    Length(f64),
    /// A landmark lies outside the surfaces.
    Outside,
    /// The opening lies at the apex.
    Exchanged,
}

impl LandmarkDoubt {
    /// Compares the landmarks with the surfaces of the first frame; `None` where they fit, or there are none.
    pub fn of(subject: &Subject) -> Option<Self> {
        let Anatomy { apex, base, .. } = subject.anatomy?;
        let surfaces = subject.sequence.surfaces();
        let points = surfaces
            .iter()
            .flat_map(|surface| surface.frames()[0].vertices());
        let [low, high] = bounding_box(points)?;
        let size = (high - low).norm();
        let apart = (base - apex).norm();
        if !LENGTH.contains(&(apart / size)) {
            return Some(Self::Length(apart / size));
        }
        let margin = Vector3::repeat(OUTSIDE * size);
        let (low, high) = (low - margin, high + margin);
        let inside = |p: &Point3| low.inf(p) == low && high.sup(p) == high;
        if !(inside(&apex) && inside(&base)) {
            return Some(Self::Outside);
        }
        exchanged(subject, apex, base).then_some(Self::Exchanged)
    }

    /// What the load report says.
    pub fn notice(&self) -> Notice {
        let why = match self {
            Self::Length(times) => format!(
                "apex and base lie {times:.2} times the size of the surfaces apart; are they in another unit?"
            ),
            Self::Outside => {
                "apex or base lies outside the surfaces; are they in other coordinates?".to_owned()
            }
            Self::Exchanged => {
                "the surface is open at the apex; are apex and base exchanged?".to_owned()
            }
        };
        Notice::warning(format!("the orientation landmarks are not used: {why}"))
    }
}

/// Whether the largest opening lies far nearer to the apex than to the base.
fn exchanged(subject: &Subject, apex: Point3, base: Point3) -> bool {
    let open = [
        SurfaceKind::Endocardium,
        SurfaceKind::Epicardium,
        SurfaceKind::Cavity,
    ]
    .into_iter()
    .find_map(|kind| subject.sequence.surface(kind));
    let Some(surface) = open else { return false };
    let vertices = surface.frames()[0].vertices();
    let loops = surface.faces().boundary_loops();
    let Some(rim) = loops.iter().max_by_key(|ring| ring.len()) else {
        return false;
    };
    let sum: Vector3 = rim
        .iter()
        .map(|&vertex| vertices[vertex as usize].coords)
        .sum();
    let centre = Point3::from(sum / rim.len() as f64);
    (centre - apex).norm() < NEARER * (centre - base).norm()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::{MeshSequence, SurfaceSequence};
    use crate::units::LengthUnit;

    /// A bowl whose tip lies at −30, open at 0, with landmarks after a change.
    fn doubt(change: impl Fn(Point3) -> Point3) -> Option<LandmarkDoubt> {
        let frames = vec![phantom::bowl(30.0, 6, 12)];
        let surface = SurfaceSequence::new(SurfaceKind::Endocardium, frames).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        let tip = sequence.surfaces()[0].frames()[0].vertices()[0];
        let mut subject = Subject::new("p", sequence, LengthUnit::Millimetre);
        let landmarks = [
            tip,
            Point3::origin(),
            Point3::new(30.0, 0.0, 0.0),
            Point3::new(0.0, 30.0, 0.0),
        ];
        let [apex, base, septum, anterior] = landmarks.map(change);
        subject.anatomy = Anatomy::from_landmarks(apex, base, septum, anterior);
        assert!(subject.anatomy.is_some());
        LandmarkDoubt::of(&subject)
    }

    #[test]
    fn landmarks_of_another_unit_place_or_order_are_told() {
        assert_eq!(doubt(|p| p), None);
        assert!(matches!(doubt(|p| p / 1000.0), Some(LandmarkDoubt::Length(x)) if x < 0.01));
        assert!(matches!(doubt(|p| p * 10.0), Some(LandmarkDoubt::Length(x)) if x > 2.0));
        assert_eq!(
            doubt(|p| p + Vector3::x() * 200.0),
            Some(LandmarkDoubt::Outside)
        );
        let exchange = |p: Point3| Point3::new(p.x, p.y, -30.0 - p.z);
        let exchanged = doubt(|p| {
            if p.x == 0.0 && p.y == 0.0 {
                exchange(p)
            } else {
                p
            }
        });
        assert_eq!(exchanged, Some(LandmarkDoubt::Exchanged));
        assert!(exchanged.unwrap().notice().text.contains("not used"));
    }
}
