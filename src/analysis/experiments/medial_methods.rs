//! Ways of telling, from noisy medial surfaces over a beat, which have a patch that does not thicken.

use crate::analysis::classification::k_means;
use crate::analysis::embedding::{MapMethod, embed};
use crate::analysis::measures::{PhaseSource, SubjectMeasures};
use crate::analysis::medial_space::{PoseDescriptor, RatioForm, pose_distance};
use crate::analysis::pose_distances::DistanceMatrix;
use crate::analysis::thickening::{Thickening, ThickeningParams, thickening};
use crate::mesh::Point3;
use crate::progress::Progress;
use crate::units::LengthUnit;

use super::ExperimentError;
use super::sheets::{PHASES, Sheet};

/// A way of telling normal from abnormal deformations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MedialMethod {
    /// What the program does: abnormal is where the search for patches finds one. Each deformation is assessed alone.
    PatchFound,
    /// The text's way: M̂ of every step, its descriptor, distances 4.5.1, the plane of all poses, and clusters of
    /// deformations by how close the points of each lie together on it. Tolerance from noise, r̂ a geometric
    /// mean, only steps in which remote myocardium changes.
    Paths,
    /// The same with |PT − 1| ≤ 5 %, r̂ a product, and all steps.
    PathsPrinted,
    /// The same, with clusters of poses; a deformation goes with most of its poses.
    PosesPrinted,
}

impl MedialMethod {
    /// The program's way first.
    pub const ALL: [Self; 4] = [
        Self::PatchFound,
        Self::Paths,
        Self::PathsPrinted,
        Self::PosesPrinted,
    ];

    /// What tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::PatchFound => "patch detection (default)",
            Self::Paths => "mean pose distance",
            Self::PathsPrinted => "mean pose distance, as printed",
            Self::PosesPrinted => "clusters of poses, as printed",
        }
    }
}

/// What thickening says of one sheet.
pub(super) struct Assessed {
    pub(super) found: Thickening,
    /// With tolerance and product as printed.
    printed: Option<Thickening>,
}

/// Thickening of one sheet, as printed too where a way asks for it.
pub(super) fn assessed(
    sheet: &Sheet,
    params: &ThickeningParams,
    with_printed: bool,
    progress: &Progress,
) -> Result<Assessed, ExperimentError> {
    let beat = sheet.beat();
    let run = |params: ThickeningParams| {
        let params = params.check()?;
        let axis = sheet.axis.as_ref();
        Ok::<_, ExperimentError>(thickening(&beat, &stated(), axis, &params, progress)?)
    };
    let printed = ThickeningParams {
        // The text calls an atom akinetic where PT differs from 1 by at most 5 %.
        tolerance: Some(1.05_f64.ln()),
        ratio: RatioForm::Product,
        ..*params
    };
    Ok(Assessed {
        found: run(*params)?,
        printed: if with_printed {
            Some(run(printed)?)
        } else {
            None
        },
    })
}

/// Measures that state the phases, in millimetres; nothing else is asked of them.
fn stated() -> SubjectMeasures {
    SubjectMeasures {
        unit: LengthUnit::Millimetre,
        frames: Vec::new(),
        end_diastole: Some(PHASES[0]),
        end_systole: Some(PHASES[1]),
        phase_source: PhaseSource::Stated,
        edv: None,
        esv: None,
        sv: None,
        ef: None,
        mass: None,
        notes: Vec::new(),
    }
}

/// How clusters become a plane and how often k-means starts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clusters {
    pub map: MapMethod,
    pub restarts: usize,
    pub seed: u64,
}

/// For each sheet the group that it is put in, 0 or 1; 2 where a way has nothing to put in a group. Groups of
/// [`MedialMethod::PatchFound`] are classes, others have no names.
pub(super) fn groups(
    method: MedialMethod,
    sheets: &[Assessed],
    centres: &[Point3],
    clusters: Clusters,
    progress: &Progress,
) -> Result<Vec<usize>, ExperimentError> {
    if method == MedialMethod::PatchFound {
        return Ok((sheets.iter())
            .map(|sheet| usize::from(!sheet.found.patches.is_empty()))
            .collect());
    }
    let paths: Vec<Vec<PoseDescriptor>> = (sheets.iter().zip(centres))
        .map(|(sheet, centre)| path(method, sheet, centre))
        .collect();
    let owners: Vec<usize> = (paths.iter().enumerate())
        .flat_map(|(sheet, path)| vec![sheet; path.len()])
        .collect();
    let plane = plane(&paths.concat(), clusters.map, progress)?;
    let k_means = |points: &[f64], dimensions: usize| {
        k_means(
            points,
            dimensions,
            2,
            clusters.restarts,
            clusters.seed,
            progress,
        )
    };
    if method == MedialMethod::PosesPrinted {
        let poses = k_means(&plane, 2)?.clusters;
        let mut votes = vec![[0_usize; 2]; sheets.len()];
        for (&owner, &cluster) in owners.iter().zip(&poses) {
            votes[owner][cluster.min(1)] += 1;
        }
        return Ok(votes
            .iter()
            .map(|[first, second]| match (first, second) {
                // Without any akinetic pose it belongs to neither cluster, and counts as wrong.
                (0, 0) => 2,
                _ => usize::from(second > first),
            })
            .collect());
    }
    let spreads: Vec<f64> = (0..sheets.len())
        .map(|sheet| spread(&plane, &owners, sheet))
        .collect();
    Ok(k_means(&spreads, 1)?.clusters)
}

/// Poses of M̂ over the beat, with positions from the middle of the sheet in its sizes.
fn path(method: MedialMethod, sheet: &Assessed, centre: &Point3) -> Vec<PoseDescriptor> {
    // The printed form takes every step, the default those in which a normal wall changes.
    let (found, all) = match (method, &sheet.printed) {
        (MedialMethod::PathsPrinted | MedialMethod::PosesPrinted, Some(printed)) => (printed, true),
        _ => (&sheet.found, false),
    };
    (found.steps.iter())
        // In steps in which even a normal wall stands still all atoms are akinetic, and say nothing.
        .filter(|step| all || step.telling)
        .filter_map(|step| step.descriptor)
        // Positions from the centre in sizes of the sheet, or place and size would outweigh the angles.
        .map(|pose| pose.relative_to(centre, found.size))
        .collect()
}

/// Coordinates of poses on the plane, two each; all 0 where there are too few to span one.
fn plane(
    poses: &[PoseDescriptor],
    map: MapMethod,
    progress: &Progress,
) -> Result<Vec<f64>, ExperimentError> {
    let distance = |i: usize, j: usize| pose_distance(&poses[i], &poses[j]);
    match DistanceMatrix::of_pairs(poses.len(), distance) {
        Some(distances) if poses.len() > 2 => Ok(embed(&distances, map, 2, progress)?.coordinates),
        _ => Ok(vec![0.0; 2 * poses.len()]),
    }
}

/// Root mean square distance of a sheet's points on the plane from their mean; a right angle, the mean over all
/// directions, where it has fewer than two, since nothing then stays.
fn spread(plane: &[f64], owners: &[usize], sheet: usize) -> f64 {
    let points = || {
        (plane.chunks_exact(2).zip(owners))
            .filter(|(_, owner)| **owner == sheet)
            .map(|(point, _)| [point[0], point[1]])
    };
    let count = points().count() as f64;
    if count < 2.0 {
        return std::f64::consts::FRAC_PI_2;
    }
    let mean = [0, 1].map(|axis| points().map(|p| p[axis]).sum::<f64>() / count);
    let squares: f64 = points()
        .map(|p| (p[0] - mean[0]).powi(2) + (p[1] - mean[1]).powi(2))
        .sum();
    (squares / count).sqrt()
}
