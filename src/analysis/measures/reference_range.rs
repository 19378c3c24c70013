//! Which measures of a subject lie outside the range of healthy adults.

use crate::units::LengthUnit;

use super::result::SubjectMeasures;

/// Range of one measure in healthy adults.
///
/// Sex, age and body size are often not part of a study: ranges run from the lower limit of women to the upper limit
/// of men, so that what lies outside is unusual for either. They say nothing of children.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceRange {
    /// The short name of the measure.
    pub name: &'static str,
    /// Lowest usual value, in the unit.
    pub low: f64,
    /// Highest usual value.
    pub high: f64,
    /// What both are counted in.
    pub unit: &'static str,
    /// Population and source, for whoever reads the range.
    pub source: &'static str,
}

/// The population and source of volumes and mass.
const MAGNETIC_RESONANCE: &str = "women’s mean − 2 SD to men’s mean + 2 SD (Kawel-Boehm et al. 2015, J Cardiovasc Magn \
                                  Reson 17:29)";

/// Ejection fraction.
///
/// Source: Lang et al. (2015), J Am Soc Echocardiogr 28(1), Table 4: 52–72 % in men, 54–74 % in women. By magnetic
/// resonance the range depends on where papillary muscles are counted: 58 ± 5 % in men and 61 ± 5 % in women with
/// them in the volume (Petersen et al. 2017, J Cardiovasc Magn Reson 19:18), 67 ± 5 % with them in the mass.
pub const EF_RANGE: ReferenceRange = ReferenceRange {
    name: "EF",
    low: 52.0,
    high: 74.0,
    unit: "%",
    source: "men 52–72 %, women 54–74 % (Lang et al. 2015, J Am Soc Echocardiogr 28:1, biplane echocardiography). Other \
             imaging differs by a few per cent.",
};

/// End-diastolic volume.
///
/// Source, here and below: Kawel-Boehm et al. (2015), J Cardiovasc Magn Reson 17:29, normal values of magnetic
/// resonance in adults: women's mean − 2 SD to men's mean + 2 SD, 132 ± 23 and 160 ± 27 ml. The update of 2020 (J Cardiovasc Magn Reson 22:87) joins more
/// cohorts; its limits are not copied here.
pub const EDV_RANGE: ReferenceRange = ReferenceRange {
    name: "EDV",
    low: 86.0,
    high: 214.0,
    unit: "ml",
    source: MAGNETIC_RESONANCE,
};

/// End-systolic volume: 44 ± 11 ml in women, 54 ± 14 ml in men.
pub const ESV_RANGE: ReferenceRange = ReferenceRange {
    name: "ESV",
    low: 22.0,
    high: 82.0,
    unit: "ml",
    source: MAGNETIC_RESONANCE,
};

/// Stroke volume: 87 ± 15 ml in women, 108 ± 18 ml in men.
pub const SV_RANGE: ReferenceRange = ReferenceRange {
    name: "SV",
    low: 57.0,
    high: 144.0,
    unit: "ml",
    source: MAGNETIC_RESONANCE,
};

/// Mass of the myocardium: 98 ± 21 g in women, 134 ± 21 g in men.
pub const MASS_RANGE: ReferenceRange = ReferenceRange {
    name: "mass",
    low: 56.0,
    high: 176.0,
    unit: "g",
    source: MAGNETIC_RESONANCE,
};

/// All ranges in one sentence, as the dictionary of columns explains what lies outside of them.
pub const ADULT_RANGES: &str = "Measures outside the range of healthy adults of either sex: EF 52–74 % (Lang 2015); EDV 86–214, \
                                ESV 22–82, SV 57–144 ml, mass 56–176 g (Kawel-Boehm 2015), from women's lower to men's upper limit; \
                                empty if none";

/// A measure outside its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutsideRange {
    /// Which range.
    pub range: ReferenceRange,
    /// Whether it lies below, and not above.
    pub below: bool,
}

impl std::fmt::Display for OutsideRange {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let ReferenceRange {
            name,
            low,
            high,
            unit,
            ..
        } = self.range;
        if self.below {
            write!(f, "{name} below {low} {unit}")
        } else {
            write!(f, "{name} above {high} {unit}")
        }
    }
}

impl ReferenceRange {
    /// "52–74 %".
    pub fn words(self) -> String {
        format!("{}–{} {}", self.low, self.high, self.unit)
    }

    /// How a value lies to the range; `None` inside it and at its ends.
    pub fn outside(self, value: f64) -> Option<OutsideRange> {
        let below = value < self.low;
        (below || value > self.high).then_some(OutsideRange { range: self, below })
    }
}

/// Measures outside the range of healthy adults: EF in any unit, volumes and mass where coordinates are millimetres.
pub fn outside_reference(measures: &SubjectMeasures) -> Vec<OutsideRange> {
    let millilitres = measures.unit == LengthUnit::Millimetre;
    let volume = |value: Option<f64>| value.filter(|_| millilitres);
    [
        (EF_RANGE, measures.ef.map(|ef| 100.0 * ef)),
        (EDV_RANGE, volume(measures.edv)),
        (ESV_RANGE, volume(measures.esv)),
        (SV_RANGE, volume(measures.sv)),
        (MASS_RANGE, measures.mass.map(|mass| mass.0)),
    ]
    .into_iter()
    .filter_map(|(range, value)| range.outside(value?))
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::measure_subject;
    use crate::mesh::phantom;
    use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};

    fn words(radii: [f64; 2], unit: LengthUnit) -> Vec<String> {
        let frames = radii.map(|radius| phantom::sphere(3, radius)).to_vec();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        let measured = measure_subject(&Subject::new("p", sequence, unit));
        outside_reference(&measured)
            .iter()
            .map(ToString::to_string)
            .collect()
    }

    #[test]
    fn a_dilated_heart_that_ejects_little_is_flagged_and_a_usual_one_is_not() {
        // 139 and 47 ml.
        assert_eq!(words([32.2, 22.5], LengthUnit::Millimetre), [""; 0]);
        // 303 and 205 ml, EF 32 %.
        assert_eq!(
            words([41.8, 36.7], LengthUnit::Millimetre),
            ["EF below 52 %", "EDV above 214 ml", "ESV above 82 ml"]
        );
    }

    #[test]
    fn the_sentence_has_the_limits_that_are_tested() {
        for range in [EF_RANGE, EDV_RANGE, ESV_RANGE, SV_RANGE, MASS_RANGE] {
            let limits = format!("{} {}–{}", range.name, range.low, range.high);
            assert!(ADULT_RANGES.contains(&limits), "{limits}");
        }
        assert_eq!(EF_RANGE.words(), "52–74 %");
    }

    #[test]
    fn volumes_in_file_units_have_no_range_and_ejection_fraction_has() {
        assert_eq!(words([4.0, 3.8], LengthUnit::FileUnit), ["EF below 52 %"]);
        assert_eq!(words([4.0, 2.0], LengthUnit::FileUnit), ["EF above 74 %"]);
    }
}
