//! A surface mapped onto the bull's-eye: vertices in the unit disc, and which faces can be drawn.

use crate::mesh::Point3;

use super::{CAP_SHARE, Level, Polar, Segment};

/// Outer radii of the four rings of the bull's-eye, from the apex out.
pub const RING_RADII: [f64; 4] = [0.25, 0.5, 0.75, 1.0];

/// Heights over the end of the cavity, as shares of its length, at which levels meet.
const LEVEL_HEIGHTS: [f64; 5] = [0.0, CAP_SHARE, 1.0 / 3.0, 2.0 / 3.0, 1.0];

/// Share of the square of the mean edge below which a flat face counts as having no area: rounding.
const FLAT: f64 = 1e-9;

/// Radius on the plot of a height ([`Polar::radius`]): linear between the rings, so that the border
/// of a level is the border of a ring. Without that the apex, where a height is a wide circle, would be
/// drawn as a dot. Above the base it stays at the rim.
pub fn plot_radius(height: f64) -> f64 {
    let mut inner = 0.0;
    for (ring, outer) in RING_RADII.into_iter().enumerate() {
        let [low, high] = [LEVEL_HEIGHTS[ring], LEVEL_HEIGHTS[ring + 1]];
        if height < high {
            // A negative height lies beyond the end of the cavity and is drawn in the middle.
            return inner + (outer - inner) * ((height - low) / (high - low)).max(0.0);
        }
        inner = outer;
    }
    inner
}

/// The height drawn at a radius: what [`plot_radius`] undoes, for radii of 0 to 1.
pub fn height_at(radius: f64) -> f64 {
    let mut inner = 0.0;
    for (ring, outer) in RING_RADII.into_iter().enumerate() {
        let [low, high] = [LEVEL_HEIGHTS[ring], LEVEL_HEIGHTS[ring + 1]];
        if radius < outer {
            return low + (high - low) * ((radius - inner) / (outer - inner)).max(0.0);
        }
        inner = outer;
    }
    1.0
}

/// Inner and outer radius of a level's ring.
pub fn ring(level: Level) -> [f64; 2] {
    let outer = RING_RADII.len() - 1 - level.index();
    let inner = outer.checked_sub(1).map_or(0.0, |ring| RING_RADII[ring]);
    [inner, RING_RADII[outer]]
}

/// Point of the plot, x to the right and y up, in the unit disc.
pub fn plot_point(polar: Polar) -> [f64; 2] {
    let (sin, cos) = polar.angle_rad.sin_cos();
    let radius = plot_radius(polar.radius);
    [radius * cos, radius * sin]
}

/// The segment drawn at a point of the plot; `None` outside the unit disc. Where septum and anterior wall
/// are not known only its level means something.
pub fn segment_on_plot([x, y]: [f64; 2]) -> Option<Segment> {
    let radius = x.hypot(y);
    let level = (Level::ALL.into_iter()).find(|&level| {
        let [inner, outer] = ring(level);
        (inner..outer).contains(&radius)
    })?;
    // Any depth inside each level will do; the ring has decided the level.
    let depths = [0.0, 0.5, 0.8, 1.0];
    Some(Segment::at(depths[level.index()], y.atan2(x)))
}

/// A surface on the bull's-eye.
#[derive(Clone, Debug, PartialEq)]
pub struct FlatMap {
    /// Per vertex, x to the right (lateral) and y up (anterior), in the unit disc.
    pub points: Vec<[f64; 2]>,
    /// Faces to draw.
    pub faces: Vec<[u32; 3]>,
    /// Indices of the faces left out, ascending: those that are folded over others or wrap around the
    /// middle the wrong way, and those of zero area on the map, as above the base.
    pub dropped: Vec<u32>,
}

/// Lays triangles on the bull's-eye by the places of their vertices.
///
/// A map of a wound surface turns all its faces the same way round. The way is that of the greater area
/// in space of `vertices`; faces that turn the other way would lie on others and are dropped.
pub fn flat_map(polar: &[Polar], vertices: &[Point3], triangles: &[[u32; 3]]) -> FlatMap {
    let points: Vec<[f64; 2]> = polar.iter().map(|&place| plot_point(place)).collect();
    let flat: Vec<f64> = triangles
        .iter()
        .map(|triangle| flat_share(triangle.map(|v| points[v as usize])))
        .collect();
    // Weighted by area in space: many small folded faces do not outvote the wall.
    let way: f64 = (flat.iter().zip(triangles))
        .map(|(&share, triangle)| {
            let [a, b, c] = triangle.map(|v| vertices[v as usize]);
            share.signum() * (b - a).cross(&(c - a)).norm() * f64::from(share.abs() > FLAT)
        })
        .sum();
    let mut map = FlatMap {
        points,
        faces: Vec::new(),
        dropped: Vec::new(),
    };
    for (face, (&share, &triangle)) in flat.iter().zip(triangles).enumerate() {
        // Above the base all vertices lie on the rim, where faces have no area.
        if share * way.signum() > FLAT {
            map.faces.push(triangle);
        } else {
            map.dropped.push(face as u32);
        }
    }
    map
}

/// Twice the signed area of a flat triangle over the sum of its squared sides; 0 for a point.
fn flat_share([a, b, c]: [[f64; 2]; 3]) -> f64 {
    let [ab, bc, ca] = [(a, b), (b, c), (c, a)].map(|(p, q)| [q[0] - p[0], q[1] - p[1]]);
    let squares: f64 = [ab, bc, ca].iter().flatten().map(|x| x * x).sum();
    if squares == 0.0 {
        return 0.0;
    }
    (ab[1] * ca[0] - ab[0] * ca[1]) / squares
}
