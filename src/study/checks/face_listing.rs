//! Do all frames list their faces in the same way?

use super::words::frames_phrase;
use crate::mesh::{FaceOrder, TriMesh};
use crate::study::{Notice, SurfaceKind};

/// Frames that list the faces of frame 0 in another way.
///
/// Why it matters: vertices correspond by their numbers, so such frames are one surface; but a program that
/// sorts faces may have sorted vertices, too, which [`SuddenJumps`](super::SuddenJumps) tells.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FaceListing {
    /// Frames with the same faces in another order, or beginning with another corner.
    pub reordered: Vec<usize>,
    /// Frames some or all of whose faces wind the other way round.
    pub rewound: Vec<usize>,
    /// Frames that cut faces of four corners along another diagonal.
    pub recut: Vec<usize>,
    frames: usize,
}

impl FaceListing {
    /// Compares the frames of a surface as they were read.
    pub fn of(frames: &[TriMesh]) -> Self {
        let mut found = Self {
            frames: frames.len(),
            ..Self::default()
        };
        let Some(first) = frames.first() else {
            return found;
        };
        for (frame, mesh) in frames.iter().enumerate().skip(1) {
            match FaceOrder::of(first.faces(), mesh.faces()) {
                FaceOrder::Same | FaceOrder::Different => {}
                FaceOrder::Reordered => found.reordered.push(frame),
                FaceOrder::Rewound => found.rewound.push(frame),
                FaceOrder::Recut => found.recut.push(frame),
            }
        }
        found
    }

    /// What the load report says, if there are any.
    pub fn notices(&self, kind: SurfaceKind) -> Vec<Notice> {
        let texts = |frames: &[usize], how: &str| {
            (!frames.is_empty()).then(|| {
                Notice::info(format!(
                    "{}: the same faces as in frame 0, but {how}, in {}; vertices correspond by their numbers, and frame 0's faces are used",
                    kind.name(),
                    frames_phrase(frames, self.frames)
                ))
            })
        };
        texts(&self.reordered, "in another order")
            .into_iter()
            .chain(texts(&self.rewound, "wound the other way round"))
            .chain(texts(
                &self.recut,
                "with quadrilaterals cut along the other diagonal",
            ))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, phantom};
    use crate::study::{MeshSequence, SurfaceSequence};

    fn relisted(mesh: &TriMesh, change: impl Fn(&mut Vec<[u32; 3]>)) -> TriMesh {
        let mut triangles = mesh.triangles().to_vec();
        change(&mut triangles);
        let faces = Faces::new(mesh.vertices().len(), triangles).unwrap();
        TriMesh::new(mesh.shared_vertices(), faces).unwrap()
    }

    #[test]
    fn frames_that_list_the_same_faces_in_another_way_are_one_surface_and_told() {
        let ball = phantom::sphere(2, 30.0);
        let frames = vec![
            ball.clone(),
            relisted(&ball, |faces| faces.reverse()),
            relisted(&ball, |faces| {
                faces.iter_mut().for_each(|f| f.rotate_left(2));
            }),
            relisted(&ball, |faces| faces.iter_mut().for_each(|f| f.swap(0, 1))),
        ];
        let texts: Vec<String> = FaceListing::of(&frames)
            .notices(SurfaceKind::Cavity)
            .into_iter()
            .map(|notice| notice.text)
            .collect();
        assert_eq!(texts.len(), 2);
        assert!(
            texts[0].contains("in another order, in frames 1, 2"),
            "{texts:?}"
        );
        assert!(
            texts[1].contains("wound the other way round, in frame 3"),
            "{texts:?}"
        );
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        assert!(
            surface
                .frames()
                .iter()
                .all(|mesh| mesh.faces() == ball.faces())
        );
        let key = |mesh: &TriMesh| {
            let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![mesh.clone()]).unwrap();
            MeshSequence::new(vec![surface]).unwrap().correspondence()
        };
        let relisted_subject = relisted(&ball, |faces| {
            faces.reverse();
            faces[3].rotate_left(1);
        });
        assert_eq!(key(&ball), key(&relisted_subject));
        let other = vec![ball.clone(), relisted(&ball, |faces| faces[0] = faces[1])];
        assert!(
            FaceListing::of(&other)
                .notices(SurfaceKind::Cavity)
                .is_empty()
        );
        assert!(SurfaceSequence::new(SurfaceKind::Cavity, other).is_err());
    }
}
