//! Is an epicardium too far from its endocardium to be that of the left ventricle alone?

use super::enclosed_volume::enclosed_volume;
use crate::mesh::{ClosestPoint, Point3};
use crate::study::SurfaceSequence;
use crate::units::LengthUnit;

/// A wall this thick at end-diastole is no left ventricle's over more than a small part of it: the thickest place of
/// 100 walls, 20 of them hypertrophic, is 24.7 mm.
const MAX_THICKNESS_MM: f64 = 25.0;
/// Share of the epicardium that may lie further out: a hypertrophic septum may, but a third of the wall may not.
const MAX_SHARE: f64 = 0.1;
/// Where the unit is not known: the ninth decile of distances over their median, which is 2.1 at most in the
/// same walls and 1.5 in gated SPECT; a right ventricle enclosed on one side makes it 2.5 and more.
const MAX_DECILE_OVER_MEDIAN: f64 = 2.3;
/// Where the unit is not known: share that the ninth decile of distances must reach, too, of the radius of a sphere as large as the cavity (0.55 at most).
const MIN_DECILE_OVER_RADIUS: f64 = 0.7;
/// Faces of the epicardium that are looked at.
const SAMPLES: usize = 400;

/// How far an epicardium lies out at end-diastole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallExtent {
    /// Share of its area that lies further than 25 mm from the endocardium; `None` where the unit is not known.
    pub thick_share: Option<f64>,
    /// Distance from the endocardium that half of its area exceeds, in coordinates.
    pub median: f64,
    /// And a tenth of it.
    pub ninth_decile: f64,
}

impl WallExtent {
    /// The distances of faces of the epicardium from the endocardium at a frame, if they are too large.
    pub(super) fn of(
        endo: &SurfaceSequence,
        epi: &SurfaceSequence,
        frame: usize,
        unit: LengthUnit,
    ) -> Option<Self> {
        let (inner, outer) = (endo.frames().get(frame)?, epi.frames().get(frame)?);
        let tree = ClosestPoint::new(inner.vertices(), inner.triangles())?;
        let stride = outer.triangles().len().div_ceil(SAMPLES).max(1);
        let mut distances: Vec<(f64, f64)> = (outer.triangles().iter().step_by(stride))
            .map(|triangle| {
                let [a, b, c] = triangle.map(|v| outer.vertices()[v as usize]);
                let centre = a + ((b - a) + (c - a)) / 3.0;
                (tree.distance(centre), 0.5 * (b - a).cross(&(c - a)).norm())
            })
            .collect();
        distances.sort_by(|a, b| a.0.total_cmp(&b.0));
        let whole: f64 = distances.iter().map(|(_, area)| area).sum();
        let quantile = |share: f64| {
            let mut below = 0.0;
            let reached = distances.iter().find(|(_, area)| {
                below += area;
                below >= share * whole
            });
            reached.map_or(0.0, |(distance, _)| *distance)
        };
        let beyond = |limit: f64| {
            let far = distances.iter().filter(|(distance, _)| *distance > limit);
            far.map(|(_, area)| area).sum::<f64>() / whole
        };
        let found = Self {
            thick_share: (unit == LengthUnit::Millimetre).then(|| beyond(MAX_THICKNESS_MM)),
            median: quantile(0.5),
            ninth_decile: quantile(0.9),
        };
        let radius = radius(inner.vertices(), inner.triangles(), endo);
        let thick = found.thick_share.is_some_and(|share| share > MAX_SHARE);
        let lopsided = found.ninth_decile > MAX_DECILE_OVER_MEDIAN * found.median
            && found.ninth_decile > MIN_DECILE_OVER_RADIUS * radius;
        (thick || lopsided).then_some(found)
    }

    /// What is wrong, in a sentence.
    pub(super) fn sentence(&self) -> String {
        let far = match self.thick_share.filter(|share| *share > MAX_SHARE) {
            Some(share) => format!(
                "{:.0} % of the epicardium lies more than {MAX_THICKNESS_MM:.0} mm from the endocardium at end-diastole, thicker than a wall",
                100.0 * share
            ),
            None => format!(
                "a tenth of the epicardium lies {:.1} times as far from the endocardium as half of it at end-diastole",
                self.ninth_decile / self.median.max(f64::MIN_POSITIVE)
            ),
        };
        format!(
            "{far}: it is probably not that of the left ventricle alone but surrounds the right ventricle too, so neither mass nor verdict is given"
        )
    }
}

/// Radius of a sphere as large as the cavity.
fn radius(vertices: &[Point3], triangles: &[[u32; 3]], endo: &SurfaceSequence) -> f64 {
    let loops = endo.faces().boundary_loops();
    let volume = enclosed_volume(vertices, triangles, &loops).abs();
    (volume * 0.75 / std::f64::consts::PI).cbrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom};
    use crate::study::SurfaceKind;

    /// A wall of 8 mm whose outer side bulges on one side by up to so much.
    fn bulging(bulge: f64, scale: f64, unit: LengthUnit) -> Option<WallExtent> {
        let sheet = |kind, radius: f64, bulge: f64| {
            let bowl = phantom::bowl(radius, 12, 32);
            let points: Vec<Point3> = (bowl.vertices().iter())
                .map(|p| {
                    let out = (p.x / radius).max(0.0) * bulge;
                    Point3::new(p.x + out, p.y, 2.0 * p.z) * scale
                })
                .collect();
            let mesh = TriMesh::new(points, bowl.faces().clone()).unwrap();
            SurfaceSequence::new(kind, vec![mesh]).unwrap()
        };
        let endo = sheet(SurfaceKind::Endocardium, 24.0, 0.0);
        let epi = sheet(SurfaceKind::Epicardium, 32.0, bulge);
        WallExtent::of(&endo, &epi, 0, unit)
    }

    #[test]
    fn an_epicardium_around_both_ventricles_is_told_and_a_thick_septum_is_not() {
        let mm = LengthUnit::Millimetre;
        assert_eq!(bulging(0.0, 1.0, mm), None);
        // A septum of 22 mm.
        assert_eq!(bulging(14.0, 1.0, mm), None);
        let both = bulging(35.0, 1.0, mm).unwrap();
        assert!(both.thick_share.unwrap() > 0.1);
        let text = both.sentence();
        assert!(
            text.contains("more than 25 mm") && text.contains("right ventricle"),
            "{text}"
        );
    }

    #[test]
    fn without_a_unit_the_shape_tells_it() {
        for scale in [1e-3, 0.1, 3.3] {
            assert_eq!(bulging(0.0, scale, LengthUnit::FileUnit), None);
            assert_eq!(bulging(14.0, scale, LengthUnit::FileUnit), None);
            let both = bulging(40.0, scale, LengthUnit::FileUnit).unwrap();
            assert_eq!(both.thick_share, None);
            assert!(
                both.sentence().contains("times as far"),
                "{}",
                both.sentence()
            );
        }
    }
}
