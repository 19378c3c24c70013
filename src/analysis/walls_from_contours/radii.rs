//! An outline as the square of its radius around a middle: ½ ∫ q dθ is its area.

use std::f64::consts::TAU;

/// Even directions in which radii are taken: 2° each, less than a pixel of cine images on the outline of a heart.
pub(super) const DIRECTIONS: usize = 180;

/// The direction of a number.
pub(super) fn direction(number: usize) -> [f64; 2] {
    let (sin, cos) = (TAU * number as f64 / DIRECTIONS as f64).sin_cos();
    [cos, sin]
}

/// The middle of the area of a polygon; `None` if it encloses none.
pub(super) fn middle(corners: &[[f64; 2]]) -> Option<[f64; 2]> {
    let &[x, y] = corners.first()?;
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let (mut twice, mut sum) = (0.0, [0.0; 2]);
    for (a, b) in edges {
        let (a, b) = ([a[0] - x, a[1] - y], [b[0] - x, b[1] - y]);
        let cross = a[0] * b[1] - a[1] * b[0];
        twice += cross;
        sum = [0, 1].map(|axis| sum[axis] + cross * (a[axis] + b[axis]));
    }
    let middle = [x + sum[0] / (3.0 * twice), y + sum[1] / (3.0 * twice)];
    middle
        .iter()
        .all(|place| place.is_finite())
        .then_some(middle)
}

/// The square of the distance from `middle` to the farthest place of a polygon in each direction; `None` where it does not
/// go all the way around.
pub(super) fn squared_radii(corners: &[[f64; 2]], middle: [f64; 2]) -> Option<Vec<f64>> {
    (0..DIRECTIONS)
        .map(|number| farthest(corners, middle, direction(number)).map(|radius| radius * radius))
        .collect()
}

/// The farthest place along a ray, in lengths of `along`.
fn farthest(corners: &[[f64; 2]], middle: [f64; 2], along: [f64; 2]) -> Option<f64> {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let crossings = edges.filter_map(|(a, b)| {
        let own = |corner: &[f64; 2]| [corner[0] - middle[0], corner[1] - middle[1]];
        let (a, b) = (own(a), own(b));
        let beside = |corner: [f64; 2]| along[0] * corner[1] - along[1] * corner[0];
        let ahead = |corner: [f64; 2]| along[0] * corner[0] + along[1] * corner[1];
        let [side_a, side_b] = [beside(a), beside(b)];
        if (side_a >= 0.0) == (side_b >= 0.0) {
            return None;
        }
        let share = side_a / (side_a - side_b);
        let radius = ahead(a) + share * (ahead(b) - ahead(a));
        (radius >= 0.0).then_some(radius)
    });
    crossings.reduce(f64::max)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    #[test]
    fn radii_of_a_square_are_those_of_a_square() {
        let square = [[1.0, 1.0], [5.0, 1.0], [5.0, 5.0], [1.0, 5.0]];
        let middle = middle(&square).unwrap();
        assert!((middle[0] - 3.0).abs() < 1e-12 && (middle[1] - 3.0).abs() < 1e-12);
        let radii = squared_radii(&square, middle).unwrap();
        for (number, squared) in radii.into_iter().enumerate() {
            let [cos, sin] = direction(number);
            let radius = 2.0 / cos.abs().max(sin.abs());
            assert!((squared - radius * radius).abs() < 1e-9, "{number}");
        }
    }

    #[test]
    fn a_polygon_beside_the_middle_has_no_radii() {
        let square = [[1.0, 1.0], [5.0, 1.0], [5.0, 5.0], [1.0, 5.0]];
        assert!(squared_radii(&square, [9.0, 3.0]).is_none());
        assert!(middle(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]).is_none());
    }
}
