//! `Info.cfg` beside the masks of a subject: group, end-diastole and end-systole, height and weight.

/// What is said about a subject beside its masks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MaskFacts {
    /// The diagnosis: `Group`.
    pub label: Option<String>,
    /// Number of the frame at end-diastole, as in the names of the files: `ED`.
    pub end_diastole: Option<u32>,
    /// And at end-systole: `ES`.
    pub end_systole: Option<u32>,
    /// `Height`.
    pub height_cm: Option<f64>,
    /// `Weight`.
    pub weight_kg: Option<f64>,
}

/// Letters of a label that are kept; those of diagnoses are a few.
const MAX_LABEL: usize = 64;

impl MaskFacts {
    /// Reads lines such as `Group: DCM`. Others are passed over, as is what cannot be: nothing here is needed.
    pub(super) fn of_text(text: &str) -> Self {
        let mut facts = Self::default();
        for line in text.lines() {
            let Some((key, value)) = line.split_once([':', '=']) else {
                continue;
            };
            let value = value.trim();
            let measure = || {
                value
                    .parse::<f64>()
                    .ok()
                    .filter(|x| x.is_finite() && *x > 0.0)
            };
            match key.trim().to_ascii_lowercase().as_str() {
                "group" if !value.is_empty() => {
                    let shown = value.chars().filter(|c| !c.is_control());
                    facts.label = Some(shown.take(MAX_LABEL).collect());
                }
                "ed" => facts.end_diastole = value.parse().ok(),
                "es" => facts.end_systole = value.parse().ok(),
                "height" => facts.height_cm = measure(),
                "weight" => facts.weight_kg = measure(),
                _ => {}
            }
        }
        facts
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_say_nothing_useful_are_passed_over() {
        let facts = MaskFacts::of_text(
            "ED: 1\r\nES: 12\nGroup: DCM\nHeight: 184.0\nNbFrame: 30\nWeight: -3\nName: nobody\nrubbish\n",
        );
        let expected = MaskFacts {
            label: Some("DCM".to_owned()),
            end_diastole: Some(1),
            end_systole: Some(12),
            height_cm: Some(184.0),
            weight_kg: None,
        };
        assert_eq!(facts, expected);
        assert_eq!(
            MaskFacts::of_text("Weight: NaN\nED: -1\nGroup:"),
            MaskFacts::default()
        );
    }
}
