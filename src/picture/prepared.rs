//! One heart made ready for drawing, once: all its poses, normals and colour values.

use std::sync::Arc;

use crate::mesh::{Point3, vertex_areas, vertex_normals};
use crate::picture::axes::SubjectAxes;
use crate::picture::origin::PictureOrigin;
use crate::picture::quantity::Quantity;
use crate::picture::wall_rim::{WallRim, wall_rim};
use crate::render::{Geometry, GeometryPose, VertexScalars};
use crate::study::{Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

/// The part a surface plays in the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SurfaceRole {
    /// The inner side of a wall that has an outer one too.
    Inner,
    /// The outer side, seen through.
    Outer,
    /// The cut between both at the base.
    Rim,
    /// A surface that stands for itself.
    Alone(SurfaceKind),
}

/// One surface with everything that colours can stand for.
#[derive(Clone, Debug)]
pub struct PreparedSurface {
    /// The part it plays.
    pub role: SurfaceRole,
    /// Its shape at every frame.
    pub geometry: Arc<Geometry>,
    displacement: Arc<VertexScalars>,
    area_ratio: Arc<VertexScalars>,
}

impl PreparedSurface {
    /// The numbers of a quantity; `None` for tissue.
    pub fn scalars(&self, quantity: Quantity) -> Option<&Arc<VertexScalars>> {
        match quantity {
            Quantity::Tissue
            | Quantity::ThicknessRatio
            | Quantity::Contribution
            | Quantity::MotionDifference => None,
            Quantity::Displacement => Some(&self.displacement),
            Quantity::AreaRatio => Some(&self.area_ratio),
        }
    }
}

/// One heart, ready for drawing at any pose. Made off the window's thread, then shared.
#[derive(Clone, Debug)]
pub struct PreparedSubject {
    /// What lengths are counted in.
    pub unit: LengthUnit,
    /// Number of frames.
    pub frame_count: usize,
    /// The frame that motion is counted from.
    pub reference_frame: usize,
    /// Which way it is turned.
    pub axes: SubjectAxes,
    /// The surfaces: inner, outer, rim, or those that stand alone.
    pub surfaces: Vec<PreparedSurface>,
    /// Which pose of the surfaces' geometry each frame is, and at the end the number of poses.
    first_poses: Vec<usize>,
    /// How the rim is made of both sides.
    pub(crate) rim: Option<WallRim>,
}

impl PreparedSubject {
    /// Prepares a heart; motion is counted from `reference_frame`, or from the first frame if
    /// there is no such frame.
    pub fn new(subject: &Subject, reference_frame: usize) -> Self {
        Self::with_interpolated_poses(subject, reference_frame, &[])
    }

    /// Prepares a heart with poses between its frames: `interpolated_poses[i]` are those from frame i to
    /// the next, in order, with the vertices of all surfaces one after the other as in
    /// [`crate::study::MeshSequence::pose`]. The poses after the last frame lead to the first one.
    pub fn with_interpolated_poses(
        subject: &Subject,
        reference_frame: usize,
        interpolated_poses: &[&[Vec<Point3>]],
    ) -> Self {
        let sequence = &subject.sequence;
        let reference = if reference_frame < sequence.frame_count() {
            reference_frame
        } else {
            0
        };
        let inner = sequence.surface(SurfaceKind::Endocardium);
        let outer = sequence.surface(SurfaceKind::Epicardium);
        let both = inner.zip(outer);
        let mut offset = 0;
        let origin = PictureOrigin::of(subject);
        let mut surfaces: Vec<PreparedSurface> = sequence
            .surfaces()
            .iter()
            .map(|surface| {
                let role = match surface.kind() {
                    SurfaceKind::Endocardium if both.is_some() => SurfaceRole::Inner,
                    SurfaceKind::Epicardium if both.is_some() => SurfaceRole::Outer,
                    kind => SurfaceRole::Alone(kind),
                };
                let poses = poses(surface, offset, interpolated_poses);
                offset += surface.faces().vertex_count();
                prepared_surface(surface, &poses, role, reference, origin)
            })
            .collect();
        let rim = both.and_then(|(inner, outer)| wall_rim(inner, outer));
        if let Some(rim) = &rim {
            let of = |role| surfaces.iter().find(|surface| surface.role == role);
            let sides = of(SurfaceRole::Inner).zip(of(SurfaceRole::Outer));
            let rim = sides.map(|(inner, outer)| prepared_rim(rim, inner, outer));
            surfaces.extend(rim);
        }
        let mut first_poses = vec![0];
        for frame in 0..sequence.frame_count() {
            let between = interpolated_poses.get(frame).map_or(0, |poses| poses.len());
            first_poses.push(first_poses[frame] + 1 + between);
        }
        Self {
            first_poses,
            rim,
            unit: subject.unit,
            frame_count: sequence.frame_count(),
            reference_frame: reference,
            axes: SubjectAxes::of(subject),
            surfaces,
        }
    }

    /// The surface that plays a part, if there is one.
    pub fn surface(&self, role: SurfaceRole) -> Option<&PreparedSurface> {
        self.surfaces.iter().find(|surface| surface.role == role)
    }

    /// Positions of all surfaces at all frames, without the poses between them.
    pub fn all_positions(&self) -> impl Iterator<Item = &[f32; 3]> + Clone {
        let frames = &self.first_poses[..self.frame_count];
        self.surfaces.iter().flat_map(move |surface| {
            let positions = &surface.geometry.positions;
            frames.iter().flat_map(move |&pose| &positions[pose])
        })
    }

    /// Number of poses: frames and what lies between them.
    pub fn pose_count(&self) -> usize {
        self.first_poses[self.frame_count]
    }

    /// The pose that a frame is.
    pub fn pose_of_frame(&self, frame: usize) -> usize {
        self.first_poses[frame.min(self.frame_count - 1)]
    }

    /// A pose told in frames: between which two it lies, and what share of the way.
    pub fn pose_in_frames(&self, pose: GeometryPose) -> GeometryPose {
        let last = self.frame_count - 1;
        let frame = (self
            .first_poses
            .partition_point(|&first| first <= pose.from))
        .saturating_sub(1)
        .min(last);
        let steps = (self.interpolated_poses(frame) + 1) as f32;
        let step = pose.from.saturating_sub(self.first_poses[frame]) as f32;
        let blend = if pose.to == pose.from {
            0.0
        } else {
            pose.blend
        };
        GeometryPose {
            from: frame,
            to: if frame == last { 0 } else { frame + 1 },
            blend: ((step + blend) / steps).clamp(0.0, 1.0),
        }
    }

    /// Number of poses between a frame and the next.
    pub fn interpolated_poses(&self, frame: usize) -> usize {
        let frame = frame.min(self.frame_count - 1);
        self.first_poses[frame + 1] - self.first_poses[frame] - 1
    }
}

/// One surface's vertices at every pose, frames and interpolated poses in order.
fn poses<'a>(
    surface: &'a SurfaceSequence,
    offset: usize,
    interpolated_poses: &'a [&'a [Vec<Point3>]],
) -> Vec<&'a [Point3]> {
    let count = surface.faces().vertex_count();
    let mut poses = Vec::with_capacity(surface.frames().len());
    for (frame, mesh) in surface.frames().iter().enumerate() {
        poses.push(mesh.vertices());
        let between = interpolated_poses.get(frame).copied().unwrap_or_default();
        poses.extend(between.iter().map(|pose| &pose[offset..offset + count]));
    }
    poses
}

fn prepared_surface(
    surface: &SurfaceSequence,
    poses: &[&[Point3]],
    role: SurfaceRole,
    reference: usize,
    origin: PictureOrigin,
) -> PreparedSurface {
    let triangles = surface.faces().triangles();
    let start = surface.frames()[reference].vertices();
    let start_areas = vertex_areas(start, triangles);
    let mut geometry = Geometry {
        triangles: triangles.to_vec(),
        ..Geometry::default()
    };
    let (mut displacement, mut area_ratio) = (Vec::new(), Vec::new());
    for &points in poses {
        (geometry.positions).push(points.iter().map(|point| origin.drawn(point)).collect());
        let normals = vertex_normals(points, triangles);
        geometry
            .normals
            .push(normals.iter().map(|n| n.cast::<f32>().into()).collect());
        let moved = points.iter().zip(start).map(|(a, b)| (a - b).norm() as f32);
        displacement.push(moved.collect());
        let areas = vertex_areas(points, triangles);
        let ratios = areas.iter().zip(&start_areas).map(|(now, then)| {
            // A vertex of no face, or of faces of zero area, has no ratio: grey.
            if *then > 0.0 {
                (now / then) as f32
            } else {
                f32::NAN
            }
        });
        area_ratio.push(ratios.collect());
    }
    PreparedSurface {
        role,
        geometry: Arc::new(geometry),
        displacement: Arc::new(VertexScalars {
            values: displacement,
        }),
        area_ratio: Arc::new(VertexScalars { values: area_ratio }),
    }
}

fn prepared_rim(
    rim: &WallRim,
    inner: &PreparedSurface,
    outer: &PreparedSurface,
) -> PreparedSurface {
    let mut geometry = Geometry {
        triangles: rim.triangles.clone(),
        ..Geometry::default()
    };
    let frames = inner
        .geometry
        .positions
        .iter()
        .zip(&outer.geometry.positions);
    for (inner_points, outer_points) in frames {
        let points = gathered(rim, inner_points, outer_points);
        let exact: Vec<Point3> = points
            .iter()
            .map(|p| Point3::from(p.map(f64::from)))
            .collect();
        let normals = vertex_normals(&exact, &rim.triangles);
        geometry.positions.push(points);
        geometry
            .normals
            .push(normals.iter().map(|n| n.cast::<f32>().into()).collect());
    }
    let scalars = |of_inner: &VertexScalars, of_outer: &VertexScalars| {
        let frames = of_inner.values.iter().zip(&of_outer.values);
        Arc::new(VertexScalars {
            values: frames.map(|(a, b)| gathered(rim, a, b)).collect(),
        })
    };
    PreparedSurface {
        role: SurfaceRole::Rim,
        displacement: scalars(&inner.displacement, &outer.displacement),
        area_ratio: scalars(&inner.area_ratio, &outer.area_ratio),
        geometry: Arc::new(geometry),
    }
}

pub(crate) fn gathered<T: Copy>(rim: &WallRim, inner: &[T], outer: &[T]) -> Vec<T> {
    let of_inner = rim.inner.iter().map(|&vertex| inner[vertex as usize]);
    let of_outer = rim.outer.iter().map(|&vertex| outer[vertex as usize]);
    of_inner.chain(of_outer).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::MeshSequence;

    #[test]
    fn poses_between_frames_stand_between_them_on_every_surface() {
        let side = |kind, radii: [f64; 3]| {
            let frames = radii.map(|radius| phantom::bowl(radius, 4, 12)).to_vec();
            SurfaceSequence::new(kind, frames).unwrap()
        };
        let sequence = MeshSequence::new(vec![
            side(SurfaceKind::Endocardium, [20.0, 16.0, 18.0]),
            side(SurfaceKind::Epicardium, [30.0, 28.0, 29.0]),
        ])
        .unwrap();
        let pose = |inner, outer| {
            let sides = [inner, outer].map(|radius| phantom::bowl(radius, 4, 12));
            sides
                .iter()
                .flat_map(|mesh| mesh.vertices().to_vec())
                .collect::<Vec<_>>()
        };
        let (a, b) = (pose(19.0, 29.5), pose(17.0, 28.5));
        let last = [pose(19.5, 29.7)];
        let first = [a, b];
        let subject = Subject::new("P", sequence, LengthUnit::Millimetre);
        let plain = PreparedSubject::new(&subject, 0);
        let heart = PreparedSubject::with_interpolated_poses(&subject, 0, &[&first, &[], &last]);
        assert_eq!(heart.pose_count(), 6);
        assert_eq!([0, 1, 2].map(|frame| heart.pose_of_frame(frame)), [0, 3, 4]);
        assert_eq!(
            [0, 1, 2].map(|frame| heart.interpolated_poses(frame)),
            [2, 0, 1]
        );
        let moved = |role, pose: usize| {
            let surface = heart.surface(role).unwrap();
            surface.scalars(Quantity::Displacement).unwrap().values[pose][5]
        };
        for (pose, inner, outer) in [(1, 1.0, 0.5), (2, 3.0, 1.5), (3, 4.0, 2.0), (5, 0.5, 0.3)] {
            assert!((moved(SurfaceRole::Inner, pose) - inner).abs() < 1e-4);
            assert!((moved(SurfaceRole::Outer, pose) - outer).abs() < 1e-4);
        }
        for surface in &heart.surfaces {
            assert_eq!(surface.geometry.positions.len(), 6);
            assert_eq!(surface.geometry.normals.len(), 6);
        }
        // The first picture does not move when interpolated poses arrive.
        assert!(plain.all_positions().eq(heart.all_positions()));
    }
}
