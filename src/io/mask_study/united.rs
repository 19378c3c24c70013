//! What the files of most subjects of a cohort say alike is said once.

use std::collections::BTreeMap;

use crate::study::checks::counted;
use crate::study::{Notice, Severity};

/// Fewer subjects each keep what is said of them.
const FEWEST: usize = 5;

/// Takes what the files of at least five subjects and of more than half of them say in equal words, but for numbers, out of
/// the lists of these subjects, and returns it once for all, with the range of each number.
pub fn united_notices(each: &mut [Vec<Notice>]) -> Vec<Notice> {
    let mut alike: BTreeMap<(Severity, String), Vec<Vec<String>>> = BTreeMap::new();
    for notice in each.iter().flat_map(|list| first_of_each_kind(list)) {
        let (words, numbers) = taken_apart(&notice.text);
        let known = alike.entry((notice.severity, words)).or_default();
        known.push(numbers);
    }
    let enough = FEWEST.max(each.len() / 2 + 1);
    alike.retain(|_, said| said.len() >= enough);
    let common = |notice: &Notice| {
        let (words, _) = taken_apart(&notice.text);
        alike.contains_key(&(notice.severity, words))
    };
    for list in each.iter_mut() {
        list.retain(|notice| !common(notice));
    }
    let subjects = counted(each.len(), "subject", "subjects");
    let once = alike.iter().map(|((severity, words), said)| Notice {
        severity: *severity,
        text: format!("{} of {subjects}: {}", said.len(), with_ranges(words, said)),
    });
    once.collect()
}

/// Of notes that differ in numbers alone, the first: a subject is counted once.
fn first_of_each_kind(list: &[Notice]) -> impl Iterator<Item = &Notice> {
    let kind = |notice: &Notice| (notice.severity, taken_apart(&notice.text).0);
    (list.iter().enumerate())
        .filter(move |(place, notice)| {
            !list[..*place]
                .iter()
                .any(|other| kind(other) == kind(notice))
        })
        .map(|(_, notice)| notice)
}

/// Stands in a text where a number was; no text has it.
const NUMBER: char = '\u{0}';

/// A text without its numbers, and these.
fn taken_apart(text: &str) -> (String, Vec<String>) {
    let (mut words, mut numbers) = (String::new(), Vec::new());
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let (before, from) = rest.split_at(start);
        let digits = from.trim_start_matches(|c: char| c.is_ascii_digit());
        // A point is part of a number where a digit follows.
        let fraction = digits
            .strip_prefix('.')
            .map(|more| more.trim_start_matches(|c: char| c.is_ascii_digit()))
            .filter(|after| after.len() + 1 < digits.len());
        let after = fraction.unwrap_or(digits);
        words.push_str(before);
        words.push(NUMBER);
        numbers.push(from[..from.len() - after.len()].to_owned());
        rest = after;
    }
    words.push_str(rest);
    (words, numbers)
}

/// Words with the least and the greatest of each number.
fn with_ranges(words: &str, said: &[Vec<String>]) -> String {
    let mut text = String::new();
    for (place, part) in words.split(NUMBER).enumerate() {
        if let Some(before) = place.checked_sub(1) {
            let mut numbers: Vec<&str> = (said.iter())
                .filter_map(|numbers| numbers.get(before).map(String::as_str))
                .collect();
            let value = |word: &&str| word.parse::<f64>().unwrap_or(f64::NAN);
            numbers.sort_by(|a, b| value(a).total_cmp(&value(b)));
            match (numbers.first(), numbers.last()) {
                (Some(least), Some(most)) if least != most => {
                    text += &format!("{least} to {most}");
                }
                (Some(only), _) => text += only,
                _ => {}
            }
        }
        text += part;
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(off_mm: &str) -> Notice {
        Notice::info(format!("corners lie up to {off_mm} mm from the 2nd place."))
    }

    #[test]
    fn what_most_subjects_say_is_said_once_with_its_range() {
        let own = Notice::warning("slice 3 is empty");
        let mut each: Vec<Vec<Notice>> = (0..9).map(|n| vec![told(&format!("{n}.5"))]).collect();
        each[4].push(own.clone());
        each[5] = vec![own.clone()];
        let once = united_notices(&mut each);
        let text = "8 of 9 subjects: corners lie up to 0.5 to 8.5 mm from the 2nd place.";
        assert_eq!(once, [Notice::info(text)]);
        assert_eq!(each.iter().flatten().count(), 2);
        assert_eq!((&each[4], &each[5]), (&vec![own.clone()], &vec![own]));
    }

    #[test]
    fn what_few_subjects_say_stays_with_them() {
        let mut few: Vec<Vec<Notice>> = (0..4).map(|_| vec![told("1")]).collect();
        assert!(united_notices(&mut few).is_empty());
        assert_eq!(few.iter().flatten().count(), 4);
        // Of one subject's files, several may say it: five of six files are no five subjects.
        let mut one = vec![Vec::new(); 20];
        one[0] = (0..18).map(|n| told(&n.to_string())).collect();
        assert!(united_notices(&mut one).is_empty());
        assert_eq!(one[0].len(), 18);
    }
}
