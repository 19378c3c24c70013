//! Points of a map from one frame to the next: made when their sources change, turned to agree with
//! the previous map, and moved to their new places.

use super::morph::Morph;
use super::orientation::Turn;
use super::point::ScatterPoint;
use crate::study::Revision;

/// Points of a map with what they were made from: the map `M` and further details `D`, such as classes.
#[derive(Debug)]
pub struct ScatterData<M, D> {
    /// The list of subjects, the map and the details.
    made_from: Option<(Revision, M, D)>,
    /// Where points belong.
    targets: Vec<ScatterPoint>,
    /// Where they are now: on their way, or there.
    points: Vec<ScatterPoint>,
    turn: Turn,
    morph: Morph,
}

impl<M, D> Default for ScatterData<M, D> {
    fn default() -> Self {
        Self {
            made_from: None,
            targets: Vec::new(),
            points: Vec::new(),
            turn: Turn::default(),
            morph: Morph::default(),
        }
    }
}

impl<M: PartialEq, D: PartialEq> ScatterData<M, D> {
    /// Makes points again where the list of subjects, the map or a detail changed; whether one
    /// did. Points of another map of the same list move there, or without `motion` are there at
    /// once.
    pub fn refresh(
        &mut self,
        (listing, map, details): (Revision, M, D),
        now_s: f64,
        motion: bool,
        make: impl FnOnce() -> Vec<ScatterPoint>,
    ) -> bool {
        let made = self.made_from.as_ref();
        let same_listing = made.is_some_and(|made| made.0 == listing);
        let same_map = same_listing && made.is_some_and(|made| made.1 == map);
        if same_map && made.is_some_and(|made| made.2 == details) {
            return false;
        }
        let mut targets = make();
        if !same_map {
            // Subjects' indices mean the same within one list only.
            self.turn = if same_listing {
                Turn::towards(&targets, &self.targets)
            } else {
                Turn::default()
            };
        }
        targets = self.turn.of_points(targets);
        if !same_map {
            self.morph = if motion && same_listing {
                Morph::between(&self.points, &targets, now_s)
            } else {
                Morph::default()
            };
        }
        self.points.clone_from(&targets);
        self.targets = targets;
        self.made_from = Some((listing, map, details));
        self.place(now_s);
        true
    }

    /// Moves points that are on their way; whether any still are.
    pub fn advance(&mut self, now_s: f64) -> bool {
        let moved = self.morph.is_under_way();
        let moves = self.morph.moves(now_s);
        if moved {
            self.place(now_s);
        }
        moves
    }

    /// How the map is turned onto the screen; `None` while points are on their way.
    pub fn turn(&self) -> Option<Turn> {
        (!self.morph.is_under_way()).then_some(self.turn)
    }

    /// How the points of a map are turned onto the screen; not at all where another map is there.
    pub fn turn_of(&self, map: &M) -> Turn {
        let same = self.made_from.as_ref().filter(|made| made.1 == *map);
        same.map_or_else(Turn::default, |_| self.turn)
    }

    /// All points, where they are now.
    pub fn points(&self) -> &[ScatterPoint] {
        &self.points
    }

    fn place(&mut self, now_s: f64) {
        for (index, (point, target)) in self.points.iter_mut().zip(&self.targets).enumerate() {
            point.at = self.morph.place(index, target.at, now_s);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::theme::MORPH_S;

    const SHAPE: [[f64; 2]; 4] = [[0.0, 0.0], [3.0, 0.0], [2.0, 2.0], [0.0, 1.0]];

    fn points(places: [[f64; 2]; 4]) -> Vec<ScatterPoint> {
        let places = places.into_iter().enumerate();
        places
            .map(|(subject, at)| ScatterPoint {
                subject,
                at,
                ..ScatterPoint::default()
            })
            .collect()
    }

    #[test]
    fn points_set_out_from_the_previous_map_and_end_exactly_at_their_new_places() {
        let mut data = ScatterData::default();
        let made = data.refresh((Revision(1), "first", 0), 1.0, true, || points(SHAPE));
        assert!(made && !data.advance(1.0), "the first map is there at once");
        assert_eq!(data.points(), points(SHAPE));
        let other = [SHAPE[0], SHAPE[1], SHAPE[2], [-3.0, 4.0]];
        data.refresh((Revision(1), "second", 0), 2.0, true, || points(other));
        assert!(data.advance(2.0));
        let target = data.targets[3].at;
        let apart = |at: [f64; 2]| (at[0] - target[0]).hypot(at[1] - target[1]);
        let begin = apart(data.points()[3].at);
        assert!(begin > 1.0);
        assert!(data.advance(2.0 + 0.5 * MORPH_S));
        let middle = apart(data.points()[3].at);
        assert!(0.0 < middle && middle < begin);
        assert!(!data.advance(2.0 + 1.01 * MORPH_S));
        assert_eq!(data.points(), data.targets);
        data.refresh((Revision(1), "third", 0), 3.0, false, || points(SHAPE));
        assert!(!data.advance(3.0), "no motion where none is wanted");
        assert_eq!(data.points(), data.targets);
    }

    #[test]
    fn a_turned_map_stays_as_it_was_and_keeps_its_turn_when_a_detail_changes() {
        let mut data = ScatterData::default();
        data.refresh((Revision(1), "first", 0), 0.0, true, || points(SHAPE));
        let turned = SHAPE.map(|[x, y]| [5.0 - y, x]);
        for details in [0, 1] {
            let made = data.refresh((Revision(1), "second", details), 1.0, false, || {
                points(turned)
            });
            assert!(made);
            for (point, at) in data.points().iter().zip(SHAPE) {
                assert!((point.at[0] - at[0]).hypot(point.at[1] - at[1]) < 1e-12);
            }
        }
        let again = data.refresh((Revision(1), "second", 1), 1.0, false, Vec::new);
        assert!(!again, "nothing changed");
        data.refresh((Revision(2), "second", 1), 2.0, true, || points(turned));
        assert_eq!(data.points(), points(turned), "another study lies as it is");
    }
}
