//! Outlines as a file has them, before it is known in which image they lie.

use std::collections::BTreeMap;

use crate::image::{ContourPart, MarkedPoints};
use crate::io::{Limits, ReadImageError};
use crate::mesh::Point3;
use crate::study::Notice;
use crate::study::checks::counted;

/// One outline.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Outline {
    pub part: ContourPart,
    pub place: OutlinePlace,
}

/// Where an outline lies.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum OutlinePlace {
    /// In one image: columns and rows; whole numbers, from 0, are the centres of pixels.
    InImage {
        image: ImageName,
        corners: Vec<[f64; 2]>,
    },
    /// In the world (LPS, millimetres).
    InWorld {
        frame: FrameName,
        points: Vec<Point3>,
    },
}

/// How a file of outlines names an image.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum ImageName {
    /// By the unique name of the image (SOP Instance UID).
    Instance(String),
    /// By the last number in the name of its file.
    Number(u32),
}

/// How a file of outlines names an instant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum FrameName {
    /// Not at all.
    Unsaid,
    /// By a number from 0.
    FromZero(u32),
    /// By a number, from 0 or 1.
    Number(u32),
    /// By the unique name of an image (SOP Instance UID).
    Instance(String),
}

/// What one file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct OutlineFile {
    pub outlines: Vec<Outline>,
    pub points: MarkedPoints,
    /// What is no outline of the left ventricle or the right cavity in slices across, and how often it occurs.
    pub passed_over: BTreeMap<&'static str, usize>,
}

impl OutlineFile {
    pub(super) fn pass_over(&mut self, what: &'static str) {
        *self.passed_over.entry(what).or_default() += 1;
    }

    /// Adds what another file holds; points that are known stay.
    pub(super) fn join(&mut self, other: Self) {
        self.outlines.extend(other.outlines);
        let MarkedPoints {
            apex,
            base,
            septum,
            blood,
        } = other.points;
        self.points.apex = self.points.apex.or(apex);
        self.points.base = self.points.base.or(base);
        self.points.septum = self.points.septum.or(septum);
        self.points.blood = self.points.blood.or(blood);
        for (what, count) in other.passed_over {
            *self.passed_over.entry(what).or_default() += count;
        }
    }

    /// What was passed over.
    pub(super) fn notices(&self) -> Vec<Notice> {
        let each = self.passed_over.iter();
        each.map(|(what, &count)| {
            Notice::info(format!(
                "{} left out: {what}",
                counted(count, "outline", "outlines")
            ))
        })
        .collect()
    }
}

/// Counts points while a file is read, and refuses too many.
pub(super) struct PointBudget {
    most: usize,
    left: usize,
}

impl PointBudget {
    pub(super) fn new(limits: &Limits) -> Self {
        Self {
            most: limits.vertices,
            left: limits.vertices,
        }
    }

    /// Takes some.
    ///
    /// # Errors
    /// If there are more than one file may have.
    pub(super) fn take(&mut self, count: usize) -> Result<(), ReadImageError> {
        self.left = self
            .left
            .checked_sub(count)
            .ok_or(ReadImageError::TooMany {
                what: "points of contours or more",
                count: self.most as u64 + 1,
                most: self.most as u64,
            })?;
        Ok(())
    }
}

/// The mean of points; `None` if there are none.
pub(super) fn mean(points: &[Point3]) -> Option<Point3> {
    let sum = points
        .iter()
        .map(|point| point.coords)
        .reduce(|a, b| a + b)?;
    Some(Point3::from(sum / points.len() as f64))
}

/// What a name says that an outline goes around; `None` where it says nothing of these, or something else.
pub(super) fn part_of_name(name: &str) -> Option<ContourPart> {
    let lower = name.to_ascii_lowercase();
    let words: Vec<&str> = lower
        .split(|c: char| !c.is_ascii_alphanumeric())
        .map(|word| word.trim_end_matches(|c: char| c.is_ascii_digit()))
        .collect();
    let any = |known: &[&str]| words.iter().any(|word| known.contains(word));
    let begins = |start: &str| words.iter().any(|word| word.starts_with(start));
    let right = any(&["rv", "right"]) || begins("rvendo");
    let outer = begins("epi") || begins("lvepi") || begins("rvepi");
    match (right, begins("endo") || begins("lvendo"), outer) {
        (true, _, false) => Some(ContourPart::RightCavity),
        (false, true, false) => Some(ContourPart::Endocardium),
        (false, false, true) => Some(ContourPart::Epicardium),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_what_an_outline_goes_around() {
        use ContourPart::{Endocardium, Epicardium, RightCavity};
        for (name, part) in [
            ("endo_slice3_frame0", Some(Endocardium)),
            ("LV-Epicardium 2", Some(Epicardium)),
            ("lvendo", Some(Endocardium)),
            ("RV endo", Some(RightCavity)),
            ("right ventricle", Some(RightCavity)),
            ("rv_epi", None),
            ("endo and epi", None),
            ("curve", None),
            ("nerve", None),
        ] {
            assert_eq!(part_of_name(name), part, "{name}");
        }
    }
}
