//! When within the cycle a file is, as its name says it: a phase, a number, a time or a share of the cycle.

/// Decimals that tell two frames apart; programs print times of 0.3 s as 0.30000000000000004.
const DECIMALS: i64 = 12;
/// One, in units of the last decimal.
const ONE: i128 = 1_000_000_000_000;
/// Digits before the point; numbers of more digits are parts of a name like any other.
const MAX_DIGITS: usize = 19;

/// When within the cycle a file is, in the order of a cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum FrameName {
    /// `ED`.
    EndDiastole,
    /// `ES`.
    EndSystole,
    /// `7`, `g7`, `frame_007`, `0.05`, `50ms`, `25%`.
    Number(FrameNumber),
}

/// A decimal number of a name, exact to 12 decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct FrameNumber {
    scaled: i128,
    unit: NumberUnit,
}

/// What a number of a name counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum NumberUnit {
    /// Frames, or times whose unit the name does not say.
    None,
    /// Seconds; milliseconds are converted.
    Seconds,
    /// Per cent of the cycle.
    Percent,
}

impl FrameNumber {
    /// A whole number without a unit.
    #[cfg(test)]
    pub(super) fn whole(number: u32) -> Self {
        Self {
            scaled: i128::from(number) * ONE,
            unit: NumberUnit::None,
        }
    }

    /// The number that a text is: sign, digits, decimals, exponent (`-0.05`, `007`, `5e-02`).
    pub(super) fn parse(text: &str) -> Option<Self> {
        let (negative, text) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let (mantissa, exponent) = match text.split_once(['e', 'E']) {
            Some((mantissa, exponent)) => (mantissa, exponent.parse::<i64>().ok()?),
            None => (text, 0),
        };
        let (whole, decimals) = mantissa
            .split_once(['.', ',', 'p'])
            .unwrap_or((mantissa, ""));
        let all_digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit());
        let counted = whole.trim_start_matches('0');
        if whole.is_empty()
            || !all_digits(whole)
            || !all_digits(decimals)
            || counted.len() > MAX_DIGITS
        {
            return None;
        }
        let decimals: String = decimals.chars().take(DECIMALS as usize + 2).collect();
        let digits: i128 = format!("{whole}{decimals}").parse().ok()?;
        let shift = DECIMALS + exponent - decimals.len() as i64;
        // a number below the last decimal is zero
        let power = match 10_i128.checked_pow(u32::try_from(shift.abs()).ok()?) {
            None if shift < 0 => i128::MAX,
            power => power?,
        };
        let scaled = if shift < 0 {
            digits / power + i128::from(digits % power >= power - power / 2)
        } else {
            digits.checked_mul(power)?
        };
        Some(Self {
            scaled: if negative { -scaled } else { scaled },
            unit: NumberUnit::None,
        })
    }

    /// The same number with the unit that a word says (`s`, `ms`, `%`), if the word is one.
    pub(super) fn with_unit(self, word: &str) -> Option<Self> {
        let (unit, divisor) = match word.to_lowercase().as_str() {
            "" => (NumberUnit::None, 1),
            "s" | "sec" | "secs" | "second" | "seconds" => (NumberUnit::Seconds, 1),
            "ms" | "msec" | "msecs" | "millisecond" | "milliseconds" => (NumberUnit::Seconds, 1000),
            "%" | "pct" | "pc" | "perc" | "percent" | "prozent" | "%rr" | "pctrr" => {
                (NumberUnit::Percent, 1)
            }
            _ => return None,
        };
        let scaled = self.scaled / divisor;
        Some(Self { scaled, unit })
    }

    /// What it counts.
    pub(super) fn unit(self) -> NumberUnit {
        self.unit
    }

    /// Its value, in seconds or per cent where it has that unit.
    pub(super) fn value(self) -> f64 {
        self.scaled as f64 / ONE as f64
    }

    /// The number of a frame, if it is whole and without a unit.
    pub(super) fn count(self) -> Option<i128> {
        let whole = self.scaled % ONE == 0 && self.unit == NumberUnit::None;
        whole.then_some(self.scaled / ONE)
    }
}

impl std::fmt::Display for FrameNumber {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let sign = if self.scaled < 0 { "-" } else { "" };
        let (size, one) = (self.scaled.unsigned_abs(), ONE.unsigned_abs());
        let decimals = format!("{:012}", size % one);
        let decimals = decimals.trim_end_matches('0');
        let point = if decimals.is_empty() { "" } else { "." };
        let unit = match self.unit {
            NumberUnit::None => "",
            NumberUnit::Seconds => " s",
            NumberUnit::Percent => " %",
        };
        write!(f, "{sign}{}{point}{decimals}{unit}", size / one)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(text: &str) -> FrameNumber {
        FrameNumber::parse(text).unwrap()
    }

    #[test]
    fn numbers_are_ordered_by_value_however_they_are_written() {
        let mut numbers = ["0.15", "0.1", "1e-2", "-0.5", "007", "0,05", "2", "1.5e1"].map(number);
        numbers.sort();
        let shown = numbers.map(|number| number.to_string());
        assert_eq!(
            shown,
            ["-0.5", "0.01", "0.05", "0.1", "0.15", "2", "7", "15"]
        );
        assert_eq!(number("0.1"), number("0.100"));
        assert_eq!(number("0.30000000000000004"), number("0.3"));
    }

    #[test]
    fn long_numbers_keep_all_their_digits() {
        assert!(number("20240101123059123") < number("20240101123059124"));
        assert_eq!(FrameNumber::parse("99999999999999999999999"), None);
        assert_eq!(FrameNumber::parse("1e999999999999"), None);
        assert_eq!(FrameNumber::parse("1e99"), None);
        assert_eq!(number("1e-99").value(), 0.0);
        assert_eq!(FrameNumber::parse("soon"), None);
        assert_eq!(FrameNumber::parse(""), None);
    }

    #[test]
    fn milliseconds_are_seconds() {
        let ms = number("50").with_unit("ms").unwrap();
        assert_eq!(ms, number("0.05").with_unit("s").unwrap());
        assert_eq!((ms.to_string().as_str(), ms.count()), ("0.05 s", None));
        assert_eq!(number("25").with_unit("%").unwrap().to_string(), "25 %");
        assert_eq!(number("25").with_unit("apples"), None);
        assert_eq!(number("007").count(), Some(7));
    }
}
