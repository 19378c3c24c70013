//! Which planes belong to one series: geometry first, then time.

use std::collections::{BTreeMap, HashMap};

use super::plane::{Plane, SlicePlace};
use crate::study::Notice;

/// Planes of one grid, in the order of the files.
#[derive(Clone, Debug, Default)]
pub(super) struct Group {
    pub(super) planes: Vec<Plane>,
    pub(super) notices: Vec<Notice>,
}

/// Directions of one series agree to this (length of the difference of unit vectors): files write 6 digits or so.
const DIRECTION: f64 = 1e-3;
/// Distances of pixels of one series agree to this share.
const SPACING: f64 = 1e-3;
/// Slices nearer than this are at one place, in millimetres: cardiac slices are 0.3 mm apart or more.
pub(super) const SAME_PLACE_MM: f64 = 0.05;

/// Drops planes that are the same frame of the same image as an earlier one (by its unique name and its numbers), as
/// where a folder holds a file twice. Returns how many.
pub(super) fn drop_same_images(planes: &mut Vec<Plane>) -> usize {
    let before = planes.len();
    let name = |plane: &Plane| (plane.facts.instance.clone(), plane.frame);
    let mut named: HashMap<(String, usize), usize> = HashMap::new();
    for plane in planes.iter() {
        *named.entry(name(plane)).or_default() += 1;
    }
    let mut seen: HashMap<((String, usize), u64), Vec<Plane>> = HashMap::new();
    planes.retain(|plane| {
        let name = name(plane);
        if name.0.is_empty() || named.get(&name) == Some(&1) {
            return true;
        }
        let same = seen
            .entry((name, plane.pixels.digest(plane.frame)))
            .or_default();
        let again = same.iter().any(|other| other.same_numbers(plane));
        if !again {
            same.push(plane.clone());
        }
        !again
    });
    before - planes.len()
}

/// Groups of one series that a plane is compared with, the latest first: far more than there are in real ones, and few enough
/// to bound the time that a file of as many directions as frames takes.
pub(super) const AT_MOST: usize = 256;

/// Puts planes together that share series, machine, kind, size, distances and directions. A series with several of
/// these is split, and says so.
pub(super) fn groups(planes: Vec<Plane>) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    let mut by_words: BTreeMap<Words, Vec<usize>> = BTreeMap::new();
    for plane in planes {
        let candidates = by_words.entry(words(&plane)).or_default();
        let found = candidates.iter().rev().take(AT_MOST).copied().find(|&n| {
            let first = groups.get(n).and_then(|group| group.planes.first());
            first.is_some_and(|first| same_grid(first, &plane))
        });
        match found.and_then(|n| groups.get_mut(n)) {
            Some(group) => group.planes.push(plane),
            None => {
                candidates.push(groups.len());
                groups.push(Group {
                    planes: vec![plane],
                    notices: Vec::new(),
                });
            }
        }
    }
    let mut by_series: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (words, parts) in by_words {
        by_series.entry(words.0).or_default().extend(parts);
    }
    for parts in by_series.values().filter(|parts| parts.len() > 1) {
        let note = Notice::warning(format!(
            "one series holds {} sorts of slices (by direction, pixels, kind or echo); each stands for itself",
            parts.len()
        ));
        for &part in parts {
            if let Some(group) = groups.get_mut(part) {
                group.notices.push(note.clone());
            }
        }
    }
    groups
}

/// What must be equal to the letter or bit.
pub(super) type Words = (
    String,
    Option<&'static str>,
    String,
    String,
    u64,
    [usize; 2],
);

/// Those of a plane.
pub(super) fn words(plane: &Plane) -> Words {
    let facts = &plane.facts;
    // A file without a series, or without a place, is one of its own.
    let alone = facts.series.is_empty() || plane.place.is_none();
    let series = match alone {
        true => format!("file {}", facts.number),
        false => facts.series.clone(),
    };
    (
        series,
        facts.modality.map(|modality| modality.letters()),
        facts.class.clone(),
        // The third word tells magnitude from phase, and the like.
        facts.image_type.get(2).cloned().unwrap_or_default(),
        plane.echo_ms.unwrap_or(0.0).to_bits(),
        [plane.pixels.layout.columns, plane.pixels.layout.rows],
    )
}

/// Whether two planes have the same distances of pixels and directions.
pub(super) fn same_grid(a: &Plane, b: &Plane) -> bool {
    let spacing = match (a.spacing, b.spacing) {
        (Some(a), Some(b)) => (0..2).all(|n| (a[n] - b[n]).abs() <= SPACING * a[n]),
        (None, None) => true,
        _ => false,
    };
    spacing
        && match (&a.place, &b.place) {
            (Some(a), Some(b)) => same_directions(a, b),
            (None, None) => true,
            _ => false,
        }
}

fn same_directions(a: &SlicePlace, b: &SlicePlace) -> bool {
    (a.row - b.row).norm() < DIRECTION && (a.column - b.column).norm() < DIRECTION
}
