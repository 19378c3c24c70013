//! Turns a new map so that it agrees with the one on screen: a map's own axes mean nothing.

use std::collections::HashMap;

use super::point::{PointKey, ScatterPoint};

/// Where a point is on the new map and on the previous one.
type Pair = ([f64; 2], [f64; 2]);

/// A motion of the plane that keeps distances, possibly with a mirror.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    from: [f64; 2],
    to: [f64; 2],
    /// −1 mirrors the second axis, 1 does not.
    mirror: f64,
    sin_cos: (f64, f64),
}

impl Default for Turn {
    /// The one that moves nothing.
    fn default() -> Self {
        Self {
            from: [0.0; 2],
            to: [0.0; 2],
            mirror: 1.0,
            sin_cos: (0.0, 1.0),
        }
    }
}

impl Turn {
    /// Moves, turns and, if that fits better, mirrors `points` so that they lie as near as possible
    /// to where `previous` shows them.
    ///
    /// With s = Σ pᵢ·qᵢ and c = Σ pᵢ×qᵢ over points of both maps, p of the new map and q of the
    /// previous, both centred, the best rotation is by atan2(c, s) and gains √(s² + c²); the mirror
    /// image is taken where it gains more. Maps that share fewer than two points stay.
    ///
    /// Source: in the plane, the rotation of Borg and Groenen, *Modern Multidimensional Scaling*, 2nd ed., section 20.2, with a
    /// reflection allowed: a map has no handedness.
    pub fn towards(points: &[ScatterPoint], previous: &[ScatterPoint]) -> Self {
        let place: HashMap<PointKey, [f64; 2]> = previous
            .iter()
            .map(|point| (point.key(), point.at))
            .collect();
        let pairs: Vec<Pair> = points
            .iter()
            .filter_map(|point| Some((point.at, *place.get(&point.key())?)))
            .collect();
        if pairs.len() < 2 {
            return Self::default();
        }
        let count = pairs.len() as f64;
        let mean = |side: fn(&Pair) -> [f64; 2]| {
            [0, 1].map(|axis| pairs.iter().map(|pair| side(pair)[axis]).sum::<f64>() / count)
        };
        let (from, to) = (mean(|pair| pair.0), mean(|pair| pair.1));
        let gain = |mirror: f64| {
            let (mut dot, mut cross) = (0.0, 0.0);
            for (p, q) in &pairs {
                let p = [p[0] - from[0], mirror * (p[1] - from[1])];
                let q = [q[0] - to[0], q[1] - to[1]];
                dot += p[0] * q[0] + p[1] * q[1];
                cross += p[0] * q[1] - p[1] * q[0];
            }
            (dot.hypot(cross), cross.atan2(dot), mirror)
        };
        let (plain, mirrored) = (gain(1.0), gain(-1.0));
        let best = if mirrored.0 > plain.0 {
            mirrored
        } else {
            plain
        };
        Self {
            from,
            to,
            mirror: best.2,
            sin_cos: best.1.sin_cos(),
        }
    }

    /// The place of the map that is shown at a place: the inverse of [`Self::apply`].
    pub fn undo(&self, at: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.sin_cos;
        let (x, y) = (at[0] - self.to[0], at[1] - self.to[1]);
        [
            self.from[0] + cos * x + sin * y,
            self.from[1] + self.mirror * (cos * y - sin * x),
        ]
    }

    /// Where a place of the new map is shown.
    pub fn apply(&self, at: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.sin_cos;
        let (x, y) = (at[0] - self.from[0], self.mirror * (at[1] - self.from[1]));
        [
            self.to[0] + cos * x - sin * y,
            self.to[1] + sin * x + cos * y,
        ]
    }

    /// The points of the new map where they are shown.
    pub fn of_points(&self, mut points: Vec<ScatterPoint>) -> Vec<ScatterPoint> {
        for point in &mut points {
            point.at = self.apply(point.at);
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(places: &[[f64; 2]]) -> Vec<ScatterPoint> {
        let points = places.iter().enumerate();
        points
            .map(|(frame, at)| ScatterPoint {
                frames: Some([frame, frame]),
                at: *at,
                ..ScatterPoint::default()
            })
            .collect()
    }

    #[test]
    fn a_turned_mirrored_and_moved_map_comes_back_to_its_place() {
        let shown = [[0.0, 0.0], [4.0, 0.5], [1.0, 3.0], [-2.0, 1.0]];
        for mirror in [1.0, -1.0] {
            let (sin, cos) = 2.1_f64.sin_cos();
            let moved = shown.map(|[x, y]| {
                let y = mirror * y;
                [7.0 + cos * x - sin * y, -3.0 + sin * x + cos * y]
            });
            let turn = Turn::towards(&map(&moved), &map(&shown));
            let back = turn.undo(turn.apply([2.0, -7.5]));
            assert!((back[0] - 2.0).hypot(back[1] + 7.5) < 1e-12, "{back:?}");
            for (got, want) in moved
                .map(|at| turn.apply(at))
                .concat()
                .iter()
                .zip(shown.concat())
            {
                assert!((got - want).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_turn_changes_no_distance_and_maps_without_common_points_stay() {
        let old = map(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        let new = [[0.0, 2.0], [5.0, 1.0], [-1.0, 1.0]];
        let turn = Turn::towards(&map(&new), &old);
        let apart = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let turned = apart(turn.apply(new[i]), turn.apply(new[j]));
            assert!((turned - apart(new[i], new[j])).abs() < 1e-12);
        }
        assert_eq!(Turn::towards(&map(&new), &old[..1]), Turn::default());
    }
}
