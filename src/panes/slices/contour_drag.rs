//! Outlines that are dragged: the corner under the pointer goes with it, its neighbours follow as far as they are near.

use crate::analysis::preparation::Preparation;
use crate::image::Contour;
use crate::mesh::{Point3, Vector3};

/// How far along an outline a drag reaches, in millimetres: half of the sheet's way to nothing.
const REACH_MM: f64 = 12.0;

/// The outline of an instant that passes nearest to a position within `reach_mm`, of those that lie in its plane: its number
/// in the list, and the number of its corner.
pub fn nearest(
    contours: &[Contour],
    instant: usize,
    at: Point3,
    reach_mm: f64,
) -> Option<(usize, usize)> {
    let here = contours.iter().enumerate();
    let here = here.filter(|(_, contour)| contour.instant == instant);
    let corners = here.flat_map(|(number, contour)| {
        let corners = contour.points.iter().enumerate();
        corners.map(move |(corner, point)| ((number, corner), (point - at).norm()))
    });
    let (found, apart) = corners.min_by(|a, b| a.1.total_cmp(&b.1))?;
    (apart <= reach_mm).then_some(found)
}

/// An outline whose corner was moved by so much: corners d mm away from it move by exp(−d² / 2 · reach²) of that.
pub fn dragged(contour: &Contour, corner: usize, by: Vector3) -> Contour {
    let Some(centre) = contour.points.get(corner).copied() else {
        return contour.clone();
    };
    let share = |point: &Point3| {
        let apart = (point - centre).norm() / REACH_MM;
        (-0.5 * apart * apart).exp()
    };
    let points = contour.points.iter();
    Contour {
        points: points.map(|point| point + by * share(point)).collect(),
        ..contour.clone()
    }
}

/// Puts a drawn outline to those of the settings, in the place of one of the same part, instant and slice.
pub fn put(settings: &mut Preparation, drawn: Contour, same_slice: impl Fn(&Contour) -> bool) {
    let mut contours = settings.contours.to_vec();
    contours.retain(|contour| {
        let same = contour.instant == drawn.instant && contour.part == drawn.part;
        !(same && same_slice(contour))
    });
    contours.push(drawn);
    settings.contours = contours.into();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image::ContourPart;

    fn circle(instant: usize, z: f64) -> Contour {
        let corners = 0..72;
        Contour {
            instant,
            part: ContourPart::Endocardium,
            points: corners
                .map(|corner| {
                    let angle = f64::from(corner) * std::f64::consts::TAU / 72.0;
                    Point3::new(30.0 * angle.cos(), 30.0 * angle.sin(), z)
                })
                .collect(),
        }
    }

    #[test]
    fn a_drag_moves_what_is_near_and_leaves_the_other_side() {
        let before = circle(0, 0.0);
        let after = dragged(&before, 0, Vector3::new(5.0, 0.0, 0.0));
        assert!((after.points[0].x - 35.0).abs() < 1e-12);
        assert!((after.points[36] - before.points[36]).norm() < 1e-4);
        let moved = |corner: usize| (after.points[corner] - before.points[corner]).norm();
        assert!(moved(1) < 5.0 && moved(1) > moved(4) && moved(4) > moved(8));
    }

    #[test]
    fn the_nearest_outline_of_the_instant_is_found_and_one_too_far_is_not() {
        let contours = [circle(0, 0.0), circle(1, 0.0), circle(0, 8.0)];
        let at = Point3::new(31.0, 0.0, 7.0);
        assert_eq!(nearest(&contours, 0, at, 3.0), Some((2, 0)));
        assert_eq!(nearest(&contours, 1, at, 3.0), None);
    }

    #[test]
    fn a_drawn_outline_takes_the_place_of_the_one_of_its_slice() {
        let mut settings = Preparation::default();
        let in_slice = |z: f64| move |contour: &Contour| (contour.points[0].z - z).abs() < 1.0;
        put(&mut settings, circle(0, 0.0), in_slice(0.0));
        put(&mut settings, circle(0, 8.0), in_slice(8.0));
        put(&mut settings, circle(1, 0.0), in_slice(0.0));
        assert_eq!(settings.contours.len(), 3);
        let moved = dragged(&circle(0, 8.0), 3, Vector3::new(0.0, 4.0, 0.0));
        put(&mut settings, moved.clone(), in_slice(8.0));
        assert_eq!(settings.contours.len(), 3);
        assert!(settings.contours.contains(&moved));
    }
}
