//! From a place on a plane map back to the items around it.

/// Places that an estimate is made of: fewer do not enclose a place, and more blur what differs between them.
const NEIGHBOURS: usize = 4;

/// How far outside of all places something is still estimated, as a share of the map's longer side: about what lies
/// between two neighbours of a map of 200 poses. Farther out, nothing but the outermost places would speak.
const OUTSIDE_SHARE: f64 = 0.05;

/// How near to the line between two linked items a place counts as on it, as a share of the map's longer side: about what
/// a hand points at, and less than what lies between two items.
const ON_LINK_SHARE: f64 = 0.01;

/// Why nothing is estimated at a place.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum InverseMapError {
    /// There is nothing around it.
    #[error("the map has no points")]
    NoPoints,
    /// It lies outside.
    #[error(
        "this place lies {distance:.3} outside of all points of the map; nothing is estimated farther out than \
         {limit:.3} ({:.0} % of the map)",
        100.0 * OUTSIDE_SHARE
    )]
    Outside {
        /// Distance from the convex hull of all points, in units of the map.
        distance: f64,
        /// The greatest distance at which something is estimated.
        limit: f64,
    },
}

/// The items that a place on a map stands for, each with its weight, greatest first; weights are positive and sum to 1.
///
/// 1. At a place of the map, its item alone.
/// 2. On the line between two items that are linked, such as one pose of a beat and the next, these two alone, each by its
///    nearness along the line. A place counts as on the nearest line within 1 % of the map's extent.
/// 3. Elsewhere the nearest items, linked or not.
///
/// For the last, with dᵢ the distances to the 4 nearest places and R that of the fifth, wᵢ ∝ ((R − dᵢ) / (R dᵢ))²: near a place
/// its item alone, and without jumps between places, as one that leaves the nearest does so with weight 0. Where there are
/// no five, R is just above the greatest distance.
///
/// Source: Franke and Nielson (1980), Int. J. Numer. Meth. Eng. 15: the local weights of Shepard's method.
///
/// # Errors
/// If there is no finite place, or `at` lies outside of the convex hull of all by more than 5 % of their
/// extent.
pub fn inverse_map(
    places: &[[f64; 2]],
    links: &[[usize; 2]],
    at: [f64; 2],
) -> Result<Vec<(usize, f64)>, InverseMapError> {
    let finite = |place: &[f64; 2]| place.iter().all(|x| x.is_finite());
    let known: Vec<[f64; 2]> = places.iter().copied().filter(finite).collect();
    let extent = |axis: usize| {
        let values = known.iter().map(|place| place[axis]);
        values.clone().fold(f64::NEG_INFINITY, f64::max) - values.fold(f64::INFINITY, f64::min)
    };
    if known.is_empty() || !finite(&at) {
        return Err(InverseMapError::NoPoints);
    }
    let size = extent(0).max(extent(1));
    let limit = OUTSIDE_SHARE * size;
    let distance = distance_outside(&hull(known), at);
    if distance > limit {
        return Err(InverseMapError::Outside { distance, limit });
    }
    let near = nearest(places, at);
    if let Some(&(index, distance)) = near.first()
        && distance <= 1e-9 * size
    {
        return Ok(vec![(index, 1.0)]);
    }
    let between = on_link(places, links, at, ON_LINK_SHARE * size);
    Ok(between.unwrap_or_else(|| weights(near)))
}

/// The two items on whose line a place lies, within `reach`.
fn on_link(
    places: &[[f64; 2]],
    links: &[[usize; 2]],
    at: [f64; 2],
    reach: f64,
) -> Option<Vec<(usize, f64)>> {
    let near = |link: &[usize; 2]| {
        let (a, b) = (*places.get(link[0])?, *places.get(link[1])?);
        let share = share_along(a, b, at);
        Some((apart(at, between(a, b, share)), share, *link))
    };
    let (distance, share, [a, b]) = (links.iter().filter_map(near))
        .filter(|(distance, ..)| distance.is_finite())
        .min_by(|one, other| one.0.total_cmp(&other.0))?;
    // Beyond its ends there is no line.
    let within = distance <= reach && share > 0.0 && share < 1.0;
    let mut both = vec![(a, 1.0 - share), (b, share)];
    both.sort_by(|one, other| other.1.total_cmp(&one.1));
    within.then_some(both)
}

/// Where the foot of a place lies on the way from `a` to `b`, in `0..=1`.
fn share_along(a: [f64; 2], b: [f64; 2], at: [f64; 2]) -> f64 {
    let length2 = (b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2);
    let along = (at[0] - a[0]) * (b[0] - a[0]) + (at[1] - a[1]) * (b[1] - a[1]);
    if length2 > 0.0 {
        (along / length2).clamp(0.0, 1.0)
    } else {
        0.0
    }
}

fn between(a: [f64; 2], b: [f64; 2], share: f64) -> [f64; 2] {
    [0, 1].map(|axis| a[axis] + share * (b[axis] - a[axis]))
}

/// The nearest places and the one after them, with their distances.
fn nearest(places: &[[f64; 2]], at: [f64; 2]) -> Vec<(usize, f64)> {
    let mut near: Vec<(usize, f64)> = (places.iter().enumerate())
        .map(|(index, place)| (index, apart(*place, at)))
        .filter(|(_, distance)| distance.is_finite())
        .collect();
    near.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(&b.0)));
    near.truncate(NEIGHBOURS + 1);
    near
}

fn weights(mut near: Vec<(usize, f64)>) -> Vec<(usize, f64)> {
    // Just above, so that places that are all equally far have weights, too.
    let reach = near.last().map_or(0.0, |last| last.1) * (1.0 + 1e-6);
    near.truncate(NEIGHBOURS);
    let raw = near
        .into_iter()
        .map(|(index, d)| (index, ((reach - d) / (reach * d)).powi(2)));
    let raw: Vec<(usize, f64)> = raw.collect();
    let sum: f64 = raw.iter().map(|(_, weight)| weight).sum();
    raw.into_iter()
        .map(|(index, weight)| (index, weight / sum))
        .collect()
}

fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Twice the area of a triangle, positive where it turns left.
fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Corners of the convex hull, turning left: Andrew's monotone chain.
fn hull(mut places: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    places.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    places.dedup();
    let chain = |places: &mut dyn Iterator<Item = &[f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for &place in places {
            while let [.., a, b] = chain[..]
                && turn(a, b, place) <= 0.0
            {
                chain.pop();
            }
            chain.push(place);
        }
        chain
    };
    let mut corners = chain(&mut places.iter());
    let upper = chain(&mut places.iter().rev());
    // The ends of both chains are the same two places.
    corners.pop();
    corners.extend(&upper[..upper.len().saturating_sub(1)]);
    if corners.is_empty() { places } else { corners }
}

/// How far a place lies outside of a convex polygon; 0 within.
fn distance_outside(corners: &[[f64; 2]], at: [f64; 2]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let sides = corners.iter().copied().zip(next.copied());
    if corners.len() > 2 && sides.clone().all(|(a, b)| turn(a, b, at) >= 0.0) {
        return 0.0;
    }
    let to_side = |(a, b)| apart(at, between(a, b, share_along(a, b, at)));
    sides.map(to_side).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [[f64; 2]; 6] = [
        [0.0, 0.0],
        [10.0, 0.0],
        [10.0, 10.0],
        [0.0, 10.0],
        [5.0, 5.0],
        [5.0, 4.0],
    ];

    #[test]
    fn at_a_place_its_item_alone_counts() {
        for (index, place) in SQUARE.iter().enumerate() {
            assert_eq!(inverse_map(&SQUARE, &[], *place), Ok(vec![(index, 1.0)]));
        }
        // Two items at one place: the first of them.
        assert_eq!(
            inverse_map(&[[1.0, 1.0]; 2], &[], [1.0; 2]),
            Ok(vec![(0, 1.0)])
        );
    }

    #[test]
    fn weights_are_shares_of_the_nearest_places_and_change_without_jumps() {
        let mut before: Option<Vec<f64>> = None;
        for step in 0..=2_000 {
            let at = [0.005 * f64::from(step), 1.0 + 0.003 * f64::from(step)];
            let weights = inverse_map(&SQUARE, &[], at).unwrap();
            assert!(weights.len() <= NEIGHBOURS);
            assert!((weights.iter().map(|w| w.1).sum::<f64>() - 1.0).abs() < 1e-12);
            assert!(weights.windows(2).all(|pair| pair[0].1 >= pair[1].1));
            let mut all = vec![0.0; SQUARE.len()];
            for (index, weight) in weights {
                assert!(weight >= 0.0);
                all[index] = weight;
            }
            if let Some(before) = before.replace(all.clone()) {
                let change = before.iter().zip(&all).map(|(a, b)| (a - b).abs());
                assert!(change.fold(0.0, f64::max) < 0.02, "at {at:?}");
            }
        }
    }

    #[test]
    fn half_way_between_the_two_nearest_both_count_alike_and_most() {
        let weights = inverse_map(&SQUARE, &[], [5.0, 4.5]).unwrap();
        assert_eq!([weights[0].0, weights[1].0], [4, 5]);
        assert!((weights[0].1 - weights[1].1).abs() < 1e-12);
        assert!(weights[0].1 + weights[1].1 > 0.97);
    }

    #[test]
    fn on_the_line_between_linked_items_these_two_alone_count() {
        let links = [[0, 1], [1, 2], [4, 5], [4, 9]];
        for (share, first) in [(0.25, 0), (0.75, 1)] {
            let weights = inverse_map(&SQUARE, &links, [10.0 * share, 0.05]).unwrap();
            assert_eq!(weights.len(), 2);
            assert_eq!(weights[0].0, first);
            assert!((weights[0].1 - 0.75).abs() < 1e-12);
        }
        assert!(
            inverse_map(&SQUARE, &links, [2.5, 0.2]).unwrap().len() > 2,
            "beside it"
        );
        assert_eq!(
            inverse_map(&SQUARE, &links, [10.0, 10.0]),
            Ok(vec![(2, 1.0)])
        );
    }

    #[test]
    fn outside_of_all_places_nothing_is_estimated_beyond_a_twentieth_of_the_map() {
        assert!(inverse_map(&SQUARE, &[], [10.49, 3.0]).is_ok());
        let Err(InverseMapError::Outside { distance, limit }) =
            inverse_map(&SQUARE, &[], [10.6, 3.0])
        else {
            panic!("0.6 outside");
        };
        assert!((distance - 0.6).abs() < 1e-12 && (limit - 0.5).abs() < 1e-12);
        // A corner is nearer than the line of a side; within, gaps of any size are no outside.
        assert!(inverse_map(&SQUARE, &[], [-0.4, -0.4]).is_err());
        assert!(inverse_map(&SQUARE, &[], [2.0, 7.0]).is_ok());
        let line = [[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]];
        assert!(inverse_map(&line, &[], [1.5, 1.5]).is_ok());
        assert!(inverse_map(&line, &[], [0.0, 1.0]).is_err());
    }

    #[test]
    fn damage_is_refused() {
        let none = Err(InverseMapError::NoPoints);
        assert_eq!(inverse_map(&[], &[], [0.0; 2]), none);
        assert_eq!(inverse_map(&[[f64::NAN; 2]], &[], [0.0; 2]), none);
        assert_eq!(inverse_map(&SQUARE, &[], [f64::INFINITY, 0.0]), none);
        let some = [[f64::NAN; 2], [1.0, 2.0]];
        assert_eq!(inverse_map(&some, &[], [1.0, 2.0]), Ok(vec![(1, 1.0)]));
        // All equally far.
        let ring = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
        let weights = inverse_map(&ring, &[], [0.0; 2]).unwrap();
        assert!(
            weights
                .iter()
                .all(|(_, weight)| (weight - 0.25).abs() < 1e-9)
        );
    }
}
