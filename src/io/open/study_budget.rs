//! How much memory the meshes of a study may take that its files are too small for.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::io::{Limits, MeshFile};

/// Memory that a mesh takes of honest files at most, for each of their bytes: a packed VTP, a glTF of floats.
const USUAL_TIMES: u64 = 8;

/// What all files of a study share: one small file may unpack to much, but not each of many.
#[derive(Debug)]
pub(super) struct StudyBudget {
    left: AtomicU64,
    most: u64,
}

impl StudyBudget {
    pub(super) fn new(limits: &Limits) -> Self {
        Self {
            left: AtomicU64::new(limits.unpacked_in_study),
            most: limits.unpacked_in_study,
        }
    }

    /// The meshes of a file of so many bytes, if there is room for them.
    ///
    /// # Errors
    /// A sentence without the file's name.
    pub(super) fn taken(&self, file: MeshFile, file_bytes: usize) -> Result<MeshFile, String> {
        let vertices: usize = file.frames.iter().map(|mesh| mesh.vertices().len()).sum();
        let faces = file.frames.first().map_or(0, |mesh| mesh.triangles().len());
        let memory = (24 * vertices + 12 * faces) as u64;
        let excess = memory.saturating_sub(USUAL_TIMES * file_bytes as u64);
        let take = |left: u64| left.checked_sub(excess);
        match (self.left).fetch_update(Ordering::Relaxed, Ordering::Relaxed, take) {
            Ok(_) => Ok(file),
            Err(_) => Err(format!(
                "the meshes of the study take more than {} MiB beyond {USUAL_TIMES} times the size of their files (--max-unpacked)",
                self.most >> 20
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    #[test]
    fn files_that_unpack_to_much_share_one_budget_and_usual_ones_take_none() {
        let ball = phantom::sphere(2, 30.0);
        let memory = (24 * ball.vertices().len() + 12 * ball.triangles().len()) as u64;
        let limits = Limits {
            unpacked_in_study: 2 * memory,
            ..Limits::default()
        };
        let budget = StudyBudget::new(&limits);
        let file = || MeshFile {
            frames: vec![ball.clone()],
            times_s: None,
            notices: Vec::new(),
        };
        for _ in 0..100 {
            assert!(budget.taken(file(), memory as usize / 4).is_ok());
        }
        assert!(budget.taken(file(), 0).is_ok() && budget.taken(file(), 0).is_ok());
        let refused = budget.taken(file(), 10).unwrap_err();
        assert!(refused.contains("--max-unpacked"), "{refused}");
        assert!(
            budget.taken(file(), memory as usize).is_ok(),
            "usual files are read on"
        );
    }
}
