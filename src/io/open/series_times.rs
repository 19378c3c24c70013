//! Times of frames whose unit nobody states: those of a list of files, and those in the names of files.

use super::plan::{SeriesTimes, TimesSource};
use super::plausible::can_be_one_cycle;
use crate::study::Notice;

/// The times in seconds, where they can be those of one cycle of length `rr_s`, with the sentence that says what was
/// assumed or why they are not used.
pub(super) fn seconds(
    times: &SeriesTimes,
    rr_s: Option<f64>,
) -> (Option<Vec<f64>>, Option<Notice>) {
    let values = &times.values;
    if values.len() < 2 {
        return (None, None);
    }
    let whose = match times.source {
        TimesSource::List => "times of the list of files",
        _ => "times in the file names",
    };
    let not_used = |why: &str| {
        (
            None,
            Some(Notice::warning(format!("{whose} are not used: {why}"))),
        )
    };
    if let Some(pair) = values.windows(2).find(|pair| pair[0] >= pair[1]) {
        let why = if pair[0] == pair[1] {
            format!("two frames have the same time {}", pair[0])
        } else {
            format!("they do not increase ({} after {})", pair[1], pair[0])
        };
        return not_used(&why);
    }
    match times.source {
        TimesSource::NamesInSeconds if can_be_one_cycle(values) => {
            let text = format!("{whose}: {} to {} s", values[0], values[values.len() - 1]);
            (Some(values.clone()), Some(Notice::info(text)))
        }
        TimesSource::NamesInSeconds => not_used(&implausible(values)),
        TimesSource::NamesInPercent => in_percent(values, rr_s),
        TimesSource::List if counts(values) => (None, None),
        TimesSource::List | TimesSource::Names => match unit(values) {
            Some((factor, unit)) => {
                let seconds = values.iter().map(|time| time * factor).collect();
                let text = format!(
                    "{whose} read as {unit}, because the last is {} and no unit is given",
                    values[values.len() - 1]
                );
                (Some(seconds), Some(Notice::info(text)))
            }
            None => not_used(&implausible(values)),
        },
    }
}

/// The unit in which ascending times are those of one cycle, with its seconds.
fn unit(values: &[f64]) -> Option<(f64, &'static str)> {
    [(1.0, "s"), (0.001, "ms")].into_iter().find(|(factor, _)| {
        let seconds: Vec<f64> = values.iter().map(|time| time * factor).collect();
        can_be_one_cycle(&seconds)
    })
}

/// Whether times only count frames: 0, 1, 2, …
fn counts(values: &[f64]) -> bool {
    values.iter().all(|time| time.fract() == 0.0)
        && values.windows(2).all(|pair| pair[1] - pair[0] == 1.0)
}

fn implausible(values: &[f64]) -> String {
    format!(
        "{} to {} for {} frames cannot be times of one cycle in s or ms; they may be step numbers",
        values[0],
        values[values.len() - 1],
        values.len()
    )
}

fn in_percent(values: &[f64], rr_s: Option<f64>) -> (Option<Vec<f64>>, Option<Notice>) {
    let (first, last) = (values[0], values[values.len() - 1]);
    let of_cycle = format!("file names read as {first} to {last} % of the cycle (R-R)");
    if last - first > 100.0 {
        let text = format!("{of_cycle}, more than one cycle: no times are taken from them");
        return (None, Some(Notice::warning(text)));
    }
    match rr_s {
        Some(rr) => {
            let seconds = values.iter().map(|share| share / 100.0 * rr).collect();
            (Some(seconds), Some(Notice::info(of_cycle)))
        }
        None => {
            let steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
            let even = steps.iter().all(|step| (step - steps[0]).abs() < 1e-6);
            let notice = if even {
                Notice::info(format!("{of_cycle}; times are unknown without its length"))
            } else {
                Notice::warning(format!(
                    "{of_cycle}, in uneven steps; without its length (rr_ms) frames count as evenly spaced"
                ))
            };
            (None, Some(notice))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(source: TimesSource, values: &[f64], rr_s: Option<f64>) -> (Option<Vec<f64>>, String) {
        let times = SeriesTimes {
            values: values.to_vec(),
            source,
        };
        let (seconds, notice) = seconds(&times, rr_s);
        (
            seconds,
            notice.map_or_else(String::new, |notice| notice.text),
        )
    }

    #[test]
    fn times_are_seconds_milliseconds_or_mere_counts() {
        let list = |values: &[f64]| of(TimesSource::List, values, None);
        assert_eq!(list(&[0.0, 1.0, 2.0]), (None, String::new()));
        assert_eq!(list(&[7.0, 8.0]), (None, String::new()));
        assert_eq!(list(&[]), (None, String::new()));
        let (seconds, text) = list(&[0.0, 0.4]);
        assert_eq!(seconds, Some(vec![0.0, 0.4]));
        assert!(text.contains("read as s"), "{text}");
        let (seconds, text) = list(&[0.0, 400.0]);
        assert_eq!(seconds, Some(vec![0.0, 0.4]));
        assert!(text.contains("read as ms"), "{text}");
        assert_eq!(list(&[-0.1, 0.2, 0.5]).0, Some(vec![-0.1, 0.2, 0.5]));
    }

    #[test]
    fn times_that_no_cycle_has_are_not_used_and_told() {
        for (values, why) in [
            (vec![0.0, 0.2, 0.2, 0.4], "same time 0.2"),
            (vec![0.0, 0.4, 0.2], "do not increase"),
            (vec![0.0, 3.0, 6.0, 9.0], "step numbers"),
            (vec![0.0, 2.0, 4.0, 6.0], "step numbers"),
            (vec![0.0, 1e6, 2e6], "step numbers"),
            (vec![0.0, 1e-6, 2e-6], "step numbers"),
        ] {
            let (seconds, text) = of(TimesSource::List, &values, None);
            assert_eq!(seconds, None, "{values:?}");
            assert!(text.contains("not used") && text.contains(why), "{text}");
        }
    }

    #[test]
    fn shares_of_the_cycle_are_times_where_its_length_is_known() {
        let percent = |values: &[f64], rr| of(TimesSource::NamesInPercent, values, rr);
        assert_eq!(percent(&[0.0, 50.0], Some(0.8)).0, Some(vec![0.0, 0.4]));
        assert!(percent(&[0.0, 50.0], None).1.contains("0 to 50 %"));
        assert!(percent(&[0.0, 5.0, 50.0], None).1.contains("uneven"));
        assert!(
            percent(&[0.0, 250.0], Some(0.8))
                .1
                .contains("more than one cycle")
        );
    }

    #[test]
    fn times_in_names_are_told_with_their_unit() {
        let (seconds, text) = of(TimesSource::Names, &[0.0, 0.05, 0.1, 0.15], None);
        assert_eq!(seconds.map(|s| s.len()), Some(4));
        assert!(text.contains("times in the file names read as s"), "{text}");
        let (seconds, text) = of(TimesSource::NamesInSeconds, &[0.0, 5.0], None);
        assert_eq!(seconds, None);
        assert!(text.contains("not used"), "{text}");
    }
}
