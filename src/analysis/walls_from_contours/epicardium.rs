//! The epicardium at instants at which only the endocardium was drawn, from the muscle that does not come or go.

use std::collections::BTreeMap;

use super::placing::{Placing, area};
use super::radii::{DIRECTIONS, direction, middle, squared_radii};
use super::{ContourError, ContourName};
use crate::image::{Contour, ContourPart, VolumeFrame};
use crate::mesh::Point3;
use crate::study::Notice;

/// Contours with an epicardium at every instant.
#[derive(Clone, Debug, PartialEq)]
pub struct WithEpicardium {
    /// Those that were given, then those that were added.
    pub contours: Vec<Contour>,
    /// What was added and how; none where nothing was missing.
    pub notices: Vec<Notice>,
}

/// Adds outlines of the epicardium at instants that have some of the endocardium and none of the epicardium.
///
/// They follow from those of the instant at which both stand in the most slices, by three assumptions that a notice tells:
/// a layer of muscle at a share s of the height from the lowest to the highest slice with a cavity stays at this share; each
/// sector of it around the middle of the cavity keeps its muscle; and so does the ventricle as a whole. With the squares q of
/// radii around the middle,
///
/// `q_epi(θ, s, t) = q_endo(θ, s, t) + f (q_epi − q_endo)(θ, s, reference)`,
///
/// where f makes the muscle ½ Σ ∫ (q_epi − q_endo) dθ of all slices equal to that of the reference: about the ratio of
/// the heights. The wall at these instants is then no measurement: how much it thickens says how much the cavity narrows.
///
/// # Errors
/// As [`masks_of_contours`](super::masks_of_contours); if no instant has both parts in a slice; or if an outline does not go
/// around the middle of its cavity.
pub fn with_epicardium(
    frame: &VolumeFrame,
    instants: usize,
    contours: &[Contour],
) -> Result<WithEpicardium, ContourError> {
    let placing = Placing::of(frame, instants, contours)?;
    let has = |instant: usize, part: ContourPart| {
        (placing.contours.iter()).any(|c| c.instant == instant && c.part == part)
    };
    let missing: Vec<usize> = (0..instants)
        .filter(|&t| has(t, ContourPart::Endocardium) && !has(t, ContourPart::Epicardium))
        .collect();
    let mut whole = WithEpicardium {
        contours: contours.to_vec(),
        notices: Vec::new(),
    };
    if missing.is_empty() {
        return Ok(whole);
    }
    let reference = Muscle::of_fullest(&placing, instants)?;
    for &instant in &missing {
        let layers = Layer::all(&placing, instant, ContourPart::Endocardium)?;
        for (slice, outline) in reference.around(&layers) {
            whole.contours.push(Contour {
                instant,
                part: ContourPart::Epicardium,
                points: in_the_world(frame, &placing, slice, &outline),
            });
        }
    }
    whole.notices.push(told(&missing, reference.instant));
    Ok(whole)
}

fn told(missing: &[usize], reference: usize) -> Notice {
    let mut numbers: Vec<String> = missing
        .iter()
        .take(8)
        .map(|t| (t + 1).to_string())
        .collect();
    if missing.len() > numbers.len() {
        numbers.push("…".to_owned());
    }
    Notice::warning(format!(
        "no epicardium was drawn in volume {}: it was added so that every sector of the wall keeps the muscle that it has in volume {}; \
         wall thickness there follows from the endocardium and is no measurement",
        numbers.join(", "),
        reference + 1
    ))
}

fn in_the_world(
    frame: &VolumeFrame,
    placing: &Placing,
    slice: usize,
    outline: &[[f64; 2]],
) -> Vec<Point3> {
    let [u, v, across] = placing.axes;
    let point = |corner: &[f64; 2]| {
        let mut voxel = Point3::origin();
        voxel[u] = corner[0];
        voxel[v] = corner[1];
        voxel[across] = slice as f64;
        frame.position(voxel)
    };
    outline.iter().map(point).collect()
}

/// An outline of one slice around the middle of its cavity.
struct Layer {
    slice: usize,
    middle: [f64; 2],
    squared: Vec<f64>,
}

impl Layer {
    /// The largest outline of a part in each slice of an instant, around its own middle.
    fn all(
        placing: &Placing,
        instant: usize,
        part: ContourPart,
    ) -> Result<Vec<Self>, ContourError> {
        let mut layers = Vec::new();
        for (slice, (place, corners)) in outlines(placing, instant, part) {
            let which = ContourName {
                contour: place,
                instant,
                part,
            };
            let middle = middle(corners).ok_or(ContourError::NoArea(which))?;
            let squared = squared_radii(corners, middle).ok_or(ContourError::NotAround(which))?;
            layers.push(Self {
                slice,
                middle,
                squared,
            });
        }
        Ok(layers)
    }
}

/// The largest outline of a part in each slice, with its place in the list.
fn outlines(
    placing: &Placing,
    instant: usize,
    part: ContourPart,
) -> BTreeMap<usize, (usize, &[[f64; 2]])> {
    let mut found: BTreeMap<usize, (usize, &[[f64; 2]])> = BTreeMap::new();
    for (place, contour) in placing.contours.iter().enumerate() {
        if contour.instant != instant || contour.part != part {
            continue;
        }
        let larger = |other: &[[f64; 2]]| area(other).abs() >= area(&contour.corners).abs();
        if !found
            .get(&contour.slice)
            .is_some_and(|(_, other)| larger(other))
        {
            found.insert(contour.slice, (place, &contour.corners));
        }
    }
    found
}

/// The muscle of one instant: in each slice with both parts, by direction.
struct Muscle {
    instant: usize,
    /// Lowest and highest slice with a cavity.
    ends: [usize; 2],
    /// The slice and q_epi − q_endo, ascending; at least one.
    layers: Vec<(usize, Vec<f64>)>,
}

impl Muscle {
    /// At the instant with the most slices of both parts; the first of equal ones.
    fn of_fullest(placing: &Placing, instants: usize) -> Result<Self, ContourError> {
        let slices = |t: usize| {
            let endo = outlines(placing, t, ContourPart::Endocardium);
            let epi = outlines(placing, t, ContourPart::Epicardium);
            endo.keys().filter(|slice| epi.contains_key(slice)).count()
        };
        let fullest = (0..instants).map(|t| (slices(t), t));
        let fullest = fullest.max_by_key(|&(count, t)| (count, usize::MAX - t));
        let Some((1.., instant)) = fullest else {
            return Err(ContourError::NoEpicardium);
        };
        let endo = Layer::all(placing, instant, ContourPart::Endocardium)?;
        let epi = outlines(placing, instant, ContourPart::Epicardium);
        let [Some(first), Some(last)] = [endo.first(), endo.last()] else {
            return Err(ContourError::NoEpicardium);
        };
        let ends = [first.slice, last.slice];
        let mut layers = Vec::new();
        for layer in &endo {
            let Some(&(place, corners)) = epi.get(&layer.slice) else {
                continue;
            };
            let which = ContourName {
                contour: place,
                instant,
                part: ContourPart::Epicardium,
            };
            let outer =
                squared_radii(corners, layer.middle).ok_or(ContourError::NotAround(which))?;
            let wall = outer.iter().zip(&layer.squared);
            // An outline that crosses the other one leaves no wall there.
            let wall = wall
                .map(|(outer, inner)| (outer - inner).max(0.0))
                .collect();
            layers.push((layer.slice, wall));
        }
        Ok(Self {
            instant,
            ends,
            layers,
        })
    }

    /// Outlines of the epicardium around cavities, by slice.
    fn around(&self, cavities: &[Layer]) -> Vec<(usize, Vec<[f64; 2]>)> {
        let [Some(first), Some(last)] = [cavities.first(), cavities.last()] else {
            return Vec::new();
        };
        let own = [first.slice, last.slice];
        let walls: Vec<Vec<f64>> = (cavities.iter())
            .map(|layer| self.at(share_of_height(layer.slice, own)))
            .collect();
        let factor = self.area_by_slice() * height(self.ends) / (mean_area(&walls) * height(own));
        let outlines = cavities.iter().zip(&walls).map(|(layer, wall)| {
            let radii = layer.squared.iter().zip(wall);
            let radii = radii.map(|(inner, wall)| (inner + factor * wall).sqrt());
            let corner = |(number, radius): (usize, f64)| {
                let along = direction(number);
                [0, 1].map(|axis| layer.middle[axis] + radius * along[axis])
            };
            (layer.slice, radii.enumerate().map(corner).collect())
        });
        outlines.collect()
    }

    /// Its wall at a share of the height, from the neighbouring slices.
    fn at(&self, share: f64) -> Vec<f64> {
        let [lowest, _] = self.ends;
        let place = lowest as f64 + share * height(self.ends) - 0.5;
        let above = (self.layers).partition_point(|(slice, _)| (*slice as f64) < place);
        let below = above.saturating_sub(1);
        let above = above.min(self.layers.len() - 1);
        let [(low, under), (high, over)] = [below, above].map(|n| &self.layers[n]);
        let part = match high > low {
            true => (place - *low as f64) / (high - low) as f64,
            false => 0.0,
        };
        let between = under.iter().zip(over);
        between.map(|(a, b)| a + part * (b - a)).collect()
    }

    fn area_by_slice(&self) -> f64 {
        let walls: Vec<&Vec<f64>> = self.layers.iter().map(|(_, wall)| wall).collect();
        mean_area(&walls)
    }
}

/// Slices from the lower side of the lowest to the upper side of the highest.
fn height([lowest, highest]: [usize; 2]) -> f64 {
    (highest - lowest + 1) as f64
}

/// Where the middle of a slice stands between both sides.
fn share_of_height(slice: usize, ends: [usize; 2]) -> f64 {
    ((slice - ends[0]) as f64 + 0.5) / height(ends)
}

/// Mean area of walls over slices, but for a factor that all have.
fn mean_area<W: AsRef<[f64]>>(walls: &[W]) -> f64 {
    let sum: f64 = walls.iter().flat_map(|wall| wall.as_ref()).sum();
    sum / (walls.len() * DIRECTIONS) as f64
}
