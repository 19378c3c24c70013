//! Ranges that are called normal, each with its source.

use crate::analysis::measures::EF_RANGE;

/// A published range of one quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NormalRange {
    /// For a line of text: "normal 52–74 %".
    pub short: &'static str,
    /// Source, population and imaging.
    pub source: &'static str,
}

/// Ejection fraction of the left ventricle.
///
/// Source: Lang et al. (2015), J Am Soc Echocardiogr 28(1), Table 4: 52–72 % in men, 54–74 % in
/// women, by biplane echocardiography. Sex is often not part of a study, so the two are joined.
pub const EJECTION_FRACTION: NormalRange = NormalRange {
    short: "normal 52–74 %",
    source: "Normal: men 52–72 %, women 54–74 % (Lang et al. 2015, J Am Soc Echocardiogr 28:1, \
             biplane echocardiography). Other imaging differs by a few per cent.",
};

/// How an ejection fraction lies to its range, in a line of text.
pub fn ejection_fraction_words(fraction: Option<f64>) -> &'static str {
    match fraction.and_then(|fraction| EF_RANGE.outside(100.0 * fraction)) {
        Some(outside) if outside.below => "below normal 52–74 %",
        Some(_) => "above normal 52–74 %",
        None => EJECTION_FRACTION.short,
    }
}

/// Why volumes and mass come without a range.
pub const NO_VOLUME_RANGE: &str = "No normal range is shown: limits depend on sex, body size and \
                                   imaging, which the study does not contain";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_ejection_fraction_outside_its_range_is_called_so() {
        assert_eq!(ejection_fraction_words(Some(0.31)), "below normal 52–74 %");
        assert_eq!(ejection_fraction_words(Some(0.80)), "above normal 52–74 %");
        assert_eq!(ejection_fraction_words(Some(0.60)), "normal 52–74 %");
        assert_eq!(ejection_fraction_words(None), "normal 52–74 %");
        let range = format!("normal {}–{} %", EF_RANGE.low, EF_RANGE.high);
        assert_eq!(EJECTION_FRACTION.short, range);
    }
}
