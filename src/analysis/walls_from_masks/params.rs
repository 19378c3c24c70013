//! Settings of walls from masks.

use crate::mesh::Point3;

/// What can be set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallParams {
    /// Vertices of each surface at most.
    pub vertices: usize,
    /// Whether slices that stand beside their neighbours (another breath-hold) are put back.
    pub correct_shifts: bool,
    /// A point of the septum or beyond it in the world of the masks, where somebody marked one: only its direction from the
    /// axis counts, and it wins over what the masks show.
    pub septum: Option<Point3>,
}

impl Default for WallParams {
    /// 800 vertices: triangles of some 4 mm, finer than the slices of most studies are thick.
    fn default() -> Self {
        Self {
            vertices: 800,
            correct_shifts: true,
            septum: None,
        }
    }
}

/// Fewest vertices: the coarsest grid over a ventricle has 55.
const MIN_VERTICES: usize = 55;
/// Most vertices: far finer than any mask.
const MAX_VERTICES: usize = 100_000;

/// A setting out of range.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum WallParamsError {
    /// The number of vertices.
    #[error("{0} vertices a surface; {MIN_VERTICES} to {MAX_VERTICES} are possible")]
    Vertices(usize),
    /// The point of the septum.
    #[error("the coordinates of the septum are not finite numbers")]
    Septum,
}

/// Settings in range.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckedWallParams(WallParams);

impl WallParams {
    /// Checks the ranges.
    ///
    /// # Errors
    /// If the number of vertices is out of range, or the septum nowhere.
    pub fn check(self) -> Result<CheckedWallParams, WallParamsError> {
        if !(MIN_VERTICES..=MAX_VERTICES).contains(&self.vertices) {
            return Err(WallParamsError::Vertices(self.vertices));
        }
        match self
            .septum
            .iter()
            .all(|septum| septum.iter().all(|x| x.is_finite()))
        {
            true => Ok(CheckedWallParams(self)),
            false => Err(WallParamsError::Septum),
        }
    }
}

impl CheckedWallParams {
    /// The settings.
    pub(super) fn get(&self) -> WallParams {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_vertices_out_of_range_are_refused() {
        let with = |vertices| WallParams {
            vertices,
            ..WallParams::default()
        };
        assert!(WallParams::default().check().is_ok());
        for vertices in [0, 54, 100_001] {
            assert_eq!(
                with(vertices).check(),
                Err(WallParamsError::Vertices(vertices))
            );
        }
    }
}
