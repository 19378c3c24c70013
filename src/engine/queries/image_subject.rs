//! The subject that walls of images make: with times, landmarks, and how it was made.

use crate::analysis::preparation::{Preparation, Prepared, TypedTimes, stated_image};
use crate::io::ImageSeries;
use crate::study::{CycleTiming, Notice, Subject};
use crate::units::{LengthUnit, Seconds};

/// The subject of walls that were prepared from a series.
pub(super) fn subject_of_walls(
    id: &str,
    series: &ImageSeries,
    prepared: &Prepared,
    settings: &Preparation,
) -> Subject {
    let measured = series.spacing_known() || settings.spacing_mm.is_some();
    let unit = match measured {
        true => LengthUnit::Millimetre,
        false => LengthUnit::FileUnit,
    };
    let mut subject = Subject::new(id, prepared.walls.sequence.clone(), unit);
    subject.anatomy = prepared.walls.anatomy;
    subject.timing = timing(series, prepared, settings);
    subject.notices.extend(series.notices.iter().cloned());
    subject.notices.extend(prepared.notices.iter().cloned());
    subject.notices.extend(prepared.walls.notices.iter().cloned());
    subject.notices.push(how_made(prepared, settings));
    subject
}

/// When the frames of the walls were taken: of the file, or as they were typed.
fn timing(series: &ImageSeries, prepared: &Prepared, settings: &Preparation) -> CycleTiming {
    let gated_ms = series.gates.as_ref().and_then(|gates| gates.cycle_ms);
    let cycle_ms = match settings.times {
        Some(TypedTimes::Cycle(ms)) => Some(ms),
        _ => gated_ms,
    };
    let stated = stated_image(&series.image, settings).ok();
    let times = stated.as_ref().and_then(|image| image.times_ms());
    let time_s = |times: &[f64]| -> Option<Vec<f64>> {
        let instants = prepared.instants.iter();
        instants.map(|n| Some(1e-3 * times.get(*n)?)).collect()
    };
    CycleTiming {
        frame_times_s: times.and_then(time_s).filter(|times| times.len() > 1),
        rr: cycle_ms.map(|ms| Seconds(1e-3 * ms)),
    }
}

fn how_made(prepared: &Prepared, settings: &Preparation) -> Notice {
    let points = settings.points;
    let marked = [points.apex, points.base, points.septum, points.blood];
    let marked = marked.into_iter().flatten().count();
    let fits = &prepared.walls.fits;
    let mean_mm = fits.iter().map(|fit| fit.mean_mm).fold(0.0, f64::max);
    Notice::info(format!(
        "walls made from {}: {marked} points marked, {} edits, {} outlines drawn; distance of the surfaces from the tissues at most \
         {mean_mm:.1} mm in the mean",
        settings.road.words(),
        settings.edits.len(),
        settings.contours.len()
    ))
}
