//! Times of the volumes of a file, in milliseconds: stated with a unit, with a unit that had to be assumed, or not at all.

use super::image_file::Provenance;
use crate::study::Notice;

/// Times, where they come from, and what was assumed.
#[derive(Debug, PartialEq)]
pub(super) struct VolumeTimes {
    pub times_ms: Option<Vec<f64>>,
    pub source: Provenance,
    pub notices: Vec<Notice>,
}

/// Beats of people: 30 to 300 a minute. Where a file gives no unit, a beat outside of this tells which it is not.
const CYCLE_S: std::ops::RangeInclusive<f64> = 0.2..=2.0;

impl VolumeTimes {
    /// A single volume needs no time.
    pub(super) fn of_one_volume() -> Self {
        Self {
            times_ms: None,
            source: Provenance::Stated,
            notices: Vec::new(),
        }
    }

    /// Several volumes without any time.
    pub(super) fn missing(why: impl Into<String>) -> Self {
        Self {
            times_ms: None,
            source: Provenance::Missing,
            notices: vec![Notice::warning(why)],
        }
    }

    /// The times of so many volumes, `step` apart.
    pub(super) fn of_steps(offset: f64, step: f64, count: usize, unit_ms: Option<f64>) -> Self {
        if count == 1 {
            return Self::of_one_volume();
        }
        Self::of_values(
            (0..count).map(|k| offset + k as f64 * step).collect(),
            unit_ms,
        )
    }

    /// The times `values`, one for each volume, in a unit of so many milliseconds if the file says it.
    ///
    /// Without a unit they are taken as seconds or milliseconds if only one of them makes a beat of 0.2 to 2 s. Numbers 0, 1, 2…
    /// count volumes and are no times.
    pub(super) fn of_values(values: Vec<f64>, unit_ms: Option<f64>) -> Self {
        if values.len() <= 1 {
            return Self::of_one_volume();
        }
        let increasing = values.windows(2).all(|pair| pair[0] < pair[1]);
        if !increasing || !values.iter().all(|time| time.is_finite()) {
            return Self::missing(
                "the times of the volumes are not increasing numbers: they are unknown",
            );
        }
        if let Some(unit) = unit_ms {
            return Self {
                times_ms: Some(values.into_iter().map(|time| time * unit).collect()),
                source: Provenance::Stated,
                notices: Vec::new(),
            };
        }
        let span = values.last().copied().unwrap_or(0.0) - values[0];
        let intervals = (values.len() - 1) as f64;
        let cycle = span * values.len() as f64 / intervals;
        let counts = values.windows(2).all(|pair| pair[1] - pair[0] == 1.0);
        let (unit, word) = if counts {
            return Self::missing("the volumes are numbered: their times are unknown");
        } else if CYCLE_S.contains(&cycle) {
            (1e3, "seconds")
        } else if CYCLE_S.contains(&(cycle * 1e-3)) {
            (1.0, "milliseconds")
        } else {
            return Self::missing(format!(
                "volumes {} apart without a unit of time: their times are unknown",
                span / intervals
            ));
        };
        Self {
            times_ms: Some(values.into_iter().map(|time| time * unit).collect()),
            source: Provenance::UnitAssumed,
            notices: vec![Notice::info(format!(
                "no unit of time: a beat of {cycle:.4} is taken as {word}"
            ))],
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    fn times(values: &[f64], unit_ms: Option<f64>) -> (Option<Vec<f64>>, Provenance) {
        let times = VolumeTimes::of_values(values.to_vec(), unit_ms);
        (times.times_ms, times.source)
    }

    #[test]
    fn a_unit_of_the_file_is_used_and_another_one_assumed_only_where_one_alone_can_be() {
        let ms = |values: &[f64]| Some(values.to_vec());
        assert_eq!(
            times(&[0.0, 0.25, 0.5], Some(1e3)),
            (ms(&[0.0, 250.0, 500.0]), Provenance::Stated)
        );
        assert_eq!(
            times(&[0.0, 0.25, 0.5], None),
            (ms(&[0.0, 250.0, 500.0]), Provenance::UnitAssumed)
        );
        assert_eq!(
            times(&[0.0, 250.0, 500.0], None),
            (ms(&[0.0, 250.0, 500.0]), Provenance::UnitAssumed)
        );
        assert_eq!(times(&[0.0, 25.0, 50.0], None), (None, Provenance::Missing));
    }

    #[test]
    fn numbers_of_volumes_and_times_that_stand_are_no_times() {
        assert_eq!(times(&[0.0, 1.0], None).1, Provenance::Missing);
        assert_eq!(times(&[1.0, 1.0], Some(1.0)).1, Provenance::Missing);
        assert_eq!(times(&[0.0, f64::NAN], Some(1.0)).1, Provenance::Missing);
        assert_eq!(
            VolumeTimes::of_steps(0.0, 0.0, 8, Some(1e3)).source,
            Provenance::Missing
        );
        let one = VolumeTimes::of_steps(0.0, 0.0, 1, None);
        assert_eq!(one, VolumeTimes::of_one_volume());
    }
}
