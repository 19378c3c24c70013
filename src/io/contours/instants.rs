//! Which volume of a series an outline belongs to that stands in the world.

use std::collections::BTreeSet;

use super::images::Images;
use super::outline::{FrameName, ImageName};
use crate::study::Notice;

/// Instants of a series, or those that outlines name where there is none.
pub(super) struct Instants {
    /// Volumes of the series.
    volumes: Option<usize>,
    /// What numbers that may begin at 0 or 1 begin at.
    first: u32,
    /// Without a series: numbers that occur, counted from `first`.
    numbers: Vec<u32>,
}

impl Instants {
    /// For outlines of these frames. Numbers begin at 0 if that occurs, else at 1.
    pub(super) fn of<'a>(
        frames: impl Iterator<Item = &'a FrameName> + Clone,
        volumes: Option<usize>,
    ) -> Self {
        let plain = frames.clone().filter_map(|frame| match frame {
            FrameName::Number(number) => Some(*number),
            _ => None,
        });
        let first = u32::from(plain.clone().next().is_some() && plain.clone().all(|n| n > 0));
        let from_zero = frames.map(|frame| match frame {
            FrameName::FromZero(number) => *number,
            FrameName::Number(number) => number.saturating_sub(first),
            _ => 0,
        });
        let numbers = from_zero.collect::<BTreeSet<u32>>();
        Self {
            volumes,
            first,
            numbers: numbers.into_iter().collect(),
        }
    }

    /// The volume of a frame; `None` if the series has no such one.
    pub(super) fn instant(
        &self,
        frame: &FrameName,
        series: usize,
        images: &Images,
    ) -> Option<usize> {
        let number = match frame {
            FrameName::Unsaid => 0,
            FrameName::FromZero(number) => *number,
            FrameName::Number(number) => number.checked_sub(self.first)?,
            FrameName::Instance(name) => {
                let place = images.place(&ImageName::Instance(name.clone()));
                return match place {
                    Some(place) => (place.series == series).then_some(place.instant),
                    // Of an image that is not there: as if it named none.
                    None => Some(0),
                };
            }
        };
        match self.volumes {
            Some(volumes) => Some(number as usize).filter(|&number| number < volumes),
            None => self.numbers.binary_search(&number).ok(),
        }
    }

    /// What was assumed about frames.
    pub(super) fn notices<'a>(
        &self,
        mut frames: impl Iterator<Item = &'a FrameName> + Clone,
        images: &Images,
    ) -> Vec<Notice> {
        let mut notices = Vec::new();
        if frames
            .clone()
            .any(|frame| matches!(frame, FrameName::Number(_)))
        {
            notices.push(Notice::info(format!(
                "numbers of instants in the names of the files are counted from {}",
                self.first
            )));
        }
        let unsaid = |frame: &FrameName| match frame {
            FrameName::Unsaid => true,
            FrameName::Instance(name) => images.place(&ImageName::Instance(name.clone())).is_none(),
            _ => false,
        };
        if self.volumes.is_some_and(|volumes| volumes > 1) && frames.any(unsaid) {
            notices.push(Notice::warning(
                "files of outlines do not say to which volume of the series they belong: the first was taken",
            ));
        }
        notices
    }
}
