//! What a file of a metric says: words, properties and terms.
//!
//! A method is called once per pass over a mesh, never once per face: the loops inside are compiled for their metric.
//! Only [`MetricTerms::side_stiffness`], which is rarely needed, is called for each face.

use nalgebra::Matrix3;

use crate::mesh::{Point3, Vector3};

use crate::analysis::metrics::metric::{Metric, PairScratch};
use crate::analysis::metrics::params::{CurvatureRole, Form, MetricParams};
use crate::analysis::metrics::path_energy::state::{Gradients, PathState, Plan};
use crate::analysis::metrics::pose::PreparedPose;

/// What a person reads about a metric.
#[derive(Clone, Copy, Debug)]
pub struct MetricWords {
    /// Name in the window.
    pub name: &'static str,
    /// Name in running text and as a value of `--metric`.
    pub id: &'static str,
    /// What it penalises, as the help of the command line says it.
    pub summary: &'static str,
    /// Changes that cost nothing without a regulariser.
    pub ignores: &'static str,
    /// Changes that cost something.
    pub penalises: &'static str,
    /// What its own term is: neither that of change of curvature nor the regulariser.
    pub term: &'static str,
    /// The forms that differ, the default first, by the names that they have in a comparison of metrics.
    pub forms: &'static [(&'static str, Form)],
}

/// A rigid motion that is applied to pose B of a pair.
pub(in crate::analysis::metrics) type Motion<'a> = (&'a Matrix3<f64>, &'a Vector3);

/// What is specific to a metric. The regulariser is common to all and no part of it.
pub(in crate::analysis::metrics) trait MetricTerms: Sync {
    fn words(&self) -> MetricWords;

    /// The weight λ of the regulariser with which it is offered.
    fn lambda(&self) -> f64;

    /// Whether uniform scaling costs nothing where corners are scale-free.
    fn ignores_scale(&self) -> bool;

    /// Whether displacement of vertices itself is penalised.
    fn penalises_displacement(&self) -> bool {
        false
    }

    fn curvature_role(&self, _: Form) -> CurvatureRole {
        CurvatureRole::Unused
    }

    /// Whether products of two fields are linear in each of them.
    fn is_inner_product(&self, form: Form) -> bool;

    /// Whether paths of several steps can cost nothing although their ends differ.
    fn path_energy_can_vanish(&self, params: &MetricParams) -> bool;

    /// Squared norms of X = (R B + t) − A at A and at B.
    ///
    /// At A it must equal `product(A, X, X)`: terms are linear rates of the field. A term that is a difference of the two
    /// poses instead, such as change of curvature, agrees with its rate to first order in X.
    fn pair(
        &self,
        metric: &Metric,
        poses: [&PreparedPose; 2],
        motion: Motion,
        scratch: &mut PairScratch,
    ) -> [f64; 2];

    /// ⟨⟨X, Y⟩⟩ at a pose.
    fn product(&self, metric: &Metric, at: &PreparedPose, x: &[Vector3], y: &[Vector3]) -> f64;

    /// ⟨⟨X, X⟩⟩, ⟨⟨X, Y⟩⟩ and ⟨⟨Y, Y⟩⟩ at a pose, equal to [`Self::product`] up to round-off.
    fn products(
        &self,
        metric: &Metric,
        at: &PreparedPose,
        x: &[Vector3],
        y: &[Vector3],
    ) -> [f64; 3] {
        each_product(self, metric, at, x, y)
    }

    /// Appends numbers that are linear in the field and whose products with those of another, summed, are
    /// [`Self::product`]. Forms that are no inner product have none of their own: theirs are those of the additive form.
    fn add_coordinates(
        &self,
        metric: &Metric,
        at: &PreparedPose,
        field: &[Vector3],
        coordinates: &mut Vec<f64>,
    );

    /// Adds to each face half its own terms at both poses.
    fn add_face_shares(
        &self,
        metric: &Metric,
        poses: [&PreparedPose; 2],
        rotation: &Matrix3<f64>,
        scratch: &mut PairScratch,
        shares: &mut [f64],
    );

    /// Terms of vertices before their weights, for the displacements of points at the pose `_at`; `None` where
    /// vertices have no terms.
    fn vertex_terms(
        &self,
        _metric: &Metric,
        _poses: [&PreparedPose; 2],
        _at: &PreparedPose,
        _points: &[Point3],
        _field: &[Vector3],
    ) -> Option<Vec<f64>> {
        None
    }

    /// Energies of the faces at all steps of a path, with their gradients. Must overwrite `gradients.face_area`, which still
    /// holds those of an earlier path: with zeros where the energy does not depend on areas of faces.
    fn add_face_energies(&self, plan: &Plan, state: &mut PathState, gradients: &mut Gradients);

    /// Energies of the vertices that are neither curvature change nor regulariser, with their gradients. Called
    /// after the faces and the other vertices.
    fn add_vertex_energies(&self, _: &Plan, _: &mut PathState, _: &mut Gradients) {}

    /// The quadratic form of a face on the relative rates of length of its sides ab, bc, ca; `None` where faces have
    /// no terms. Squared terms of corners are multiplied by `corner_weights`.
    fn side_stiffness(
        &self,
        params: &MetricParams,
        length2: [f64; 3],
        corner_weights: Option<[f64; 3]>,
    ) -> Option<[[f64; 3]; 3]>;
}

/// ⟨⟨X, X⟩⟩, ⟨⟨X, Y⟩⟩ and ⟨⟨Y, Y⟩⟩, one after the other.
pub(super) fn each_product<T: MetricTerms + ?Sized>(
    terms: &T,
    metric: &Metric,
    at: &PreparedPose,
    x: &[Vector3],
    y: &[Vector3],
) -> [f64; 3] {
    [(x, x), (x, y), (y, y)].map(|(x, y)| terms.product(metric, at, x, y))
}
