//! Lets the first picture of a study come before its analyses: both would take the same cores, and the picture is what
//! somebody waits for.

use std::time::{Duration, Instant};

/// Analyses begin then without a picture: the 3D view may be closed, or a subject not drawable.
const AT_MOST: Duration = Duration::from_secs(1);

/// Whose first picture is waited for.
#[derive(Debug, Default)]
pub struct FirstPicture {
    opening: u64,
    since: Option<Instant>,
    seen: bool,
}

impl FirstPicture {
    /// Whether analyses of the study of this opening wait still; asked once as a frame begins, with the opening whose
    /// subjects the frame before has drawn.
    pub fn holds_back(&mut self, opening: u64, drawn: Option<u64>, now: Instant) -> bool {
        if self.since.is_none() || self.opening != opening {
            *self = Self {
                opening,
                since: Some(now),
                seen: false,
            };
        }
        let since = *self.since.get_or_insert(now);
        self.seen |= drawn == Some(opening) || now.saturating_duration_since(since) >= AT_MOST;
        !self.seen
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analyses_begin_after_the_first_picture_of_each_study_or_after_a_second() {
        let (mut first, now) = (FirstPicture::default(), Instant::now());
        let ms = |ms| now + Duration::from_millis(ms);
        assert!(first.holds_back(1, None, now));
        assert!(first.holds_back(1, Some(0), ms(10)), "of the study before");
        assert!(!first.holds_back(1, Some(1), ms(20)));
        assert!(!first.holds_back(1, None, ms(30)), "once is enough");
        assert!(first.holds_back(2, Some(1), ms(40)));
        assert!(first.holds_back(2, None, ms(1_030)));
        assert!(!first.holds_back(2, None, ms(1_040)), "no longer");
    }
}
