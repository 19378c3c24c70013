//! Are deformations followed by other objects (section 3.4.2)?

use rayon::prelude::*;

use crate::analysis::alignment::rigid_motion;
use crate::analysis::transport::{TransportError, TransportParams, transport_deformation};
use crate::mesh::{Point3, TriMesh, Vector3, face_normals};
use crate::progress::Progress;

use super::error::step;
use super::{
    Deformation, ExperimentError, Motion, ObjectKind, Solid, SyntheticParams, synthetic_cohort,
};

/// How many deformations are transported, and by what.
#[derive(Clone, Debug, PartialEq)]
pub struct TransportExperimentParams {
    /// Kinds of objects.
    pub objects: Vec<ObjectKind>,
    /// The deformations; the object is replaced by each of `objects`.
    pub cohort: SyntheticParams,
    /// How they are transported.
    pub transport: TransportParams,
}

impl Default for TransportExperimentParams {
    /// 6 kinds × 4 motions × 3: 72 deformations.
    fn default() -> Self {
        Self {
            objects: ObjectKind::ALL.to_vec(),
            cohort: SyntheticParams {
                per_class: 3,
                ..SyntheticParams::default()
            },
            transport: TransportParams::default(),
        }
    }
}

/// One deformation on another object.
#[derive(Clone, Debug, PartialEq)]
pub struct TransportCase {
    /// What moved.
    pub object: ObjectKind,
    /// What followed: an ellipsoid, or a deformed torus.
    pub target: &'static str,
    /// How the object is deformed.
    pub motion: Motion,
    /// ‖transported − true‖ / ‖true‖ of the last displacement, the truth being the same motion applied
    /// to the target itself, after rigid alignment.
    pub relative_error: f64,
    /// Cosine of the angle between both displacements.
    pub cosine: f64,
    /// ‖transported‖ / ‖true‖.
    pub norm_ratio: f64,
    /// Faces of the last pose whose normal points away from that of the truth.
    pub flipped_faces: usize,
    /// Whether it counts as followed: cosine ≥ 0.9, norm within a third, no face flipped.
    pub followed: bool,
}

/// All cases.
#[derive(Clone, Debug, PartialEq)]
pub struct TransportExperiment {
    /// The settings with which it was run.
    pub params: TransportExperimentParams,
    /// By kind of object, then class.
    pub cases: Vec<TransportCase>,
}

/// A direction nearer than 26° is the same motion to the eye.
const MIN_COSINE: f64 = 0.9;
/// And a size within a third.
const NORM_RANGE: std::ops::RangeInclusive<f64> = 2.0 / 3.0..=1.5;

/// Transports every deformation onto an ellipsoid (of a sphere) or a deformed torus (of a torus), and
/// measures it against the same motion of the target itself. The same bits for any number of threads.
///
/// # Errors
/// If settings are out of range, it was stopped, or a motion cannot be transported at all.
pub fn transport_experiment(
    params: &TransportExperimentParams,
    progress: &Progress,
) -> Result<TransportExperiment, ExperimentError> {
    let mut tasks = Vec::new();
    for &object in &params.objects {
        let still = SyntheticParams {
            object,
            ..params.cohort
        };
        let cohort = synthetic_cohort(&still)?;
        for deformation in cohort.deformations {
            tasks.push((object, cohort.template.clone(), deformation));
        }
    }
    progress.expect_steps(tasks.len());
    let cases = tasks
        .par_iter()
        .map(|(object, template, deformation)| {
            progress.step()?;
            transported(params, *object, template, deformation, progress)
        })
        .collect::<Result<_, ExperimentError>>()?;
    Ok(TransportExperiment {
        params: params.clone(),
        cases,
    })
}

fn transported(
    params: &TransportExperimentParams,
    object: ObjectKind,
    template: &TriMesh,
    deformation: &Deformation,
    progress: &Progress,
) -> Result<TransportCase, ExperimentError> {
    let checked = params.transport.check();
    let checked = checked.map_err(|error| step("transporting a motion", &error))?;
    // Another shape than the source, or transport would have nothing to do.
    let (target, shaped) = target(object);
    let rest: Vec<Point3> = template.vertices().iter().map(shaped).collect();
    let (motion, poses) = (Motion::ALL[deformation.class], &deformation.poses);
    let truth: Vec<Point3> = (rest.iter())
        .map(|p| motion.moved(object.solid, p, deformation.amplitude))
        .collect();
    // The source lies anywhere in space; its motion is transported from beside the target.
    let source = poses.first().cloned().unwrap_or_default();
    let beside = rigid_motion(&source, &rest).map_err(|e| step("aligning objects", &e))?;
    let moved: Vec<Vec<Point3>> = (poses.iter())
        .map(|pose| pose.iter().map(|p| beside.apply(p)).collect())
        .collect();
    let result = transport_deformation(
        template.faces(),
        &moved,
        &rest,
        &checked,
        &progress.within(),
    )
    .map_err(|error| match error {
        TransportError::Stopped(stopped) => stopped.into(),
        other => step("transporting a motion", &other),
    })?;
    let last = result.poses.last().cloned().unwrap_or_default();
    let Difference {
        relative_error,
        cosine,
        norm_ratio,
        flipped_faces,
    } = difference(&last, &truth, &rest, template.triangles())?;
    Ok(TransportCase {
        object,
        target,
        motion,
        relative_error,
        cosine,
        norm_ratio,
        flipped_faces,
        // All three: direction, amount, and a surface that does not fold.
        followed: cosine >= MIN_COSINE && NORM_RANGE.contains(&norm_ratio) && flipped_faces == 0,
    })
}

/// How a transported pose differs from the truth; see [`TransportCase`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Difference {
    pub relative_error: f64,
    pub cosine: f64,
    pub norm_ratio: f64,
    pub flipped_faces: usize,
}

/// Compares a transported pose, aligned with the true one, with that, both as displacements from rest.
pub(super) fn difference(
    transported: &[Point3],
    truth: &[Point3],
    rest: &[Point3],
    triangles: &[[u32; 3]],
) -> Result<Difference, ExperimentError> {
    // Where the target lies in space is no part of the question.
    let onto = rigid_motion(transported, truth).map_err(|e| step("aligning objects", &e))?;
    let laid: Vec<Point3> = transported.iter().map(|p| onto.apply(p)).collect();
    let field =
        |pose: &[Point3]| -> Vec<Vector3> { pose.iter().zip(rest).map(|(p, q)| p - q).collect() };
    let (found, true_field) = (field(&laid), field(truth));
    let product =
        |a: &[Vector3], b: &[Vector3]| -> f64 { a.iter().zip(b).map(|(a, b)| a.dot(b)).sum() };
    let (own, whole) = (
        product(&found, &found).sqrt(),
        product(&true_field, &true_field).sqrt(),
    );
    let off: Vec<Vector3> = found.iter().zip(&true_field).map(|(a, b)| a - b).collect();
    let normals = |points: &[Point3]| face_normals(points, triangles);
    Ok(Difference {
        relative_error: product(&off, &off).sqrt() / whole,
        cosine: product(&found, &true_field) / (own * whole),
        norm_ratio: own / whole,
        flipped_faces: (normals(&laid).iter().zip(&normals(truth)))
            // Against the true normals: a true motion may turn a face far.
            .filter(|(a, b)| a.dot(b) < 0.0)
            .count(),
    })
}

/// What follows: axes of 1.3, 0.9 and 0.8; or a torus that is also thicker on one side.
fn target(object: ObjectKind) -> (&'static str, fn(&Point3) -> Point3) {
    match object.solid {
        Solid::Sphere => ("ellipsoid", |p| {
            Point3::new(1.3 * p.x, 0.9 * p.y, 0.8 * p.z)
        }),
        Solid::Torus => ("deformed torus", |p| {
            Point3::new(1.2 * p.x, 0.9 * p.y, p.z * (1.0 + 0.25 * p.x))
        }),
    }
}
