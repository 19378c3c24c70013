//! Paths in the space of poses, with the tangent spaces of a metric.

use crate::analysis::geodesics::same_pose;
use crate::analysis::metrics::{Metric, PreparedPose};
use crate::mesh::{Point3, Vector3};

use super::{Nearness, Products, SampledPath, TransportError, TransportedStep, parallel_transport};

/// A sampled path between poses: velocity is the forward difference, at the last sample the backward
/// one.
#[derive(Clone, Debug)]
pub struct PosePath<'a> {
    metric: &'a Metric,
    poses: Vec<PreparedPose>,
    velocities: Vec<Vec<Vector3>>,
}

impl<'a> PosePath<'a> {
    /// Prepares each sample; those equal to the sample before are left out.
    ///
    /// # Errors
    /// If counts of vertices differ, squares overflow, or the metric's form is no inner product.
    pub fn new(metric: &'a Metric, path: &[Vec<Point3>]) -> Result<Self, TransportError> {
        if !metric.params().is_inner_product() {
            return Err(TransportError::NotAnInnerProduct);
        }
        let mut kept: Vec<&[Point3]> = Vec::with_capacity(path.len());
        for pose in path {
            // A step of no length has no direction, and would divide by its norm.
            if kept.last().is_none_or(|last| !same_pose(last, pose)) {
                kept.push(pose);
            }
        }
        let poses = (kept.iter())
            .map(|pose| metric.prepare(pose))
            .collect::<Result<Vec<_>, _>>()?;
        let mut velocities: Vec<Vec<Vector3>> = (kept.windows(2))
            .map(|pair| pair[0].iter().zip(pair[1]).map(|(a, b)| b - a).collect())
            .collect();
        // Backward at the last sample.
        if let Some(last) = velocities.last().cloned() {
            velocities.push(last);
        }
        Ok(Self {
            metric,
            poses,
            velocities,
        })
    }

    /// Norms and products with the path's direction of a field at the first sample and of another at the last.
    fn step(&self, first: &[Vector3], last: &[Vector3]) -> TransportedStep {
        let mut step = TransportedStep {
            norms: [0.0; 2],
            products: [0.0; 2],
        };
        let end = self.poses.len() - 1;
        for (place, (sample, field)) in [(0, first), (end, last)].into_iter().enumerate() {
            let norm2 = match self.velocities.is_empty() {
                // A path of one sample has no direction.
                true => self.metric.inner_product(&self.poses[sample], field, field),
                false => {
                    let products = self.products(sample, field);
                    if products.velocity > 0.0 {
                        step.products[place] = products.mixed / products.velocity.sqrt();
                    }
                    products.field
                }
            };
            step.norms[place] = norm2.max(0.0).sqrt();
        }
        step
    }
}

impl SampledPath for PosePath<'_> {
    fn samples(&self) -> usize {
        self.velocities.len()
    }

    fn velocity(&self, sample: usize) -> &[Vector3] {
        &self.velocities[sample]
    }

    fn products(&self, sample: usize, field: &[Vector3]) -> Products {
        let velocity = &self.velocities[sample];
        let [field, mixed, velocity] = self.metric.products(&self.poses[sample], field, velocity);
        Products {
            field,
            mixed,
            velocity,
        }
    }

    fn lowered_velocity(&self, sample: usize) -> Vec<Vector3> {
        let velocity = &self.velocities[sample];
        let mut unit = vec![Vector3::zeros(); velocity.len()];
        (0..velocity.len())
            .map(|vertex| {
                Vector3::from_fn(|axis, _| {
                    unit[vertex][axis] = 1.0;
                    let product = self
                        .metric
                        .inner_product(&self.poses[sample], velocity, &unit);
                    unit[vertex][axis] = 0.0;
                    product
                })
            })
            .collect()
    }
}

/// Transports a field of displacements from the first pose of a path to the last by
/// [`parallel_transport`], nearest in the metric; velocities are those of [`PosePath`].
///
/// Along a straight path the number of samples does not matter: the field stays in the plane
/// spanned by itself and the path's direction, where product and norm determine it. A path whose
/// poses are all the same returns the field as it is.
///
/// # Errors
/// If there is no pose, counts differ, the metric's form is no inner product, or squares overflow.
pub fn transport_along(
    metric: &Metric,
    path: &[Vec<Point3>],
    field: &[Vector3],
    keep_norm: bool,
) -> Result<Vec<Vector3>, TransportError> {
    let (transported, _) = transport_nearest(metric, path, field, Nearness::Metric, keep_norm)?;
    Ok(transported)
}

/// The same, with what was kept.
pub(super) fn transport_nearest(
    metric: &Metric,
    path: &[Vec<Point3>],
    field: &[Vector3],
    nearness: Nearness,
    keep_norm: bool,
) -> Result<(Vec<Vector3>, TransportedStep), TransportError> {
    let start = path.first().ok_or(TransportError::NoPoses)?;
    if field.len() != start.len() {
        return Err(TransportError::FieldLength {
            displacements: field.len(),
            vertices: start.len(),
        });
    }
    let path = PosePath::new(metric, path)?;
    let transported = parallel_transport(&path, field, nearness, keep_norm);
    let norm2: f64 = transported.iter().map(Vector3::norm_squared).sum();
    if !norm2.is_finite() {
        return Err(TransportError::NotFinite { pose: 0, norm2 });
    }
    let step = path.step(field, &transported);
    Ok((transported, step))
}
