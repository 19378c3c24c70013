//! Closed curves in the plane of a slice.

/// A point of a slice.
pub(super) type Point2 = nalgebra::Point2<f64>;
/// A direction in a slice.
pub(super) type Vector2 = nalgebra::Vector2<f64>;

/// Sides of a closed polygon.
fn sides(polygon: &[Point2]) -> impl Iterator<Item = [Point2; 2]> + '_ {
    (0..polygon.len()).map(|i| [polygon[i], polygon[(i + 1) % polygon.len()]])
}

/// Area inside, positive if wound against the clock, and centroid; `None` of no area.
pub(super) fn area_and_centroid(polygon: &[Point2]) -> Option<(f64, Point2)> {
    let first = *polygon.first()?;
    let (mut twice, mut moment) = (0.0, Vector2::zeros());
    for [a, b] in sides(polygon) {
        // From a vertex: far from the origin the products would cancel.
        let (a, b) = (a - first, b - first);
        let cross = a.perp(&b);
        twice += cross;
        moment += (a + b) * cross;
    }
    let centroid = first + moment / (3.0 * twice);
    (centroid.x.is_finite() && centroid.y.is_finite()).then_some((0.5 * twice, centroid))
}

/// Signed way along `direction` from a point to each crossing of its line with a polygon.
pub(super) fn crossings(
    polygon: &[Point2],
    from: Point2,
    direction: Vector2,
) -> impl Iterator<Item = f64> + '_ {
    sides(polygon).filter_map(move |[a, b]| {
        let [ha, hb] = [a, b].map(|p| direction.perp(&(p - from)));
        // A vertex on the line counts for one of its two sides, so that no crossing is counted twice.
        if (ha <= 0.0) == (hb <= 0.0) {
            return None;
        }
        let crossing = a + (b - a) * (ha / (ha - hb));
        Some(direction.dot(&(crossing - from)))
    })
}

/// The same closed curve by `count` points at even distances along it.
pub(super) fn resampled(polygon: &[Point2], count: usize) -> Vec<Point2> {
    let mut lengths = vec![0.0];
    for [a, b] in sides(polygon) {
        lengths.push(lengths[lengths.len() - 1] + (b - a).norm());
    }
    let whole = lengths[polygon.len()];
    let mut side = 0;
    (0..count)
        .map(|step| {
            let wanted = whole * step as f64 / count as f64;
            // Lengths ascend, so the search never goes back.
            while side + 1 < polygon.len() && lengths[side + 1] <= wanted {
                side += 1;
            }
            let [a, b] = [polygon[side], polygon[(side + 1) % polygon.len()]];
            let length = lengths[side + 1] - lengths[side];
            let part = if length > 0.0 {
                (wanted - lengths[side]) / length
            } else {
                0.0
            };
            a + (b - a) * part
        })
        .collect()
}

/// Place on a closed polygon nearest to a point: the side's number and the share of its length.
pub(super) fn nearest_place(polygon: &[Point2], point: Point2) -> Option<(usize, f64)> {
    let place = |[a, b]: [Point2; 2]| {
        let along = b - a;
        let length2 = along.norm_squared();
        let share = if length2 > 0.0 {
            (along.dot(&(point - a)) / length2).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (share, (a + along * share - point).norm_squared())
    };
    sides(polygon)
        .map(place)
        .enumerate()
        .min_by(|a, b| a.1.1.total_cmp(&b.1.1))
        .map(|(side, (share, _))| (side, share))
}
