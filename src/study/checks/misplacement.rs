//! What would put an endocardium into its epicardium?

use super::inside::Inside;
use super::nesting::{samples, share_inside};
use crate::mesh::{Point3, Vector3};
use crate::study::SurfaceSequence;

/// A change explains why surfaces are apart if it puts this share of one into the other.
const EXPLAINS: f64 = 0.95;

/// A change of coordinates that puts one surface into the other.
#[derive(Clone, Debug, PartialEq)]
pub enum Misplacement {
    /// x and y change their signs.
    LpsAndRas,
    /// One axis changes its sign.
    Mirrored(&'static str),
    /// y and z are exchanged, one with another sign.
    OtherAxes,
    /// One unit of length is a power of ten of the other.
    OtherUnit,
    /// They are moved onto each other, by so many units of coordinates.
    Shifted(f64),
}

/// How a misplaced point is put right.
type Change = Box<dyn Fn(&Point3) -> Point3>;

impl Misplacement {
    /// The first change that puts the endocardium into the epicardium at a frame, the likeliest first.
    pub(super) fn of(endo: &SurfaceSequence, epi: &SurfaceSequence, frame: usize) -> Option<Self> {
        let (inner, outer) = (endo.frames().get(frame)?, epi.frames().get(frame)?);
        let points: Vec<Point3> = samples(endo)
            .into_iter()
            .map(|v| inner.vertices()[v as usize])
            .collect();
        let loops = epi.faces().boundary_loops();
        let inside = Inside::new(outer.vertices(), outer.triangles(), &loops);
        let explains = |change: &dyn Fn(&Point3) -> Point3| {
            share_inside(&inside, points.iter().map(change)) >= EXPLAINS
        };
        let scaled =
            |x: f64, y: f64, z: f64| move |p: &Point3| Point3::new(x * p.x, y * p.y, z * p.z);
        let mut changes: Vec<(Self, Change)> = vec![
            (Self::LpsAndRas, Box::new(scaled(-1.0, -1.0, 1.0))),
            (Self::Mirrored("x"), Box::new(scaled(-1.0, 1.0, 1.0))),
            (Self::Mirrored("y"), Box::new(scaled(1.0, -1.0, 1.0))),
            (Self::Mirrored("z"), Box::new(scaled(1.0, 1.0, -1.0))),
            (
                Self::OtherAxes,
                Box::new(|p: &Point3| Point3::new(p.x, p.z, -p.y)),
            ),
            (
                Self::OtherAxes,
                Box::new(|p: &Point3| Point3::new(p.x, -p.z, p.y)),
            ),
        ];
        for factor in [10.0, 100.0, 1000.0] {
            for factor in [factor, 1.0 / factor] {
                let by = Box::new(scaled(factor, factor, factor));
                changes.push((Self::OtherUnit, by));
            }
        }
        if let Some((found, _)) = changes.into_iter().find(|(_, change)| explains(change)) {
            return Some(found);
        }
        let shift = mean(outer.vertices()) - mean(inner.vertices());
        explains(&|p| p + shift).then(|| Self::Shifted(shift.norm()))
    }

    /// The change, and what it means.
    pub fn sentence(&self) -> String {
        match self {
            Self::LpsAndRas => "with x and y negated in one of them they do: one is probably in LPS and the other in RAS coordinates".to_owned(),
            Self::Mirrored(axis) => format!("with {axis} negated in one of them they do: their coordinate systems probably differ in that axis"),
            Self::OtherAxes => "with the axes y and z exchanged in one of them they do: one is probably stored with y upwards".to_owned(),
            Self::OtherUnit => "with one of them scaled by a power of ten they do: they are probably in different units of length".to_owned(),
            Self::Shifted(by) => format!("moved by {by:.0} units of coordinates they do: they are probably in different coordinate systems"),
        }
    }
}

fn mean(points: &[Point3]) -> Point3 {
    let Some(first) = points.first() else {
        return Point3::origin();
    };
    // Offsets, so that a place far from the origin costs no digits.
    let sum: Vector3 = points.iter().map(|point| point - first).sum();
    first + sum / points.len() as f64
}
