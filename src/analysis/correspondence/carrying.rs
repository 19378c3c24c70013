//! A surface brought onto another one: by a spline through landmarks, then by smooth moves to the nearest places.

use std::sync::Arc;

use rayon::prelude::*;

use crate::analysis::registration::ThinPlateSpline;
use crate::mesh::{
    CappedSheet, Faces, Point3, Sheet, Vector3, mean_point, vertex_areas, vertex_normals,
};
use crate::progress::Progress;

use super::target_surface::TargetSurface;
use super::turned_faces::turned_faces;
use super::{SurfaceLandmarks, TargetError};

/// How stiff each round is: α of the moves u that minimise Σᵢ |uᵢ − dᵢ|² + α Σ |uᵢ − uⱼ|² over neighbours, dᵢ the way to the
/// nearest place. From the whole, some four edges, to the single vertex, so that neighbours stay neighbours.
const STIFFNESS: [f64; 12] = [16.0, 16.0, 8.0, 8.0, 4.0, 4.0, 2.0, 2.0, 1.0, 0.5, 0.2, 0.1];
/// Jacobi sweeps of one round; moves settle over √α edges.
const SWEEPS: usize = 24;
/// Rounds in which vertices of faces that are folded over are moved to the middle of their neighbours.
const UNFOLDING: usize = 12;
/// Difference of volumes, as a share, up to which the rest is made up for by a move along the normals: what chords cut off.
const MAX_VOLUME_GAP: f64 = 0.03;

/// The template's connectivity, prepared.
#[derive(Clone, Debug)]
pub(super) struct Carrier {
    faces: Arc<Faces>,
    neighbours: Vec<Vec<u32>>,
    on_rim: Vec<bool>,
    capped: CappedSheet,
    /// 1 where normals of the faces point out of the ventricle, −1 where into it.
    outward: f64,
}

impl Carrier {
    pub fn new(vertices: &[Point3], faces: &Arc<Faces>) -> Result<Self, TargetError> {
        let mut neighbours = vec![Vec::new(); faces.vertex_count()];
        for [a, b] in faces.edges() {
            neighbours[a as usize].push(b);
            neighbours[b as usize].push(a);
        }
        let triangles = faces.triangles().to_vec();
        let sheet = Sheet {
            faces: (0..triangles.len()).collect(),
            triangles,
            turned: 0,
        };
        let capped = CappedSheet::new(faces.vertex_count(), &sheet)?;
        let outward = capped.signed_volume(vertices).signum();
        Ok(Self {
            on_rim: faces.boundary_vertices(),
            faces: Arc::clone(faces),
            neighbours,
            capped,
            outward,
        })
    }

    /// Volume within the surface and a lid.
    pub fn volume(&self, points: &[Point3]) -> f64 {
        self.outward * self.capped.signed_volume(points)
    }

    /// 1 where normals of the faces point out of the ventricle, −1 where into it.
    pub fn outward(&self) -> f64 {
        self.outward
    }

    pub fn triangles(&self) -> &[[u32; 3]] {
        self.faces.triangles()
    }

    /// Unit normals out of the ventricle at the vertices.
    pub fn normals(&self, points: &[Point3]) -> Vec<Vector3> {
        let normals = vertex_normals(points, self.triangles()).into_iter();
        normals.map(|normal| self.outward * normal).collect()
    }

    /// The points brought onto a target: `smoothing` is that of the spline, as a share of the target's size.
    pub fn carry(
        &self,
        points: &[Point3],
        [from, onto]: [&SurfaceLandmarks; 2],
        target: &TargetSurface,
        smoothing: f64,
        progress: &Progress,
    ) -> Result<Vec<Point3>, TargetError> {
        let lambda = smoothing * size(target.vertices());
        let spline = ThinPlateSpline::new(&from.points, &onto.points, lambda);
        let spline = spline.map_err(|error| TargetError::Landmarks(error.to_string()))?;
        let mut points = spline.apply_all(points);
        let rim = target.rim();
        for stiffness in STIFFNESS {
            progress.check()?;
            let ways = self.ways(&points, target, &rim);
            for (point, way) in points.iter_mut().zip(self.smoothed(&ways, stiffness)) {
                *point += way;
            }
        }
        self.project(&mut points, target, &rim);
        for _ in 0..UNFOLDING {
            progress.check()?;
            if !self.untangle(&mut points, target) {
                break;
            }
            self.project(&mut points, target, &rim);
        }
        self.restore_volume(&mut points, target);
        Ok(points)
    }

    /// The way of each vertex to the nearest place of the target, of the rim to the rim; none where that looks another way
    /// or is an end that the vertex lies beyond.
    fn ways(
        &self,
        points: &[Point3],
        target: &TargetSurface,
        rim: &[Point3],
    ) -> Vec<Option<Vector3>> {
        let normals = self.normals(points);
        let way = |(v, point): (usize, &Point3)| {
            if self.on_rim[v] {
                return nearest_on_loop(rim, point).map(|place| place - point);
            }
            let nearest = target.nearest(*point);
            let normal = target.normal(nearest.face);
            let looks_away = normal.is_some_and(|normal| normal.dot(&normals[v]) < 0.0);
            let beyond = nearest.distance > 0.0 && target.is_on_boundary(&nearest);
            (!looks_away && !beyond).then(|| nearest.point - point)
        };
        points.par_iter().enumerate().map(way).collect()
    }

    /// Moves that are near the ways and smooth over the surface, by Jacobi's method.
    fn smoothed(&self, ways: &[Option<Vector3>], stiffness: f64) -> Vec<Vector3> {
        let mut moves: Vec<Vector3> = ways.iter().map(|way| way.unwrap_or_default()).collect();
        for _ in 0..SWEEPS {
            let relaxed = |v: usize| {
                let around = &self.neighbours[v];
                let sum: Vector3 = around.iter().map(|&n| moves[n as usize]).sum();
                let (own, weight) = ways[v].map_or((Vector3::zeros(), 0.0), |way| (way, 1.0));
                let whole = weight + stiffness * around.len() as f64;
                (whole > 0.0).then(|| (own + stiffness * sum) / whole)
            };
            moves = (0..moves.len())
                .map(|v| relaxed(v).unwrap_or_default())
                .collect();
        }
        moves
    }

    /// Every vertex goes to its place on the target.
    fn project(&self, points: &mut [Point3], target: &TargetSurface, rim: &[Point3]) {
        let ways = self.ways(points, target, rim);
        for (point, way) in points.iter_mut().zip(ways) {
            *point += way.unwrap_or_default();
        }
    }

    /// Moves vertices of faces that are folded over to the middle of their neighbours; false if there are none.
    fn untangle(&self, points: &mut [Point3], target: &TargetSurface) -> bool {
        let turned = turned_faces(points, self.triangles(), target, self.outward);
        let mut touched = vec![false; points.len()];
        for face in &turned {
            for &v in &self.triangles()[*face] {
                touched[v as usize] = true;
                for &n in &self.neighbours[v as usize] {
                    touched[n as usize] = true;
                }
            }
        }
        let before = points.to_vec();
        for v in (0..points.len()).filter(|&v| touched[v]) {
            let pulls = |n: &&u32| !self.on_rim[v] || self.on_rim[**n as usize];
            let around = self.neighbours[v].iter().filter(pulls);
            let (mut sum, mut count) = (Vector3::zeros(), 0.0);
            for &n in around {
                sum += before[n as usize].coords;
                count += 1.0;
            }
            if count > 0.0 {
                points[v] = Point3::from(sum / count);
            }
        }
        !turned.is_empty()
    }

    /// Makes up for what chords cut off from the volume, by a move along the normals that is equally far everywhere but on
    /// the rim.
    fn restore_volume(&self, points: &mut [Point3], target: &TargetSurface) {
        let Some(wanted) = target.volume() else {
            return;
        };
        for _ in 0..3 {
            let gap = wanted - self.volume(points);
            if gap.abs() > MAX_VOLUME_GAP * wanted {
                return;
            }
            let areas = vertex_areas(points, self.triangles());
            let normals = self.normals(points);
            let inside = |v: &usize| !self.on_rim[*v];
            let area: f64 = (0..points.len()).filter(inside).map(|v| areas[v]).sum();
            if area <= 0.0 {
                return;
            }
            for v in (0..points.len()).filter(inside) {
                points[v] += normals[v] * (gap / area);
            }
        }
    }
}

/// Twice the greatest distance of points from their mean, which does not change when they are turned.
pub(super) fn size(points: &[Point3]) -> f64 {
    let centre = mean_point(points.iter().copied());
    2.0 * points
        .iter()
        .fold(0.0_f64, |most, p| most.max((p - centre).norm()))
}

/// The nearest place of a closed chain.
fn nearest_on_loop(rim: &[Point3], point: &Point3) -> Option<Point3> {
    let on_side = |index: usize| {
        let [from, to] = [rim[index], rim[(index + 1) % rim.len()]];
        let along = to - from;
        let share = along.dot(&(point - from)) / along.norm_squared().max(f64::MIN_POSITIVE);
        from + along * share.clamp(0.0, 1.0)
    };
    let away = |place: &Point3| (place - point).norm_squared();
    let places = (0..rim.len()).map(on_side);
    places.min_by(|a, b| away(a).total_cmp(&away(b)))
}
