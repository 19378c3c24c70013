//! Thickness of a subject's wall at a frame by any of the methods.

use crate::analysis::measures::{Side, wall_sides};
use crate::analysis::segments::{LongAxis, long_axis};
use crate::mesh::{ClosestPoint, Point3, TriMesh};
use crate::progress::{Progress, Stopped};
use crate::study::{Subject, SurfaceKind};

use super::centreline::centreline;
use super::laplace_field::field_of;
use super::nearest::nearest_points;
use super::volume_over_area::{piece, volume_over_area};
use super::wall_voxels::WallVoxels;
use super::{CheckedThicknessParams, ThicknessError, ThicknessMap, ThicknessMethod};

/// Thickness at every vertex of the inner side of a subject's wall at a frame.
///
/// # Errors
/// If the subject has no such frame, no wall, or, for the methods that need them, no long axis or
/// no inside; or if asked to stop.
pub fn thickness(
    subject: &Subject,
    frame: usize,
    method: ThicknessMethod,
    params: &CheckedThicknessParams,
    progress: &Progress,
) -> Result<ThicknessMap, ThicknessError> {
    let wall = WallPose::of(subject, frame)?;
    let axis = match method {
        ThicknessMethod::Centreline | ThicknessMethod::VolumeOverArea => {
            Some(long_axis(subject, frame)?)
        }
        ThicknessMethod::Nearest | ThicknessMethod::Laplace => None,
    };
    let mut thickness = wall.measured(method, axis.as_ref(), params, progress)?;
    for (value, &member) in thickness.iter_mut().zip(&wall.members) {
        // Vertices of the surface that are no part of the inner side have no wall in front of them.
        *value = value.filter(|value| member && value.is_finite());
    }
    Ok(ThicknessMap {
        method,
        surface: wall.surface,
        thickness,
    })
}

/// Both sides at one frame.
struct WallPose {
    inner: TriMesh,
    outer: TriMesh,
    surface: SurfaceKind,
    /// Whether each vertex of the surface is part of the inner side.
    members: Vec<bool>,
}

impl WallPose {
    fn of(subject: &Subject, frame: usize) -> Result<Self, ThicknessError> {
        let frames = subject.sequence.frame_count();
        let sides = wall_sides(&subject.sequence);
        let (inner, outer) = match (sides.inner, sides.outer, sides.unsplit) {
            (Some(inner), Some(outer), _) => (inner, outer),
            (_, _, Some(reason)) => return Err(reason.into()),
            (None, _, None) => return Err(ThicknessError::NoSide { missing: "inner" }),
            (_, None, None) => return Err(ThicknessError::NoSide { missing: "outer" }),
        };
        let at = |side: &Side<'_>| side.mesh(frame);
        let (Some(inner_mesh), Some(outer_mesh)) = (at(&inner), at(&outer)) else {
            return Err(ThicknessError::NoFrame { frame, frames });
        };
        Ok(Self {
            inner: inner_mesh,
            outer: outer_mesh,
            surface: inner.surface().kind(),
            members: inner.members(),
        })
    }

    fn measured(
        &self,
        method: ThicknessMethod,
        axis: Option<&LongAxis>,
        params: &CheckedThicknessParams,
        progress: &Progress,
    ) -> Result<Vec<Option<f64>>, ThicknessError> {
        let settings = params.get();
        match (method, axis) {
            (ThicknessMethod::Centreline, Some(axis)) => {
                let counts = [settings.slices, settings.chords].map(usize::from);
                Ok(centreline(
                    &self.inner,
                    &self.outer,
                    axis,
                    counts,
                    progress,
                )?)
            }
            (ThicknessMethod::VolumeOverArea, Some(axis)) => {
                let (_, _, spacing) = self.nearest(settings.voxels_across, progress)?;
                // Volumes are as right as voxels are small; half the side costs less than an equation.
                let voxels = WallVoxels::new(&self.inner, &self.outer, 0.5 * spacing, progress)?;
                let pieces = volume_over_area(&self.inner, &self.outer, &voxels, axis, progress)?;
                let at = |&vertex: &Point3| pieces[piece(axis, vertex)?];
                Ok(self.inner.vertices().iter().map(at).collect())
            }
            (ThicknessMethod::Laplace, _) => self.laplace(settings.voxels_across, progress),
            _ => {
                let (_, nearest, _) = self.nearest(settings.voxels_across, progress)?;
                let away =
                    |(vertex, near): (&Point3, Option<Point3>)| Some((near? - vertex).norm());
                Ok(self
                    .inner
                    .vertices()
                    .iter()
                    .zip(nearest)
                    .map(away)
                    .collect())
            }
        }
    }

    /// The outer side to look things up in, the nearest of its points for each vertex, and the side of
    /// a voxel of which as many as wanted lie across the median distance.
    fn nearest(
        &self,
        voxels_across: f64,
        progress: &Progress,
    ) -> Result<(ClosestPoint, Vec<Option<Point3>>, f64), ThicknessError> {
        let outer = ClosestPoint::new(self.outer.vertices(), self.outer.triangles())
            .ok_or(ThicknessError::NoSide { missing: "outer" })?;
        let vertices = self.inner.vertices();
        let nearest = nearest_points(vertices, &self.members, &outer, progress)?;
        let mut away: Vec<f64> = (vertices.iter().zip(&nearest))
            .filter_map(|(vertex, near)| Some((near.as_ref()? - vertex).norm()))
            .collect();
        // The median: where the wall is cut off at the base, nearest distances are no thickness.
        away.sort_unstable_by(f64::total_cmp);
        let median = away.get(away.len() / 2).copied().unwrap_or(0.0);
        Ok((outer, nearest, median / voxels_across))
    }

    /// Thickness of the field line halfway between each vertex and the nearest point of the outer side.
    fn laplace(
        &self,
        voxels_across: f64,
        progress: &Progress,
    ) -> Result<Vec<Option<f64>>, ThicknessError> {
        let (outer, nearest, spacing) = self.nearest(voxels_across, progress)?;
        let inner = ClosestPoint::new(self.inner.vertices(), self.inner.triangles())
            .ok_or(ThicknessError::NoSide { missing: "inner" })?;
        let voxels = WallVoxels::new(&self.inner, &self.outer, spacing, progress)?;
        let graph = voxels.graph(&inner, &outer, progress)?;
        let field = field_of(graph, progress)?;
        let at = |(vertex, near): (&Point3, Option<Point3>)| {
            // In the middle of the wall every corner of the cell is likely to be solved.
            voxels.sample(&field, nalgebra::center(vertex, &near?))
        };
        Ok(self.inner.vertices().iter().zip(nearest).map(at).collect())
    }
}

/// Thickness by every method that says something of a frame, each a part of the progress.
///
/// # Errors
/// [`Stopped`] if asked to stop; why a method says nothing is its own result.
pub fn all_methods(
    subject: &Subject,
    frame: usize,
    params: &CheckedThicknessParams,
    progress: &Progress,
) -> Result<Vec<Result<ThicknessMap, ThicknessError>>, Stopped> {
    let share = 1.0 / ThicknessMethod::ALL.len() as f32;
    let mut maps = Vec::new();
    for (place, method) in ThicknessMethod::ALL.into_iter().enumerate() {
        let from = place as f32 * share;
        let part = progress.part(method.name(), from, from + share);
        let map = thickness(subject, frame, method, params, &part);
        if map == Err(ThicknessError::Stopped(Stopped)) {
            return Err(Stopped);
        }
        maps.push(map);
    }
    Ok(maps)
}
