//! Whether two scenes draw the same: arrays of meshes are compared by who they are, not by what they hold.

use std::sync::Arc;

use super::{Lines, Points, Scene, Surface, SurfaceColour};

/// Whether two scenes certainly give the same picture. Costs nothing in the size of the meshes; marks, which are few and
/// made anew for each picture, are compared by their contents.
pub(super) fn same_scene(a: &Scene, b: &Scene) -> bool {
    a.background == b.background
        && same_lists(&a.surfaces, &b.surfaces, same_surface)
        && same_lists(&a.lines, &b.lines, same_lines)
        && same_lists(&a.points, &b.points, same_points)
}

fn same_lists<T>(a: &[T], b: &[T], same: impl Fn(&T, &T) -> bool) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b))
}

fn same_surface(a: &Surface, b: &Surface) -> bool {
    Arc::ptr_eq(&a.geometry, &b.geometry)
        && a.pose == b.pose
        && same_colour(&a.colour, &b.colour)
        && a.opacity == b.opacity
        && a.shading == b.shading
        && a.wireframe == b.wireframe
        && a.silhouette == b.silhouette
}

fn same_colour(a: &SurfaceColour, b: &SurfaceColour) -> bool {
    match (a, b) {
        (SurfaceColour::Uniform(a), SurfaceColour::Uniform(b)) => a == b,
        (
            SurfaceColour::Scalars {
                scalars: scalars_a,
                map: map_a,
                limits: limits_a,
                below: below_a,
                above: above_a,
            },
            SurfaceColour::Scalars {
                scalars: scalars_b,
                map: map_b,
                limits: limits_b,
                below: below_b,
                above: above_b,
            },
        ) => {
            Arc::ptr_eq(scalars_a, scalars_b)
                && Arc::ptr_eq(map_a, map_b)
                && limits_a == limits_b
                && below_a == below_b
                && above_a == above_b
        }
        _ => false,
    }
}

fn same_lines(a: &Lines, b: &Lines) -> bool {
    same_marks(&a.strips, &b.strips) && a.colour == b.colour && a.width == b.width
}

fn same_points(a: &Points, b: &Points) -> bool {
    same_marks(&a.positions, &b.positions)
        && same_marks(&a.colours, &b.colours)
        && a.diameter == b.diameter
}

fn same_marks<T: PartialEq>(a: &Arc<Vec<T>>, b: &Arc<Vec<T>>) -> bool {
    Arc::ptr_eq(a, b) || a == b
}
