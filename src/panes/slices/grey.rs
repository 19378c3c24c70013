//! The window and level that the values of a series suggest.

use std::sync::{Arc, Weak};

use crate::document::GreyWindow;
use crate::io::ImageSeries;

/// So many values are looked at, evenly spread: sorting them takes about a millisecond.
const SAMPLES: usize = 20_000;
/// Shares of the values below black and above white: the brightest few of an image are seldom those that matter.
const DARKEST: f64 = 0.01;
const BRIGHTEST: f64 = 0.998;

/// The window of the series on screen, found once.
#[derive(Default)]
pub struct FoundWindow {
    of: Weak<ImageSeries>,
    window: Option<GreyWindow>,
}

impl FoundWindow {
    /// What the values of a series suggest.
    pub fn of(&mut self, series: &Arc<ImageSeries>) -> GreyWindow {
        let same = std::ptr::eq(self.of.as_ptr(), Arc::as_ptr(series));
        match self.window.filter(|_| same) {
            Some(window) => window,
            None => {
                let window = suggested(series.image.volumes());
                (self.of, self.window) = (Arc::downgrade(series), Some(window));
                window
            }
        }
    }
}

/// From the value that one in a hundred lies below to the one that two in a thousand lie above, over all instants.
fn suggested(volumes: &[Arc<[f32]>]) -> GreyWindow {
    let all: usize = volumes.iter().map(|volume| volume.len()).sum();
    let step = (all / SAMPLES).max(1);
    let values = volumes.iter().flat_map(|volume| volume.iter());
    let mut values: Vec<f32> = values.step_by(step).copied().collect();
    values.retain(|value| value.is_finite());
    values.sort_by(f32::total_cmp);
    let at = |share: f64| {
        let last = values.len().saturating_sub(1);
        let place = (share * last as f64).round() as usize;
        values.get(place).copied().map_or(0.0, f64::from)
    };
    let (black, white) = (at(DARKEST), at(BRIGHTEST));
    // Where nearly all is background, the rest decides.
    match white > black {
        true => GreyWindow::between(black, white),
        false => GreyWindow::between(at(0.0), at(1.0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_very_bright_values_do_not_darken_the_rest() {
        let mut values: Vec<f32> = (0..10_000).map(|value| value as f32).collect();
        values.extend([1e9; 5]);
        values.push(f32::NAN);
        let window = suggested(&[values.into()]);
        assert_eq!(window.grey(10_000.0), 255);
        assert!(window.width < 11_000.0, "{window:?}");
        let labels: Vec<f32> = (0..10_000).map(|n| f32::from(u8::from(n < 3))).collect();
        let window = suggested(&[labels.into()]);
        assert_eq!((window.grey(0.0), window.grey(1.0)), (0, 255));
        assert!(suggested(&[]).is_usable());
    }
}
