//! Ranges that are called normal, each with its source.

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

/// Why volumes and mass come without a range.
pub const NO_VOLUME_RANGE: &str = "No normal range is shown: limits depend on sex, body size and \
                                   imaging, which the study does not contain";
