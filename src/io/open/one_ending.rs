//! One frame in several formats: which file is read.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use super::frame_name::FrameName;
use crate::study::Notice;
use crate::study::checks::counted;

/// Keeps one file of each frame where several formats hold it: that of the commonest ending. No frame is lost with a
/// format that only some frames have.
pub(super) fn one_ending<T>(
    members: Vec<T>,
    frame: impl Fn(&T) -> Option<FrameName>,
    path: impl Fn(&T) -> &Path,
    notices: &mut Vec<Notice>,
) -> Vec<T> {
    let frames: BTreeSet<Option<FrameName>> = members.iter().map(&frame).collect();
    if frames.len() == members.len() {
        return members;
    }
    let ending = |member: &T| {
        let ending = path(member).extension().unwrap_or_default();
        ending.to_string_lossy().to_ascii_lowercase()
    };
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for member in &members {
        *counts.entry(ending(member)).or_default() += 1;
    }
    let rank = |ending: &String| (Reverse(counts.get(ending)), ending.clone());
    let mut best: BTreeMap<Option<FrameName>, String> = BTreeMap::new();
    for member in &members {
        let own = ending(member);
        let known = best.entry(frame(member)).or_insert_with(|| own.clone());
        if rank(&own) < rank(known) {
            *known = own;
        }
    }
    let (kept, left): (Vec<T>, Vec<T>) = members
        .into_iter()
        .partition(|member| best.get(&frame(member)) == Some(&ending(member)));
    let mut left_out: BTreeMap<String, usize> = BTreeMap::new();
    for member in left {
        *left_out.entry(ending(&member)).or_default() += 1;
    }
    notices.extend(left_out.into_iter().map(|(ending, count)| {
        let hold = if count == 1 {
            "holds the same frame and is"
        } else {
            "hold the same frames and are"
        };
        Notice::info(format!(
            "{} with the extension .{ending} {hold} not read",
            counted(count, "file", "files")
        ))
    }));
    kept
}
