//! Parts of one slice: pixels that belong together, without holes.

use std::collections::VecDeque;

/// Some pixels of a slice, i fastest.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Region {
    width: usize,
    inside: Vec<bool>,
}

/// The four neighbours of a pixel.
const NEIGHBOURS: [[isize; 2]; 4] = [[1, 0], [-1, 0], [0, 1], [0, -1]];

impl Region {
    /// Pixels of rows of `width`, which must be more than 0.
    pub fn new(width: usize, inside: Vec<bool>) -> Self {
        Self { width, inside }
    }

    /// How many pixels there are.
    pub fn count(&self) -> usize {
        self.inside.iter().filter(|&&inside| inside).count()
    }

    /// The column and row of every pixel.
    pub fn pixels(&self) -> impl Iterator<Item = [usize; 2]> {
        let places = self
            .inside
            .iter()
            .enumerate()
            .filter(|(_, inside)| **inside);
        places.map(|(place, _)| [place % self.width, place / self.width])
    }

    /// Mean column and row; `None` without pixels.
    pub fn centre(&self) -> Option<[f64; 2]> {
        let (mut sum, mut count) = ([0.0; 2], 0.0);
        for [i, j] in self.pixels() {
            sum = [sum[0] + i as f64, sum[1] + j as f64];
            count += 1.0;
        }
        (count > 0.0).then(|| sum.map(|s| s / count))
    }

    /// Pixels of either.
    pub fn with(&self, other: &Self) -> Self {
        let either = self.inside.iter().zip(&other.inside);
        Self::new(self.width, either.map(|(a, b)| *a || *b).collect())
    }

    /// Pixels of both.
    pub fn within(&self, other: &Self) -> Self {
        let both = self.inside.iter().zip(&other.inside);
        Self::new(self.width, both.map(|(a, b)| *a && *b).collect())
    }

    /// Whether a pixel is one of these, beyond the slice never.
    pub fn contains(&self, [i, j]: [isize; 2]) -> bool {
        self.place([i, j]).is_some_and(|place| self.inside[place])
    }

    fn place(&self, [i, j]: [isize; 2]) -> Option<usize> {
        let (i, j) = (usize::try_from(i).ok()?, usize::try_from(j).ok()?);
        let place = j.checked_mul(self.width)?.checked_add(i)?;
        (i < self.width && place < self.inside.len()).then_some(place)
    }

    /// The pixels that hang together with a starting one over their sides, all of which `may` be entered.
    fn flooded(&self, start: usize, may: impl Fn(usize) -> bool, seen: &mut [bool]) -> Vec<usize> {
        let mut found = vec![start];
        let mut next = VecDeque::from([start]);
        seen[start] = true;
        while let Some(place) = next.pop_front() {
            let [i, j] = [place % self.width, place / self.width].map(|x| x as isize);
            for [di, dj] in NEIGHBOURS {
                if let Some(beside) = self.place([i + di, j + dj])
                    && !seen[beside]
                    && may(beside)
                {
                    seen[beside] = true;
                    found.push(beside);
                    next.push_back(beside);
                }
            }
        }
        found
    }

    /// The largest part that hangs together; of equal ones the first.
    pub fn largest_part(&self) -> Self {
        let mut seen = vec![false; self.inside.len()];
        let mut largest = Vec::new();
        for start in 0..self.inside.len() {
            if self.inside[start] && !seen[start] {
                let part = self.flooded(start, |place| self.inside[place], &mut seen);
                if part.len() > largest.len() {
                    largest = part;
                }
            }
        }
        let mut inside = vec![false; self.inside.len()];
        for place in largest {
            inside[place] = true;
        }
        Self::new(self.width, inside)
    }

    /// With everything that it encloses.
    pub fn filled(&self) -> Self {
        let height = self.inside.len() / self.width;
        let mut outside = vec![false; self.inside.len()];
        let edge = |place: usize| {
            let (i, j) = (place % self.width, place / self.width);
            i == 0 || j == 0 || i + 1 == self.width || j + 1 == height
        };
        for start in (0..self.inside.len()).filter(|&place| edge(place)) {
            if !self.inside[start] && !outside[start] {
                self.flooded(start, |place| !self.inside[place], &mut outside);
            }
        }
        Self::new(
            self.width,
            outside.into_iter().map(|outside| !outside).collect(),
        )
    }

    /// Sides of pixels with the outside beyond: the middle of each in columns and rows, and the pixel beyond.
    pub fn outline(&self) -> impl Iterator<Item = ([f64; 2], [isize; 2])> {
        self.pixels().flat_map(move |[i, j]| {
            let [x, y] = [i as f64, j as f64];
            let [i, j] = [i as isize, j as isize];
            NEIGHBOURS.into_iter().filter_map(move |[di, dj]| {
                let beyond = [i + di, j + dj];
                let middle = [x + 0.5 * di as f64, y + 0.5 * dj as f64];
                (!self.contains(beyond)).then_some((middle, beyond))
            })
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn region(rows: &[&str]) -> Region {
        let inside = rows.iter().flat_map(|row| row.chars().map(|c| c == '#'));
        Region::new(rows[0].len(), inside.collect())
    }

    #[test]
    fn the_largest_part_is_kept_and_holes_are_filled() {
        let ring = region(&["####.#", "#..#.#", "#..#..", "####.#"]);
        assert_eq!(ring.largest_part().count(), 12);
        assert_eq!(ring.largest_part().filled().count(), 16);
        assert_eq!(ring.filled().count(), 19);
        assert_eq!(region(&["...", "..."]).largest_part().count(), 0);
    }

    #[test]
    fn the_outline_has_every_side_once_even_at_the_edge_of_the_slice() {
        assert_eq!(region(&["##", "##"]).outline().count(), 8);
        assert_eq!(region(&["....", ".##.", "...."]).outline().count(), 6);
        assert_eq!(region(&["..."]).centre(), None);
        assert_eq!(region(&[".##."]).centre(), Some([1.5, 0.0]));
    }
}
