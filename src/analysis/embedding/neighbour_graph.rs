//! Items linked to their neighbours, and the shortest ways along the links.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::{Progress, Stopped};

use super::Neighbours;

/// Links between items, each in both directions; of two items linked twice the lengths agree.
pub(super) struct NeighbourGraph {
    starts: Vec<u32>,
    ends: Vec<u32>,
    lengths: Vec<f64>,
}

impl NeighbourGraph {
    /// Links each item to its neighbours, and these to it.
    pub(super) fn new(neighbours: &Neighbours) -> Self {
        let links = (0..neighbours.len()).flat_map(|item| {
            let lengths = neighbours.distances_of(item);
            (neighbours.of(item).iter().zip(lengths))
                .map(move |(&other, &length)| (item as u32, other, length))
        });
        Self::of_links(neighbours.len(), links)
    }

    fn of_links(items: usize, links: impl Iterator<Item = (u32, u32, f64)>) -> Self {
        let mut both: Vec<(u32, u32, f64)> = links
            .flat_map(|(a, b, length)| [(a, b, length), (b, a, length)])
            .collect();
        both.sort_unstable_by_key(|&(a, b, _)| (a, b));
        both.dedup_by_key(|&mut (a, b, _)| (a, b));
        let mut starts = vec![0; items + 1];
        for &(a, _, _) in &both {
            starts[a as usize + 1] += 1;
        }
        for item in 0..items {
            starts[item + 1] += starts[item];
        }
        Self {
            starts,
            ends: both.iter().map(|&(_, b, _)| b).collect(),
            lengths: both.iter().map(|&(_, _, length)| length).collect(),
        }
    }

    fn items(&self) -> usize {
        self.starts.len() - 1
    }

    fn links_of(&self, item: usize) -> impl Iterator<Item = (usize, f64)> {
        let range = self.starts[item] as usize..self.starts[item + 1] as usize;
        (self.ends[range.clone()].iter())
            .zip(&self.lengths[range])
            .map(|(&end, &length)| (end as usize, length))
    }

    /// Adds the shortest links that join all parts into one; returns how many parts there were.
    ///
    /// # Errors
    /// If stopped.
    pub(super) fn join(
        &mut self,
        distances: &DistanceMatrix,
        progress: &Progress,
    ) -> Result<usize, Stopped> {
        let (mut part_of, parts) = self.parts();
        if parts <= 1 {
            return Ok(parts);
        }
        // Kruskal's rule on the shortest link of each two parts.
        let mut shortest = vec![None; parts * parts];
        for i in 0..distances.size() {
            progress.check()?;
            for (offset, &length) in distances.row_right_of_diagonal(i).iter().enumerate() {
                let j = i + 1 + offset;
                let (a, b) = (part_of[i].min(part_of[j]), part_of[i].max(part_of[j]));
                let known = &mut shortest[a * parts + b];
                if a != b && known.is_none_or(|(known, _, _)| length < known) {
                    *known = Some((length, i, j));
                }
            }
        }
        let mut candidates: Vec<_> = shortest.into_iter().flatten().collect();
        candidates.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
        let mut links = self.all_links();
        for (length, i, j) in candidates {
            progress.check()?;
            let (a, b) = (part_of[i], part_of[j]);
            if a != b {
                links.push((i as u32, j as u32, length));
                part_of
                    .iter_mut()
                    .filter(|part| **part == b)
                    .for_each(|part| *part = a);
            }
        }
        *self = Self::of_links(self.items(), links.into_iter());
        Ok(parts)
    }

    fn all_links(&self) -> Vec<(u32, u32, f64)> {
        (0..self.items())
            .flat_map(|a| {
                self.links_of(a)
                    .map(move |(b, length)| (a as u32, b as u32, length))
            })
            .filter(|(a, b, _)| a < b)
            .collect()
    }

    /// The part of each item, numbered in the order of first items, and their number.
    fn parts(&self) -> (Vec<usize>, usize) {
        let mut part_of = vec![usize::MAX; self.items()];
        let mut parts = 0;
        for first in 0..self.items() {
            if part_of[first] != usize::MAX {
                continue;
            }
            part_of[first] = parts;
            let mut open = vec![first];
            while let Some(item) = open.pop() {
                for (other, _) in self.links_of(item) {
                    if part_of[other] == usize::MAX {
                        part_of[other] = parts;
                        open.push(other);
                    }
                }
            }
            parts += 1;
        }
        (part_of, parts)
    }

    /// Who finds shortest ways along these links; its memory is kept from one question to the next.
    pub(super) fn traveller(&self) -> Traveller<'_> {
        Traveller {
            graph: self,
            lengths: vec![f64::INFINITY; self.items()],
            open: BinaryHeap::new(),
        }
    }
}

/// Finds shortest ways.
pub(super) struct Traveller<'a> {
    graph: &'a NeighbourGraph,
    lengths: Vec<f64>,
    open: BinaryHeap<Reverse<(u64, u32)>>,
}

impl Traveller<'_> {
    /// Lengths of the shortest ways from one item to all, by Dijkstra's rule; infinite to other
    /// parts.
    pub(super) fn lengths_from(&mut self, from: usize) -> &[f64] {
        self.lengths.fill(f64::INFINITY);
        self.lengths[from] = 0.0;
        self.open.push(Reverse((0, from as u32)));
        while let Some(Reverse((bits, item))) = self.open.pop() {
            let here = f64::from_bits(bits);
            if here > self.lengths[item as usize] {
                continue;
            }
            for (other, length) in self.graph.links_of(item as usize) {
                let by = here + length;
                if by < self.lengths[other] {
                    self.lengths[other] = by;
                    // Bits of numbers that are not negative are in the order of the numbers.
                    self.open.push(Reverse((by.to_bits(), other as u32)));
                }
            }
        }
        &self.lengths
    }
}
