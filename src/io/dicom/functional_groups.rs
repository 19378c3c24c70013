//! Frames of enhanced files, whose attributes stand in groups that all frames share or that each has its own (PS3.3, C.7.6.16).

use std::sync::Arc;

use super::element::DataSet;
use super::pixels::Pixels;
use super::plane::{FileFacts, Plane};
use super::tag::{
    CARDIAC_DELAY, CARDIAC_PERCENT, CARDIAC_SYNCHRONIZATION, DIMENSION_INDEX_SEQUENCE,
    DIMENSION_INDEX_VALUES, DIMENSION_POINTER, FRAME_CONTENT, PER_FRAME_GROUPS, PIXEL_MEASURES,
    PLANE_ORIENTATION, PLANE_POSITION, SHARED_GROUPS, TEMPORAL_POSITION_INDEX, TRIGGER_TIME, Tag,
    VALUE_TRANSFORMATION,
};

/// The groups that are looked into.
const GROUPS: [Tag; 6] = [
    PLANE_POSITION,
    PLANE_ORIENTATION,
    PIXEL_MEASURES,
    VALUE_TRANSFORMATION,
    FRAME_CONTENT,
    CARDIAC_SYNCHRONIZATION,
];

/// The groups of attributes of a file.
pub(super) struct FunctionalGroups<'a> {
    shared: Option<DataSet<'a>>,
    frames: Vec<DataSet<'a>>,
    /// Which of the index values of a frame counts instants.
    dimension_of_time: Option<usize>,
}

impl<'a> FunctionalGroups<'a> {
    /// Those of a file; `None` if it has none.
    pub(super) fn new(set: &DataSet<'a>) -> Option<Self> {
        let shared = set.item(SHARED_GROUPS);
        let frames = set.items(PER_FRAME_GROUPS);
        if shared.is_none() && frames.is_empty() {
            return None;
        }
        // By the tags that the file names, not by their usual order (rordenlab/dcm2niix#809).
        let dimensions = set.items(DIMENSION_INDEX_SEQUENCE);
        let dimension_of_time = dimensions.iter().position(|dimension| {
            let named = dimension.named_tags(DIMENSION_POINTER);
            let times = [
                TEMPORAL_POSITION_INDEX,
                CARDIAC_PERCENT,
                CARDIAC_DELAY,
                TRIGGER_TIME,
            ];
            named.first().is_some_and(|tag| times.contains(tag))
        });
        Some(Self {
            shared,
            frames,
            dimension_of_time,
        })
    }

    /// The attributes of one frame: its own first, then those of all.
    pub(super) fn of_frame(&self, frame: usize) -> Vec<DataSet<'a>> {
        let own = self.frames.get(frame);
        let both = [own, self.shared.as_ref()];
        let sets = both.into_iter().flatten();
        sets.flat_map(|set| GROUPS.iter().filter_map(|&group| set.item(group)))
            .collect()
    }

    /// The first item of any group of one frame, its own first.
    pub(super) fn group(&self, frame: usize, group: Tag) -> Option<DataSet<'a>> {
        let own = self.frames.get(frame).and_then(|set| set.item(group));
        own.or_else(|| self.shared.as_ref()?.item(group))
    }

    /// The frames of the file with their places and instants.
    pub(super) fn planes(
        &self,
        set: &DataSet<'a>,
        facts: &Arc<FileFacts>,
        pixels: &Arc<Pixels>,
    ) -> Vec<Plane> {
        let frames = 0..pixels.layout.frames;
        frames
            .map(|frame| {
                let groups = self.of_frame(frame);
                let sets: Vec<_> = groups.iter().chain([set]).collect();
                let mut plane = Plane::new(facts, pixels, frame, &sets);
                let index = self.dimension_of_time.and_then(|dimension| {
                    let values = groups
                        .iter()
                        .find_map(|g| g.numbers(DIMENSION_INDEX_VALUES));
                    values?.get(dimension).copied()
                });
                plane.when = plane.when.with_dimension(index);
                plane
            })
            .collect()
    }
}
