//! Which moment of a motion is shown, in words.

/// `frame 3 (0–7)`: frames are numbered from 0, as in every table that the program writes.
pub fn frame_words(frame: usize, frame_count: usize) -> String {
    format!("frame {frame} (0–{})", frame_count.saturating_sub(1))
}

/// Whether a position, counted in frames, lies between recorded poses. Positions within a millionth of a frame count as
/// recorded: that far go rounding errors of phases.
pub fn is_between(position: f64) -> bool {
    (position - position.round()).abs() > 1e-6
}

/// The two frames that a position lies between; `None` on a frame. After the last frame comes the first.
pub fn frames_around(position: f64, frame_count: usize) -> Option<[usize; 2]> {
    let count = frame_count.max(1);
    let from = (position.max(0.0).floor() as usize) % count;
    (is_between(position) && count > 1).then_some([from, (from + 1) % count])
}

/// `frame 3 (0–7)` on a frame, `between frames 3 and 4` elsewhere.
pub fn position_words(position: f64, frame_count: usize) -> String {
    match frames_around(position, frame_count) {
        Some([from, to]) => format!("between frames {from} and {to}"),
        None => {
            let frame = (position.round().max(0.0) as usize) % frame_count.max(1);
            frame_words(frame, frame_count)
        }
    }
}

/// A share of the cycle, in `0..=1`: `53 % R-R` where the length of the cycle is known, else `53 % of the cycle by
/// frames`, for frames then share the cycle evenly.
pub fn share_words(share: f64, rr_is_known: bool) -> String {
    format!("{:.0} {}", 100.0 * share, share_unit(rr_is_known))
}

/// The unit of shares of the cycle, in percent.
pub fn share_unit(rr_is_known: bool) -> &'static str {
    match rr_is_known {
        true => "% R-R",
        false => "% of the cycle by frames",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_frame_of_eight_is_seven() {
        assert_eq!(frame_words(7, 8), "frame 7 (0–7)");
    }

    #[test]
    fn between_frames_neither_is_named_alone() {
        assert_eq!(position_words(3.0, 8), "frame 3 (0–7)");
        assert_eq!(position_words(2.999_999_9, 8), "frame 3 (0–7)");
        assert_eq!(position_words(3.2, 8), "between frames 3 and 4");
        assert_eq!(position_words(7.9, 8), "between frames 7 and 0");
        assert_eq!(position_words(0.0, 1), "frame 0 (0–0)");
    }

    #[test]
    fn no_share_is_one_of_an_interval_that_is_not_known() {
        assert_eq!(share_words(0.5, true), "50 % R-R");
        assert_eq!(share_words(0.5, false), "50 % of the cycle by frames");
    }
}
