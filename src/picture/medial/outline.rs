//! Borders of patches as smooth closed lines on the medial surface and on the wall.

use crate::mesh::Point3;

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

/// A line cut into dashes of one length with gaps of another, in the unit of its coordinates. The last dash may be
/// shorter. Lengths that are not positive leave the line whole.
pub(super) fn dashed(line: &[[f32; 3]], [dash, gap]: [f64; 2]) -> Vec<Vec<[f32; 3]>> {
    if !(dash > 0.0 && gap > 0.0) {
        return vec![line.to_vec()];
    }
    let mut dashes = Vec::new();
    let mut current: Vec<[f32; 3]> = line.first().copied().into_iter().collect();
    let (mut drawing, mut left) = (true, dash);
    for pair in line.windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|p| Point3::from(p.map(f64::from)));
        let length = (b - a).norm();
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let at: [f32; 3] = (a + done / length * (b - a)).coords.cast::<f32>().into();
            if drawing {
                current.push(at);
                dashes.push(std::mem::take(&mut current));
            } else {
                current = vec![at];
            }
            drawing = !drawing;
            left = if drawing { dash } else { gap };
        }
        left -= length - done;
        if drawing {
            current.push(pair[1]);
        }
    }
    if drawing && current.len() > 1 {
        dashes.push(current);
    }
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dashes_have_their_length_and_stay_on_the_line() {
        // Ten long, with a corner: dashes of two and gaps of one begin at 0, 3, 6 and 9.
        let line = [[0.0, 0.0, 0.0], [7.0, 0.0, 0.0], [7.0, 3.0, 0.0]];
        let dashes = dashed(&line, [2.0, 1.0]);
        assert_eq!(dashes.len(), 4);
        assert_eq!(dashes[1], [[3.0, 0.0, 0.0], [5.0, 0.0, 0.0]]);
        assert_eq!(
            dashes[2],
            [[6.0, 0.0, 0.0], [7.0, 0.0, 0.0], [7.0, 1.0, 0.0]]
        );
        assert_eq!(dashes[3], [[7.0, 2.0, 0.0], [7.0, 3.0, 0.0]]);
        assert_eq!(dashed(&line, [0.0, 1.0]), [line.to_vec()]);
        assert!(dashed(&[], [2.0, 1.0]).is_empty());
    }

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
