//! Does a surface jump between frames?

use super::words::frames_phrase;
use crate::mesh::TriMesh;
use crate::study::{Notice, SurfaceSequence};

/// A step counts as a jump where vertices move by more than this share of the surface's extent
/// (root mean square against the diagonal of its box). A whole beat of a healthy subject moves them by
/// 0.05 to 0.1; vertices in another order move them by about 0.4.
const JUMP: f64 = 0.25;

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
}

impl SuddenJumps {
    /// Measures every step from frame to frame.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let mut found = Self::default();
        for (earlier, pair) in surface.frames().windows(2).enumerate() {
            let step = relative_step(&pair[0], &pair[1]);
            if step > JUMP {
                found.frames.push(earlier + 1);
                found.largest_percent = found.largest_percent.max((100.0 * step).round() as usize);
            }
        }
        found
    }

    /// What the load report says, if there are any.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        (!self.frames.is_empty()).then(|| {
            Notice::warning(format!(
                "{}: vertices jump by up to {} % of its extent into {}; they may not correspond",
                surface.kind().name(),
                self.largest_percent,
                frames_phrase(&self.frames, surface.frames().len())
            ))
        })
    }
}

/// √(mean |Δ|²) over the box's diagonal of the first mesh; zero where it has no extent.
fn relative_step(first: &TriMesh, second: &TriMesh) -> f64 {
    let count = first.vertices().len().max(1) as f64;
    let squares: f64 = first
        .vertices()
        .iter()
        .zip(second.vertices())
        .map(|(a, b)| (b - a).norm_squared())
        .sum();
    let diagonal = diagonal(first);
    if diagonal > 0.0 {
        (squares / count).sqrt() / diagonal
    } else {
        0.0
    }
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
    use crate::mesh::{Point3, phantom};
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
