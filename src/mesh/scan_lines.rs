//! Where lines along z enter and leave a closed surface: the way to tell many points inside from outside.

use super::Point3;

/// Lines along z over a grid in x and y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScanGrid {
    /// x and y of the first line.
    pub origin: [f64; 2],
    /// Distance of neighbours in x and y.
    pub spacing: [f64; 2],
    /// Lines in x and y.
    pub lines: [usize; 2],
}

/// Heights z at which each line crosses triangles, ascending; lines with x fastest.
///
/// Between the first and second, the third and fourth … a line is inside. Of a closed surface each line
/// crosses an even number of times: a side shared by two triangles is computed alike for both, and
/// triangles own their lower and left borders only, so that none is met twice or missed.
pub fn scan_lines(triangles: &[[Point3; 3]], grid: &ScanGrid) -> Vec<Vec<f64>> {
    let mut crossings = vec![Vec::new(); grid.lines[0] * grid.lines[1]];
    for corners in triangles {
        let [low, high] = span(corners, 1, grid);
        for row in low..high {
            let y = grid.origin[1] + grid.spacing[1] * row as f64;
            let Some([left, right]) = cut_at(corners, y) else {
                continue;
            };
            let first = (left - grid.origin[0]) / grid.spacing[0] - 1.0;
            let last = (right - grid.origin[0]) / grid.spacing[0] + 2.0;
            let columns = clamped(first, grid.lines[0])..clamped(last, grid.lines[0]);
            for column in columns {
                let x = grid.origin[0] + grid.spacing[0] * column as f64;
                if left <= x && x < right {
                    crossings[row * grid.lines[0] + column].push(height(corners, x, y));
                }
            }
        }
    }
    for line in &mut crossings {
        line.sort_unstable_by(f64::total_cmp);
    }
    crossings
}

/// Rows that a triangle may meet.
fn span(corners: &[Point3; 3], axis: usize, grid: &ScanGrid) -> [usize; 2] {
    let place = |point: &Point3| (point[axis] - grid.origin[axis]) / grid.spacing[axis];
    let low = corners.iter().map(place).fold(f64::INFINITY, f64::min);
    let high = corners.iter().map(place).fold(f64::NEG_INFINITY, f64::max);
    [
        clamped(low - 1.0, grid.lines[axis]),
        clamped(high + 2.0, grid.lines[axis]),
    ]
}

fn clamped(place: f64, most: usize) -> usize {
    (place.max(0.0) as usize).min(most)
}

/// Where the line of a row crosses the sides of a triangle seen along z, left first.
fn cut_at(corners: &[Point3; 3], y: f64) -> Option<[f64; 2]> {
    let mut found = [0.0; 2];
    let mut count = 0;
    for (from, to) in [(0, 1), (1, 2), (2, 0)] {
        let (a, b) = ordered(corners[from], corners[to]);
        if (a.y <= y) != (b.y <= y) {
            *found.get_mut(count)? = a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
            count += 1;
        }
    }
    (count == 2).then(|| [found[0].min(found[1]), found[0].max(found[1])])
}

/// Ends of a side in an order that does not depend on the triangle.
fn ordered(a: Point3, b: Point3) -> (Point3, Point3) {
    let key = |p: &Point3| (p.x, p.y, p.z);
    if key(&a) < key(&b) { (a, b) } else { (b, a) }
}

/// Height of a triangle's plane over a place that it covers.
fn height([a, b, c]: &[Point3; 3], x: f64, y: f64) -> f64 {
    let normal = (b - a).cross(&(c - a));
    if normal.z == 0.0 {
        return a.z;
    }
    let z = a.z - (normal.x * (x - a.x) + normal.y * (y - a.y)) / normal.z;
    let low = a.z.min(b.z).min(c.z);
    z.clamp(low, a.z.max(b.z).max(c.z))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom, winding_number};

    fn corners(mesh: &TriMesh) -> Vec<[Point3; 3]> {
        (mesh.triangles().iter())
            .map(|t| t.map(|v| mesh.vertices()[v as usize]))
            .collect()
    }

    #[test]
    fn inside_by_lines_is_inside_by_winding() {
        let torus = corners(&phantom::torus(3.0, 1.0, 40, 20));
        // Lines pass through vertices and along sides on purpose.
        let grid = ScanGrid {
            origin: [-4.0, -4.0],
            spacing: [0.25, 0.25],
            lines: [33, 33],
        };
        let lines = scan_lines(&torus, &grid);
        for (line, crossings) in lines.iter().enumerate() {
            assert!(crossings.len().is_multiple_of(2));
            let x = -4.0 + 0.25 * (line % 33) as f64;
            let y = -4.0 + 0.25 * (line / 33) as f64;
            for step in 0..9 {
                let z = -1.03 + 0.26 * f64::from(step);
                let below = crossings.iter().filter(|&&c| c < z).count();
                let winding = winding_number(torus.iter().copied(), Point3::new(x, y, z));
                assert_eq!(below % 2 == 1, winding > 0.5, "{x} {y} {z}");
            }
        }
    }

    #[test]
    fn lines_beside_a_surface_and_upright_faces_are_not_crossed() {
        let upright = [[
            Point3::origin(),
            Point3::new(1.0, 0.0, 0.0),
            Point3::new(0.0, 0.0, 1.0),
        ]];
        let grid = ScanGrid {
            origin: [-1.0, -1.0],
            spacing: [0.5, 0.5],
            lines: [5, 5],
        };
        assert!(scan_lines(&upright, &grid).iter().all(Vec::is_empty));
    }
}
