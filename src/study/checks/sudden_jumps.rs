//! Does a surface jump between frames?

use super::words::{counted, frames_phrase};
use crate::mesh::{Point3, TriMesh};
use crate::study::{Notice, SurfaceSequence};

/// A step counts as a jump where vertices move by more than this share of the surface's extent
/// (root mean square against the diagonal of its box). A whole beat of a healthy subject moves them by
/// 0.05 to 0.1; vertices in another order move them by about 0.4.
const JUMP: f64 = 0.25;
/// One vertex that moves by more than this share, and by far more than the others, is out of place. Vertices of the base of
/// a healthy subject move by up to 0.2.
const STRAY: f64 = 0.3;
/// How many times the root mean square that is: of a motion, the largest step is about three times it.
const FAR_MORE: f64 = 3.5;

/// Steps between frames in which vertices move too far.
///
/// Why it matters: frames whose vertices do not correspond, or that lie in different coordinates,
/// look like subjects one by one, and every motion between them is meaningless.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct SuddenJumps {
    /// Frames that lie too far from the frame before.
    pub frames: Vec<usize>,
    /// The largest step in per cent of the extent.
    pub largest_percent: usize,
    /// Frames into which single vertices move too far, as where missing numbers are written as zeros.
    pub stray_frames: Vec<usize>,
    /// The most of them in one frame.
    pub stray_vertices: usize,
}

impl SuddenJumps {
    /// Measures every step from frame to frame.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let mut found = Self::default();
        // Many that move far are a part that moves, such as a limb.
        let few = 1 + surface.faces().vertex_count() / 100;
        for (earlier, pair) in surface.frames().windows(2).enumerate() {
            let (step, stray) = relative_step(&pair[0], &pair[1]);
            if (1..=few).contains(&stray) && step <= JUMP {
                found.stray_frames.push(earlier + 1);
                found.stray_vertices = found.stray_vertices.max(stray);
            }
            if step > JUMP {
                found.frames.push(earlier + 1);
                found.largest_percent = found.largest_percent.max((100.0 * step).round() as usize);
            }
        }
        found
    }

    /// What the load report says, if there are any.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        let into = |frames: &[usize]| frames_phrase(frames, surface.frames().len());
        let name = surface.kind().name();
        if !self.frames.is_empty() {
            return Some(Notice::warning(format!(
                "{name}: vertices jump by up to {} % of its extent into {}; they may not correspond",
                self.largest_percent,
                into(&self.frames)
            )));
        }
        (!self.stray_frames.is_empty()).then(|| {
            let stray = counted(self.stray_vertices, "vertex jumps", "vertices jump");
            Notice::warning(format!(
                "{name}: {stray} far beyond all others into {}; are these coordinates missing or wrong?",
                into(&self.stray_frames)
            ))
        })
    }
}

/// √(mean |Δ|²) over the box's diagonal of the first mesh, and how many vertices are out of place beside it; zeros where it
/// has no extent.
fn relative_step(first: &TriMesh, second: &TriMesh) -> (f64, usize) {
    let count = first.vertices().len().max(1) as f64;
    let pairs = || first.vertices().iter().zip(second.vertices());
    let diagonal = diagonal(first);
    if diagonal == 0.0 {
        return (0.0, 0);
    }
    let rms = |squares: f64, count: f64| (squares / count.max(1.0)).sqrt() / diagonal;
    let squares: f64 = pairs().map(|(a, b)| (b - a).norm_squared()).sum();
    // Of the others alone: a vertex far away would make its own step usual.
    let far = |a: &Point3, b: &Point3| (b - a).norm() > STRAY * diagonal;
    let near = pairs().filter(|(a, b)| !far(a, b));
    let (of_near, near) = near.fold((0.0, 0.0), |(sum, count), (a, b)| {
        (sum + (b - a).norm_squared(), count + 1.0)
    });
    let least = (FAR_MORE * rms(of_near, near)).max(STRAY) * diagonal;
    let stray = pairs().filter(|(a, b)| (*b - *a).norm() > least).count();
    (rms(squares, count), stray)
}

/// Length of the bounding box's diagonal.
fn diagonal(mesh: &TriMesh) -> f64 {
    let Some(&first) = mesh.vertices().first() else {
        return 0.0;
    };
    let (low, high) = mesh
        .vertices()
        .iter()
        .fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)));
    (high - low).norm()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::SurfaceKind;

    #[test]
    fn a_renumbered_frame_jumps_and_a_contraction_does_not() {
        let rest = phantom::sphere(2, 30.0);
        let beat = phantom::sphere(2, 22.0);
        let mut shuffled = rest.vertices().to_vec();
        shuffled.reverse();
        let shuffled = TriMesh::new(shuffled, rest.faces().clone()).unwrap();
        let frames = vec![rest, beat.clone(), shuffled, beat];
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        let found = SuddenJumps::of(&surface);
        assert_eq!(found.frames, [2, 3]);
        assert!(
            found
                .notice(&surface)
                .unwrap()
                .text
                .ends_with("% of its extent into frames 2, 3; they may not correspond")
        );
    }

    #[test]
    fn a_vertex_that_is_zero_in_one_frame_is_told_and_a_contraction_is_not() {
        let at = |radius: f64| -> Vec<Point3> {
            let ball = phantom::sphere(2, radius);
            ball.vertices()
                .iter()
                .map(|p| Point3::new(p.x + 80.0, p.y, p.z))
                .collect()
        };
        let faces = phantom::sphere(2, 1.0).faces().clone();
        let mesh = |points: Vec<Point3>| TriMesh::new(points, faces.clone()).unwrap();
        let surface = |frames| SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        let sound = surface(vec![mesh(at(30.0)), mesh(at(18.0)), mesh(at(26.0))]);
        assert_eq!(SuddenJumps::of(&sound), SuddenJumps::default());
        let mut damaged = at(18.0);
        damaged[7] = Point3::origin();
        let odd = surface(vec![mesh(at(30.0)), mesh(damaged), mesh(at(26.0))]);
        assert_eq!(
            SuddenJumps::of(&odd).notice(&odd).unwrap().text,
            "cavity: 1 vertex jumps far beyond all others into frames 1, 2; are these coordinates missing or wrong?"
        );
    }

    #[test]
    fn frames_in_other_coordinates_jump() {
        let here = phantom::sphere(1, 30.0);
        let moved: Vec<Point3> = here
            .vertices()
            .iter()
            .map(|p| Point3::new(p.x + 100.0, p.y, p.z))
            .collect();
        let there = TriMesh::new(moved, here.faces().clone()).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![here, there]).unwrap();
        assert_eq!(SuddenJumps::of(&surface).frames, [1]);
    }
}
