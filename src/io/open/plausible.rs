//! Values that no heart has: most were typed in another unit.

use std::ops::RangeInclusive;

use super::plan::Stated;
use crate::study::Notice;

/// Length of a cycle, in seconds: heart rates of 300 to 20 a minute.
const CYCLE_S: RangeInclusive<f64> = 0.2..=3.0;
/// Time that the frames of a cycle cover, in seconds. Sequences may hold a part of a cycle, so that the shortest is
/// three quarters of the shortest cycle.
const COVERED_S: RangeInclusive<f64> = 0.15..=3.0;
/// Shortest time between two frames that are a whole sequence, such as end-diastole and end-systole, in seconds.
const MIN_PAIR_S: f64 = 0.03;
/// Body height, in centimetres, from the smallest newborn to the tallest man.
const HEIGHT_CM: RangeInclusive<f64> = 25.0..=275.0;
/// Body weight, in kilograms, from the smallest newborn to the heaviest man.
const WEIGHT_KG: RangeInclusive<f64> = 0.3..=650.0;
/// Rounding that sums of decimals bring.
const ROUNDING_S: f64 = 1e-9;

/// Whether ascending times, in seconds, can be those of frames of one cycle.
///
/// n frames at even steps cover (n − 1) / n of a cycle, and the last runs into the first.
pub(super) fn can_be_one_cycle(times_s: &[f64]) -> bool {
    let (Some(first), Some(last)) = (times_s.first(), times_s.last()) else {
        return false;
    };
    let (span, count) = (last - first, times_s.len() as f64);
    if times_s.len() == 2 {
        return (MIN_PAIR_S..=*COVERED_S.end()).contains(&span);
    }
    let cycle = span * count / (count - 1.0).max(1.0);
    cycle >= COVERED_S.start() - ROUNDING_S && span <= COVERED_S.end() + ROUNDING_S
}

/// Whether ascending times, in seconds, can be those of frames of a part of a cycle.
fn can_be_part_of_cycle(times_s: &[f64]) -> bool {
    let (Some(first), Some(last)) = (times_s.first(), times_s.last()) else {
        return false;
    };
    (MIN_PAIR_S..=*COVERED_S.end() + ROUNDING_S).contains(&(last - first))
}

/// Takes out what is stated and no heart has, a warning for each.
pub(super) fn without_implausible(stated: &mut Stated) -> Vec<Notice> {
    let mut notices = Vec::new();
    if let Some(rr) = stated.rr_s.take_if(|rr| !CYCLE_S.contains(rr)) {
        let beats = 60.0 / rr;
        let meant = if CYCLE_S.contains(&(rr * 1000.0)) {
            format!(
                "; if {} are seconds, write {}",
                shown(rr * 1000.0),
                shown(rr * 1e6)
            )
        } else if CYCLE_S.contains(&(60.0 / (rr * 1000.0))) {
            let ms = 60_000.0 / (rr * 1000.0);
            format!("; if {} is a heart rate, write {ms:.0}", shown(rr * 1000.0))
        } else {
            String::new()
        };
        notices.push(Notice::warning(format!(
            "rr_ms = {} is not used: a cycle (R-R) of {} ms is a heart rate of {beats:.0} a minute, and 20 to 300 are plausible{meant}",
            shown(rr * 1000.0),
            shown(rr * 1000.0)
        )));
    }
    let times = stated.frame_times_s.as_deref().unwrap_or_default();
    let ascending = times.windows(2).all(|pair| pair[0] < pair[1]);
    if times.len() > 1 && ascending && !can_be_part_of_cycle(times) {
        let span = (times[times.len() - 1] - times[0]) * 1000.0;
        let seconds: Vec<f64> = times.iter().map(|time| time * 1000.0).collect();
        let meant = if can_be_part_of_cycle(&seconds) {
            "; are they seconds?"
        } else {
            ""
        };
        notices.push(Notice::warning(format!(
            "time_ms is not used: {} frames within {} ms are not those of one cycle{meant}",
            times.len(),
            shown(span)
        )));
        stated.frame_times_s = None;
    }
    let covered = stated
        .frame_times_s
        .as_deref()
        .and_then(|times| Some(times.last()? - times.first()?));
    if let Some(covered) = covered
        && let Some(rr) = stated.rr_s.take_if(|rr| covered > *rr + ROUNDING_S)
    {
        notices.push(Notice::warning(format!(
            "rr_ms = {} is not used: the frames cover {} ms, more than one cycle (R-R)",
            shown(rr * 1000.0),
            shown(covered * 1000.0)
        )));
    }
    let body = [
        (&mut stated.height_cm, HEIGHT_CM, "height_cm", "cm"),
        (&mut stated.weight_kg, WEIGHT_KG, "weight_kg", "kg"),
    ];
    for (value, plausible, key, unit) in body {
        if let Some(value) = value.take_if(|value| !plausible.contains(value)) {
            notices.push(Notice::warning(format!(
                "{key} = {} is not used: {} to {} {unit} are plausible",
                shown(value),
                plausible.start(),
                plausible.end()
            )));
        }
    }
    notices
}

/// A number as a person would write it, without the noise of a conversion.
fn shown(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    format!("{rounded}")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checked(stated: Stated) -> (Stated, Vec<String>) {
        let mut stated = stated;
        let notices = without_implausible(&mut stated);
        (stated, notices.into_iter().map(|n| n.text).collect())
    }

    #[test]
    fn a_cycle_in_seconds_or_as_a_heart_rate_is_refused_with_what_was_meant() {
        for (ms, meant) in [
            (0.85, "write 850"),
            (72.0, "write 833"),
            (0.0001, "300 are plausible"),
        ] {
            let (stated, texts) = checked(Stated {
                rr_s: Some(ms / 1000.0),
                ..Stated::default()
            });
            assert_eq!(stated.rr_s, None);
            assert!(texts[0].contains(&format!("rr_ms = {ms}")), "{texts:?}");
            assert!(texts[0].ends_with(meant), "{texts:?}");
        }
        let (stated, texts) = checked(Stated {
            rr_s: Some(0.85),
            ..Stated::default()
        });
        assert_eq!((stated.rr_s, texts.len()), (Some(0.85), 0));
    }

    #[test]
    fn frame_times_in_seconds_or_beyond_the_cycle_are_refused() {
        let times = |times: &[f64], rr_s: Option<f64>| {
            checked(Stated {
                frame_times_s: Some(times.to_vec()),
                rr_s,
                ..Stated::default()
            })
        };
        let (stated, texts) = times(&[0.0, 0.0002, 0.0004], None);
        assert_eq!(stated.frame_times_s, None);
        assert!(texts[0].ends_with("are they seconds?"), "{texts:?}");
        let (stated, texts) = times(&[0.0, 0.5, 0.9], Some(0.8));
        assert_eq!((stated.rr_s, stated.frame_times_s.is_some()), (None, true));
        assert!(texts[0].contains("more than one cycle"), "{texts:?}");
        assert_eq!(times(&[0.0, 0.4, 0.8], Some(0.8)).1.len(), 0);
        assert_eq!(times(&[0.0, 0.05, 0.1, 0.15], None).1.len(), 0);
    }

    #[test]
    fn bodies_in_metres_or_grams_are_refused() {
        let (stated, texts) = checked(Stated {
            height_cm: Some(1.72),
            weight_kg: Some(71_500.0),
            ..Stated::default()
        });
        assert_eq!((stated.height_cm, stated.weight_kg), (None, None));
        assert_eq!(texts.len(), 2);
    }
}
