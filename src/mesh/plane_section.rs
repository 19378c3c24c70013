//! Where a plane cuts a surface: chains of points.

use std::collections::BTreeMap;

use super::{Edge, Point3, Vector3};

/// A chain of points in which a plane cuts a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// In order along the chain; the first does not stand again at the end.
    pub points: Vec<Point3>,
    /// Whether it runs back to its first point; an open one ends at the surface's border.
    pub closed: bool,
}

/// Cuts triangles by the plane through `origin` across `normal`.
///
/// A vertex in the plane counts as above it, so that each triangle is cut by two sides or none, and
/// chains are connected whatever passes through a vertex. Where a surface branches, chains end.
pub fn plane_section(
    vertices: &[Point3],
    triangles: &[[u32; 3]],
    origin: Point3,
    normal: Vector3,
) -> Vec<Contour> {
    let heights: Vec<f64> = vertices
        .iter()
        .map(|point| normal.dot(&(point - origin)))
        .collect();
    let above = |v: u32| heights[v as usize] >= 0.0;
    let mut links: BTreeMap<Edge, Vec<Edge>> = BTreeMap::new();
    for &[a, b, c] in triangles {
        let mut cut = [[a, b], [b, c], [c, a]]
            .into_iter()
            .filter(|&[p, q]| above(p) != above(q))
            .map(|[p, q]| [p.min(q), p.max(q)]);
        if let (Some(one), Some(other)) = (cut.next(), cut.next()) {
            links.entry(one).or_default().push(other);
            links.entry(other).or_default().push(one);
        }
    }
    let point = |[a, b]: Edge| {
        let [ha, hb] = [heights[a as usize], heights[b as usize]];
        let [a, b] = [vertices[a as usize], vertices[b as usize]];
        a + (b - a) * (ha / (ha - hb))
    };
    let mut contours = Vec::new();
    // Open chains first, from an end; what is left then is closed.
    let ends: Vec<Edge> = (links.iter())
        .filter(|(_, next)| next.len() != 2)
        .map(|(&edge, _)| edge)
        .collect();
    for end in ends {
        while let Some(edges) = follow(&mut links, end) {
            contours.push(Contour {
                points: edges.into_iter().map(point).collect(),
                closed: false,
            });
        }
    }
    let starts: Vec<Edge> = links.keys().copied().collect();
    for start in starts {
        if let Some(mut edges) = follow(&mut links, start) {
            let closed = edges.len() > 2 && edges.first() == edges.last();
            edges.truncate(edges.len() - usize::from(closed));
            contours.push(Contour {
                points: edges.into_iter().map(point).collect(),
                closed,
            });
        }
    }
    contours
}

/// Follows links from an edge, using them up, until there is none or more than one way on.
fn follow(links: &mut BTreeMap<Edge, Vec<Edge>>, start: Edge) -> Option<Vec<Edge>> {
    let mut chain = vec![start];
    let mut here = start;
    while let Some(next) = links.get_mut(&here).and_then(Vec::pop) {
        if let Some(back) = links.get_mut(&next)
            && let Some(place) = back.iter().position(|&edge| edge == here)
        {
            back.swap_remove(place);
        }
        chain.push(next);
        here = next;
        if here == start || links.get(&here).is_none_or(|ways| ways.len() != 1) {
            break;
        }
    }
    (chain.len() > 1).then_some(chain)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    #[test]
    fn a_torus_is_cut_into_two_circles_across_and_two_along() {
        let torus = phantom::torus(3.0, 1.0, 60, 30);
        let cut = |origin: Point3, normal: Vector3| {
            plane_section(torus.vertices(), torus.triangles(), origin, normal)
        };
        let across = cut(Point3::origin(), Vector3::x());
        assert_eq!(across.len(), 2);
        let along = cut(Point3::new(0.0, 0.0, 0.01), Vector3::z());
        assert_eq!(along.len(), 2);
        for contour in across.iter().chain(&along) {
            assert!(contour.closed);
        }
        for point in across.iter().flat_map(|contour| &contour.points) {
            assert!(point.x.abs() < 1e-12);
            let tube = (point.y.hypot(0.0).abs() - 3.0).hypot(point.z);
            assert!((tube - 1.0).abs() < 0.01, "{tube}");
        }
        assert!(cut(Point3::new(0.0, 0.0, 5.0), Vector3::z()).is_empty());
    }

    #[test]
    fn a_plane_through_vertices_and_an_open_rim_gives_one_open_chain() {
        let bowl = phantom::bowl(1.0, 8, 16);
        // Through the pole and two vertices of every ring.
        let cut = plane_section(
            bowl.vertices(),
            bowl.triangles(),
            Point3::origin(),
            Vector3::y(),
        );
        assert_eq!(cut.len(), 1);
        assert!(!cut[0].closed);
        let ends = [cut[0].points[0], cut[0].points[cut[0].points.len() - 1]];
        assert!(ends.iter().all(|p| p.z.abs() < 0.15), "{ends:?}");
    }

    #[test]
    fn a_single_triangle_is_cut_in_one_piece() {
        let points = [
            Point3::origin(),
            Point3::new(1.0, 0.0, 0.0),
            Point3::new(0.0, 0.0, 1.0),
        ];
        let cut = plane_section(
            &points,
            &[[0, 1, 2]],
            Point3::new(0.0, 0.0, 0.5),
            Vector3::z(),
        );
        assert_eq!(cut.len(), 1);
        assert_eq!(cut[0].points.len(), 2);
    }
}
