//! Labelled studies of deformed objects.

use std::sync::Arc;

use nalgebra::Rotation3;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::mesh::{Point3, TriMesh, Vector3};
use crate::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

use super::ExperimentError;
use super::motions::Motion;
use super::objects::{Fineness, ObjectKind, object};

/// Deformations of one kind of object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SyntheticParams {
    /// What is deformed.
    pub object: ObjectKind,
    /// How fine its mesh is.
    pub fineness: Fineness,
    /// Members of each class of [`Motion::ALL`].
    pub per_class: u16,
    /// Poses of a deformation, the first at rest; amplitudes grow evenly.
    pub poses: u16,
    /// Amplitudes are multiplied by a factor between 1 − this and 1 + this.
    pub amplitude_jitter: f64,
    /// Each axis of an object is multiplied by such a factor.
    pub object_jitter: f64,
    /// Of amplitudes, objects, and places in space.
    pub seed: u64,
}

impl Default for SyntheticParams {
    /// 4 × 15 deformations of 3 poses (fig. 3.9), amplitudes ± 20 %, objects ± 5 % along each axis.
    fn default() -> Self {
        Self {
            object: ObjectKind::ALL[0],
            fineness: Fineness::default(),
            per_class: 15,
            poses: 3,
            amplitude_jitter: 0.2,
            object_jitter: 0.05,
            seed: 1,
        }
    }
}

/// One deformation: poses of an object, the first at rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Deformation {
    /// Index into [`Motion::ALL`].
    pub class: usize,
    /// The amplitude at which it ends, see [`Motion::typical_amplitude`].
    pub amplitude: f64,
    /// The object at rest and deformed; lengths in radii of the solid.
    pub poses: Vec<Vec<Point3>>,
}

/// Deformations in correspondence.
#[derive(Clone, Debug, PartialEq)]
pub struct SyntheticCohort {
    /// The undeformed object, which gives the faces.
    pub template: TriMesh,
    /// Class after class.
    pub deformations: Vec<Deformation>,
}

/// Makes the deformations. Equal parameters give equal bits.
///
/// # Errors
/// If there are fewer than two poses, no members, more than two boundaries, or jitter is not in 0..0.9.
pub fn synthetic_cohort(params: &SyntheticParams) -> Result<SyntheticCohort, ExperimentError> {
    check(params)?;
    let template = object(params.object, params.fineness);
    let mut deformations = Vec::new();
    for (class, motion) in Motion::ALL.into_iter().enumerate() {
        for member in 0..params.per_class {
            let mut random = ChaCha8Rng::seed_from_u64(params.seed);
            // A stream per member: more members change none of the first.
            random.set_stream((class as u64) << 32 | u64::from(member));
            deformations.push(Deformation {
                class,
                ..deformed(&template, motion, params, &mut random)
            });
        }
    }
    Ok(SyntheticCohort {
        template,
        deformations,
    })
}

fn check(params: &SyntheticParams) -> Result<(), ExperimentError> {
    let count = |name, value: u16, least: u16| {
        let fits = value >= least;
        fits.then_some(()).ok_or(ExperimentError::TooFew {
            name,
            value: usize::from(value),
            least: usize::from(least),
        })
    };
    count("poses", params.poses, 2)?;
    count("deformations per class", params.per_class, 1)?;
    if params.object.boundaries > 2 {
        return Err(ExperimentError::Boundaries {
            boundaries: params.object.boundaries,
        });
    }
    for (name, value) in [
        ("amplitude jitter", params.amplitude_jitter),
        ("object jitter", params.object_jitter),
    ] {
        // Past this an object or a motion may all but vanish.
        if !(0.0..0.9).contains(&value) {
            return Err(ExperimentError::Jitter { name, value });
        }
    }
    Ok(())
}

/// The jittered object at every amplitude, placed anywhere in space.
fn deformed(
    template: &TriMesh,
    motion: Motion,
    params: &SyntheticParams,
    random: &mut ChaCha8Rng,
) -> Deformation {
    let mut factor = |jitter: f64| 1.0 + jitter * random.random_range(-1.0..=1.0);
    let axes = Vector3::from_fn(|_, _| factor(params.object_jitter));
    let solid = params.object.solid;
    let amplitude = motion.typical_amplitude(solid) * factor(params.amplitude_jitter);
    let mut angle = || random.random_range(-3.0..3.0);
    // Anywhere in space: a method must not tell classes by position.
    let turn = Rotation3::from_euler_angles(angle(), angle(), angle());
    let place = Vector3::new(angle(), angle(), angle());
    let rest: Vec<Point3> = (template.vertices().iter())
        .map(|p| Point3::from(p.coords.component_mul(&axes)))
        .collect();
    let poses = (0..params.poses)
        .map(|pose| {
            // From rest to the full amplitude in equal steps.
            let reached = amplitude * f64::from(pose) / f64::from(params.poses - 1);
            let at = |p: &Point3| turn * motion.moved(solid, p, reached) + place;
            rest.iter().map(at).collect()
        })
        .collect();
    Deformation {
        class: 0,
        amplitude,
        poses,
    }
}

impl SyntheticCohort {
    /// The class of each deformation, an index into [`Motion::ALL`].
    pub fn labels(&self) -> Vec<usize> {
        self.deformations.iter().map(|d| d.class).collect()
    }

    /// A study with one subject per deformation, labelled by its class.
    ///
    /// # Errors
    /// If coordinates are not finite.
    pub fn study(&self) -> Result<Study, ExperimentError> {
        let mut subjects = Vec::with_capacity(self.deformations.len());
        for (index, deformation) in self.deformations.iter().enumerate() {
            let class = Motion::ALL[deformation.class].name();
            let frames = (deformation.poses.iter())
                .map(|points| TriMesh::new(points.clone(), Arc::clone(self.template.faces())))
                .collect::<Result<Vec<_>, _>>()?;
            let surface = SurfaceSequence::new(SurfaceKind::Other, frames)?;
            let id = format!("{class} {}", index + 1);
            let sequence = MeshSequence::new(vec![surface])?;
            let mut subject = Subject::new(id, sequence, LengthUnit::FileUnit);
            subject.label = Some(class.to_owned());
            // The first pose is at rest; without volumes nothing else would say so.
            subject.end_diastole = Some(0);
            subjects.push(Arc::new(subject));
        }
        Ok(Study {
            name: "Synthetic deformations".to_owned(),
            subjects,
            ..Study::default()
        })
    }
}
