//! What the frames in the names of a subject's files say: phases, times, gaps in the numbering.

use std::collections::BTreeSet;

use super::frame_name::{FrameName, FrameNumber, NumberUnit};
use super::plan::Stated;
use super::plan::{SeriesTimes, TimesSource};
use crate::study::Notice;
use crate::study::checks::counted;

/// Takes phases and times from the frames in names, which are in the order of frames, and tells what was assumed.
pub(super) fn take_facts(
    frames: &[FrameName],
    stated: &mut Stated,
    notices: &mut Vec<Notice>,
) -> Option<SeriesTimes> {
    notices.extend(numbering_notice(frames));
    name_phases(frames, stated, notices);
    let numbers: Vec<FrameNumber> = frames.iter().filter_map(number).collect();
    if numbers.len() < 2 {
        return None;
    }
    if numbers.len() < frames.len() {
        notices.push(Notice::warning(
            "some files are named by a phase and some by a number: their order in time is not known, and the phases are put first",
        ));
        return None;
    }
    let units: BTreeSet<NumberUnit> = numbers.iter().map(|number| number.unit()).collect();
    let source = match units.first() {
        Some(_) if units.len() > 1 => {
            notices.push(Notice::warning(
                "file names give numbers in different units: the order of the frames may be wrong",
            ));
            return None;
        }
        Some(NumberUnit::Seconds) => TimesSource::NamesInSeconds,
        Some(NumberUnit::Percent) => TimesSource::NamesInPercent,
        _ if numbers.iter().any(|number| number.count().is_none()) => TimesSource::Names,
        _ => return None,
    };
    let values = numbers.iter().map(|number| number.value()).collect();
    Some(SeriesTimes { values, source })
}

fn number(frame: &FrameName) -> Option<FrameNumber> {
    match frame {
        FrameName::Number(number) => Some(*number),
        _ => None,
    }
}

/// Numbers that skip some: an even step gives a note, a gap a warning.
fn numbering_notice(frames: &[FrameName]) -> Option<Notice> {
    let numbers: Vec<FrameNumber> = frames.iter().filter_map(number).collect();
    let numbers: Vec<i128> = numbers
        .iter()
        .map(|number| number.count())
        .collect::<Option<_>>()?;
    let steps: BTreeSet<i128> = numbers.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let (first, last) = (numbers.first()?, numbers.last()?);
    if *last < 0 && numbers.len() > 1 {
        return Some(Notice::warning(format!(
            "numbers in the file names read as negative, {first} to {last}: frames are in that order"
        )));
    }
    match steps.first() {
        None | Some(1) if steps.len() <= 1 => None,
        Some(step) if steps.len() == 1 && numbers.len() > 2 => Some(Notice::info(format!(
            "files are numbered {first} to {last} in steps of {step}: {} frames, assumed evenly spaced",
            numbers.len()
        ))),
        _ => {
            let missing = last - first + 1 - numbers.len() as i128;
            let gap = numbers.windows(2).find(|pair| pair[1] - pair[0] > 1)?;
            let missing = counted(
                usize::try_from(missing).unwrap_or(usize::MAX),
                "number is",
                "numbers are",
            );
            Some(Notice::warning(format!(
                "{missing} missing between file {first} and file {last} (the first is {}): the motion jumps there",
                gap[0] + 1
            )))
        }
    }
}

/// Takes end-diastole and end-systole from names that say them, where nothing else states them.
fn name_phases(frames: &[FrameName], stated: &mut Stated, notices: &mut Vec<Notice>) {
    let place = |phase| frames.iter().position(|&frame| frame == phase);
    let diastole = place(FrameName::EndDiastole);
    let systole = place(FrameName::EndSystole);
    stated.end_diastole = stated.end_diastole.or(diastole);
    stated.end_systole = stated.end_systole.or(systole);
    notices.push(match (diastole, systole) {
        (Some(diastole), Some(systole)) => Notice::info(format!(
            "end-diastole (frame {diastole}) and end-systole (frame {systole}) from the file names; times between them are not known"
        )),
        (Some(_), None) if frames.len() == 1 => {
            Notice::info("end-diastole only, by its file name: there is no end-systole, so no ejection fraction")
        }
        (None, Some(_)) if frames.len() == 1 => Notice::warning(
            "end-systole only, by its file name: there is no end-diastole, so no ejection fraction",
        ),
        (Some(frame), None) => Notice::info(format!("end-diastole (frame {frame}) from its file name")),
        (None, Some(frame)) => Notice::info(format!("end-systole (frame {frame}) from its file name")),
        (None, None) => return,
    });
}

/// What a sentence calls the file of a frame.
pub(super) fn word_of_frame(frame: FrameName) -> String {
    match frame {
        FrameName::EndDiastole => "ED file".to_owned(),
        FrameName::EndSystole => "ES file".to_owned(),
        FrameName::Number(number) => format!("file {number}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn facts(names: &[&str]) -> (Option<SeriesTimes>, Stated, Vec<String>) {
        let frames: Vec<FrameName> = names
            .iter()
            .filter_map(|name| crate::io::open::file_name::mesh_name(name).frame)
            .collect();
        let (mut stated, mut notices) = (Stated::default(), Vec::new());
        let times = take_facts(&frames, &mut stated, &mut notices);
        let texts = notices.into_iter().map(|notice| notice.text).collect();
        (times, stated, texts)
    }

    #[test]
    fn decimals_and_units_are_times() {
        let (times, ..) = facts(&["e_0.0", "e_0.05", "e_0.1"]);
        assert_eq!(times.unwrap().source, TimesSource::Names);
        let (times, ..) = facts(&["e_0ms", "e_50ms"]);
        assert_eq!(times.unwrap().values, [0.0, 0.05]);
        let (times, ..) = facts(&["e_0%", "e_25%"]);
        assert_eq!(times.unwrap().source, TimesSource::NamesInPercent);
        assert_eq!(facts(&["e_0", "e_1"]).0, None);
    }

    #[test]
    fn one_phase_alone_says_that_there_is_no_ejection_fraction() {
        let (_, stated, texts) = facts(&["endo_ES"]);
        assert_eq!((stated.end_diastole, stated.end_systole), (None, Some(0)));
        assert!(texts[0].ends_with("so no ejection fraction"), "{texts:?}");
    }

    #[test]
    fn phases_among_numbers_and_mixed_units_are_told() {
        assert!(
            facts(&["e_ED", "e_1", "e_2"])
                .2
                .iter()
                .any(|t| t.contains("order in time"))
        );
        assert!(
            facts(&["e_1", "e_50ms"])
                .2
                .iter()
                .any(|t| t.contains("different units"))
        );
        assert!(facts(&["e_-2", "e_-1"]).2[0].contains("negative"));
    }
}
