//! Which image of which file each slice of a series came from, for what names images by themselves: contours.

use std::fmt;

use super::series::instants_of;
use super::stack::Stack;

/// Where the image of one file went.
#[derive(Clone, PartialEq, Eq)]
pub struct SliceSource {
    /// The unique name of the image (SOP Instance UID), by which other files refer to it. It is never shown.
    pub instance: String,
    /// Its frame in that file, from 0.
    pub frame: usize,
    /// The place of the file among all that were read.
    pub file: usize,
    /// The series, counted from 0.
    pub series: usize,
    /// The slice: k of its grid.
    pub slice: usize,
    /// The instant: which volume.
    pub instant: usize,
}

impl fmt::Debug for SliceSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            series,
            slice,
            instant,
            ..
        } = self;
        write!(f, "series {series}, slice {slice}, instant {instant}")
    }
}

/// The sources of a stack, as series 0.
pub(super) fn sources_of_slices(stack: &Stack) -> Vec<SliceSource> {
    let slices = stack.slices.iter().enumerate();
    let each = slices.flat_map(|(slice, planes)| {
        let planes = planes.planes.iter().take(instants_of(stack)).enumerate();
        planes.map(move |(instant, plane)| SliceSource {
            instance: plane.facts.instance.clone(),
            frame: plane.frame,
            file: plane.facts.number,
            series: 0,
            slice,
            instant,
        })
    });
    each.collect()
}
