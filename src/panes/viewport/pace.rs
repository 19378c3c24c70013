//! How well a picture of the 3D view can be drawn without holding the window up, by measured speed.

use std::time::{Duration, Instant};

use crate::render::{Quality, Resolution};

/// A picture at rest follows this long after the last movement.
pub const REST: Duration = Duration::from_millis(150);

/// A full picture that takes longer is not drawn while anything moves: with the rest of the window's frame, twenty
/// pictures a second are left.
const FULL_AT_MOST: Duration = Duration::from_millis(25);

/// What the pixels of moving pictures may take together.
const MOVING_AT_MOST: Duration = Duration::from_millis(14);

/// Pixels along a side of moving pictures, as shares of those at rest: steps, so that few textures are made.
const SCALES: [f32; 5] = [1.0, 0.85, 0.7, 0.6, 0.5];

/// A new measurement of the same counts this much against what was known: pictures differ in what they show.
const NEWS: f64 = 0.5;

/// Time for each pixel of a picture at both qualities, as far as it is known.
#[derive(Clone, Copy, Debug, Default)]
pub struct Pace {
    full_ns: Option<f64>,
    moving_ns: Option<f64>,
    scale: Option<f32>,
    /// When the last picture was drawn that shows something new.
    moved: Option<Instant>,
}

impl Pace {
    /// The resolution of a picture that shows something new, where `views` like it are drawn in each frame.
    pub fn of_change(&mut self, full: Resolution, views: u32, now: Instant) -> Resolution {
        self.moved = Some(now);
        let pixels = pixel_count(full) * f64::from(views.max(1));
        if !self.is_slow(pixels) {
            return full;
        }
        full.moving(self.moving_scale(pixels))
    }

    /// How long until a picture that was drawn for movement is due to be drawn in full.
    pub fn until_rest(&self, now: Instant) -> Duration {
        let moved = self.moved.map(|moved| now.saturating_duration_since(moved));
        moved.map_or(Duration::ZERO, |since| REST.saturating_sub(since))
    }

    /// Whether the next picture of this resolution is to be timed: waiting for it costs something where the graphics
    /// card works beside the processor, so that is done only as often as needed.
    pub fn asks_time(&self, resolution: Resolution) -> bool {
        match resolution.quality {
            // Of a card that was once found slow, since it was found while something else held it up.
            Quality::Full => self
                .full_ns
                .is_none_or(|ns| is_over(ns * pixel_count(resolution))),
            Quality::Moving => true,
        }
    }

    /// Takes in how long a picture took, all of it.
    pub fn took(&mut self, resolution: Resolution, time: Duration) {
        let ns = time.as_nanos() as f64 / pixel_count(resolution).max(1.0);
        match resolution.quality {
            Quality::Full => self.full_ns = Some(ns),
            Quality::Moving => {
                let known = self.moving_ns.unwrap_or(ns);
                self.moving_ns = Some(known + NEWS * (ns - known));
            }
        }
    }

    /// The first picture counts as slow: it is there sooner on any machine, and the full one follows and is timed.
    fn is_slow(&self, pixels: f64) -> bool {
        self.full_ns.is_none_or(|ns| is_over(ns * pixels))
    }

    /// Keeps the scale until another fits clearly better, so that pictures do not change their sharpness while playing.
    fn moving_scale(&mut self, pixels: f64) -> f32 {
        let allowed = MOVING_AT_MOST.as_nanos() as f64;
        let cost = |scale: f32, ns: f64| f64::from(scale * scale) * ns * pixels;
        let Some(ns) = self.moving_ns else {
            return SCALES[SCALES.len() / 2];
        };
        let fits = |margin: f64| {
            let mut scales = SCALES.into_iter();
            let found = scales.find(|&scale| cost(scale, ns) <= margin * allowed);
            found.unwrap_or(SCALES[SCALES.len() - 1])
        };
        let scale = match self.scale {
            Some(kept) if cost(kept, ns) > 1.3 * allowed => fits(1.0),
            Some(kept) => kept.max(fits(0.7)),
            None => fits(1.0),
        };
        self.scale = Some(scale);
        scale
    }
}

fn is_over(ns: f64) -> bool {
    ns > FULL_AT_MOST.as_nanos() as f64
}

fn pixel_count(resolution: Resolution) -> f64 {
    let [width, height] = resolution.pixels;
    f64::from(width) * f64::from(height)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn full() -> Resolution {
        Resolution::full([1000, 500], 1.0)
    }

    fn ms(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    /// A pace that knows what a full picture takes.
    fn pace(full_ms: u64) -> Pace {
        let mut pace = Pace::default();
        pace.took(full(), ms(full_ms));
        pace
    }

    #[test]
    fn a_fast_machine_draws_every_picture_in_full_and_is_timed_once() {
        let mut pace = pace(5);
        assert_eq!(pace.of_change(full(), 1, Instant::now()), full());
        assert!(!pace.asks_time(full()));
        assert!(Pace::default().asks_time(full()));
    }

    #[test]
    fn the_first_picture_of_an_unknown_machine_is_drawn_as_one_that_moves() {
        let first = Pace::default().of_change(full(), 1, Instant::now());
        assert_eq!(first.quality, Quality::Moving);
    }

    #[test]
    fn a_slow_machine_draws_fewer_pixels_while_something_moves() {
        let mut pace = pace(400);
        let moving = pace.of_change(full(), 1, Instant::now());
        assert_eq!(moving.quality, Quality::Moving);
        pace.took(moving, ms(60));
        let slower = pace.of_change(full(), 1, Instant::now());
        assert!(slower.pixels[0] < moving.pixels[0] && slower.pixels[0] >= 500);
        assert!((slower.pixels_per_point - slower.pixels[0] as f32 / 1000.0).abs() < 1e-3);
    }

    #[test]
    fn views_side_by_side_share_the_time() {
        let mut pace = pace(10);
        assert_eq!(
            pace.of_change(full(), 2, Instant::now()).quality,
            Quality::Full
        );
        assert_eq!(
            pace.of_change(full(), 8, Instant::now()).quality,
            Quality::Moving
        );
    }

    #[test]
    fn what_was_found_slow_once_is_timed_again_and_may_turn_out_fast() {
        let mut pace = pace(400);
        assert!(pace.asks_time(full()));
        pace.took(full(), ms(3));
        assert_eq!(pace.of_change(full(), 1, Instant::now()), full());
    }

    #[test]
    fn the_scale_stays_while_times_vary_a_little() {
        let mut pace = pace(400);
        let mut scales = Vec::new();
        for time in [20, 13, 15, 14, 16, 13, 14, 15] {
            let moving = pace.of_change(full(), 1, Instant::now());
            pace.took(moving, ms(time));
            scales.push(moving.pixels[0]);
        }
        assert!(
            scales[2..].windows(2).all(|pair| pair[0] == pair[1]),
            "{scales:?}"
        );
    }

    #[test]
    fn rest_comes_150_ms_after_the_last_change() {
        let mut pace = pace(400);
        let now = Instant::now();
        pace.of_change(full(), 1, now);
        assert_eq!(pace.until_rest(now + ms(50)), ms(100));
        assert_eq!(pace.until_rest(now + ms(200)), Duration::ZERO);
    }
}
