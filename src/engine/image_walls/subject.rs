//! A subject of the walls of an image.

use crate::analysis::preparation::{
    ImageFacts, Preparation, Prepared, Road, TypedTimes, facts, stated_image,
};
use crate::engine::mask_walls::{how_near, masks_of};
use crate::io::{ImageSeries, Modality};
use crate::study::{CycleTiming, Notice, Subject};
use crate::units::{LengthUnit, Seconds};

/// What is known of a series that was read.
pub fn series_facts(series: &ImageSeries) -> ImageFacts {
    ImageFacts {
        spacing_known: series.spacing_known(),
        times_known: series.times_known(),
        ..facts(&series.image, series.modality)
    }
}

/// The subject of walls that were made of a series, with its times and how it was made.
pub fn prepared_subject(
    id: &str,
    series: &ImageSeries,
    preparation: &Preparation,
    prepared: Prepared,
) -> Subject {
    let known = series.spacing_known() || preparation.spacing_mm.is_some();
    let unit = match known {
        true => LengthUnit::Millimetre,
        false => LengthUnit::FileUnit,
    };
    let timing = timing(series, preparation, &prepared.instants);
    let near = how_near(&prepared.walls.fits, &made_from(series, preparation));
    let mut subject = Subject::new(id, prepared.walls.sequence, unit);
    subject.timing = timing;
    subject.anatomy = prepared.walls.anatomy;
    let typed = typed(preparation).map(Notice::info);
    let untimed = (subject.sequence.frame_count() > 1 && subject.timing == CycleTiming::default())
        .then(|| Notice::info("the files do not say the times of the volumes"));
    subject.notices = (series.notices.iter().cloned())
        .chain(typed)
        .chain(untimed)
        .chain(prepared.notices)
        .chain(prepared.walls.notices)
        .chain(near)
        .collect();
    subject
}

/// What walls were made from, in words.
fn made_from(series: &ImageSeries, preparation: &Preparation) -> String {
    let kind = series.modality.map_or("", Modality::letters);
    match preparation.road {
        Road::Masks(labels) => masks_of(&labels),
        Road::Spect => format!(
            "gated SPECT by its counts (blur {} mm)",
            preparation.blur_mm
        ),
        Road::Cine => format!("cine {kind} by marked points and edges").replace("  ", " "),
        Road::Contours => "drawn contours".to_owned(),
    }
}

/// What somebody typed because the file does not say it.
fn typed(preparation: &Preparation) -> Option<String> {
    let spacing = preparation
        .spacing_mm
        .map(|[i, j, k]| format!("distances between voxels set by the user: {i} × {j} × {k} mm"));
    let times = preparation.times.as_ref().map(|times| match times {
        TypedTimes::Cycle(ms) => format!("length of the beat set by the user: {ms} ms"),
        TypedTimes::Each(_) => "times of the volumes set by the user".to_owned(),
    });
    let all: Vec<String> = spacing.into_iter().chain(times).collect();
    (!all.is_empty()).then(|| all.join("; "))
}

/// Times of the volumes that have a frame, and the length of the beat.
fn timing(series: &ImageSeries, preparation: &Preparation, instants: &[usize]) -> CycleTiming {
    let stated = stated_image(&series.image, preparation).ok();
    let times = stated.as_ref().and_then(|image| image.times_ms());
    let kept = times.and_then(|times| {
        let of_frame = |&instant: &usize| Some(times.get(instant)? / 1000.0);
        instants.iter().map(of_frame).collect::<Option<Vec<f64>>>()
    });
    let cycle_ms = match preparation.times {
        Some(TypedTimes::Cycle(ms)) => Some(ms),
        Some(TypedTimes::Each(_)) => None,
        None => series.gates.as_ref().and_then(|gates| gates.cycle_ms),
    };
    CycleTiming {
        frame_times_s: kept.filter(|times| times.len() > 1),
        rr: cycle_ms.map(|ms| Seconds(ms / 1000.0)),
    }
}
