//! Measures of one subject and of all subjects of a study.

use rayon::prelude::*;

use crate::mesh::{Point3, bounding_box};
use crate::numeric::in_waves;
use crate::progress::{Progress, Stopped};
use crate::study::checks::WallDoubt;
use crate::study::{Study, Subject};
use crate::units::{Grams, LengthUnit};

use super::result::{FrameMeasures, MeasureNote, PhaseSource, SubjectMeasures};
use super::volumes::{SubjectGeometry, UnknownVolume};

/// Density of myocardium in g/ml, by which its volume becomes a mass.
///
/// Source: Taimouri, *Shape Analysis in Shape Space*, 4.1.1 (printed there as g/cm).
const MUSCLE_DENSITY_G_PER_ML: f64 = 1.05;

/// Sizes of one subject at every frame, its phases, ejection fraction and mass.
///
/// Open surfaces are closed at each boundary loop by a flat fan to the loop's centroid; volumes
/// follow from the divergence theorem and are positive whichever way faces are wound.
/// EF = (EDV − ESV) / EDV. Frames of end-diastole and end-systole are those that the subject
/// states, or the extremes of the endocardial volume, the first if there are several.
/// What cannot be determined is `None`; [`unknown_volumes`] says why.
pub fn measure_subject(subject: &Subject) -> SubjectMeasures {
    // A progress that nobody holds is never stopped.
    measure(subject, &Progress::default()).unwrap_or_else(|Stopped| no_measures(subject))
}

/// [`measure_subject`] of each subject, in their order; a step per frame.
///
/// # Errors
/// [`Stopped`] if asked to stop.
pub fn measure_study(study: &Study, progress: &Progress) -> Result<Vec<SubjectMeasures>, Stopped> {
    let frames = study
        .subjects
        .iter()
        .map(|subject| subject.sequence.frame_count())
        .sum();
    progress.expect_steps(frames);
    in_waves(&study.subjects, 1, |wave| {
        (wave.par_iter())
            .map(|subject| measure(subject, progress))
            .collect()
    })
}

/// Why volumes of a subject are `None`.
pub fn unknown_volumes(subject: &Subject) -> Vec<UnknownVolume> {
    SubjectGeometry::new(subject).unknown
}

fn measure(subject: &Subject, progress: &Progress) -> Result<SubjectMeasures, Stopped> {
    let geometry = SubjectGeometry::new(subject);
    let doubt = WallDoubt::of(&subject.sequence, subject.unit);
    let mut measured = no_measures(subject);
    for frame in 0..subject.sequence.frame_count() {
        let mut sizes = frame_measures(subject, &geometry, frame);
        // Both surfaces have their volumes, but what lies between them is no myocardium.
        if doubt.as_ref().is_some_and(|doubt| doubt.concerns(frame)) {
            sizes.wall_volume = None;
        }
        measured.frames.push(sizes);
        progress.step()?;
    }
    find_phases(subject, &mut measured);
    find_ejection(subject, &mut measured);
    if let Some(doubt) = doubt {
        measured.notes.push(MeasureNote::Wall(doubt.sentence()));
    }
    // Without phases, as of a wall whose cavity is not known, the first frame stands for all.
    let wall_ml = measured
        .frames
        .get(measured.end_diastole.unwrap_or(0))
        .and_then(|frame| frame.wall_volume);
    // Density is per millilitre: without a unit there is no mass.
    if subject.unit == LengthUnit::Millimetre {
        measured.mass = wall_ml.map(|ml| Grams(MUSCLE_DENSITY_G_PER_ML * ml));
    }
    Ok(measured)
}

fn no_measures(subject: &Subject) -> SubjectMeasures {
    SubjectMeasures {
        unit: subject.unit,
        frames: Vec::new(),
        end_diastole: None,
        end_systole: None,
        phase_source: PhaseSource::VolumeCurve,
        edv: None,
        esv: None,
        sv: None,
        ef: None,
        mass: None,
        notes: Vec::new(),
    }
}

fn frame_measures(
    subject: &Subject,
    geometry: &SubjectGeometry<'_>,
    frame: usize,
) -> FrameMeasures {
    let sizes = geometry.at(frame);
    let (cubic, square) = (
        subject.unit.volume_from_cubic(),
        subject.unit.area_from_square(),
    );
    // Very large coordinates overflow in cubes, and infinity is no volume.
    let finite = |value: f64| Some(value).filter(|value| value.is_finite());
    let points = subject
        .sequence
        .surfaces()
        .iter()
        .flat_map(|surface| surface.frames()[frame].vertices());
    let corner = |point: Point3| [point.x, point.y, point.z];
    FrameMeasures {
        endo_volume: sizes.endo.and_then(|endo| finite(cubic * endo.volume)),
        epi_volume: sizes.epi.and_then(|epi| finite(cubic * epi.volume)),
        wall_volume: sizes.wall_volume.and_then(|volume| finite(cubic * volume)),
        endo_area: sizes.endo.and_then(|endo| finite(square * endo.area)),
        epi_area: sizes.epi.and_then(|epi| finite(square * epi.area)),
        bounding_box: bounding_box(points)
            .map_or_else(Default::default, |[low, high]| [corner(low), corner(high)]),
    }
}

/// Volumes that differ by less than this share of the larger one are equal but for rounding.
const EQUAL_VOLUMES: f64 = 1e-9;

/// EDV and ESV, and what follows from them where they are volumes of two frames that differ.
fn find_ejection(subject: &Subject, measured: &mut SubjectMeasures) {
    let volume_at = |frame: Option<usize>| measured.frames.get(frame?)?.endo_volume;
    let (edv, esv) = (
        volume_at(measured.end_diastole),
        volume_at(measured.end_systole),
    );
    (measured.edv, measured.esv) = (edv, esv);
    let still = subject.sequence.frame_count() == 1;
    let note = match (measured.end_diastole, measured.end_systole, edv, esv) {
        (None, Some(_), _, Some(_)) if still => MeasureNote::EndSystoleOnly,
        (Some(_), None, Some(_), _) if still => MeasureNote::OneFrame,
        (_, Some(_), Some(_), _) if !still && constant(&measured.frames) => {
            MeasureNote::EqualVolumes
        }
        (Some(diastole), Some(systole), Some(_), _) if diastole == systole => {
            MeasureNote::SameFrame(diastole)
        }
        (None, Some(frame), _, Some(_)) | (Some(frame), None, Some(_), _) => {
            MeasureNote::SameFrame(frame)
        }
        (_, _, Some(edv), Some(esv)) if equal(edv, esv) => MeasureNote::EqualVolumes,
        (_, _, Some(edv), Some(esv)) => {
            measured.sv = Some(edv - esv);
            measured.ef = Some((edv - esv) / edv).filter(|ef| ef.is_finite());
            return;
        }
        _ => return,
    };
    measured.notes.push(note);
}

fn equal(a: f64, b: f64) -> bool {
    (a - b).abs() <= EQUAL_VOLUMES * a.max(b)
}

/// Whether the cavity has the same volume at every frame at which it has one.
fn constant(frames: &[FrameMeasures]) -> bool {
    let mut volumes = frames.iter().filter_map(|frame| frame.endo_volume);
    let first = volumes.next();
    first.is_some_and(|first| volumes.all(|volume| equal(first, volume)))
}

/// Frames of end-diastole and end-systole of a subject as it is now: what is stated counts at once, what is measured as
/// soon as it is known. `find_phases` decides the same with the volumes at hand.
pub fn phases_of(
    subject: &Subject,
    measures: Option<&SubjectMeasures>,
) -> (Option<usize>, Option<usize>) {
    let (end_diastole, end_systole) = subject.stated_phases();
    (
        end_diastole.or(measures.and_then(|known| known.end_diastole)),
        end_systole.or(measures.and_then(|known| known.end_systole)),
    )
}

/// A single frame is end-diastole and has no end-systole, or what the input says it is, so that no motion is made up.
fn find_phases(subject: &Subject, measured: &mut SubjectMeasures) {
    let count = measured.frames.len();
    let volumes: Vec<(usize, f64)> = measured
        .frames
        .iter()
        .enumerate()
        .filter_map(|(frame, sizes)| Some((frame, sizes.endo_volume?)))
        .collect();
    let extreme = |sign: f64| {
        volumes
            .iter()
            // From the end, since `max_by` takes the last of equals: the first frame wins.
            .rev()
            .max_by(|a, b| (sign * a.1).total_cmp(&(sign * b.1)))
            .map(|&(frame, _)| frame)
    };
    let (stated_ed, stated_es) = subject.stated_phases();
    if stated_ed.is_some() || stated_es.is_some() {
        measured.phase_source = PhaseSource::Stated;
    }
    // A frame is one phase, unless the input calls it both: an ejection fraction of zero would be made up.
    let other_than = |stated: Option<usize>, frame: Option<usize>| {
        frame.filter(|_| stated.is_none() || stated != frame)
    };
    measured.end_diastole = stated_ed.or_else(|| other_than(stated_es, extreme(1.0)));
    measured.end_systole =
        stated_es.or_else(|| other_than(stated_ed, extreme(-1.0)).filter(|_| count > 1));
}
