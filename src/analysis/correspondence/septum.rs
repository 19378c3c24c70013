//! How a template is turned around the long axis where nobody said where the septum is.

use std::f64::consts::TAU;

use crate::mesh::Point3;

use super::axis::VentricleAxis;
use super::surface_frames::TargetFrames;
use super::target_surface::TargetSurface;
use super::template::Template;

/// Angles that are tried, all around.
const ANGLES: usize = 36;
/// Halvings between the best angle and its neighbours: to a hundredth of a degree.
const ROUNDS: usize = 20;
/// Vertices of each surface that are looked at.
const SAMPLES: usize = 256;

/// The angle from the septum of an axis to where the template's septum fits best at the first frame: the sum of squared
/// distances of its vertices, stretched along and across the axis to the size of the subject, is least.
pub(super) fn best_turn(
    template: &Template,
    surfaces: &[TargetFrames],
    axis: &VentricleAxis,
) -> f64 {
    let samples = samples(template, surfaces, axis);
    let misfit = |angle: f64| {
        let turned = axis.turned(angle);
        let square = |(place, sheet): &(Place, &TargetSurface)| {
            sheet.nearest(place.at(&turned)).distance.powi(2)
        };
        samples.iter().map(square).sum::<f64>()
    };
    let step = TAU / ANGLES as f64;
    let tried = (0..ANGLES).map(|at| (misfit(step * at as f64), step * at as f64));
    let Some((_, best)) = tried.min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return 0.0;
    };
    // Golden section: Kiefer (1953), Proc. AMS 4(3), 502–506.
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    let [mut low, mut high] = [best - step, best + step];
    for _ in 0..ROUNDS {
        let [left, right] = [high - golden * (high - low), low + golden * (high - low)];
        if misfit(left) < misfit(right) {
            high = right;
        } else {
            low = left;
        }
    }
    0.5 * (low + high)
}

/// Coordinates of a vertex of the template along its axis, in lengths of the subject.
struct Place {
    depth: f64,
    septal: f64,
    anterior: f64,
}

impl Place {
    fn at(&self, axis: &VentricleAxis) -> Point3 {
        axis.base
            + axis.down * self.depth
            + axis.septal * self.septal
            + axis.anterior * self.anterior
    }
}

/// Length of the axis and mean radius of the rim.
fn size<'a>(
    points: impl Iterator<Item = &'a Point3>,
    rim: &[Point3],
    axis: &VentricleAxis,
) -> [f64; 2] {
    let deepest = points.map(|p| axis.depth(p)).fold(0.0, f64::max);
    let across = |p: &Point3| ((p - axis.base) - axis.down * axis.depth(p)).norm();
    let radius = rim.iter().map(across).sum::<f64>() / rim.len().max(1) as f64;
    [deepest, radius]
}

fn samples<'a>(
    template: &Template,
    surfaces: &'a [TargetFrames],
    axis: &VentricleAxis,
) -> Vec<(Place, &'a TargetSurface)> {
    let mut samples = Vec::new();
    for surface in surfaces {
        let (Some(sheet), Some(own)) = (surface.frames.first(), template.surface(surface.kind))
        else {
            continue;
        };
        let points = own.mesh.vertices();
        let rim: Vec<Point3> = (points.iter().zip(own.mesh.faces().boundary_vertices()))
            .filter_map(|(p, on_rim)| on_rim.then_some(*p))
            .collect();
        let from = size(points.iter(), &rim, &template.axis);
        let onto = size(sheet.vertices().iter(), &sheet.rim(), axis);
        let [along, across] = [0, 1].map(|k| onto[k] / from[k].max(f64::MIN_POSITIVE));
        let stride = points.len().div_ceil(SAMPLES).max(1);
        samples.extend(points.iter().step_by(stride).map(|point| {
            let away = point - template.axis.base;
            let place = Place {
                depth: along * template.axis.down.dot(&away),
                septal: across * template.axis.septal.dot(&away),
                anterior: across * template.axis.anterior.dot(&away),
            };
            (place, sheet)
        }));
    }
    samples
}
