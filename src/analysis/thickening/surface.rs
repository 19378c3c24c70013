//! The medial surface as far as it takes part: its mean shape, areas, neighbours and phases.

use rayon::prelude::*;

use crate::analysis::measures::SubjectMeasures;
use crate::analysis::medial::MedialBeat;
use crate::mesh::{Point3, Vector3, bounding_box};

use super::diffusion::{Diffusion, RegularMesh};
use super::error::ThickeningError;
use super::neighbours::Neighbours;

/// The medial surface as far as it takes part.
pub(super) struct Surface {
    /// Mean position of each atom over the beat, whose edges have less noise than those of a pose.
    pub middle: Vec<Point3>,
    /// With areas there.
    pub mesh: RegularMesh,
    /// With areas at end-diastole.
    pub at_end_diastole: RegularMesh,
    pub neighbours: Neighbours,
    /// Atoms near the edge at which the wall was cut open, where no patch begins.
    pub at_edge: Vec<bool>,
    /// Poses of end-diastole and end-systole.
    pub phases: [usize; 2],
    /// Largest side of the box at end-diastole.
    pub size: f64,
}

impl Surface {
    pub fn new(beat: &MedialBeat, measures: &SubjectMeasures) -> Result<Self, ThickeningError> {
        // The mean over the cycle: its noise is smaller by the root of the number of poses.
        let middle = mean_shape(beat);
        let mesh = RegularMesh::new(beat.faces.triangles(), &middle, &beat.regular);
        let phases = phases(beat, measures);
        let rest = beat.frames[phases[0]].positions();
        let at_end_diastole = RegularMesh::new(beat.faces.triangles(), &rest, &beat.regular);
        if !(mesh.whole > 0.0 && at_end_diastole.whole > 0.0) {
            return Err(ThickeningError::NoArea);
        }
        Ok(Self {
            neighbours: Neighbours::new(middle.len(), &mesh.triangles),
            at_edge: at_edge(beat, &middle),
            size: bounding_box(&rest).map_or(0.0, |[low, high]| (high - low).max()),
            middle,
            mesh,
            at_end_diastole,
            phases,
        })
    }
}

/// Areas that fall by more than this share when positions are smoothed are those of noise: smoothing takes some hundredths
/// off a clean cup.
const ROUGH: f64 = 0.05;

impl Surface {
    /// Areas at end-diastole without what noise adds: it makes faces larger, most where atoms stand close, and so draws
    /// centroids there. Where positions are rough, areas are those of positions smoothed as thickening is, 2 D − D², which keeps curvature.
    pub fn steady(&mut self, beat: &MedialBeat, diffusion: &Diffusion) {
        let raw = beat.frames[self.phases[0]].positions();
        let columns = |points: &[Vector3]| -> Vec<f64> {
            (0..3)
                .flat_map(|axis| points.iter().map(move |point| point[axis]))
                .collect()
        };
        let points = |columns: &[f64]| -> Vec<Vector3> {
            (0..raw.len())
                .map(|i| Vector3::from_fn(|axis, _| columns[axis * raw.len() + i]))
                .collect()
        };
        let smoothed = |field: &[Vector3]| {
            let mut columns = columns(field);
            diffusion.apply(&mut columns);
            points(&columns)
        };
        let rest: Vec<Vector3> = raw.iter().map(|point| point.coords).collect();
        let once = smoothed(&rest);
        let lost: Vec<Vector3> = rest.iter().zip(&once).map(|(x, s)| x - s).collect();
        // 2 D − D² instead of D: averaging alone shrinks a cup, and with it every area.
        let twice: Vec<Point3> = (once.iter().zip(smoothed(&lost)))
            .map(|(s, back)| Point3::from(s + back))
            .collect();
        let steady = RegularMesh::new(beat.faces.triangles(), &twice, &beat.regular);
        // Only where noise was large enough to matter: clean surfaces keep their measured areas.
        if steady.whole < (1.0 - ROUGH) * self.at_end_diastole.whole && steady.whole > 0.0 {
            self.at_end_diastole = steady;
        }
    }
}

/// Width of the edge as a share of the way from it to the apex: 18 mm of 90, as far as the base of a normal ventricle descends
/// in systole (12 to 15 mm) and averaging reaches. So near to a cut, one place of the surface is different tissue at
/// end-diastole and at end-systole, partly that of the outflow tract, and a ratio of its thicknesses is not thickening. A share of
/// the heart and no length or number of wall thicknesses, so that it leaves as much of a small or thick-walled heart.
///
/// Subjects with a patch of which most lies farther from the edge, of all patches that `analyze` finds without one:
///
/// | width | `mesa`, 25 volunteers | `acdc_walls`: NOR, 20 | MINF, 20 | DCM, 20 | HCM, 20 |
/// |---|---|---|---|---|---|
/// | 0 | 19 | 2 | 20 | 17 | 7 |
/// | 1/8 | 15 | 2 | 20 | 17 | 7 |
/// | 1/6 | 6 | 0 | 20 | 16 | 6 |
/// | 1/5 | 4 | 0 | 20 | 16 | 6 |
/// | 1/4 | 4 | 0 | 20 | 15 | 3 |
/// | 1/3 | 4 | 0 | 18 | 13 | 2 |
///
/// The last four of `mesa` have an ejection fraction of 26 to 41 %, and patches that do not reach the edge.
const EDGE: f64 = 0.2;

/// Which atoms lie nearer to the open edge of the medial surface than [`EDGE`] of the distance of the atom that is farthest from it.
fn at_edge(beat: &MedialBeat, middle: &[Point3]) -> Vec<bool> {
    let rim: Vec<Point3> = (beat.faces.boundary_vertices().iter().zip(middle))
        .filter_map(|(rim, point)| rim.then_some(*point))
        .collect();
    let distances: Vec<f64> = (middle.par_iter())
        .map(|point| {
            let squares = rim.iter().map(|edge| (point - edge).norm_squared());
            squares.fold(f64::INFINITY, f64::min).sqrt()
        })
        .collect();
    // Without an edge all distances are infinite, and none is less than that.
    let width = EDGE * distances.iter().copied().fold(0.0, f64::max);
    distances.iter().map(|distance| *distance < width).collect()
}

/// Mean position of each atom over the beat, whose edges have less noise than those of a pose.
fn mean_shape(beat: &MedialBeat) -> Vec<Point3> {
    let mut sums = vec![Vector3::zeros(); beat.faces.vertex_count()];
    for frame in &beat.frames {
        sums.iter_mut()
            .zip(&frame.atoms)
            .for_each(|(sum, atom)| *sum += atom.position.coords);
    }
    let poses = beat.frames.len() as f64;
    sums.into_iter()
        .map(|sum| Point3::from(sum / poses))
        .collect()
}

/// Poses of end-diastole and end-systole: by volume or as stated; where that is not known, the greatest and
/// least area of the medial surface.
pub fn phases(beat: &MedialBeat, measures: &SubjectMeasures) -> [usize; 2] {
    let count = beat.frames.len();
    let within = |pose: Option<usize>| pose.filter(|&pose| pose < count);
    match [within(measures.end_diastole), within(measures.end_systole)] {
        [Some(ed), Some(es)] if ed != es => [ed, es],
        _ => {
            // Without volumes: the medial surface is largest where the cavity is.
            let area = |pose: usize| {
                RegularMesh::new(
                    beat.faces.triangles(),
                    &beat.frames[pose].positions(),
                    &beat.regular,
                )
                .whole
            };
            let areas: Vec<f64> = (0..count).map(area).collect();
            let extreme = |sign: f64| {
                let better =
                    |a: &usize, b: &usize| (sign * areas[*a]).total_cmp(&(sign * areas[*b]));
                // From the last, so that of equal areas the first pose is taken.
                (0..count).rev().max_by(better).unwrap_or(0)
            };
            match [extreme(1.0), extreme(-1.0)] {
                [ed, es] if ed != es => [ed, es],
                // A surface whose area never changes has neither: the first two poses stand in.
                _ => [0, 1],
            }
        }
    }
}
