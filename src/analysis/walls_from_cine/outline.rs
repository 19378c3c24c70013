//! Closed outlines as radii around a middle: hull, smoothing, area, and polygons.

use std::f64::consts::TAU;

use super::polar::{RAYS, direction};
use super::slices::Place;

/// Corners of an outline around a middle.
pub(super) fn corners(radii: &[f64], middle: Place) -> Vec<Place> {
    let rays = radii.iter().enumerate();
    rays.map(|(ray, radius)| middle + direction(ray) * *radius)
        .collect()
}

/// Area ½ Σ pᵢ × pᵢ₊₁ and centroid of a polygon; positive if it goes as the rays do.
pub(super) fn area_and_centroid(corners: &[Place]) -> (f64, Place) {
    let mut area = 0.0;
    let mut moment = Place::zeros();
    for (from, to) in sides(corners) {
        let cross = from.perp(&to);
        area += 0.5 * cross;
        moment += (from + to) * cross / 6.0;
    }
    let centroid = if area == 0.0 {
        Place::zeros()
    } else {
        moment / area
    };
    (area, centroid)
}

fn sides(corners: &[Place]) -> impl Iterator<Item = (Place, Place)> {
    let next = corners.iter().cycle().skip(1);
    corners.iter().copied().zip(next.copied())
}

/// Mean of the radii.
pub(super) fn mean_radius(radii: &[f64]) -> f64 {
    radii.iter().sum::<f64>() / radii.len().max(1) as f64
}

/// The farthest crossing of each ray from a middle with a polygon; `None` if a ray meets none: the middle is outside.
pub(super) fn radii_of(polygon: &[Place], middle: Place) -> Option<Vec<f64>> {
    (0..RAYS)
        .map(|ray| farthest_crossing(polygon, middle, direction(ray)))
        .collect()
}

fn farthest_crossing(polygon: &[Place], middle: Place, along: Place) -> Option<f64> {
    let crossings = sides(polygon).filter_map(|(from, to)| {
        let (from, to) = (from - middle, to - middle);
        let (left, right) = (along.perp(&from), along.perp(&to));
        // A corner on the ray belongs to one of its sides.
        if (left >= 0.0) == (right >= 0.0) {
            return None;
        }
        let share = left / (left - right);
        Some((from + (to - from) * share).dot(&along))
    });
    crossings.filter(|radius| *radius > 0.0).reduce(f64::max)
}

/// Radii of the convex hull: muscles that stand into the cavity are within it.
pub(super) fn hull(radii: &[f64]) -> Vec<f64> {
    let mut points = corners(radii, Place::zeros());
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let mut around = half_hull(points.iter().copied());
    around.extend(half_hull(points.iter().rev().copied()));
    radii_of(&around, Place::zeros()).unwrap_or_else(|| radii.to_vec())
}

/// One side of the hull of points in order, without the last one.
fn half_hull(points: impl Iterator<Item = Place>) -> Vec<Place> {
    let mut side: Vec<Place> = Vec::new();
    for point in points {
        while let [.., before, last] = side[..] {
            if (last - before).perp(&(point - last)) > 0.0 {
                break;
            }
            side.pop();
        }
        side.push(point);
    }
    side.pop();
    side
}

/// The Fourier series of the radii up to a harmonic, r(θ) = a₀ + Σ aₙ cos nθ + bₙ sin nθ, at every ray.
pub(super) fn smooth(radii: &[f64], harmonics: usize) -> Vec<f64> {
    let count = radii.len() as f64;
    let mut smooth = vec![mean_radius(radii); radii.len()];
    for harmonic in 1..=harmonics {
        let wave = |ray: usize| (TAU * (harmonic * ray) as f64 / count).sin_cos();
        let (mut a, mut b) = (0.0, 0.0);
        for (ray, radius) in radii.iter().enumerate() {
            let (sin, cos) = wave(ray);
            a += 2.0 * radius * cos / count;
            b += 2.0 * radius * sin / count;
        }
        for (ray, value) in smooth.iter_mut().enumerate() {
            let (sin, cos) = wave(ray);
            *value += a * cos + b * sin;
        }
    }
    smooth
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    #[test]
    fn a_square_has_its_area_centroid_and_radii() {
        let square = [[1.0, 2.0], [5.0, 2.0], [5.0, 6.0], [1.0, 6.0]].map(Place::from);
        let (area, centroid) = area_and_centroid(&square);
        assert!((area - 16.0).abs() < 1e-12 && (centroid - Place::new(3.0, 4.0)).norm() < 1e-12);
        let radii = radii_of(&square, centroid).unwrap();
        assert!((radii[0] - 2.0).abs() < 1e-12 && (radii[RAYS / 8] - 8.0_f64.sqrt()).abs() < 1e-12);
        assert!(radii_of(&square, Place::new(9.0, 9.0)).is_none());
    }

    #[test]
    fn the_hull_closes_a_dent_and_leaves_a_circle() {
        let mut radii = vec![20.0; RAYS];
        let round = hull(&radii);
        assert!(round.iter().all(|r| (r - 20.0).abs() < 1e-9));
        radii[5] = 10.0;
        let closed = hull(&radii);
        assert!(closed[5] > 19.5 && closed[5] <= 20.0, "{}", closed[5]);
    }

    #[test]
    fn smoothing_keeps_slow_waves_and_takes_fast_ones_away() {
        let wave = |n: usize| move |ray: usize| (TAU * (n * ray) as f64 / RAYS as f64).cos();
        let slow: Vec<f64> = (0..RAYS).map(|ray| 20.0 + 3.0 * wave(3)(ray)).collect();
        let noisy: Vec<f64> = slow
            .iter()
            .enumerate()
            .map(|(ray, r)| r + wave(20)(ray))
            .collect();
        let smoothed = smooth(&noisy, 8);
        assert!(
            smoothed
                .iter()
                .zip(&slow)
                .all(|(a, b)| (a - b).abs() < 1e-9)
        );
    }
}
