//! Which series are parts of one: a slice each, or an instant each.

use super::group::{AT_MOST, Group, SAME_PLACE_MM, same_grid, words};
use super::plane::{INSTANT_KEYS, InstantKey, Plane};
use crate::study::Notice;

/// Joins series that are one instant each (with all its slices) to one, where the files say the time of each in the beat
/// and no two are of one time: the phases of a cardiac CT.
pub(super) fn join_single_instants(groups: Vec<Group>) -> Vec<Group> {
    let mut joined: Vec<(Group, Vec<u64>)> = Vec::new();
    for group in groups {
        let Some(time) = one_time(&group) else {
            joined.push((group, Vec::new()));
            continue;
        };
        let fits = |(other, times): &&mut (Group, Vec<u64>)| {
            !times.is_empty() && !times.contains(&time) && same_places(other, &group, times.len())
        };
        match joined.iter_mut().rev().take(AT_MOST).find(fits) {
            Some((other, times)) => {
                other.planes.extend(group.planes);
                other.notices.extend(group.notices);
                times.push(time);
            }
            None => joined.push((group, vec![time])),
        }
    }
    let told = joined.into_iter().map(|(mut group, times)| {
        if times.len() > 1 {
            group.notices.push(Notice::info(format!(
                "{} series of one instant each make one",
                times.len()
            )));
        }
        group
    });
    told.collect()
}

/// The time in the beat that all planes of a stack say.
fn one_time(group: &Group) -> Option<u64> {
    let keys = INSTANT_KEYS.iter().enumerate();
    let mut keys =
        keys.filter(|(_, (key, _))| matches!(key, InstantKey::AfterRWave | InstantKey::Percent));
    let several = group.planes.len() > 1;
    keys.find_map(|(index, _)| {
        let time = |plane: &Plane| plane.when.0.get(index).copied().flatten();
        let first = time(group.planes.first()?)?;
        let same = group.planes.iter().all(|plane| time(plane) == Some(first));
        (same && several).then_some(first.to_bits())
    })
}

/// Whether a group stands at the places of each of the `parts` that another was joined from.
fn same_places(joined: &Group, group: &Group, parts: usize) -> bool {
    let count = joined.planes.len() / parts.max(1);
    let [Some(first), Some(second)] = [joined.planes.first(), group.planes.first()] else {
        return false;
    };
    if count != group.planes.len() || !may_be_joined(first, second) || !one_world(joined, group) {
        return false;
    }
    let normal = first.place.map(|place| place.normal()).unwrap_or_default();
    let sorted = |planes: &[Plane]| {
        let mut along: Vec<f64> = planes.iter().map(|plane| plane.along(normal)).collect();
        along.sort_by(f64::total_cmp);
        along
    };
    let own = sorted(joined.planes.get(..count).unwrap_or_default());
    let other = sorted(&group.planes);
    own.iter()
        .zip(other)
        .all(|(own, other)| (own - other).abs() < SAME_PLACE_MM)
}

/// Joins series that are one slice each (with all its instants) to one stack, where they are at least three parallel
/// ones of a study with as many instants each. Those that stand where another stands, too, stay alone.
pub(super) fn join_single_slices(groups: Vec<Group>) -> (Vec<Group>, Vec<Vec<Group>>) {
    let (single, mut rest): (Vec<Group>, Vec<Group>) = groups.into_iter().partition(at_one_place);
    let mut stacks: Vec<Vec<Group>> = Vec::new();
    for group in single {
        let fits = |stack: &Vec<Group>| {
            (stack.first()).is_some_and(|first| may_be_one_stack(first, &group))
        };
        match stacks
            .iter_mut()
            .rev()
            .take(AT_MOST)
            .find(|stack| fits(stack))
        {
            Some(stack) => stack.push(group),
            None => stacks.push(vec![group]),
        }
    }
    let mut joined = Vec::new();
    for mut stack in stacks {
        // The later of two at one place first: it is taken when a breath-hold was repeated.
        let number = |group: &Group| {
            let first = group.planes.first();
            first.map_or((0.0, 0), |p| {
                (p.facts.series_number.unwrap_or(0.0), p.facts.number)
            })
        };
        stack.sort_by(|a, b| {
            number(b)
                .partial_cmp(&number(a))
                .unwrap_or(std::cmp::Ordering::Equal)
        });
        let mut chosen: Vec<Group> = Vec::new();
        let mut again: Vec<Group> = Vec::new();
        for group in stack {
            match chosen
                .iter()
                .rev()
                .take(4 * AT_MOST)
                .any(|other| distance(other, &group) < SAME_PLACE_MM)
            {
                true => again.push(group),
                false => chosen.push(group),
            }
        }
        if chosen.len() < 3 {
            rest.extend(chosen);
            rest.extend(again);
            continue;
        }
        if !again.is_empty() {
            let note = format!(
                "slices that were taken again: {}; the stack has the later series of each, and the earlier stand alone",
                again.len()
            );
            if let Some(first) = chosen.first_mut() {
                first.notices.push(Notice::warning(note));
            }
        }
        rest.extend(again);
        joined.push(chosen);
    }
    (rest, joined)
}

fn at_one_place(group: &Group) -> bool {
    let Some(place) = group.planes.first().and_then(|plane| plane.place) else {
        return false;
    };
    let near = |plane: &Plane| {
        (plane.place).is_some_and(|other| (other.origin - place.origin).norm() < SAME_PLACE_MM)
    };
    group.planes.iter().all(near)
}

fn may_be_one_stack(a: &Group, b: &Group) -> bool {
    let (Some(first), Some(second)) = (a.planes.first(), b.planes.first()) else {
        return false;
    };
    a.planes.len() == b.planes.len() && may_be_joined(first, second) && one_world(a, b)
}

/// Whether positions of two groups are of one frame of reference. Some who take names away give each file one of its own:
/// then it tells nothing.
fn one_world(a: &Group, b: &Group) -> bool {
    let named = |group: &Group| {
        let names = group
            .planes
            .iter()
            .map(|plane| &plane.facts.frame_of_reference);
        let first = names.clone().next().cloned();
        (names.clone().all(|name| Some(name) == first.as_ref()))
            .then_some(first)
            .flatten()
    };
    match (named(a), named(b)) {
        (Some(a), Some(b)) => a == b,
        _ => true,
    }
}

/// Whether two planes were taken in the same way in one study, with the same grid.
fn may_be_joined(first: &Plane, second: &Plane) -> bool {
    let (own, other) = (&first.facts, &second.facts);
    let [own_words, other_words] = [words(first), words(second)];
    let mut as_one = other_words.clone();
    as_one.0.clone_from(&own_words.0);
    // Echo times differ by small amounts from series to series; another sequence has another.
    as_one.4 = own_words.4;
    let echo = |plane: &Plane| plane.echo_ms.unwrap_or(0.0);
    own_words == as_one
        && (echo(first) - echo(second)).abs() <= 0.2 * echo(first)
        && own.sequence == other.sequence
        && own.study == other.study
        && same_grid(first, second)
}

/// How far two groups of one slice each are from each other along their normal, in millimetres.
fn distance(a: &Group, b: &Group) -> f64 {
    let (Some(first), Some(second)) = (a.planes.first(), b.planes.first()) else {
        return f64::INFINITY;
    };
    let normal = first.place.map(|place| place.normal()).unwrap_or_default();
    (second.along(normal) - first.along(normal)).abs()
}
