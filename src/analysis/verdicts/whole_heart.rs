//! Features of the whole heart, of any surface of a ventricle: volumes and mass by body size, shape, motion of the inner side.

use std::f64::consts::PI;

use rayon::prelude::*;

use crate::analysis::measures::{FrameMeasures, SubjectMeasures, measure_subject, wall_sides};
use crate::analysis::segments::long_axis;
use crate::mesh::{Point3, Vector3, vertex_areas};
use crate::study::checks::WallDoubt;
use crate::study::{Study, Subject};
use crate::units::LengthUnit;

use super::error::VerdictError;
use super::feature::Feature;
use super::features::Features;
use super::result::{Examined, NotAssessed};
use super::weighted::Weighted;

/// Fewest model features that a verdict on a subject without a wall is made of: ejection fraction, sphericity and
/// motion need no more than one closed or open surface.
const MIN_KNOWN: usize = 3;

/// What is known of every subject, its whole heart included.
///
/// # Errors
/// If the subjects are not those of the study.
pub(super) fn with_whole_hearts(
    study: &Study,
    examined: &[Result<Examined, NotAssessed>],
) -> Result<Vec<Result<Examined, NotAssessed>>, VerdictError> {
    if examined.len() != study.subjects.len() {
        return Err(VerdictError::Count {
            examined: examined.len(),
            subjects: study.subjects.len(),
        });
    }
    let known = (study.subjects.par_iter().zip(examined))
        .map(|(subject, examined)| match wall_in_doubt(subject) {
            Some(reason) if examined.is_ok() => Err(reason),
            _ => with_whole_heart(subject, examined.clone()),
        })
        .collect();
    Ok(known)
}

/// What is known of the whole heart beside its wall; alone where there is no wall, if that is enough.
fn with_whole_heart(
    subject: &Subject,
    examined: Result<Examined, NotAssessed>,
) -> Result<Examined, NotAssessed> {
    let (mut found, reason) = match examined {
        Ok(examined) => (examined, None),
        // A wall that is there and looks wrong puts volumes and shape in doubt, too; one that is not there does not.
        Err(reason @ NotAssessed::NoThickening(_)) => (Examined::default(), Some(reason)),
        Err(reason) => return Err(reason),
    };
    add_whole_heart(&mut found.features, subject);
    let known = found.features.model_features().iter().flatten().count();
    match reason {
        Some(reason) if known < MIN_KNOWN => Err(reason),
        _ => Ok(found),
    }
}

/// Why there is no verdict on what lies between two surfaces: they do not lie in each other, or the outer one is
/// not that of the left ventricle alone.
pub fn wall_in_doubt(subject: &Subject) -> Option<NotAssessed> {
    WallDoubt::of(&subject.sequence, subject.unit)
        .map(|doubt| NotAssessed::WallInDoubt(doubt.sentence()))
}

/// Adds what surfaces, height and weight tell of one subject; what they do not tell stays unknown.
///
/// Volumes and mass are indexed to body surface, √(height in cm × weight in kg / 3600) in m² (Mosteller 1987, N Engl J
/// Med 317:1098). Without millimetres there is no volume, mass or wall thickness that two subjects could be compared by;
/// ejection fraction, sphericity and motion need no unit.
fn add_whole_heart(features: &mut Features, subject: &Subject) {
    let measures = measure_subject(subject);
    let millimetres = measures.unit == LengthUnit::Millimetre;
    let indexed =
        |value: Option<f64>| Some(value.filter(|_| millimetres)? / body_surface_m2(subject)?);
    let mass = measures.mass.map(|mass| mass.0);
    let sphericity = |pose: Option<usize>| sphericity(subject, &measures, pose?);
    let motion = inward_motion(subject, &measures);
    for feature in Feature::ALL {
        let value = match feature {
            Feature::EjectionFraction => measures.ef,
            Feature::EdvIndex => indexed(measures.edv),
            Feature::EsvIndex => indexed(measures.esv),
            Feature::MassIndex => indexed(mass),
            Feature::MassToVolume => (measures.edv)
                .filter(|edv| millimetres && *edv > 0.0)
                .and_then(|edv| Some(mass? / edv)),
            Feature::SphericityEd => sphericity(measures.end_diastole),
            Feature::SphericityEs => sphericity(measures.end_systole),
            Feature::InwardSpread => motion.as_ref().map(Weighted::deviation),
            Feature::InwardTenth => motion.as_ref().map(|motion| motion.quantile(0.1)),
            Feature::WallEd | Feature::ThickestEd | Feature::WallEs | Feature::ThickestEs => {
                features.get(feature).filter(|_| millimetres)
            }
            // The others of the wall need no unit.
            Feature::AkineticShare
            | Feature::Median
            | Feature::RelativeSpread
            | Feature::ThicknessRatio
            | Feature::Spread
            | Feature::TenthPercentile
            | Feature::Remote
            | Feature::UpperRange
            | Feature::PatchShare
            | Feature::Confidence
            | Feature::PatchThickening
            | Feature::Compactness
            | Feature::MeanPoseDistance
            | Feature::NormalSpread
            | Feature::MeanPositionDistance => features.get(feature),
        };
        features.set(feature, value);
    }
    features.without_infinite();
}

fn body_surface_m2(subject: &Subject) -> Option<f64> {
    let area = (subject.height_cm? * subject.weight_kg? / 3600.0).sqrt();
    (area > 0.0).then_some(area)
}

/// Volume of the cavity over that of a sphere as wide as the ventricle is long: 1 for a sphere.
fn sphericity(subject: &Subject, measures: &SubjectMeasures, pose: usize) -> Option<f64> {
    let volume = |frame: &FrameMeasures| frame.endo_volume;
    let cubic = volume(measures.frames.get(pose)?)? / measures.unit.volume_from_cubic();
    let length = long_axis(subject, pose).ok()?.length();
    (length > 0.0).then(|| cubic / (PI / 6.0 * length.powi(3)))
}

/// Share of its distance from the centroid by which each vertex of the inner side comes nearer from end-diastole to
/// end-systole, with its area; vertices are taken to be the same tissue, or the same place of the wall.
fn inward_motion(subject: &Subject, measures: &SubjectMeasures) -> Option<Weighted> {
    let (ed, es) = (measures.end_diastole?, measures.end_systole?);
    let sides = wall_sides(&subject.sequence);
    let side = sides.inner.as_ref().or(sides.outer.as_ref())?;
    let areas = vertex_areas(side.vertices(ed), side.faces().triangles());
    let [rest, contracted] = [ed, es].map(|pose| {
        let points = side.vertices(pose);
        let own = (vertex_areas(points, side.faces().triangles()).into_iter()).zip(points);
        let (sum, area) = own.fold((Vector3::zeros(), 0.0), |(sum, whole), (area, point)| {
            (sum + point.coords * area, whole + area)
        });
        let centre = Point3::from(sum / f64::max(area, f64::MIN_POSITIVE));
        points
            .iter()
            .map(|point| (point - centre).norm())
            .collect::<Vec<f64>>()
    });
    let moved: Vec<f64> = (rest.iter().zip(&contracted))
        // A vertex in the centroid has no distance to lose a share of.
        .map(|(a, b)| if *a > 0.0 { 1.0 - b / a } else { 0.0 })
        .collect();
    let motion = Weighted::new(&moved, &areas);
    (motion.whole() > 0.0).then_some(motion)
}
