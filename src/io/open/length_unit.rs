//! What one unit of the coordinates is, where nobody says so.

use super::plan::StatedUnit;
use crate::mesh::Point3;
use crate::study::{MeshSequence, Notice, SurfaceKind};
use crate::units::LengthUnit;

/// Longest side of a ventricle's box that is plausible in millimetres. A left ventricle is 60 to
/// 130 mm long from apex to base, less at end-systole and in children, more with the box's slant;
/// images of 64 voxels and fewer hold hearts of at most 45 voxels.
const PLAUSIBLE_MM: std::ops::RangeInclusive<f64> = 50.0..=150.0;

/// Longest side that a ventricle can have, in millimetres: of small children to greatly enlarged ones.
const POSSIBLE_MM: std::ops::RangeInclusive<f64> = 20.0..=250.0;

/// The unit of a subject's coordinates, with the sentence that says why.
///
/// What is stated holds. Otherwise a ventricle of plausible size is taken as millimetres; anything
/// else keeps to file units, because a guess would be read as a measurement.
pub(super) fn length_unit(
    stated: Option<StatedUnit>,
    sequence: &MeshSequence,
) -> (LengthUnit, Option<Notice>) {
    let side = longest_side(sequence);
    match stated {
        Some(StatedUnit::Millimetres(_)) => {
            let is_heart = sequence
                .surfaces()
                .iter()
                .any(|s| s.kind() != SurfaceKind::Other);
            let absurd = is_heart && !POSSIBLE_MM.contains(&side);
            let notice = absurd.then(|| {
                Notice::warning(format!(
                    "unit mm, but the longest side is {}: volumes in ml are implausible; is the unit in study.toml right?",
                    millimetres(side)
                ))
            });
            (LengthUnit::Millimetre, notice)
        }
        Some(StatedUnit::FileUnits) => (LengthUnit::FileUnit, None),
        None if all_known(sequence) && PLAUSIBLE_MM.contains(&side) => (
            LengthUnit::Millimetre,
            Some(Notice::info(format!(
                "unit mm assumed, because the longest side is {}, as of a left ventricle; no file gives a unit",
                millimetres(side)
            ))),
        ),
        None if all_known(sequence) => (
            LengthUnit::FileUnit,
            Some(Notice::info(format!(
                "no unit of length given; a longest side of {side:.1} is too {} for a left ventricle in mm{}, so sizes are in file units, not in ml",
                if side < *PLAUSIBLE_MM.start() {
                    "short"
                } else {
                    "long"
                },
                offer(side)
            ))),
        ),
        None => (
            LengthUnit::FileUnit,
            Some(Notice::info(format!(
                "no unit of length given (the longest side is {side:.2}){}: sizes are in file units",
                offer(side)
            ))),
        ),
    }
}

/// Longest sides that are nearly certain to be millimetres, though not a usual ventricle's: small or dilated ones,
/// both ventricles, or a surface that is not named. Hearts in voxels are shorter.
const LIKELY_MM: std::ops::RangeInclusive<f64> = 46.0..=200.0;
/// And centimetres; longer ones may be voxels.
const LIKELY_CM: std::ops::RangeInclusive<f64> = 4.6..=14.0;
/// And metres.
const LIKELY_M: std::ops::RangeInclusive<f64> = 0.046..=0.2;

/// How a unit that is nearly certain, but not taken, is stated.
fn offer(side: f64) -> String {
    let (unit, how) = if LIKELY_MM.contains(&side) {
        ("mm", "--unit mm, or units = \"mm\" in study.toml")
    } else if LIKELY_CM.contains(&side) {
        ("cm", "units = \"cm\" in study.toml")
    } else if LIKELY_M.contains(&side) {
        ("m", "units = \"m\" in study.toml")
    } else {
        return String::new();
    };
    format!(" (it is probably in {unit}; if so, state it: {how})")
}

fn millimetres(length: f64) -> String {
    format!("{length:.0} mm")
}

fn all_known(sequence: &MeshSequence) -> bool {
    sequence
        .surfaces()
        .iter()
        .all(|surface| surface.kind() != SurfaceKind::Other)
}

/// The longest side of any frame's box around all surfaces.
fn longest_side(sequence: &MeshSequence) -> f64 {
    (0..sequence.frame_count())
        .filter_map(|frame| box_sides(&sequence.pose(frame)?))
        .fold(0.0, f64::max)
}

fn box_sides(points: &[Point3]) -> Option<f64> {
    let first = *points.first()?;
    let (low, high) = points
        .iter()
        .fold((first, first), |(low, high), p| (low.inf(p), high.sup(p)));
    Some((high - low).max())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::SurfaceSequence;

    fn ball(kind: SurfaceKind, radius: f64) -> MeshSequence {
        let surface = SurfaceSequence::new(kind, vec![phantom::sphere(2, radius)]).unwrap();
        MeshSequence::new(vec![surface]).unwrap()
    }

    #[test]
    fn a_ventricle_of_plausible_size_is_taken_as_millimetres_and_told() {
        let (unit, notice) = length_unit(None, &ball(SurfaceKind::Cavity, 40.0));
        assert_eq!(unit, LengthUnit::Millimetre);
        assert_eq!(
            notice.unwrap().text,
            "unit mm assumed, because the longest side is 80 mm, as of a left ventricle; no file gives a unit"
        );
    }

    #[test]
    fn voxels_and_unnamed_surfaces_stay_in_file_units() {
        let (unit, notice) = length_unit(None, &ball(SurfaceKind::Cavity, 14.0));
        assert_eq!(unit, LengthUnit::FileUnit);
        assert!(
            notice
                .unwrap()
                .text
                .ends_with("sizes are in file units, not in ml")
        );
        let (unit, _) = length_unit(None, &ball(SurfaceKind::Other, 40.0));
        assert_eq!(unit, LengthUnit::FileUnit);
    }

    #[test]
    fn a_unit_that_is_nearly_certain_is_offered_and_not_taken() {
        let note_of = |kind, radius| {
            let (unit, notice) = length_unit(None, &ball(kind, radius));
            assert_eq!(unit, LengthUnit::FileUnit);
            notice.unwrap().text
        };
        for (kind, radius, option) in [
            (SurfaceKind::Other, 45.0, "--unit mm"),
            (SurfaceKind::Cavity, 85.0, "--unit mm"),
            (SurfaceKind::Cavity, 4.5, "units = \"cm\""),
            (SurfaceKind::Cavity, 0.045, "units = \"m\""),
        ] {
            let text = note_of(kind, radius);
            assert!(text.contains(option), "{text}");
        }
        // Voxels of gated SPECT.
        assert!(!note_of(SurfaceKind::Cavity, 14.0).contains("state it"));
    }

    #[test]
    fn what_is_stated_holds() {
        let voxels = ball(SurfaceKind::Cavity, 40.0);
        assert_eq!(
            length_unit(Some(StatedUnit::FileUnits), &voxels),
            (LengthUnit::FileUnit, None)
        );
        let small = ball(SurfaceKind::Cavity, 0.04);
        let (unit, notice) = length_unit(Some(StatedUnit::Millimetres(1.0)), &small);
        assert_eq!(unit, LengthUnit::Millimetre);
        assert!(notice.is_some());
    }
}
