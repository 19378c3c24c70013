//! Points on their way from the map before to the new one, so that the eye can follow them.

use std::collections::HashMap;

use crate::ui::theme::MORPH_S;

use super::point::{PointKey, ScatterPoint};

/// Where points come from, and when they began to move.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Morph {
    from: Vec<[f64; 2]>,
    began_s: Option<f64>,
}

impl Morph {
    /// Starts from where points are shown now. The old places are scaled to the spread of the new
    /// ones, as the pane shows both at the same size. Points that the old map lacks are at their new
    /// places at once.
    pub fn between(shown: &[ScatterPoint], targets: &[ScatterPoint], now_s: f64) -> Self {
        let shown: HashMap<PointKey, [f64; 2]> =
            shown.iter().map(|point| (point.key(), point.at)).collect();
        let place = |target: &ScatterPoint| shown.get(&target.key()).copied();
        let pairs: Vec<([f64; 2], [f64; 2])> = targets
            .iter()
            .filter_map(|target| Some((place(target)?, target.at)))
            .collect();
        if pairs.is_empty() {
            return Self::default();
        }
        let (old, old_spread) = centre_and_spread(pairs.iter().map(|pair| pair.0));
        let (new, new_spread) = centre_and_spread(pairs.iter().map(|pair| pair.1));
        let scale = if old_spread > 0.0 && new_spread > 0.0 {
            new_spread / old_spread
        } else {
            1.0
        };
        let start =
            |place: [f64; 2]| [0, 1].map(|axis| new[axis] + scale * (place[axis] - old[axis]));
        let from = targets.iter();
        Self {
            from: from
                .map(|target| place(target).map_or(target.at, start))
                .collect(),
            began_s: Some(now_s),
        }
    }

    /// Whether points were moving when they were last asked.
    pub fn is_under_way(&self) -> bool {
        self.began_s.is_some()
    }

    /// Whether points still move at this time; once they do not, they never do again.
    pub fn moves(&mut self, now_s: f64) -> bool {
        if self.began_s.is_some_and(|began| now_s - began >= MORPH_S) {
            *self = Self::default();
        }
        self.began_s.is_some()
    }

    /// Where a point is now, on its way to `target`: it starts and ends slowly.
    pub fn place(&self, index: usize, target: [f64; 2], now_s: f64) -> [f64; 2] {
        let (Some(from), Some(began_s)) = (self.from.get(index), self.began_s) else {
            return target;
        };
        let share = ((now_s - began_s) / MORPH_S).clamp(0.0, 1.0);
        let share = share * share * (3.0 - 2.0 * share);
        [0, 1].map(|axis| from[axis] + share * (target[axis] - from[axis]))
    }
}

/// Mean and root mean square distance from it.
fn centre_and_spread(places: impl Iterator<Item = [f64; 2]> + Clone) -> ([f64; 2], f64) {
    let count = places.clone().count().max(1) as f64;
    let centre = [0, 1].map(|axis| places.clone().map(|place| place[axis]).sum::<f64>() / count);
    let squares = places.map(|place| {
        let offset = [0, 1].map(|axis| place[axis] - centre[axis]);
        offset[0] * offset[0] + offset[1] * offset[1]
    });
    (centre, (squares.sum::<f64>() / count).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points<const N: usize>(places: [(usize, [f64; 2]); N]) -> [ScatterPoint; N] {
        places.map(|(subject, at)| ScatterPoint {
            subject,
            at,
            ..ScatterPoint::default()
        })
    }

    #[test]
    fn points_go_from_old_to_new_places_and_stay_there() {
        let shown = points([(0, [0.0, 0.0]), (1, [2.0, 0.0])]);
        let targets = points([(0, [1.0, 1.0]), (1, [3.0, 1.0]), (2, [9.0, 9.0])]);
        let mut morph = Morph::between(&shown, &targets, 0.0);
        // The old places, moved to where the new map lies.
        assert_eq!(morph.place(0, targets[0].at, 0.0), [1.0, 1.0]);
        assert_eq!(morph.place(2, targets[2].at, 0.0), [9.0, 9.0]);
        assert!(morph.moves(0.1));
        let turned = points([(0, [3.0, 1.0]), (1, [1.0, 1.0])]);
        let mut other = Morph::between(&shown, &turned, 0.0);
        assert_eq!(other.place(0, turned[0].at, 0.0), [1.0, 1.0]);
        assert_eq!(other.place(0, turned[0].at, 0.5 * MORPH_S), [2.0, 1.0]);
        assert!(other.moves(0.9 * MORPH_S));
        assert!(!other.moves(MORPH_S));
        assert_eq!(other.place(0, turned[0].at, 0.0), [3.0, 1.0]);
    }

    #[test]
    fn a_map_of_another_scale_begins_at_its_own_and_one_without_common_points_does_not_move() {
        let shown = points([(0, [-1.0, 0.0]), (1, [1.0, 0.0])]);
        let targets = points([(0, [0.0, -100.0]), (1, [0.0, 100.0])]);
        let morph = Morph::between(&shown, &targets, 0.0);
        assert_eq!(morph.place(1, targets[1].at, 0.0), [100.0, 0.0]);
        let others = points([(7, [5.0, 5.0])]);
        let mut morph = Morph::between(&shown, &others, 0.0);
        assert!(!morph.moves(0.0));
        assert_eq!(morph.place(0, [5.0, 5.0], 0.0), [5.0, 5.0]);
    }
}
