//! Tables of colours that numbers are looked up in.

use std::sync::{Arc, LazyLock};

/// Colours from low to high, with the colours of what lies outside.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourMap {
    /// 256 colours, sRGB, evenly spaced.
    pub colours: Arc<[[u8; 3]]>,
    /// Colour of values below the range.
    pub below: [f32; 3],
    /// Colour of values above the range.
    pub above: [f32; 3],
}

/// Colours of a map; 256 steps are finer than an 8-bit screen shows.
const STEPS: usize = 256;

/// The diverging map of ratios: blue below 1, red above, evenly spaced over the logarithm
/// (the look's stops at 0.5, 0.71, 1, 1.41 and 2).
const RATIO_STOPS: [[u8; 3]; 5] = [
    [0x2b, 0x6c, 0xb0],
    [0x8f, 0xb8, 0xde],
    [0xf2, 0xef, 0xe9],
    [0xe9, 0xb3, 0x84],
    [0xb7, 0x47, 0x2a],
];

static VIRIDIS: LazyLock<Arc<[[u8; 3]]>> = LazyLock::new(|| table(colorous::VIRIDIS));
static CIVIDIS: LazyLock<Arc<[[u8; 3]]>> = LazyLock::new(|| table(colorous::CIVIDIS));
static RATIO: LazyLock<Arc<[[u8; 3]]>> = LazyLock::new(|| {
    (0..STEPS)
        .map(|i| between_stops(&RATIO_STOPS, i as f64 / (STEPS - 1) as f64))
        .collect()
});

impl ColourMap {
    /// Sequential, dark blue to yellow. Outside: near black, and pale cream.
    pub fn viridis() -> Self {
        Self {
            colours: Arc::clone(&VIRIDIS),
            below: [0.13, 0.0, 0.17],
            above: [1.0, 0.97, 0.80],
        }
    }

    /// Sequential, made to look the same to people with and without colour blindness.
    pub fn cividis() -> Self {
        Self {
            colours: Arc::clone(&CIVIDIS),
            below: [0.0, 0.05, 0.18],
            above: [1.0, 0.98, 0.80],
        }
    }

    /// The colour at a share of the way from low to high; beyond the ends, theirs.
    pub fn at(&self, share: f64) -> [u8; 3] {
        let bytes = |colour: [f32; 3]| colour.map(|part| (255.0 * part).round() as u8);
        if share < 0.0 {
            return bytes(self.below);
        }
        if share > 1.0 {
            return bytes(self.above);
        }
        let last = self.colours.len().saturating_sub(1);
        let place = (share * last as f64).round() as usize;
        self.colours.get(place).copied().unwrap_or_default()
    }

    /// Diverging about the middle, for ratios on a logarithmic scale. Outside: deeper ends.
    pub fn ratio() -> Self {
        Self {
            colours: Arc::clone(&RATIO),
            below: [0.07, 0.22, 0.42],
            above: [0.42, 0.10, 0.06],
        }
    }
}

fn table(gradient: colorous::Gradient) -> Arc<[[u8; 3]]> {
    (0..STEPS)
        .map(|i| {
            let colour = gradient.eval_rational(i, STEPS);
            [colour.r, colour.g, colour.b]
        })
        .collect()
}

/// Linear between evenly spaced stops; `share` in `0..=1`.
fn between_stops(stops: &[[u8; 3]], share: f64) -> [u8; 3] {
    let position = share.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
    let first = (position as usize).min(stops.len() - 2);
    let part = position - first as f64;
    std::array::from_fn(|channel| {
        let (from, to) = (stops[first][channel], stops[first + 1][channel]);
        (f64::from(from) + part * (f64::from(to) - f64::from(from))).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn luminance([r, g, b]: [u8; 3]) -> f64 {
        0.2126 * f64::from(r) + 0.7152 * f64::from(g) + 0.0722 * f64::from(b)
    }

    #[test]
    fn sequential_maps_grow_lighter_from_low_to_high() {
        for map in [ColourMap::viridis(), ColourMap::cividis()] {
            assert_eq!(map.colours.len(), 256);
            // One step of 8-bit rounding may undo an increase.
            let falls = map
                .colours
                .windows(2)
                .filter(|pair| luminance(pair[1]) < luminance(pair[0]) - 1.0);
            assert_eq!(falls.count(), 0);
        }
        assert_eq!(ColourMap::viridis().colours[0], [68, 1, 84]);
    }

    #[test]
    fn the_ratio_map_is_palest_at_one() {
        let colours = ColourMap::ratio().colours;
        let palest =
            (0..256).max_by(|&a, &b| luminance(colours[a]).total_cmp(&luminance(colours[b])));
        assert!((127..=128).contains(&palest.unwrap()));
        assert_eq!(colours[0], RATIO_STOPS[0]);
        assert_eq!(colours[255], RATIO_STOPS[4]);
    }
}
