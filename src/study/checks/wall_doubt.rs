//! Is what lies between endocardium and epicardium the wall of a left ventricle?

use super::enclosed_volume::enclosed_volume;
use super::misplacement::Misplacement;
use super::nesting::Nesting;
use super::wall_extent::WallExtent;
use super::words::frames_phrase;
use crate::study::{MeshSequence, Notice, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

/// An epicardium that encloses more than this many times the endocardium's volume at its largest is in another unit
/// of length: hearts reach 2.9 at end-diastole, and walls of gated SPECT, the thickest, 11; a step between units
/// of length is 10 at least, and a step of volume 1,000.
const MAX_VOLUME_RATIO: f64 = 40.0;

/// Why a wall between two surfaces is not measured.
///
/// Why it matters: volumes of both surfaces are right each for itself, so that the mass between them looks
/// like any other mass.
#[derive(Clone, Debug, PartialEq)]
pub enum WallDoubt {
    /// The two do not lie in each other.
    Apart {
        /// The largest share of the endocardium outside the epicardium.
        outside: f64,
        /// In which frames; ascending.
        frames: Vec<usize>,
        /// Number of frames.
        of: usize,
        /// What would put them into each other.
        misplacement: Option<Misplacement>,
    },
    /// Their volumes are not of one unit.
    Sizes {
        /// Epicardial volume over endocardial volume at end-diastole.
        ratio: f64,
    },
    /// The outer surface is too far out.
    Extent(WallExtent),
}

impl WallDoubt {
    /// Looks at both surfaces, where there are two: in each other at every frame, and how far apart at the frame of
    /// the largest endocardium.
    pub fn of(sequence: &MeshSequence, unit: LengthUnit) -> Option<Self> {
        let endo = sequence
            .surface(SurfaceKind::Endocardium)
            .or_else(|| sequence.surface(SurfaceKind::Cavity))?;
        let epi = sequence.surface(SurfaceKind::Epicardium)?;
        let (inner, outer) = (volumes(endo), volumes(epi));
        let (largest, inner_volume) = (inner.iter().copied().enumerate())
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .unwrap_or((0, 0.0));
        // Swapped names are another finding, with words of its own.
        if inner
            .iter()
            .zip(&outer)
            .all(|(inner, outer)| inner >= outer)
            && Nesting::of(epi, endo).frames.is_empty()
        {
            return None;
        }
        let nesting = Nesting::of(endo, epi);
        if let Some(&first) = nesting.frames.first() {
            return Some(Self::Apart {
                outside: nesting.outside,
                misplacement: Misplacement::of(endo, epi, first),
                frames: nesting.frames,
                of: sequence.frame_count(),
            });
        }
        let ratio = outer[largest] / inner_volume;
        if ratio.is_finite() && ratio > MAX_VOLUME_RATIO {
            return Some(Self::Sizes { ratio });
        }
        WallExtent::of(endo, epi, largest, unit).map(Self::Extent)
    }

    /// Whether what lies between the surfaces at a frame is no wall.
    pub fn concerns(&self, frame: usize) -> bool {
        match self {
            Self::Apart { frames, .. } => frames.binary_search(&frame).is_ok(),
            Self::Sizes { .. } | Self::Extent(_) => true,
        }
    }

    /// What is wrong, in a sentence.
    pub fn sentence(&self) -> String {
        match self {
            Self::Apart {
                outside,
                frames,
                of,
                misplacement,
            } => {
                let place = match frames_phrase(frames, *of) {
                    phrase if phrase.is_empty() => String::new(),
                    phrase => format!(" in {phrase}"),
                };
                let cause = misplacement
                    .as_ref()
                    .map_or_else(String::new, |found| format!("; {}", found.sentence()));
                format!(
                    "endocardium and epicardium do not lie in each other: {:.0} % of the endocardium is outside the epicardium{place}, so no mass is given there{cause}",
                    100.0 * outside
                )
            }
            Self::Sizes { ratio } => format!(
                "the epicardium encloses {ratio:.0} times the volume of the endocardium: the two are probably in different units of length, so no mass is given"
            ),
            Self::Extent(extent) => extent.sentence(),
        }
    }

    /// What the load report says.
    pub fn notice(&self) -> Notice {
        Notice::warning(self.sentence())
    }
}

fn volumes(surface: &SurfaceSequence) -> Vec<f64> {
    let loops = surface.faces().boundary_loops();
    surface
        .frames()
        .iter()
        .map(|mesh| enclosed_volume(mesh.vertices(), mesh.triangles(), &loops).abs())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Point3, TriMesh, Vector3, phantom};
    use proptest::prelude::*;

    fn moved(mesh: &TriMesh, place: impl Fn(&Point3) -> Point3) -> TriMesh {
        let points: Vec<Point3> = mesh.vertices().iter().map(place).collect();
        TriMesh::new(points, mesh.faces().clone()).unwrap()
    }

    /// A wall of 10 mm on a scanner's table, each surface moved as asked.
    fn wall(inner: impl Fn(&Point3) -> Point3, outer: impl Fn(&Point3) -> Point3) -> MeshSequence {
        let on_table = |radius: f64| {
            moved(&phantom::bowl(radius, 8, 16), |p| {
                p + Vector3::new(40.0, -25.0, 110.0)
            })
        };
        let surface =
            |kind, frames: [TriMesh; 2]| SurfaceSequence::new(kind, frames.to_vec()).unwrap();
        MeshSequence::new(vec![
            surface(
                SurfaceKind::Endocardium,
                [25.0, 20.0].map(|radius| moved(&on_table(radius), &inner)),
            ),
            surface(
                SurfaceKind::Epicardium,
                [35.0, 33.0].map(|radius| moved(&on_table(radius), &outer)),
            ),
        ])
        .unwrap()
    }

    fn doubt(sequence: &MeshSequence) -> Option<String> {
        WallDoubt::of(sequence, LengthUnit::Millimetre).map(|doubt| doubt.sentence())
    }

    fn same(p: &Point3) -> Point3 {
        *p
    }

    #[test]
    fn surfaces_in_lps_and_ras_coordinates_are_told_with_the_likely_cause() {
        let flipped = |p: &Point3| Point3::new(-p.x, -p.y, p.z);
        for sequence in [wall(flipped, same), wall(same, flipped)] {
            let text = doubt(&sequence).unwrap();
            assert!(
                text.starts_with("endocardium and epicardium do not lie in each other: 100 %")
                    && text.contains("in both frames")
                    && text.contains("LPS"),
                "{text}"
            );
        }
        let mirrored = doubt(&wall(|p| Point3::new(p.x, -p.y, p.z), same)).unwrap();
        assert!(mirrored.contains("y negated"), "{mirrored}");
    }

    #[test]
    fn surfaces_in_other_units_or_places_are_told_with_the_likely_cause() {
        let cm = doubt(&wall(|p| p * 0.1, same)).unwrap();
        assert!(cm.contains("unit"), "{cm}");
        let metres = doubt(&wall(same, |p| p * 0.001)).unwrap();
        assert!(metres.contains("unit"), "{metres}");
        let shift = Vector3::new(0.0, 60.0, -35.0);
        let elsewhere = doubt(&wall(|p| p + shift, same)).unwrap();
        assert!(elsewhere.contains("moved by 67 units"), "{elsewhere}");
        let turned = doubt(&wall(|p| Point3::new(p.x, p.z, -p.y), same)).unwrap();
        assert!(turned.contains("axes"), "{turned}");
    }

    #[test]
    fn units_that_differ_at_the_origin_are_told_by_the_volumes() {
        let centred = |p: &Point3| Point3::from((p - Point3::new(40.0, -25.0, 105.0)) * 0.1);
        let outer = |p: &Point3| Point3::from(p - Point3::new(40.0, -25.0, 110.0));
        let text = doubt(&wall(centred, outer)).unwrap();
        assert!(text.contains("different units of length"), "{text}");
    }

    #[test]
    fn a_wall_is_no_wall_only_where_its_surfaces_part() {
        let sequence = {
            let sound = wall(same, same);
            let parted = wall(|p| p + Vector3::new(70.0, 0.0, 0.0), same);
            let frames = |kind| {
                let of = |sequence: &MeshSequence, frame: usize| {
                    sequence.surface(kind).unwrap().frames()[frame].clone()
                };
                SurfaceSequence::new(kind, vec![of(&sound, 0), of(&parted, 1)]).unwrap()
            };
            let kinds = [SurfaceKind::Endocardium, SurfaceKind::Epicardium];
            MeshSequence::new(kinds.map(frames).to_vec()).unwrap()
        };
        let found = WallDoubt::of(&sequence, LengthUnit::Millimetre).unwrap();
        assert_eq!([0, 1].map(|frame| found.concerns(frame)), [false, true]);
        assert!(
            found.sentence().contains("in frame 1"),
            "{}",
            found.sentence()
        );
    }

    #[test]
    fn swapped_surfaces_are_left_to_the_check_of_their_order() {
        let sheet =
            |kind, radius| SurfaceSequence::new(kind, vec![phantom::bowl(radius, 6, 12)]).unwrap();
        let swapped = MeshSequence::new(vec![
            sheet(SurfaceKind::Endocardium, 35.0),
            sheet(SurfaceKind::Epicardium, 25.0),
        ])
        .unwrap();
        assert_eq!(doubt(&swapped), None);
    }

    proptest! {
        #[test]
        fn a_sound_wall_stays_sound_wherever_it_stands(
            angles in proptest::array::uniform3(-3.0..3.0_f64),
            shift in proptest::array::uniform3(-1e8..1e8_f64),
        ) {
            let motion = nalgebra::Isometry3::new(shift.into(), angles.into());
            let sequence = wall(|p| motion * p, |p| motion * p);
            prop_assert_eq!(doubt(&sequence), None);
        }
    }
}
