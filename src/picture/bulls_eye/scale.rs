//! What the bull's-eye shows, and how numbers become colours and words on it.

use serde::{Deserialize, Serialize};

use crate::picture::colour_map::ColourMap;
use crate::picture::colour_ranges::CohortColourRanges;
use crate::picture::quantity::Quantity;
use crate::picture::ticks::{logarithmic_ticks, nice_ticks, ratio_text, tick_text};
use crate::render::ColourRange;
use crate::units::LengthUnit;

/// What the bull's-eye shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BullsEyeQuantity {
    /// Thickening from end-diastole to end-systole, as the whole beat tells it.
    #[default]
    Thickening,
    /// PT of the pose on screen against end-diastole.
    // The name in pictures and settings that were saved.
    #[serde(rename = "ratio")]
    ThicknessRatio,
    /// How far the inner wall has moved since end-diastole at the pose on screen.
    Displacement,
    /// Area of the inner wall at the pose on screen against end-diastole.
    AreaRatio,
}

impl BullsEyeQuantity {
    /// All, in the order in which one key steps through them.
    pub const ALL: [Self; 4] = [
        Self::Thickening,
        Self::ThicknessRatio,
        Self::Displacement,
        Self::AreaRatio,
    ];

    /// The next one, and after the last the first.
    pub fn next(self) -> Self {
        let place = Self::ALL.iter().position(|&other| other == self);
        Self::ALL[place.map_or(0, |place| (place + 1) % Self::ALL.len())]
    }

    /// The word on its chooser.
    pub fn name(self) -> &'static str {
        match self {
            Self::Thickening => "Thickening",
            Self::ThicknessRatio => "PT, this pose",
            Self::Displacement => "Displacement",
            Self::AreaRatio => "Area ratio",
        }
    }

    /// What has the same colours on the heart.
    pub fn on_heart(self) -> Quantity {
        match self {
            Self::Thickening | Self::ThicknessRatio => Quantity::ThicknessRatio,
            Self::Displacement => Quantity::Displacement,
            Self::AreaRatio => Quantity::AreaRatio,
        }
    }
}

/// Colours and words of one quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct BullsEyeScale {
    /// What is shown.
    pub quantity: BullsEyeQuantity,
    /// Numbers at the ends of the colours.
    pub limits: ColourRange,
    /// The colours.
    pub map: ColourMap,
    unit: LengthUnit,
}

impl Default for BullsEyeScale {
    fn default() -> Self {
        Self::of(
            BullsEyeQuantity::default(),
            &CohortColourRanges::default(),
            None,
            LengthUnit::default(),
        )
    }
}

impl BullsEyeScale {
    /// The scale of a quantity: that of the same quantity on the heart, with its typed limits where there are any.
    pub fn of(
        quantity: BullsEyeQuantity,
        cohort: &CohortColourRanges,
        typed: Option<[f64; 2]>,
        unit: LengthUnit,
    ) -> Self {
        let range = cohort.range(quantity.on_heart());
        let typed = typed.filter(|[low, high]| high > low && (*low > 0.0 || !range.logarithmic));
        let limits = typed.map_or(range, |[low, high]| ColourRange {
            low: low as f32,
            high: high as f32,
            ..range
        });
        Self {
            quantity,
            limits,
            map: quantity
                .on_heart()
                .colour_map()
                .unwrap_or_else(ColourMap::ratio),
            unit,
        }
    }

    /// Share of the way along the colours; not a number where the value has no place on them.
    pub fn share(&self, value: f64) -> f64 {
        let (low, high) = (f64::from(self.limits.low), f64::from(self.limits.high));
        if self.limits.logarithmic {
            (value / low).ln() / (high / low).ln()
        } else {
            (value - low) / (high - low)
        }
    }

    /// The colour of a value; `None` for no number.
    pub fn colour(&self, value: f64) -> Option<[u8; 3]> {
        let share = self.share(value);
        (value.is_finite() && share.is_finite()).then(|| self.map.at(share))
    }

    /// Places along the bar with their texts, about so many.
    pub fn ticks(&self, wanted: usize) -> Vec<(f64, String)> {
        let (low, high) = (f64::from(self.limits.low), f64::from(self.limits.high));
        if self.limits.logarithmic {
            let values = logarithmic_ticks(low, high, wanted).into_iter();
            let text = |value: f64| match self.quantity {
                BullsEyeQuantity::Thickening => self.text(value),
                _ => ratio_text(value),
            };
            return values.map(|value| (value, text(value))).collect();
        }
        let values = nice_ticks(low, high, wanted);
        let step = values
            .get(1)
            .map_or(high - low, |second| second - values[0]);
        let texts = values.iter().map(|&value| (value, tick_text(value, step)));
        texts.collect()
    }

    /// A value as it stands in its segment: "1.52", "52" percent, "7.3" millimetres.
    pub fn text(&self, value: f64) -> String {
        match self.quantity {
            BullsEyeQuantity::ThicknessRatio | BullsEyeQuantity::AreaRatio => format!("{value:.2}"),
            BullsEyeQuantity::Displacement => format!("{value:.1}"),
            BullsEyeQuantity::Thickening => {
                let percent = (100.0 * (value - 1.0)).round();
                if percent < 0.0 {
                    format!("−{:.0}", -percent)
                } else {
                    format!("{:.0}", percent.abs())
                }
            }
        }
    }

    /// Title with unit, as it stands at the colour bar; `moment` is the pose on screen, such as "ES".
    pub fn title(&self, moment: &str) -> String {
        match self.quantity {
            BullsEyeQuantity::Thickening => "thickening ED to ES, %".to_owned(),
            BullsEyeQuantity::ThicknessRatio => {
                format!("thickness ratio PT to end-diastole · {moment}")
            }
            BullsEyeQuantity::AreaRatio => {
                format!("endocardial area relative to end-diastole · {moment}")
            }
            BullsEyeQuantity::Displacement => {
                format!(
                    "displacement from end-diastole, {} · {moment}",
                    self.unit.length_symbol()
                )
            }
        }
    }

    /// A value with what it is and its unit: "PT 1.52 × at ES".
    pub fn words(&self, value: f64, moment: &str) -> String {
        let text = self.text(value);
        match self.quantity {
            BullsEyeQuantity::Thickening => format!("thickening {text} %, ED to ES"),
            BullsEyeQuantity::ThicknessRatio => format!("PT {text} × at {moment}"),
            BullsEyeQuantity::AreaRatio => format!("endocardial area {text} × at {moment}"),
            BullsEyeQuantity::Displacement => {
                format!(
                    "{text} {} from end-diastole at {moment}",
                    self.unit.length_symbol()
                )
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scale(quantity: BullsEyeQuantity, typed: Option<[f64; 2]>) -> BullsEyeScale {
        let cohort = CohortColourRanges {
            displacement: ColourRange {
                low: 0.0,
                high: 12.0,
                logarithmic: false,
            },
            ..CohortColourRanges::default()
        };
        BullsEyeScale::of(quantity, &cohort, typed, LengthUnit::Millimetre)
    }

    #[test]
    fn values_are_said_with_the_digits_they_deserve() {
        let thickening = scale(BullsEyeQuantity::Thickening, None);
        assert_eq!(thickening.text(1.518), "52");
        assert_eq!(thickening.text(0.951), "−5");
        assert_eq!(thickening.text(0.999), "0");
        assert_eq!(thickening.words(1.518, "ES"), "thickening 52 %, ED to ES");
        let ratio = scale(BullsEyeQuantity::ThicknessRatio, None);
        assert_eq!(ratio.text(1.518), "1.52");
        assert_eq!(ratio.words(1.518, "ES"), "PT 1.52 × at ES");
        let way = scale(BullsEyeQuantity::Displacement, None);
        assert_eq!(
            way.words(7.26, "frame 2"),
            "7.3 mm from end-diastole at frame 2"
        );
        assert_eq!(way.title("ES"), "displacement from end-diastole, mm · ES");
    }

    #[test]
    fn colours_run_from_end_to_end_and_unusable_limits_are_not_taken() {
        for quantity in BullsEyeQuantity::ALL {
            let scale = scale(quantity, None);
            let (low, high) = (f64::from(scale.limits.low), f64::from(scale.limits.high));
            assert_eq!([scale.share(low), scale.share(high)], [0.0, 1.0]);
            assert!(scale.ticks(4).len() > 1, "{quantity:?}");
            assert_eq!(scale.colour(f64::NAN), None);
        }
        let ratio = BullsEyeQuantity::ThicknessRatio;
        assert_eq!(scale(ratio, Some([-1.0, 1.5])), scale(ratio, None));
        assert_eq!(scale(ratio, Some([1.5, 1.5])), scale(ratio, None));
        assert_eq!(scale(ratio, Some([0.8, 1.5])).limits.high, 1.5);
        assert_eq!(scale(ratio, None).colour(0.0), None);
    }

    #[test]
    fn one_key_steps_through_all_quantities() {
        let mut quantity = BullsEyeQuantity::default();
        for _ in BullsEyeQuantity::ALL {
            quantity = quantity.next();
        }
        assert_eq!(quantity, BullsEyeQuantity::default());
    }
}
