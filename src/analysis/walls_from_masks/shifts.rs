//! Slices that stand beside their neighbours because they were taken in another breath-hold.

use nalgebra::{DMatrix, Matrix2};

use super::planes::{Place, Planes};
use super::region::Region;
use super::slices::{FrameSlices, SliceRegions};

/// Rounds of reweighting; the weights settle after some ten.
const ROUNDS: usize = 20;
/// Rounds that make small shifts vanish; each makes them smaller by some factor.
const SPARSE_ROUNDS: usize = 60;
/// What a shift of one slice costs against the squares of what parabolas leave, as a share of the least jump: of the values tried
/// on the masks of 100 ventricles, 0.5 left jumps of 6 mm where they were, and with 0.15 every third stack was torn at a place
/// where it only bends.
const SHIFT_COST: f64 = 0.3;
/// By how much of its length the middle of the axis of a ventricle usually stands beside the straight line between its ends.
const USUAL_BEND: f64 = 0.04;
/// Slices that a frame must show so that one of them can be told to stand beside the others.
const MIN_SLICES: usize = 5;
/// How many times its usual size a step must be beside the expected one to count as a jump.
const OUTLYING: f64 = 3.0;
/// Bounds of the least jump in pixels: the middle of an outline is known to some tenth of a pixel, and a step of less than
/// one and a half is the ventricle's own form.
const JUMP_PIXELS: [f64; 2] = [1.5, 3.0];
/// And as a share of the distance of slices: no ventricle bends by more than that from one slice to the next.
const JUMP_SHARE: [f64; 2] = [0.2, 0.4];
/// How much larger a jump of the first and of the last slice must be: there the ventricle bends most, at the tip, and
/// where the wall ends at the valve.
const AT_THE_ENDS: f64 = 2.0;

/// How far each slice of the stack stands beside the others, in millimetres: zero for most.
///
/// Slices of one breath-hold stand at their places, and those of another one all stand off by the same shift, so that the
/// middle of the outlines jumps where one breath-hold ends. Steps of the middle from slice to slice, Δ, follow a line
/// a + b z, as those of a parabola do, which is fitted by repeated least squares with weights (1 + (d / 2s)²)⁻²
/// (Geman–McClure), d = |Δ − a − b z| and s = 1.48 · median d. A step with d beyond the bounds is a jump, if the outlines of cavity
/// and heart have it both (the smaller counts), on average over the frames: all frames of a slice are taken in one
/// breath-hold. Slices between jumps are one group, whose shift follows by least squares (`group_shifts`). What grows
/// along the axis evenly cannot be told from the ventricle's own form, and stays.
pub(super) fn slice_shifts(planes: &Planes, frames: &[FrameSlices]) -> Vec<Place> {
    let outlines: [fn(&SliceRegions) -> &Option<Region>; 2] = [|s| &s.cavity, |s| &s.heart];
    let steps = outlines.map(|of| mean_steps(planes, frames, of));
    let pixel = planes.pixel_mm();
    let off = steps
        .each_ref()
        .map(|steps| beside_line(steps, 0.25 * pixel));
    let joint: Vec<Option<Place>> = off[0]
        .iter()
        .zip(&off[1])
        .map(|(&c, &h)| common(c, h))
        .collect();
    let usual = 1.48 * median(joint.iter().flatten().map(|step| step.norm()).collect());
    let bound = |side: usize| {
        f64::max(
            JUMP_PIXELS[side] * pixel,
            JUMP_SHARE[side] * planes.thickness,
        )
    };
    let least = (OUTLYING * usual).clamp(bound(0), bound(1));
    let known = |step: &Option<Place>| step.is_some();
    let ends = [joint.iter().position(known), joint.iter().rposition(known)];
    let mut groups = vec![0_usize];
    for (slice, step) in joint.iter().enumerate() {
        let least = if ends.contains(&Some(slice)) {
            AT_THE_ENDS * least
        } else {
            least
        };
        let jumps = step.is_some_and(|step| step.norm() >= least);
        groups.push(groups.last().map_or(0, |group| group + usize::from(jumps)));
    }
    let curves: Vec<_> = steps.iter().flat_map(|steps| paths(steps)).collect();
    // The bend of a parabola costs as much as a pixel off where its middle stands off by the usual share of its length.
    let usual_bend = 4.0 * USUAL_BEND * planes.thickness * planes.count() as f64;
    let shifts = group_shifts(&curves, &groups, least, (pixel / usual_bend).powi(2));
    let real = |shift: &&Place| shift.norm() >= 0.5 * least;
    let of_slice = groups
        .iter()
        .map(|&group| shifts.get(group).filter(real).copied());
    of_slice
        .map(|shift| shift.unwrap_or_else(Place::zeros))
        .collect()
}

/// The ways of the middle over slices that follow from its steps, each from an unknown start.
fn paths(steps: &[Option<Place>]) -> Vec<Vec<(usize, Place)>> {
    let mut paths: Vec<Vec<(usize, Place)>> = Vec::new();
    let mut going = false;
    for (slice, step) in steps.iter().enumerate() {
        match step {
            None => going = false,
            Some(step) => {
                if !going {
                    paths.push(vec![(slice, Place::zeros())]);
                    going = true;
                }
                if let Some(path) = paths.last_mut() {
                    let here = path.last().map_or_else(Place::zeros, |(_, place)| *place);
                    path.push((slice + 1, here + step));
                }
            }
        }
    }
    paths
}

/// The shift of each group of slices: least squares of paths by a parabola for each path plus the shift, with as few
/// slices shifted as can be: a cost that grows with Σ |shift| over slices is part of what is minimised, by repeated reweighting (`bend` times the square of the
/// parabola's bend is another part), and at the end
/// least squares decide how large those shifts are that did not vanish.
fn group_shifts(
    paths: &[Vec<(usize, Place)>],
    groups: &[usize],
    least: f64,
    bend: f64,
) -> Vec<Place> {
    let count = groups.last().map_or(0, |last| last + 1);
    let mut shifts = vec![Place::zeros(); count];
    if count < 2 {
        return shifts;
    }
    let reach = groups.len() as f64;
    let size = count + 3 * paths.len();
    let mut normal = DMatrix::<f64>::zeros(size, size);
    let mut right = DMatrix::<f64>::zeros(size, 2);
    for (number, path) in paths.iter().enumerate() {
        for &(slice, place) in path {
            let z = slice as f64 / reach - 0.5;
            let parabola = count + 3 * number;
            let row = [
                (groups[slice], 1.0),
                (parabola, 1.0),
                (parabola + 1, z),
                (parabola + 2, z * z),
            ];
            for (i, a) in row {
                for (j, b) in row {
                    normal[(i, j)] += a * b;
                }
                right[(i, 0)] += a * place.x;
                right[(i, 1)] += a * place.y;
            }
        }
    }
    for path in 0..paths.len() {
        let parabola = count + 3 * path;
        // Short paths leave their parabola open.
        normal[(parabola, parabola)] += 1e-6;
        normal[(parabola + 1, parabola + 1)] += 1e-6;
        normal[(parabola + 2, parabola + 2)] += 1e-6 + bend;
    }
    // As often as slices stand in paths.
    let mut members = vec![0.0_f64; count];
    for (slice, _) in paths.iter().flatten() {
        members[groups[*slice]] += 1.0;
    }
    let solved = |cost: &dyn Fn(usize) -> f64| {
        let mut with_cost = normal.clone();
        for group in 0..count {
            with_cost[(group, group)] += cost(group);
        }
        let solved = with_cost.cholesky()?.solve(&right);
        Some(
            (0..count)
                .map(|g| Place::new(solved[(g, 0)], solved[(g, 1)]))
                .collect::<Vec<_>>(),
        )
    };
    if let Some(free) = solved(&|_| 1e-3) {
        shifts = free;
    }
    for _ in 0..SPARSE_ROUNDS {
        let cost = |group: usize| {
            let norm = f64::max(shifts[group].norm(), 1e-3 * least);
            SHIFT_COST * least * members[group] / norm
        };
        match solved(&cost) {
            Some(now) => shifts = now,
            None => break,
        }
    }
    // What the cost of shifts took from those that are there.
    let held = |group: usize| {
        if shifts[group].norm() < 0.5 * least {
            1e9
        } else {
            1e-6
        }
    };
    solved(&held).unwrap_or(shifts)
}

/// What both outlines have in common; that of the heart alone where a slice has no cavity.
fn common(cavity: Option<Place>, heart: Option<Place>) -> Option<Place> {
    let (Some(cavity), Some(heart)) = (cavity, heart) else {
        return heart.or(cavity);
    };
    if cavity.dot(&heart) <= 0.0 {
        return Some(Place::zeros());
    }
    Some(if cavity.norm() < heart.norm() {
        cavity
    } else {
        heart
    })
}

/// The step of an outline's middle from each slice to the next one up, on average over the frames that show both.
fn mean_steps(
    planes: &Planes,
    frames: &[FrameSlices],
    of: fn(&SliceRegions) -> &Option<Region>,
) -> Vec<Option<Place>> {
    let mut sums = vec![(Place::zeros(), 0.0); planes.count().saturating_sub(1)];
    for frame in frames {
        let middles: Vec<Option<Place>> = (frame.lowest..)
            .zip(&frame.slices)
            .map(|(slice, regions)| {
                let centre = of(regions).as_ref()?.centre()?;
                Some(planes.place(slice, centre))
            })
            .collect();
        if middles.iter().flatten().count() < MIN_SLICES {
            continue;
        }
        for (step, pair) in middles.windows(2).enumerate() {
            if let ([Some(here), Some(above)], Some(sum)) =
                (pair, sums.get_mut(frame.lowest + step))
            {
                *sum = (sum.0 + above - here, sum.1 + 1.0);
            }
        }
    }
    let means = sums
        .into_iter()
        .map(|(sum, count)| (count > 0.0).then(|| sum / count));
    means.collect()
}

/// What steps have beside the line that most of them follow. `least` bounds the scale of the weights from below.
fn beside_line(steps: &[Option<Place>], least: f64) -> Vec<Option<Place>> {
    let reach = steps.len().max(1) as f64;
    let powers = |place: usize| [1.0, place as f64 / reach - 0.5];
    let middle = |axis: usize| median(steps.iter().flatten().map(|step| step[axis]).collect());
    // Columns x and y of [a; b]; the medians are where repeated least squares begin.
    let mut line = Matrix2::new(middle(0), middle(1), 0.0, 0.0);
    let off = |line: &Matrix2<f64>| -> Vec<Option<Place>> {
        let expected = |place: usize| {
            let [one, z] = powers(place);
            Place::new(
                line[(0, 0)] * one + line[(1, 0)] * z,
                line[(0, 1)] * one + line[(1, 1)] * z,
            )
        };
        let all = steps.iter().enumerate();
        all.map(|(place, step)| Some((*step)? - expected(place)))
            .collect()
    };
    for _ in 0..ROUNDS {
        let now = off(&line);
        let usual = 1.48 * median(now.iter().flatten().map(|d| d.norm()).collect());
        let scale = 2.0 * usual.max(least);
        let (mut normal, mut right) = (Matrix2::<f64>::zeros(), Matrix2::<f64>::zeros());
        for (place, (step, d)) in steps.iter().zip(&now).enumerate() {
            let (Some(step), Some(d)) = (step, d) else {
                continue;
            };
            let weight = (1.0 + (d.norm() / scale).powi(2)).powi(-2);
            let p = powers(place);
            for row in 0..2 {
                for column in 0..2 {
                    normal[(row, column)] += weight * p[row] * p[column];
                    right[(row, column)] += weight * p[row] * step[column];
                }
            }
        }
        match normal.cholesky() {
            Some(factor) => line = factor.solve(&right),
            None => break,
        }
    }
    off(&line)
}

/// The middle value; 0 of none.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
