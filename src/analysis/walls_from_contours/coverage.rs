//! Which pixels belong to a polygon, so that together they have its area.

/// Pixels of a rectangle, with the share of each that a polygon covers.
#[derive(Clone, Debug)]
pub(super) struct Coverage {
    /// The lowest column and row.
    first: [usize; 2],
    width: usize,
    /// Row by row, each with two more cells than `width`.
    shares: Vec<f64>,
}

/// Shares that differ from a whole pixel by less are whole: they are sums of rounded numbers.
const ROUNDING: f64 = 1e-9;

impl Coverage {
    /// Of a closed polygon whose pixel (i, j) is the square from (i, j) to (i + 1, j + 1), on a grid of `size`; what lies
    /// outside of the grid is cut off.
    ///
    /// Each edge adds the signed area between it and the right end of its rows: Δy in all pixels to its right, less in those
    /// that it passes through. The sums along the rows are winding numbers times covered areas, so that a polygon that does not
    /// cross itself gets exactly its area.
    pub(super) fn of(corners: &[[f64; 2]], size: [usize; 2]) -> Option<Self> {
        let range = |axis: usize| {
            let most = size[axis] as f64;
            let places = corners.iter().map(|corner| corner[axis].clamp(0.0, most));
            let low = places.clone().fold(most, f64::min).floor();
            let high = places.fold(0.0, f64::max).ceil();
            (low as usize, high as usize)
        };
        let ([left, right], [low, high]) =
            (<[usize; 2]>::from(range(0)), <[usize; 2]>::from(range(1)));
        if right <= left || high <= low {
            return None;
        }
        let width = right - left;
        let mut coverage = Self {
            first: [left, low],
            width,
            shares: vec![0.0; (width + 2) * (high - low)],
        };
        let most = [width as f64, (high - low) as f64];
        let own = |[x, y]: [f64; 2]| {
            [
                (x - left as f64).clamp(0.0, most[0]),
                (y - low as f64).clamp(0.0, most[1]),
            ]
        };
        for (place, &from) in corners.iter().enumerate() {
            let to = corners[(place + 1) % corners.len()];
            coverage.add_edge(own(from), own(to));
        }
        coverage.sum_up();
        Some(coverage)
    }

    fn add_edge(&mut self, from: [f64; 2], to: [f64; 2]) {
        let rises = to[1] - from[1];
        if rises == 0.0 {
            return;
        }
        let (low, high, sign) = match rises > 0.0 {
            true => (from, to, 1.0),
            false => (to, from, -1.0),
        };
        let slope = (high[0] - low[0]) / (high[1] - low[1]);
        let at = |y: f64| low[0] + slope * (y - low[1]);
        let rows = self.shares.len() / (self.width + 2);
        let last = (high[1].ceil() as usize).min(rows);
        for row in low[1].floor() as usize..last {
            let bottom = low[1].max(row as f64);
            let top = high[1].min((row + 1) as f64);
            if top > bottom {
                let ends = [at(bottom), at(top)].map(|x| x.clamp(0.0, self.width as f64));
                self.add_in_row(row, ends, sign * (top - bottom));
            }
        }
    }

    /// A piece of an edge within one row, from one x to another, that rises by `rise`.
    fn add_in_row(&mut self, row: usize, [a, b]: [f64; 2], rise: f64) {
        let (left, right) = (a.min(b), a.max(b));
        let first = left.floor() as usize;
        let last = (right.ceil() as usize).max(first + 1);
        for cell in first..last {
            let (from, to) = (left.max(cell as f64), right.min((cell + 1) as f64));
            let part = match right > left {
                true => rise * (to - from).max(0.0) / (right - left),
                false => rise,
            };
            let within = 0.5 * (from + to) - cell as f64;
            let place = row * (self.width + 2) + cell;
            for (share, added) in self.shares[place..]
                .iter_mut()
                .zip([part * (1.0 - within), part * within])
            {
                *share += added;
            }
        }
    }

    fn sum_up(&mut self) {
        for row in self.shares.chunks_mut(self.width + 2) {
            let mut sum = 0.0;
            for share in row {
                sum += *share;
                // A polygon may go either way around.
                *share = sum.abs().min(1.0);
            }
        }
    }

    /// The covered area in pixels.
    pub(super) fn area(&self) -> f64 {
        let rows = self.shares.chunks(self.width + 2);
        rows.flat_map(|row| &row[..self.width]).sum()
    }

    /// As many pixels as the polygon has area, those first of which it covers the most.
    pub(super) fn pixels(&self) -> Vec<[usize; 2]> {
        let count = self.area().round() as usize;
        let mut inside = Vec::with_capacity(count);
        let mut partly = Vec::new();
        for (row, shares) in self.shares.chunks(self.width + 2).enumerate() {
            for (column, &share) in shares[..self.width].iter().enumerate() {
                let pixel = [self.first[0] + column, self.first[1] + row];
                if share >= 1.0 - ROUNDING {
                    inside.push(pixel);
                } else if share > 0.0 {
                    partly.push((share, pixel));
                }
            }
        }
        partly.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        let missing = count.saturating_sub(inside.len());
        inside.extend(partly.into_iter().take(missing).map(|(_, pixel)| pixel));
        inside
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    #[test]
    fn covered_areas_are_those_of_polygons() {
        let triangle = [[0.5, 0.25], [7.25, 1.5], [2.0, 6.75]];
        let doubled = (7.25_f64 - 0.5) * (6.75 - 0.25) - (2.0 - 0.5) * (1.5 - 0.25);
        for corners in [triangle.to_vec(), triangle.iter().rev().copied().collect()] {
            let area = Coverage::of(&corners, [10, 10]).unwrap().area();
            assert!((area - doubled / 2.0).abs() < 1e-12, "{area}");
        }
        let square = [[1.5, 1.5], [3.5, 1.5], [3.5, 3.5], [1.5, 3.5]];
        let coverage = Coverage::of(&square, [5, 5]).unwrap();
        assert!((coverage.area() - 4.0).abs() < 1e-12);
        let pixels = coverage.pixels();
        assert_eq!(pixels.len(), 4);
        assert!(pixels.contains(&[2, 2]));
    }

    #[test]
    fn what_lies_beside_the_grid_is_cut_off() {
        let square = [[-5.0, -5.0], [2.0, -5.0], [2.0, 2.0], [-5.0, 2.0]];
        assert_eq!(Coverage::of(&square, [10, 10]).unwrap().pixels().len(), 4);
        let beside = [[-5.0, 1.0], [-1.0, 1.0], [-1.0, 4.0]];
        assert!(Coverage::of(&beside, [10, 10]).is_none());
        let whole = [[-1e9, -1e9], [1e9, -1e9], [1e9, 1e9], [-1e9, 1e9]];
        assert_eq!(Coverage::of(&whole, [3, 2]).unwrap().pixels().len(), 6);
    }
}
