//! Is a point inside a surface whose openings are closed by fans?

use crate::mesh::{Point3, Vector3};

/// The direction of the ray from each point: along no axis, diagonal or side of anything that is built by hand, so
/// that it meets no vertex or edge.
const RAY: [f64; 3] = [0.537_712_9, 0.276_104_7, 0.796_632_1];

/// Triangles as a ray along [`RAY`] sees them.
pub(super) struct Inside {
    origin: Point3,
    axes: [Vector3; 3],
    /// Triangles by the strips that their shadows reach into: most points ask a few of them.
    strips: Vec<Vec<Shadow>>,
    from: f64,
    strips_per_length: f64,
}

/// Strips across the surface: with some thousands of triangles, a strip has fewer than a hundred.
const STRIPS: usize = 128;

/// A triangle in the axes of the ray: its corners, and the rectangle around its shadow.
#[derive(Clone, Copy)]
struct Shadow {
    corners: [Vector3; 3],
    low: [f64; 2],
    high: [f64; 2],
}

impl Inside {
    /// Of triangles with each boundary loop closed by a fan to its centroid.
    pub fn new(vertices: &[Point3], triangles: &[[u32; 3]], loops: &[Vec<u32>]) -> Self {
        // Near the surface, so that rounding is that of its size and not of its place.
        let origin = vertices.first().copied().unwrap_or_else(Point3::origin);
        let axes = ray_axes();
        let seen = |point: Point3| {
            let offset = point - origin;
            Vector3::new(
                axes[0].dot(&offset),
                axes[1].dot(&offset),
                axes[2].dot(&offset),
            )
        };
        let at = |vertex: u32| seen(vertices[vertex as usize]);
        let mut shadows: Vec<Shadow> = triangles
            .iter()
            .map(|triangle| Shadow::new(triangle.map(at)))
            .collect();
        for ring in loops.iter().filter(|ring| !ring.is_empty()) {
            let centre = ring.iter().map(|&v| at(v)).sum::<Vector3>() / ring.len() as f64;
            let next = ring.iter().cycle().skip(1);
            shadows.extend(
                (ring.iter().zip(next)).map(|(&a, &b)| Shadow::new([at(a), at(b), centre])),
            );
        }
        let from = shadows.iter().map(|s| s.low[0]).fold(f64::MAX, f64::min);
        let to = shadows.iter().map(|s| s.high[0]).fold(f64::MIN, f64::max);
        let mut inside = Self {
            origin,
            axes,
            strips: vec![Vec::new(); STRIPS],
            from,
            strips_per_length: STRIPS as f64 / (to - from),
        };
        for shadow in shadows {
            let reach = inside.strip(shadow.low[0])..=inside.strip(shadow.high[0]);
            for strip in &mut inside.strips[reach] {
                strip.push(shadow);
            }
        }
        inside
    }

    /// The strip of a place; it never falls where the place rises.
    fn strip(&self, u: f64) -> usize {
        // Below zero, and where all is flat, this is the first one.
        (((u - self.from) * self.strips_per_length) as usize).min(STRIPS - 1)
    }

    /// Whether the ray from a point leaves the surface once more than it enters it; whichever way faces wind.
    pub fn holds(&self, point: Point3) -> bool {
        let offset = point - self.origin;
        let [u, v, w] = [0, 1, 2].map(|axis| self.axes[axis].dot(&offset));
        let shadows = self.strips[self.strip(u)].iter();
        let crossings = shadows.filter(|shadow| shadow.is_above(u, v, w));
        crossings.count() % 2 == 1
    }
}

impl Shadow {
    fn new(corners: [Vector3; 3]) -> Self {
        let bound = |axis: usize, better: fn(f64, f64) -> f64| {
            corners[1..]
                .iter()
                .fold(corners[0][axis], |bound, c| better(bound, c[axis]))
        };
        Self {
            corners,
            low: [bound(0, f64::min), bound(1, f64::min)],
            high: [bound(0, f64::max), bound(1, f64::max)],
        }
    }

    fn is_above(&self, u: f64, v: f64, w: f64) -> bool {
        if u < self.low[0] || u > self.high[0] || v < self.low[1] || v > self.high[1] {
            return false;
        }
        let [a, b, c] = self.corners;
        // Twice the areas of the parts that the place makes of the shadow.
        let part = |p: Vector3, q: Vector3| (p.x - u) * (q.y - v) - (q.x - u) * (p.y - v);
        let parts = [part(b, c), part(c, a), part(a, b)];
        let inside = parts.iter().all(|&p| p > 0.0) || parts.iter().all(|&p| p < 0.0);
        let sum: f64 = parts.iter().sum();
        inside && (parts[0] * a.z + parts[1] * b.z + parts[2] * c.z) / sum > w
    }
}

fn ray_axes() -> [Vector3; 3] {
    let along = Vector3::from(RAY).normalize();
    let side = along.cross(&Vector3::x()).normalize();
    [side, along.cross(&side), along]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{phantom, winding_number};

    #[test]
    fn inside_by_a_ray_is_inside_by_winding() {
        let torus = phantom::torus(3.0, 1.0, 24, 12);
        let inside = Inside::new(torus.vertices(), torus.triangles(), &[]);
        let corners: Vec<[Point3; 3]> = (torus.triangles().iter())
            .map(|t| t.map(|v| torus.vertices()[v as usize]))
            .collect();
        let mut counts = [0; 2];
        for step in 0..729 {
            let at = |count: i32| -4.2 + 8.4 * f64::from(count % 9) / 8.0;
            let point = Point3::new(at(step), at(step / 9), at(step / 81) / 4.0);
            let winding = winding_number(corners.iter().copied(), point);
            assert_eq!(inside.holds(point), winding > 0.5, "{point}");
            counts[usize::from(winding > 0.5)] += 1;
        }
        assert!(counts.iter().all(|&count| count > 50), "{counts:?}");
    }

    #[test]
    fn an_open_bowl_holds_what_lies_under_its_lid_wherever_it_stands() {
        for shift in [0.0, 1e8] {
            let moved = |p: &Point3| p + Vector3::new(shift, -shift, shift);
            let bowl = phantom::bowl(1.0, 6, 12);
            let points: Vec<Point3> = bowl.vertices().iter().map(moved).collect();
            let loops = bowl.faces().boundary_loops();
            let inside = Inside::new(&points, bowl.triangles(), &loops);
            let centre = bowl.vertices().iter().map(|p| p.coords).sum::<Vector3>()
                / bowl.vertices().len() as f64;
            assert!(inside.holds(moved(&Point3::from(centre))));
            assert!(!inside.holds(moved(&Point3::from(-centre))));
        }
    }
}
