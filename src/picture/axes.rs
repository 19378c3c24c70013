//! Which way a heart is turned in a picture: its axes, the six views, and the orientation cube.

use crate::mesh::{Vector3, mean_point};
use crate::picture::openings::openings;
use crate::study::{Subject, SurfaceKind, SurfaceSequence};

/// The six directions to look from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum AnatomicalView {
    /// From the front.
    Anterior,
    /// From behind, onto the inferior wall.
    Inferior,
    /// Onto the septum.
    Septal,
    /// Onto the free wall.
    Lateral,
    /// From the apex.
    Apex,
    /// From the base.
    Base,
}

/// One side of the orientation cube.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CubeFace {
    /// Unit direction that the side faces, in coordinates.
    pub normal: glam::Vec3,
    /// A, I, S, L, base or apex.
    pub label: &'static str,
}

/// Directions of one heart, square to each other, in its coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SubjectAxes {
    /// Along the long axis towards the base; upwards in pictures.
    pub up: Vector3,
    /// Towards the anterior wall; towards the viewer in the anterior view.
    pub front: Vector3,
    /// Towards the septum, square to both.
    pub side: Vector3,
    /// Whether anatomical names are known to belong to these directions.
    pub named: bool,
}

/// How far the first view is lifted above the horizon, so that one sees into the base.
const HOME_ELEVATION_RAD: f64 = 0.38;
/// How far the first view is turned from the front away from the septum, so that depth reads.
const HOME_AZIMUTH_RAD: f64 = 0.52;

impl SubjectAxes {
    /// Axes from the landmarks if they are known; else the long axis from the opening at the
    /// base, or for closed surfaces the direction of greatest extent with the wider end up.
    /// Surfaces that are not said to be part of a heart stand as their file has them, y up.
    pub fn of(subject: &Subject) -> Self {
        if let Some(anatomy) = &subject.anatomy {
            return Self {
                up: anatomy.long_axis(),
                front: anatomy.anterior,
                side: anatomy.septal,
                named: true,
            };
        }
        let surface = &subject.sequence.surfaces()[0];
        let up = if surface.kind() == SurfaceKind::Other {
            Vector3::y()
        } else {
            towards_opening(surface).unwrap_or_else(|| towards_wider_end(surface))
        };
        // The file's axis that lies squarest to the long axis, so that the choice is stable.
        let front = [Vector3::z(), Vector3::x(), Vector3::y()]
            .into_iter()
            // Of axes that are as square but for rounding the first one, wherever the subject lies.
            .min_by_key(|axis| (1e6 * axis.dot(&up).abs()).round() as u32)
            .and_then(|axis| (axis - up * up.dot(&axis)).try_normalize(0.0))
            .unwrap_or_else(Vector3::z);
        Self {
            up,
            front,
            side: front.cross(&up),
            named: false,
        }
    }

    /// Camera rotation for a view; anatomical words hold only where [`Self::named`] is true.
    pub fn view(&self, view: AnatomicalView) -> glam::Quat {
        let (towards_viewer, up) = match view {
            AnatomicalView::Anterior => (self.front, self.up),
            AnatomicalView::Inferior => (-self.front, self.up),
            AnatomicalView::Septal => (self.side, self.up),
            AnatomicalView::Lateral => (-self.side, self.up),
            AnatomicalView::Apex => (-self.up, self.front),
            AnatomicalView::Base => (self.up, self.front),
        };
        camera_rotation(towards_viewer, up)
    }

    /// Camera rotation of the first picture: base up, a little from above and from the side.
    pub fn home(&self) -> glam::Quat {
        let level = self.front * HOME_AZIMUTH_RAD.cos() - self.side * HOME_AZIMUTH_RAD.sin();
        let towards_viewer = level * HOME_ELEVATION_RAD.cos() + self.up * HOME_ELEVATION_RAD.sin();
        camera_rotation(towards_viewer, self.up)
    }

    /// Sides of the orientation cube; none where anatomical names are not known.
    pub fn cube(&self) -> Vec<CubeFace> {
        if !self.named {
            return Vec::new();
        }
        [
            (self.front, "A"),
            (-self.front, "I"),
            (self.side, "S"),
            (-self.side, "L"),
            (self.up, "base"),
            (-self.up, "apex"),
        ]
        .map(|(normal, label)| CubeFace {
            normal: glam::DVec3::new(normal.x, normal.y, normal.z).as_vec3(),
            label,
        })
        .to_vec()
    }
}

/// Rotation whose z axis points to the viewer and whose y axis is `up` as nearly as possible.
fn camera_rotation(towards_viewer: Vector3, up: Vector3) -> glam::Quat {
    let z = glam::DVec3::new(towards_viewer.x, towards_viewer.y, towards_viewer.z)
        .normalize_or(glam::DVec3::Z);
    let up = glam::DVec3::new(up.x, up.y, up.z);
    let x = up
        .cross(z)
        .try_normalize()
        .unwrap_or_else(|| z.any_orthonormal_vector());
    let y = z.cross(x);
    glam::DQuat::from_mat3(&glam::DMat3::from_cols(x, y, z)).as_quat()
}

/// From the middle of the surface to the middle of its widest opening at frame 0.
fn towards_opening(surface: &SurfaceSequence) -> Option<Vector3> {
    let mesh = &surface.frames()[0];
    let widest = openings(surface)
        .into_iter()
        .max_by(|a, b| a.area.total_cmp(&b.area))?;
    (widest.centre - mean_point(mesh.vertices().iter().copied())).try_normalize(0.0)
}

/// The direction of greatest extent, pointing to the end whose cross-section is wider.
fn towards_wider_end(surface: &SurfaceSequence) -> Vector3 {
    let points = surface.frames()[0].vertices();
    let centre = mean_point(points.iter().copied());
    let mut spread = nalgebra::Matrix3::zeros();
    for point in points {
        let offset = point - centre;
        spread += offset * offset.transpose();
    }
    let eigen = nalgebra::SymmetricEigen::new(spread);
    let axis: Vector3 = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into();
    // Σ (distance from the axis)² · (place along it): positive if the far end is the wider one.
    let lean: f64 = points
        .iter()
        .map(|point| {
            let offset = point - centre;
            let along = axis.dot(&offset);
            (offset.norm_squared() - along * along) * along
        })
        .sum();
    let axis = axis.try_normalize(0.0).unwrap_or_else(Vector3::z);
    if lean < 0.0 { -axis } else { axis }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Point3, TriMesh, phantom};
    use crate::study::{Anatomy, MeshSequence};
    use crate::units::LengthUnit;

    fn subject(kind: SurfaceKind, mesh: TriMesh) -> Subject {
        let surface = SurfaceSequence::new(kind, vec![mesh]).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        Subject::new("P-001", sequence, LengthUnit::Millimetre)
    }

    #[test]
    fn the_base_is_up_and_the_named_wall_faces_the_viewer() {
        let mut heart = subject(SurfaceKind::Endocardium, phantom::bowl(30.0, 4, 12));
        heart.anatomy = Anatomy::from_landmarks(
            Point3::new(0.0, 0.0, -80.0),
            Point3::origin(),
            Point3::new(30.0, 0.0, -20.0),
            Point3::new(0.0, 25.0, -20.0),
        );
        let axes = SubjectAxes::of(&heart);
        for (view, label) in [
            (AnatomicalView::Anterior, "A"),
            (AnatomicalView::Inferior, "I"),
            (AnatomicalView::Septal, "S"),
            (AnatomicalView::Lateral, "L"),
            (AnatomicalView::Apex, "apex"),
            (AnatomicalView::Base, "base"),
        ] {
            let towards_viewer = axes.view(view) * glam::Vec3::Z;
            let nearest = axes
                .cube()
                .into_iter()
                .max_by(|a, b| {
                    a.normal
                        .dot(towards_viewer)
                        .total_cmp(&b.normal.dot(towards_viewer))
                })
                .unwrap();
            assert_eq!(nearest.label, label);
        }
        assert!((axes.view(AnatomicalView::Anterior) * glam::Vec3::Y).z > 0.999);
        assert!((axes.home() * glam::Vec3::Y).z > 0.9);
    }

    #[test]
    fn without_landmarks_the_opening_is_up_and_nothing_is_named() {
        let bowl = phantom::bowl(30.0, 4, 12);
        let rim = bowl.faces().boundary_loops();
        let centre = mean_point(bowl.vertices().iter().copied());
        let opening = bowl.vertices()[rim[0][0] as usize].z;
        let axes = SubjectAxes::of(&subject(SurfaceKind::Endocardium, bowl));
        assert!(axes.up.z.abs() > 0.999);
        assert_eq!(axes.up.z > 0.0, opening > centre.z);
        assert!(axes.cube().is_empty());
        assert!(axes.front.dot(&axes.up).abs() < 1e-12);
        let handed = axes.up.cross(&axes.front);
        assert!((handed + axes.side).norm() < 1e-12);
    }

    #[test]
    fn a_closed_surface_stands_on_its_narrow_end() {
        // An egg: an ellipsoid along x whose far end is drawn out to a point.
        let sphere = phantom::sphere(3, 1.0);
        let egg: Vec<Point3> = sphere
            .vertices()
            .iter()
            .map(|p| Point3::new(3.0 * p.x, p.y * (1.0 - 0.4 * p.x), p.z * (1.0 - 0.4 * p.x)))
            .collect();
        let mesh = TriMesh::new(egg, sphere.faces().clone()).unwrap();
        let axes = SubjectAxes::of(&subject(SurfaceKind::Cavity, mesh));
        assert!(axes.up.x < -0.99, "{:?}", axes.up);
    }
}
