//! Borders of patches as smooth closed lines on the medial surface and on the wall.

/// On which side of which surface a line lies, so that it is seen from there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lies {
    /// On the medial surface, towards the outer side.
    Middle,
    /// On the inner wall, in the cavity.
    Cavity,
    /// On the inner wall, seen from outside.
    InnerFromOutside,
    /// On the outer wall.
    Outside,
}

/// Teeth of one triangle are evened out by one step, those of two by the next.
const EVENINGS: usize = 2;

/// Rounds the corners of a closed line, which follows edges of the mesh: each corner is replaced by two
/// points a quarter of the way to its neighbours (Chaikin's corner cutting), after steps of averaging that
/// take the saw teeth of triangles off. The first point comes back at the end.
pub(in crate::picture) fn rounded<const N: usize>(corners: &[[f64; N]]) -> Vec<[f64; N]> {
    let count = corners.len();
    if count < 3 {
        return Vec::new();
    }
    let mut even = corners.to_vec();
    for _ in 0..EVENINGS {
        even = (0..count)
            .map(|i| {
                let (before, after) = (even[(i + count - 1) % count], even[(i + 1) % count]);
                std::array::from_fn(|k| 0.5 * even[i][k] + 0.25 * (before[k] + after[k]))
            })
            .collect();
    }
    let mut line = Vec::with_capacity(2 * count + 1);
    for i in 0..count {
        let (a, b) = (even[i], even[(i + 1) % count]);
        for share in [0.25, 0.75] {
            line.push(std::array::from_fn(|k| a[k] + share * (b[k] - a[k])));
        }
    }
    line.extend(line.first().copied());
    line
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rounded_line_is_closed_and_stays_within_its_corners() {
        let square = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]].map(|[x, y]| [x, y, 1.0_f64]);
        let line = rounded(&square);
        assert_eq!(line.len(), 9);
        assert_eq!(line.first(), line.last());
        for [x, y, z] in line {
            assert!((0.0..=2.0).contains(&x) && (0.0..=2.0).contains(&y) && z == 1.0);
        }
        assert!(rounded(&square[..2]).is_empty());
    }
}
