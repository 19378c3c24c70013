//! What was read: series, contours, and what was left out.

use std::collections::BTreeMap;

use super::contours::ContouredStructure;
use super::sources_of_slices::SliceSource;
use crate::io::image_file::{ImageSeries, ReadImageError};

/// What files held.
#[derive(Debug, Default)]
pub struct DicomReading {
    /// The series: by study, then in the order of their numbers, then of their files.
    pub series: Vec<ImageSeries>,
    /// The study that each series is of, counted from 0 in the order of the files.
    pub studies: Vec<usize>,
    /// Where the images of the files went, for stacks of single images.
    pub sources: Vec<SliceSource>,
    /// The names (last parts of the paths) of all files that were read, by the number that [`SliceSource`] gives them.
    pub files: Vec<String>,
    /// The structures of files of contours.
    pub contours: Vec<ContouredStructure>,
    /// What is no part of a series.
    pub left_out: Vec<LeftOut>,
}

/// Files or images that were left out.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// How many files, or images where a file holds several.
    pub count: usize,
    /// The name of one of the files; `None` where images of a series are meant.
    pub file: Option<String>,
    /// Why.
    pub reason: ReadImageError,
}

impl DicomReading {
    /// Notes images that are left out, once for each reason.
    pub(super) fn leave_out(&mut self, count: usize, reason: ReadImageError) {
        let known = self
            .left_out
            .iter_mut()
            .find(|out| out.file.is_none() && out.reason == reason);
        match known {
            Some(out) => out.count += count,
            None => self.left_out.push(LeftOut {
                count,
                file: None,
                reason,
            }),
        }
    }

    /// As [`leave_out`](Self::leave_out), with a reason in words.
    pub(super) fn leave_out_planes(&mut self, count: usize, reason: &str) {
        self.leave_out(count, ReadImageError::Unsupported(reason.to_owned()));
    }

    /// Files that could not be read, once for each reason.
    pub(super) fn count_refused(&mut self, refused: Vec<(String, ReadImageError)>) {
        let mut places: BTreeMap<String, usize> = BTreeMap::new();
        for (name, reason) in refused {
            let place = *places
                .entry(reason.to_string())
                .or_insert(self.left_out.len());
            match self.left_out.get_mut(place) {
                Some(out) => out.count += 1,
                None => self.left_out.push(LeftOut {
                    count: 1,
                    file: Some(name),
                    reason,
                }),
            }
        }
    }
}
