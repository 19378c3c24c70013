//! Which part of their names is the frame, where names of files stand beside each other.
//!
//! One name alone cannot tell: in `ES_endo_3` the first word is a phase or someone's initials, in `endo_2_v3` either
//! number may count frames. Beside the other names it can: the frame is what differs.

use std::collections::{BTreeMap, BTreeSet};

use super::file_name::{MeshName, NameParts, PHASE, PhaseUse, Reading};
use super::frame_name::{FrameName, FrameNumber};
use crate::study::Notice;

/// What is said of phases in names beside others that have a number alone.
const NUMBERED_BESIDE: &str = "ED or ES in some file names is not read as end-diastole or end-systole, because others have a number alone: \
     the numbers are read as frames";
const SEVERAL_OF_PHASE: &str = "ED or ES in the file names is not read as end-diastole or end-systole, because several files have it: \
     their numbers are read as frames";

/// Reads names that stand beside each other, with what was assumed about them.
pub(super) fn read_names(stems: &[&str]) -> (Vec<MeshName>, Vec<Notice>) {
    let parts: Vec<NameParts> = stems.iter().map(|stem| NameParts::of(stem)).collect();
    let mut alike: BTreeMap<Vec<String>, Vec<usize>> = BTreeMap::new();
    for (index, parts) in parts.iter().enumerate() {
        alike.entry(parts.template()).or_default().push(index);
    }
    let mut names: Vec<MeshName> = vec![MeshName::default(); parts.len()];
    let mut notices = Vec::new();
    for (template, members) in &alike {
        let group_of = |members: &[usize]| -> Vec<&NameParts> {
            members.iter().map(|&index| &parts[index]).collect()
        };
        let of_group = group_of(members);
        let plain: Vec<String> = (template.iter())
            .filter(|word| *word != PHASE)
            .cloned()
            .collect();
        let beside = alike.get(&plain).filter(|_| plain.len() < template.len());
        let numbered = beside.and_then(|beside| numbered_beside(&of_group, &group_of(beside)));
        let (reading, notice) = match numbered {
            Some(reading) => (reading, Some(NUMBERED_BESIDE)),
            None => reading_of(&of_group),
        };
        for &index in members {
            names[index] = parts[index].name(reading);
        }
        if let (Some(text), Some(&first)) = (notice, members.first()) {
            notices.push(Notice::warning(format!(
                "{text} (names such as {:?})",
                stems[first]
            )));
        }
    }
    (names, notices)
}

/// How names that differ only in phases and numbers are read.
fn reading_of(names: &[&NameParts]) -> (Reading, Option<&'static str>) {
    let Some(first) = names.first() else {
        return (Reading::default(), None);
    };
    let number = varying_number(names);
    let with_number = |phase| Reading { phase, number };
    if first.phase.is_none() {
        return (with_number(PhaseUse::Frame), None);
    }
    let usual = (first.usual_reading(), None);
    let Some(candidate) = number.and_then(|index| first.numbers.get(index)) else {
        return usual;
    };
    let phases: BTreeSet<Option<FrameName>> = names.iter().map(|name| name.phase).collect();
    let numbers: Vec<BTreeSet<Option<FrameNumber>>> = phases
        .iter()
        .map(|&phase| {
            let with = names.iter().filter(|name| name.phase == phase);
            with.map(|name| value(name, number)).collect()
        })
        .collect();
    let (apart, together) = match numbers.as_slice() {
        [one] => (one.len() > 1, true),
        [one, other] => (one.is_disjoint(other), false),
        _ => (false, false),
    };
    if !apart || !candidate.sure {
        return usual;
    }
    if numbers.iter().all(|set| set.len() == 1) {
        // `frame01_ED`, `frame12_ES`: both say the frame. Without a word for it the numbers may be patients'.
        let both = with_number(PhaseUse::Frame);
        return if candidate.worded {
            (both, None)
        } else {
            usual
        };
    }
    // `ES_endo_5` among others of ES: someone's initials. `diastole_5`, `systole_9`: halves of a cycle.
    let phase = if together {
        PhaseUse::Case
    } else {
        PhaseUse::Left
    };
    (with_number(phase), Some(SEVERAL_OF_PHASE))
}

/// `endo_0_ED`, `endo_1_ES` beside `endo_2`: the numbers are the frames of all, if each is of one file alone.
fn numbered_beside(names: &[&NameParts], beside: &[&NameParts]) -> Option<Reading> {
    let number = varying_number(names)?;
    let sure = |name: &&NameParts| name.numbers.get(number).is_some_and(|found| found.sure);
    if !names.iter().all(sure) {
        return None;
    }
    let reading = Reading {
        phase: PhaseUse::Left,
        number: Some(number),
    };
    let key = |name: MeshName| (name.case, name.surface, name.frame);
    let of_others = beside
        .iter()
        .map(|name| key(name.name(reading_of(beside).0)));
    let mut seen: BTreeSet<_> = of_others.collect();
    let all_new = names
        .iter()
        .all(|name| seen.insert(key(name.name(reading))));
    all_new.then_some(reading)
}

fn value(name: &NameParts, number: Option<usize>) -> Option<FrameNumber> {
    Some(name.numbers.get(number?)?.number)
}

/// The likeliest number that differs between the names; the likeliest of all where none does.
///
/// Only numbers that are surely a frame's stand in for the likeliest: `03_endo_1` and `04_endo_1` are two patients.
fn varying_number(names: &[&NameParts]) -> Option<usize> {
    let first = names.first()?;
    let varies = |index: usize| {
        let values: BTreeSet<_> = names.iter().map(|name| value(name, Some(index))).collect();
        values.len() > 1
    };
    let count = first.numbers.len();
    (0..count)
        .find(|&index| varies(index) && (index == 0 || first.numbers[index].sure))
        .or((count > 0).then_some(0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(stems: &[&str]) -> Vec<(String, Option<String>)> {
        let shown = |frame: FrameName| match frame {
            FrameName::EndDiastole => "ED".to_owned(),
            FrameName::EndSystole => "ES".to_owned(),
            FrameName::Number(number) => number.to_string(),
        };
        let (names, _) = read_names(stems);
        names
            .into_iter()
            .map(|name| (name.case, name.frame.map(shown)))
            .collect()
    }

    fn expect(stems: &[&str], read_as: &[(&str, &str)]) {
        let wanted: Vec<(String, Option<String>)> = read_as
            .iter()
            .map(|(case, frame)| ((*case).to_owned(), Some((*frame).to_owned())))
            .collect();
        assert_eq!(read(stems), wanted, "{stems:?}");
    }

    #[test]
    fn initials_of_all_files_are_no_phase() {
        expect(&["ES_endo_0", "ES_endo_1"], &[("ES", "0"), ("ES", "1")]);
        expect(&["ed_endo_0", "ed_endo_1"], &[("ed", "0"), ("ed", "1")]);
        assert_eq!(read_names(&["ES_endo_0", "ES_endo_1"]).1.len(), 1);
        expect(&["ES_ED_endo", "ES_ES_endo"], &[("ES", "ED"), ("ES", "ES")]);
    }

    #[test]
    fn phases_with_frame_numbers_are_one_subject() {
        expect(
            &["p1_frame01_ED_endo", "p1_frame12_ES_endo"],
            &[("p1", "ED"), ("p1", "ES")],
        );
        expect(
            &["diastole_endo_0", "diastole_endo_1", "systole_endo_2"],
            &[("", "0"), ("", "1"), ("", "2")],
        );
    }

    #[test]
    fn numbers_of_some_files_are_frames_of_those_with_a_phase_as_well() {
        expect(
            &[
                "endo_0_ED",
                "endo_1_ES",
                "endo_2",
                "epi_0_ED",
                "epi_1_ES",
                "epi_2",
            ],
            &[
                ("", "0"),
                ("", "1"),
                ("", "2"),
                ("", "0"),
                ("", "1"),
                ("", "2"),
            ],
        );
        expect(
            &["endo_3_ED", "endo_3_ES", "endo_4"],
            &[("3", "ED"), ("3", "ES"), ("", "4")],
        );
    }

    #[test]
    fn phases_of_numbered_patients_stay_phases() {
        expect(
            &["ED_endo_0", "ES_endo_0", "ED_endo_1", "ES_endo_1"],
            &[("0", "ED"), ("0", "ES"), ("1", "ED"), ("1", "ES")],
        );
        expect(&["p_03_ED", "p_04_ES"], &[("p_03", "ED"), ("p_04", "ES")]);
        expect(&["03_ED_endo", "04_ED_endo"], &[("03", "ED"), ("04", "ED")]);
    }

    #[test]
    fn the_number_that_differs_is_the_frame() {
        expect(&["endo_0_v2", "endo_1_v2"], &[("v2", "0"), ("v2", "1")]);
        expect(
            &["p_12_endo_3", "p_12_endo_4", "p_13_endo_3"],
            &[("p_12", "3"), ("p_12", "4"), ("p_13", "3")],
        );
        expect(&["03_endo_1", "04_endo_1"], &[("03", "1"), ("04", "1")]);
    }
}
