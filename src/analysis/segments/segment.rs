//! The 17 segments of the American Heart Association: numbers, names, and which place is which.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, FRAC_PI_4, PI, TAU};

/// AHA segment number, 1 to 17.
///
/// Source: Cerqueira et al. (2002), Circulation 105(4), 539–542.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Segment(u8);

/// A ring of segments, from the base down.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Level {
    /// The third of the cavity next to the base: segments 1–6.
    Basal,
    /// The middle third: segments 7–12.
    Mid,
    /// The third next to the apex: segments 13–16.
    Apical,
    /// The cap beyond the end of the cavity: segment 17.
    Apex,
}

impl Level {
    /// All four, from the base down.
    pub const ALL: [Self; 4] = [Self::Basal, Self::Mid, Self::Apical, Self::Apex];

    /// The level of a depth: the distance from the base over the distance from the base to the end
    /// of the cavity. Thirds are basal, mid and apical; from 1 on it is the apex.
    pub fn at_depth(depth: f64) -> Self {
        if depth < 1.0 / 3.0 {
            Self::Basal
        } else if depth < 2.0 / 3.0 {
            Self::Mid
        } else if depth < 1.0 {
            Self::Apical
        } else {
            Self::Apex
        }
    }

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Basal => "basal",
            Self::Mid => "mid",
            Self::Apical => "apical",
            Self::Apex => "apex",
        }
    }

    /// Place in [`Self::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }

    /// Its segments in ascending order.
    pub fn segments(self) -> impl Iterator<Item = Segment> {
        Segment::all().filter(move |segment| segment.level() == self)
    }
}

/// Names of segments 1 to 17, as the standard calls them.
const NAMES: [&str; Segment::COUNT] = [
    "basal anterior",
    "basal anteroseptal",
    "basal inferoseptal",
    "basal inferior",
    "basal inferolateral",
    "basal anterolateral",
    "mid anterior",
    "mid anteroseptal",
    "mid inferoseptal",
    "mid inferior",
    "mid inferolateral",
    "mid anterolateral",
    "apical anterior",
    "apical septal",
    "apical inferior",
    "apical lateral",
    "apex",
];

impl Segment {
    /// How many there are.
    pub const COUNT: usize = 17;

    /// The segment of a number; `None` unless 1 to 17.
    pub fn new(number: u8) -> Option<Self> {
        (1..=Self::COUNT as u8)
            .contains(&number)
            .then_some(Self(number))
    }

    /// All of them in ascending order.
    pub fn all() -> impl Iterator<Item = Self> {
        (1..=Self::COUNT as u8).map(Self)
    }

    /// The segment at a depth (see [`Level::at_depth`]) and an angle: 0 in the middle of the lateral
    /// wall, π/2 of the anterior one, π of the septum, 3π/2 of the inferior wall.
    ///
    /// Basal and mid segments are 60° wide and count from the anterior wall over the septum,
    /// apical ones 90°. Source: Cerqueira et al. (2002), Figs. 2–4.
    pub fn at(depth: f64, angle_rad: f64) -> Self {
        // The first sector begins at 60°, so that the anterior wall, at 90°, is in its middle.
        let sixth = || sector(angle_rad - FRAC_PI_3, FRAC_PI_3, 6);
        match Level::at_depth(depth) {
            Level::Basal => Self(1 + sixth()),
            Level::Mid => Self(7 + sixth()),
            // Four sectors of 90°: the first begins at 45° for the same reason.
            Level::Apical => Self(13 + sector(angle_rad - FRAC_PI_4, FRAC_PI_2, 4)),
            Level::Apex => Self(17),
        }
    }

    /// 1 to 17.
    pub fn number(self) -> u8 {
        self.0
    }

    /// Place in an array of all: the number less one.
    pub fn index(self) -> usize {
        usize::from(self.0) - 1
    }

    /// As the standard calls it: "basal anteroseptal".
    pub fn name(self) -> &'static str {
        NAMES[self.index()]
    }

    /// Its ring.
    pub fn level(self) -> Level {
        match self.0 {
            ..=6 => Level::Basal,
            7..=12 => Level::Mid,
            13..=16 => Level::Apical,
            _ => Level::Apex,
        }
    }

    /// Middle and half width of its sector on the bull's-eye, in radians; the apex is a full circle.
    pub fn sector_rad(self) -> [f64; 2] {
        let step = f64::from(self.0);
        match self.level() {
            Level::Basal => [FRAC_PI_2 + FRAC_PI_3 * (step - 1.0), 0.5 * FRAC_PI_3],
            Level::Mid => [FRAC_PI_2 + FRAC_PI_3 * (step - 7.0), 0.5 * FRAC_PI_3],
            Level::Apical => [FRAC_PI_2 * (step - 12.0), FRAC_PI_4],
            Level::Apex => [0.0, PI],
        }
    }
}

/// Index of the sector of `width` in which an angle lies, of `count`.
fn sector(angle_rad: f64, width: f64, count: u8) -> u8 {
    // Round-off just below a full turn must not make one sector more.
    ((angle_rad.rem_euclid(TAU) / width) as u8).min(count - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_each_segment_is_that_segment() {
        for segment in Segment::all() {
            let depth = [0.17, 0.5, 0.83, 1.0][segment.level().index()];
            let [middle, half] = segment.sector_rad();
            for angle in [middle, middle + 0.99 * half, middle - 0.99 * half] {
                assert_eq!(Segment::at(depth, angle), segment);
                assert_eq!(Segment::at(depth, angle - TAU), segment);
            }
        }
    }

    #[test]
    fn numbers_outside_the_standard_are_no_segments() {
        assert!(Segment::new(0).is_none() && Segment::new(18).is_none());
        assert_eq!(Segment::all().count(), Segment::COUNT);
        assert_eq!(Segment::new(2).unwrap().name(), "basal anteroseptal");
        assert_eq!(Segment::new(17).unwrap().name(), "apex");
    }

    #[test]
    fn levels_hold_six_six_four_and_one_segments() {
        let counts = Level::ALL.map(|level| level.segments().count());
        assert_eq!(counts, [6, 6, 4, 1]);
    }
}
