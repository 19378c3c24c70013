//! Which frame of a beat is shown, in words.

/// `frame 3 (0–7)`: frames are numbered from 0, as in every table that the program writes.
pub fn frame_words(frame: usize, frame_count: usize) -> String {
    format!("frame {frame} (0–{})", frame_count.saturating_sub(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_frame_of_eight_is_seven() {
        assert_eq!(frame_words(7, 8), "frame 7 (0–7)");
    }
}
