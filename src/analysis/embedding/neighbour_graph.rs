//! Items linked to their neighbours, and the shortest ways along the links.

use std::cmp::Reverse;
use std::collections::{BinaryHeap, VecDeque};

use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::{Progress, Stopped};

use super::Neighbours;

/// Items that ways are found from at once: whole vector registers.
pub(super) const LANES: usize = 8;

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
        // Two items may name each other: sorted, the repeated link lies beside its twin.
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
        // Ties by the items, so that the links that join parts are the same on every run.
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

    /// Items in groups of up to [`LANES`] that lie near each other along the links.
    pub(super) fn groups(&self) -> Vec<Vec<usize>> {
        let items = self.items();
        let mut grouped = vec![false; items];
        let mut seen_by = vec![usize::MAX; items];
        let mut groups = Vec::with_capacity(items.div_ceil(LANES));
        for first in 0..items {
            if grouped[first] {
                continue;
            }
            let mut group = Vec::with_capacity(LANES);
            // Breadth first: members of a group are near each other and share most of their ways.
            let mut open = VecDeque::from([first]);
            seen_by[first] = first;
            while let Some(item) = open.pop_front() {
                if !grouped[item] {
                    grouped[item] = true;
                    group.push(item);
                    if group.len() == LANES {
                        break;
                    }
                }
                for (other, _) in self.links_of(item) {
                    if seen_by[other] != first {
                        seen_by[other] = first;
                        open.push_back(other);
                    }
                }
            }
            groups.push(group);
        }
        groups
    }

    /// Who finds shortest ways along these links; its memory is kept from one question to the next.
    pub(super) fn traveller(&self) -> Traveller<'_> {
        Traveller {
            graph: self,
            lengths: vec![[f64::INFINITY; LANES]; self.items()],
            stale: vec![false; self.items()],
            order: Vec::with_capacity(self.items()),
            open: BinaryHeap::new(),
        }
    }
}

/// Finds shortest ways from several items at once.
pub(super) struct Traveller<'a> {
    graph: &'a NeighbourGraph,
    lengths: Vec<[f64; LANES]>,
    stale: Vec<bool>,
    order: Vec<usize>,
    open: BinaryHeap<Reverse<(u64, u32)>>,
}

impl Traveller<'_> {
    /// Lengths of the shortest ways from up to [`LANES`] items, one lane each, to all; infinite to
    /// other parts.
    ///
    /// From the first item by Dijkstra's rule. The others lie near it: so in the order in which it
    /// reached items, ways from all of them are all but found in one sweep, and a few sweeps over what is still
    /// stale, there and back, finish them. As adding a length never turns an order round, lengths are
    /// those that Dijkstra's rule gives for each, bit for bit, in a third of the time.
    pub(super) fn lengths_from(&mut self, from: &[usize]) -> &[[f64; LANES]] {
        self.lengths.fill([f64::INFINITY; LANES]);
        if let Some(&first) = from.first() {
            self.settle_first(first);
        }
        for (lane, &item) in from.iter().enumerate().skip(1) {
            self.lengths[item][lane] = 0.0;
        }
        // All are offered on once: a lane may begin anywhere.
        self.order.iter().for_each(|&item| self.stale[item] = true);
        let mut any = true;
        while any {
            any = false;
            for at in 0..self.order.len() {
                any |= self.offer_on(self.order[at]);
            }
            if any {
                any = false;
                // Forth and back: lanes that begin elsewhere need ways against the order of the first.
                for at in (0..self.order.len()).rev() {
                    any |= self.offer_on(self.order[at]);
                }
            }
        }
        &self.lengths
    }

    /// Lane 0 by Dijkstra's rule, and the order in which items are reached.
    fn settle_first(&mut self, first: usize) {
        self.order.clear();
        self.lengths[first][0] = 0.0;
        self.open.push(Reverse((0, first as u32)));
        while let Some(Reverse((bits, item))) = self.open.pop() {
            let (here, item) = (f64::from_bits(bits), item as usize);
            // An older entry of the heap, since found by a shorter way.
            if here > self.lengths[item][0] {
                continue;
            }
            self.order.push(item);
            for (other, length) in self.graph.links_of(item) {
                let by = here + length;
                if by < self.lengths[other][0] {
                    self.lengths[other][0] = by;
                    // Bits of numbers that are not negative are in the order of the numbers.
                    self.open.push(Reverse((by.to_bits(), other as u32)));
                }
            }
        }
    }

    /// Offers the lengths of an item, if they are new, to those it is linked with.
    fn offer_on(&mut self, item: usize) -> bool {
        if !self.stale[item] {
            return false;
        }
        self.stale[item] = false;
        let here = self.lengths[item];
        let mut any = false;
        for (other, length) in self.graph.links_of(item) {
            let there = &mut self.lengths[other];
            let mut shorter = false;
            for lane in 0..LANES {
                let by = here[lane] + length;
                shorter |= by < there[lane];
                there[lane] = if by < there[lane] { by } else { there[lane] };
            }
            self.stale[other] |= shorter;
            any |= shorter;
        }
        any
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_found_together_have_the_bits_of_ways_found_alone() {
        let points: Vec<f64> = (0..400)
            .map(|i| 0.754_877_666 * f64::from(i))
            .flat_map(|t| {
                [
                    t.fract(),
                    (1.324_717_957 * t).fract(),
                    0.1 * (9.0 * t).sin(),
                ]
            })
            .collect();
        let nearest = Neighbours::of_points(&points, 400, 6, &Progress::default()).unwrap();
        let graph = NeighbourGraph::new(&nearest);
        let groups = graph.groups();
        let mut members = groups.concat();
        members.sort_unstable();
        assert_eq!(members, (0..400).collect::<Vec<_>>());
        assert!(groups.iter().all(|group| group.len() <= LANES));
        let (mut together, mut alone) = (graph.traveller(), graph.traveller());
        for group in groups {
            let lengths = together.lengths_from(&group);
            for (lane, &from) in group.iter().enumerate() {
                let expected = alone.lengths_from(&[from]);
                for (found, expected) in lengths.iter().zip(expected) {
                    assert_eq!(found[lane].to_bits(), expected[0].to_bits());
                }
            }
        }
    }
}
