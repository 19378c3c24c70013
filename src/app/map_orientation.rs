//! Turns a new map so that it agrees with the one on screen: a map's own axes mean nothing.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::Arc;

use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::Embedding;
use crate::analysis::medial_map::{MedialMap, StillPart};
use crate::engine::{PoseMap, Showing};

/// The map on screen with the answer that it was made from: turned once.
#[derive(Debug)]
pub struct Oriented<T>(Option<Turned<T>>);

#[derive(Debug)]
struct Turned<T> {
    /// Which opening of a study it is of; maps of others have nothing to agree with.
    opening: u64,
    answer: Arc<T>,
    shown: Arc<T>,
}

impl<T> Default for Oriented<T> {
    fn default() -> Self {
        Self(None)
    }
}

impl<T: Clone> Oriented<T> {
    /// What is shown, with the map turned by `like` so that it agrees with the one shown before.
    pub fn turned(
        &mut self,
        mut showing: Showing<T>,
        opening: u64,
        like: impl Fn(T, &T) -> T,
    ) -> Showing<T> {
        let map = match &mut showing {
            Showing::Ready(answer) => answer,
            Showing::Computing { previous, .. } | Showing::Interrupted { previous, .. } => {
                match previous {
                    Some(answer) => answer,
                    None => return showing,
                }
            }
        };
        let before = (self.0.as_ref()).filter(|turned| turned.opening == opening);
        let shown = match before {
            Some(turned) if Arc::ptr_eq(&turned.answer, map) => Arc::clone(&turned.shown),
            Some(turned) => Arc::new(like(T::clone(map), &turned.shown)),
            None => Arc::clone(map),
        };
        self.0 = Some(Turned {
            opening,
            answer: std::mem::replace(map, Arc::clone(&shown)),
            shown,
        });
        showing
    }
}

/// An item on the new map and on the old.
type Pair = ([f64; 2], [f64; 2]);

/// `map`, moved, turned and, if that fits better, mirrored, so that poses lie as near as possible
/// to where `previous` shows them. Distances stay as they are.
pub fn oriented_like(map: PoseMap, previous: &PoseMap) -> PoseMap {
    let embedding = turned(
        (&map.distances.poses, &map.embedding),
        (&previous.distances.poses, &previous.embedding),
    );
    PoseMap { embedding, ..map }
}

/// The same for a map of deformations. Its curves stay as they are: they lie on another map.
pub fn deformations_like(map: DeformationMap, previous: &DeformationMap) -> DeformationMap {
    let embedding = turned(
        (&map.subjects, &map.embedding),
        (&previous.subjects, &previous.embedding),
    );
    DeformationMap { embedding, ..map }
}

/// The same for a map of the medial shape space.
pub fn medial_like(map: MedialMap, previous: &MedialMap) -> MedialMap {
    let steps = |map: &MedialMap| -> Vec<(usize, StillPart, usize)> {
        let poses = map.poses.iter();
        poses
            .map(|pose| (pose.subject, pose.part, pose.step_from))
            .collect()
    };
    let embedding = turned(
        (&steps(&map), &map.embedding),
        (&steps(previous), &previous.embedding),
    );
    MedialMap { embedding, ..map }
}

/// With s = Σ pᵢ·qᵢ and c = Σ pᵢ×qᵢ over items in both maps, p of the new map and q of the old,
/// both centred, the best rotation is by atan2(c, s) and gains √(s² + c²); the mirror image is
/// taken where it gains more. Maps that share fewer than two items, or are not plane, stay.
fn turned<K: Eq + Hash>(
    (items, map): (&[K], &Embedding),
    (old_items, previous): (&[K], &Embedding),
) -> Embedding {
    let mut map = map.clone();
    if map.dimensions != 2 || previous.dimensions != 2 {
        return map;
    }
    let place: HashMap<&K, usize> = old_items.iter().zip(0..).collect();
    let pairs: Vec<Pair> = items
        .iter()
        .enumerate()
        .filter_map(|(row, item)| {
            let old = *place.get(item)?;
            Some((plane(map.point(row)), plane(previous.point(old))))
        })
        .collect();
    if pairs.len() < 2 {
        return map;
    }
    let count = pairs.len() as f64;
    let middle = |side: fn(&Pair) -> [f64; 2]| {
        let sum = pairs.iter().map(side).fold([0.0, 0.0], |sum, point| {
            [sum[0] + point[0], sum[1] + point[1]]
        });
        [sum[0] / count, sum[1] / count]
    };
    let (from, to) = (middle(|pair| pair.0), middle(|pair| pair.1));
    let turn = |mirror: f64| {
        let (mut dot, mut cross) = (0.0, 0.0);
        for (p, q) in &pairs {
            let p = [p[0] - from[0], mirror * (p[1] - from[1])];
            let q = [q[0] - to[0], q[1] - to[1]];
            dot += p[0] * q[0] + p[1] * q[1];
            cross += p[0] * q[1] - p[1] * q[0];
        }
        (dot.hypot(cross), cross.atan2(dot), mirror)
    };
    let (plain, mirrored) = (turn(1.0), turn(-1.0));
    let (_, angle, mirror) = if mirrored.0 > plain.0 {
        mirrored
    } else {
        plain
    };
    let (sin, cos) = angle.sin_cos();
    for point in map.coordinates.chunks_exact_mut(2) {
        let (x, y) = (point[0] - from[0], mirror * (point[1] - from[1]));
        point[0] = to[0] + cos * x - sin * y;
        point[1] = to[1] + sin * x + cos * y;
    }
    map
}

fn plane(point: &[f64]) -> [f64; 2] {
    [
        point.first().copied().unwrap_or_default(),
        point.get(1).copied().unwrap_or_default(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::embedding::Embedding;
    use crate::analysis::pose_distances::{DistanceMatrix, PoseDistances, PoseId};
    use std::sync::Arc;

    fn map(points: &[[f64; 2]]) -> PoseMap {
        let poses = (0..points.len())
            .map(|frame| PoseId { subject: 0, frame })
            .collect();
        let pairs = points.len() * (points.len() - 1) / 2;
        PoseMap {
            distances: Arc::new(PoseDistances {
                poses,
                distances: DistanceMatrix::from_upper(points.len(), vec![1.0; pairs]).unwrap(),
                left_out: Vec::new(),
            }),
            embedding: Embedding {
                dimensions: 2,
                coordinates: points.concat(),
                ..Embedding::default()
            },
        }
    }

    #[test]
    fn a_turned_mirrored_and_moved_map_comes_back_to_its_place() {
        let shown = [[0.0, 0.0], [4.0, 0.5], [1.0, 3.0], [-2.0, 1.0]];
        for mirror in [1.0, -1.0] {
            let (sin, cos) = 2.1_f64.sin_cos();
            let moved: Vec<[f64; 2]> = shown
                .iter()
                .map(|[x, y]| {
                    let y = mirror * y;
                    [7.0 + cos * x - sin * y, -3.0 + sin * x + cos * y]
                })
                .collect();
            let back = oriented_like(map(&moved), &map(&shown));
            for (got, want) in back.embedding.coordinates.iter().zip(shown.concat()) {
                assert!((got - want).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn orienting_changes_no_distance() {
        let old = map(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        let new = map(&[[0.0, 2.0], [5.0, 1.0], [-1.0, 1.0]]);
        let length = |map: &PoseMap, i: usize, j: usize| {
            let (p, q) = (map.embedding.point(i), map.embedding.point(j));
            (p[0] - q[0]).hypot(p[1] - q[1])
        };
        let turned = oriented_like(new.clone(), &old);
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            assert!((length(&turned, i, j) - length(&new, i, j)).abs() < 1e-12);
        }
    }
}
