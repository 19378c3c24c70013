//! Parts of a graph of neighbours: which items see each other at all?

use super::Neighbours;

/// Number of closed parts of the directed graph from items to their neighbours: sets of items that all
/// reach each other and nothing outside.
///
/// It is the number of independent vectors that equal the mean of themselves over neighbours, with
/// any weights in general position; one such vector, the constant one, is always there.
///
/// Source: Tarjan (1972), SIAM J. Comput. 1(2): strongly connected components, by depth-first search.
pub(super) fn closed_parts(neighbours: &Neighbours) -> usize {
    const UNSEEN: usize = usize::MAX;
    let items = neighbours.len();
    let mut order = vec![UNSEEN; items];
    let mut lowest = vec![0; items];
    let mut part_of = vec![UNSEEN; items];
    let mut open = Vec::new();
    let (mut seen, mut parts) = (0, 0);
    for root in 0..items {
        if order[root] != UNSEEN {
            continue;
        }
        // Tarjan’s components with a stack of its own: a chain of neighbours may be as long as the list.
        let mut way = vec![(root, 0)];
        while let Some(&mut (item, ref mut next)) = way.last_mut() {
            if *next == 0 {
                (order[item], lowest[item]) = (seen, seen);
                seen += 1;
                open.push(item);
            }
            if let Some(&other) = neighbours.of(item).get(*next) {
                *next += 1;
                let other = other as usize;
                if order[other] == UNSEEN {
                    way.push((other, 0));
                } else if part_of[other] == UNSEEN {
                    // Only of members that are still open: a finished part cannot lead back.
                    lowest[item] = lowest[item].min(order[other]);
                }
                continue;
            }
            way.pop();
            if let Some(&(above, _)) = way.last() {
                lowest[above] = lowest[above].min(lowest[item]);
            }
            if lowest[item] == order[item] {
                while let Some(member) = open.pop() {
                    part_of[member] = parts;
                    if member == item {
                        break;
                    }
                }
                parts += 1;
            }
        }
    }
    let mut closed = vec![true; parts];
    for item in 0..items {
        for &other in neighbours.of(item) {
            if part_of[item] != part_of[other as usize] {
                // A part with a link out takes its mean from elsewhere, and is not free to move by itself.
                closed[part_of[item]] = false;
            }
        }
    }
    closed.iter().filter(|closed| **closed).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::progress::Progress;

    fn parts(line: &[f64], count: usize) -> usize {
        let found = Neighbours::of_points(line, line.len(), count, &Progress::default());
        closed_parts(&found.unwrap())
    }

    #[test]
    fn an_item_that_sees_two_groups_which_do_not_see_it_joins_neither() {
        assert_eq!(parts(&[0.0, 1.0, 2.0, 9.0, 10.0, 11.0], 2), 2);
        assert_eq!(parts(&[0.0, 1.0, 2.0, 5.5, 9.0, 10.0, 11.0], 2), 2);
        assert_eq!(parts(&[0.0, 1.0, 2.0, 9.0, 10.0, 11.0], 3), 1);
        assert_eq!(parts(&[0.0, 1.0, 2.1, 3.3, 4.6], 1), 1);
    }

    #[test]
    fn a_long_way_needs_no_deep_stack() {
        let line: Vec<f64> = (0..3000)
            .map(|i| f64::from(i) * (1.0 + 1e-6 * f64::from(i)))
            .collect();
        assert_eq!(parts(&line, 2), 1);
    }
}
