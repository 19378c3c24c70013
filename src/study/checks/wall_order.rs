//! Does the endocardium lie inside the epicardium?

use super::enclosed_volume::enclosed_volume;
use super::words::frames_phrase;
use crate::study::{MeshSequence, Notice, SurfaceSequence};

/// Frames in which the inner surface encloses at least as much as the outer one.
///
/// Why it matters: the myocardium is what lies between; swapped names give a negative mass and a subject
/// that is seen from the wrong side.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WallOrder {
    /// Frames whose endocardium is not the smaller one.
    pub swapped: Vec<usize>,
}

impl WallOrder {
    /// Compares enclosed volumes, where there are both surfaces.
    pub fn of(sequence: &MeshSequence) -> Self {
        let Some([endo, epi]) = sequence.wall_pair() else {
            return Self::default();
        };
        let swapped = volumes(endo)
            .zip(volumes(epi))
            .enumerate()
            .filter(|(_, (inner, outer))| inner >= outer)
            .map(|(frame, _)| frame)
            .collect();
        Self { swapped }
    }

    /// What the load report says, if any frame is wrong.
    pub fn notice(&self, sequence: &MeshSequence) -> Option<Notice> {
        if self.swapped.is_empty() {
            return None;
        }
        let count = sequence.frame_count();
        let place = match frames_phrase(&self.swapped, count) {
            phrase if phrase.is_empty() => String::new(),
            phrase => format!(" in {phrase}"),
        };
        Some(Notice::warning(format!(
            "the endocardium encloses no less than the epicardium{place}; are the two swapped?"
        )))
    }
}

fn volumes(surface: &SurfaceSequence) -> impl Iterator<Item = f64> {
    let loops = surface.faces().boundary_loops();
    surface
        .frames()
        .iter()
        .map(move |mesh| enclosed_volume(mesh.vertices(), mesh.triangles(), &loops).abs())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::SurfaceKind;

    fn heart(endo_radius: f64, epi_radius: f64) -> MeshSequence {
        let sheet =
            |kind, radius| SurfaceSequence::new(kind, vec![phantom::bowl(radius, 6, 12)]).unwrap();
        MeshSequence::new(vec![
            sheet(SurfaceKind::Endocardium, endo_radius),
            sheet(SurfaceKind::Epicardium, epi_radius),
        ])
        .unwrap()
    }

    #[test]
    fn swapped_sheets_are_told() {
        let swapped = heart(35.0, 25.0);
        assert_eq!(
            WallOrder::of(&swapped).notice(&swapped),
            Some(Notice::warning(
                "the endocardium encloses no less than the epicardium; are the two swapped?"
            ))
        );
        let sound = heart(25.0, 35.0);
        assert_eq!(WallOrder::of(&sound).notice(&sound), None);
    }
}
