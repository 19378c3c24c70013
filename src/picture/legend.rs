//! What the colours of a picture stand for: the colour bar as plain values.

use crate::picture::colour_map::ColourMap;
use crate::picture::quantity::Quantity;
use crate::picture::ticks::{logarithmic_ticks, nice_ticks, ratio_text, tick_text};
use crate::render::ColourRange;
use crate::units::LengthUnit;

/// One mark of a colour bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// The number it stands for.
    pub value: f64,
    /// Where on the bar, 0 at its low end and 1 at its high end.
    pub position: f32,
    /// The number as shown.
    pub text: String,
}

/// The note of a legend whose limits the user has set.
pub const USER_LIMITS: &str = "limits set by the user";

/// A colour bar, ready to be drawn by a panel or into a figure.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourLegend {
    /// What is shown.
    pub title: String,
    /// Unit of the numbers; empty for ratios.
    pub unit: &'static str,
    /// Whether the range is the cohort's fixed one, the subject's, or typed.
    pub note: &'static str,
    /// Numbers at the ends.
    pub limits: ColourRange,
    /// Marks from low to high.
    pub ticks: Vec<Tick>,
    /// The colours.
    pub map: ColourMap,
    /// Whether a value below the range is on show somewhere in the beat.
    pub below: bool,
    /// Whether a value above the range is on show somewhere in the beat.
    pub above: bool,
}

impl ColourLegend {
    /// Title with unit, as it stands at the bar.
    pub fn heading(&self) -> String {
        if self.unit.is_empty() {
            self.title.clone()
        } else {
            format!("{}, {}", self.title, self.unit)
        }
    }

    /// The legend of a quantity; `None` for tissue, which has no numbers. `extremes` are the
    /// least and greatest values on show.
    pub(crate) fn of(
        quantity: Quantity,
        unit: LengthUnit,
        limits: ColourRange,
        note: &'static str,
        extremes: [f32; 2],
    ) -> Option<Self> {
        Some(Self {
            title: quantity.title()?.to_owned(),
            unit: quantity.unit(unit),
            note,
            ticks: ticks(limits),
            map: quantity.colour_map()?,
            // As the renderer compares, so that an end colour on the heart is always explained.
            below: extremes[0] < limits.low,
            above: extremes[1] > limits.high,
            limits,
        })
    }
}

fn ticks(limits: ColourRange) -> Vec<Tick> {
    let (low, high) = (f64::from(limits.low), f64::from(limits.high));
    let tick = |value: f64, share: f64, text: String| Tick {
        value,
        position: share.clamp(0.0, 1.0) as f32,
        text,
    };
    if limits.logarithmic {
        return logarithmic_ticks(low, high, 5)
            .into_iter()
            .map(|value| {
                tick(
                    value,
                    (value / low).ln() / (high / low).ln(),
                    ratio_text(value),
                )
            })
            .collect();
    }
    let values = nice_ticks(low, high, 5);
    let step = values
        .windows(2)
        .next()
        .map_or(0.0, |pair| pair[1] - pair[0]);
    values
        .into_iter()
        .map(|value| tick(value, (value - low) / (high - low), tick_text(value, step)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bar_of_a_ratio_has_one_in_its_middle() {
        let limits = ColourRange {
            low: 0.5,
            high: 2.0,
            logarithmic: true,
        };
        let legend = ColourLegend::of(
            Quantity::AreaRatio,
            LengthUnit::Millimetre,
            limits,
            "",
            [0.4, 1.9],
        )
        .unwrap();
        let one = legend.ticks.iter().find(|tick| tick.text == "1").unwrap();
        assert!((one.position - 0.5).abs() < 1e-6);
        assert!(legend.below && !legend.above);
        assert_eq!(legend.heading(), "Area relative to end-diastole");
    }

    #[test]
    fn lengths_say_their_unit() {
        let limits = ColourRange {
            low: 0.0,
            high: 20.0,
            logarithmic: false,
        };
        let legend = ColourLegend::of(
            Quantity::Displacement,
            LengthUnit::FileUnit,
            limits,
            "",
            [0.0, 20.0],
        )
        .unwrap();
        assert_eq!(legend.heading(), "Displacement from end-diastole, units");
        assert_eq!(legend.ticks.last().unwrap().text, "20");
        assert!(!legend.above);
    }
}
