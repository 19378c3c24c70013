//! Do the poses between two poses look like the motion between them (section 3.4.1)?

use crate::analysis::alignment::rigid_motion;
use crate::analysis::geodesics::{GeodesicParams, geodesic};
use crate::mesh::{Point3, TriMesh, signed_volume};
use crate::progress::Progress;

use super::error::step;
use super::{ExperimentError, Fineness, Motion, ObjectKind, object};

/// What is interpolated, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct InterpolationExperimentParams {
    /// Kinds of objects; all motions are applied to each.
    pub objects: Vec<ObjectKind>,
    /// How fine their meshes are.
    pub fineness: Fineness,
    /// The path.
    pub geodesic: GeodesicParams,
}

impl Default for InterpolationExperimentParams {
    /// Sphere and torus, three poses between (fig. 3.7).
    fn default() -> Self {
        Self {
            objects: vec![ObjectKind::ALL[0], ObjectKind::ALL[3]],
            fineness: Fineness::default(),
            geodesic: GeodesicParams::default(),
        }
    }
}

/// One path.
#[derive(Clone, Debug, PartialEq)]
pub struct InterpolationCase {
    /// What moves.
    pub object: ObjectKind,
    /// How the object is deformed.
    pub motion: Motion,
    /// Energy of the path over that of the straight line.
    pub energy_ratio: f64,
    /// Longest over shortest step.
    pub step_ratio: f64,
    /// Least and greatest volume of an interpolated pose (boundaries are none) over that at rest.
    pub volume_ratios: [f64; 2],
    /// Distance of the middle pose from the motion at half its amplitude, after rigid alignment, over
    /// the whole displacement.
    pub midpoint_error: f64,
    /// Pairs of faces that cross.
    pub self_intersections: usize,
    /// Start, interpolated poses, end, for a picture.
    pub poses: Vec<Vec<Point3>>,
}

/// All paths.
#[derive(Clone, Debug, PartialEq)]
pub struct InterpolationExperiment {
    /// The settings with which it was run.
    pub params: InterpolationExperimentParams,
    /// By object, then motion.
    pub cases: Vec<InterpolationCase>,
}

/// Finds the path from every object at rest to each of its deformations.
///
/// # Errors
/// If settings are out of range, it was stopped, or there is no path.
pub fn interpolation_experiment(
    params: &InterpolationExperimentParams,
    progress: &Progress,
) -> Result<InterpolationExperiment, ExperimentError> {
    let mut cases = Vec::new();
    progress.expect_steps(params.objects.len() * Motion::ALL.len());
    for &kind in &params.objects {
        let mesh = object(kind, params.fineness);
        for motion in Motion::ALL {
            progress.step()?;
            cases.push(interpolated(params, kind, &mesh, motion, progress)?);
            // A stopped search returns the best path so far.
            progress.check()?;
        }
    }
    Ok(InterpolationExperiment {
        params: params.clone(),
        cases,
    })
}

fn interpolated(
    params: &InterpolationExperimentParams,
    kind: ObjectKind,
    mesh: &TriMesh,
    motion: Motion,
    progress: &Progress,
) -> Result<InterpolationCase, ExperimentError> {
    let amplitude = motion.typical_amplitude(kind.solid);
    let at = |share: f64| -> Vec<Point3> {
        let moved = |p: &Point3| motion.moved(kind.solid, p, share * amplitude);
        mesh.vertices().iter().map(moved).collect()
    };
    let (start, middle, end) = (at(0.0), at(0.5), at(1.0));
    let checked = (params.geodesic.check()).map_err(|e| step("searching for a path", &e))?;
    let path = geodesic(mesh.faces(), &start, &end, &checked, &progress.within())
        .map_err(|e| step("searching for a path", &e))?;
    let volume = |points: &[Point3]| {
        let corners = mesh.triangles().iter();
        signed_volume(
            corners.map(|face| face.map(|v| points[v as usize])),
            Point3::origin(),
        )
    };
    let at_end_diastole = volume(&start);
    // Relative to the start, so that a shrinking straight line shows below 1.
    let volumes = path.poses.iter().map(|pose| volume(pose) / at_end_diastole);
    let (least, greatest) = volumes.fold((f64::MAX, f64::MIN), |(low, high), v| {
        (low.min(v), high.max(v))
    });
    let steps = path.step_lengths.iter().copied();
    let (shortest, longest) = steps.fold((f64::MAX, f64::MIN), |(low, high), s| {
        (low.min(s), high.max(s))
    });
    let found = &path.poses[path.poses.len() / 2];
    // The path is free to turn: rigid motion costs nothing in the metric.
    let onto = rigid_motion(found, &middle).map_err(|e| step("aligning objects", &e))?;
    let square = |a: &[Point3], b: &[Point3]| -> f64 {
        a.iter().zip(b).map(|(p, q)| (p - q).norm_squared()).sum()
    };
    let laid: Vec<Point3> = found.iter().map(|p| onto.apply(p)).collect();
    Ok(InterpolationCase {
        object: kind,
        motion,
        energy_ratio: path.energy / path.energy_linear,
        step_ratio: longest / shortest,
        volume_ratios: [least, greatest],
        // Relative to the whole motion, so that objects and motions can be compared.
        midpoint_error: (square(&laid, &middle) / square(&start, &end)).sqrt(),
        self_intersections: path.self_intersections,
        poses: path.poses,
    })
}
