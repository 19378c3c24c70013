//! The slices of a cine image that the ventricle lies in, and places within them in millimetres.

use nalgebra::{Matrix2, Vector2};

use super::CineError;
use crate::image::{Image, MarkedPoints, VolumeFrame};
use crate::mesh::{Point3, Vector3};

/// A place in a slice, in millimetres from the centre of its first voxel.
pub(super) type Place = Vector2<f64>;

/// Distances of apex and base: from a newborn to the greatest ventricles.
const LENGTH_MM: [f64; 2] = [15.0, 180.0];
/// Greatest angle between the axis and the direction across the slices: a short-axis stack that was planned badly is 30° off.
const MAX_ANGLE_DEG: f64 = 50.0;
/// Distances of planes that differ by less are equal: then the direction of the axis decides.
const ALIKE: f64 = 1.2;
/// Slices whose middle lies beyond apex or base by this share of their distance still count.
const BEYOND: f64 = 0.1;
/// Slices times instants: 200 MB of polar images.
const MAX_COUNT: usize = 6000;

/// The slices between apex and base.
pub(super) struct Slices<'a> {
    image: &'a Image,
    /// Two axes within the slices, and the one across.
    axes: [usize; 3],
    /// Directions at right angles within the slices.
    directions: [Vector3; 2],
    /// Voxels along the two axes from millimetres.
    voxels_from_mm: Matrix2<f64>,
    /// Numbers of the slices in the volume, from the apex to the base.
    numbers: Vec<usize>,
    /// Where the axis from apex to base passes each of them.
    on_axis: Vec<Place>,
    /// Distance of neighbouring slices.
    step_mm: f64,
    /// A point of the blood: slice, counted from the apex, and place.
    blood: (usize, Place),
}

impl<'a> Slices<'a> {
    /// # Errors
    /// If points are missing, not finite, outside of the image or no long axis across the slices.
    pub(super) fn of(image: &'a Image, points: &MarkedPoints) -> Result<Self, CineError> {
        let [apex, base, blood] = needed(points)?;
        let frame = image.frame();
        let long = base - apex;
        let length_mm = long.norm();
        if !(LENGTH_MM[0]..=LENGTH_MM[1]).contains(&length_mm) {
            return Err(CineError::Length {
                length_mm,
                range_mm: LENGTH_MM,
            });
        }
        let across = axis_across(frame, &(long / length_mm));
        let axes = [(across + 1) % 3, (across + 2) % 3, across];
        let steps = axes.map(|axis| frame.steps()[axis]);
        let normal = steps[0].cross(&steps[1]).normalize();
        let angle_deg = (normal.dot(&long).abs() / length_mm)
            .min(1.0)
            .acos()
            .to_degrees();
        if angle_deg > MAX_ANGLE_DEG {
            return Err(CineError::NotShortAxis {
                angle_deg,
                max_deg: MAX_ANGLE_DEG,
            });
        }
        let x = steps[0].normalize();
        let y = normal.cross(&x);
        let mm_from_voxels = Matrix2::new(
            steps[0].dot(&x),
            steps[1].dot(&x),
            steps[0].dot(&y),
            steps[1].dot(&y),
        );
        let mut slices = Self {
            image,
            axes,
            directions: [x, y],
            // A frame has steps that are independent.
            voxels_from_mm: mm_from_voxels
                .try_inverse()
                .unwrap_or_else(Matrix2::identity),
            numbers: Vec::new(),
            on_axis: Vec::new(),
            step_mm: normal.dot(&steps[2]).abs(),
            blood: (0, Place::zeros()),
        };
        slices.choose(apex, base)?;
        slices.blood = slices.marked(blood)?;
        Ok(slices)
    }

    /// Takes the slices between apex and base.
    fn choose(&mut self, apex: Point3, base: Point3) -> Result<(), CineError> {
        let [from, to] = [apex, base].map(|point| self.height(point));
        let last = self.image.frame().size()[self.axes[2]] as f64 - 1.0;
        let low = (from.min(to) - BEYOND).ceil().max(0.0);
        let high = (from.max(to) + BEYOND).floor().min(last);
        if low > high {
            return Err(CineError::NoSlice);
        }
        self.numbers = (low as usize..=high as usize).collect();
        if from > to {
            self.numbers.reverse();
        }
        let count = self.numbers.len().saturating_mul(self.instants());
        if count > MAX_COUNT {
            return Err(CineError::TooMany {
                count,
                most: MAX_COUNT,
            });
        }
        // The angle with the slices is bounded, so that apex and base lie at different heights.
        let place = |&number: &usize| {
            let share = (number as f64 - from) / (to - from);
            self.place(number, apex + (base - apex) * share)
        };
        self.on_axis = self.numbers.iter().map(place).collect();
        Ok(())
    }

    /// The slice of the point of the blood, which must lie within the image; the nearest one between apex and base.
    fn marked(&self, blood: Point3) -> Result<(usize, Place), CineError> {
        let voxel = self.image.frame().voxel(blood);
        let size = self.image.frame().size();
        if (0..3).any(|axis| !(-0.5..=size[axis] as f64 - 0.5).contains(&voxel[axis])) {
            return Err(CineError::Outside("the point of the blood"));
        }
        let height = self.height(blood);
        let away = |slice: &usize| (self.numbers[*slice] as f64 - height).abs();
        let nearest = (0..self.count()).min_by(|a, b| away(a).total_cmp(&away(b)));
        let slice = nearest.ok_or(CineError::NoSlice)?;
        Ok((slice, self.place(self.numbers[slice], blood)))
    }

    pub(super) fn count(&self) -> usize {
        self.numbers.len()
    }

    pub(super) fn instants(&self) -> usize {
        self.image.volumes().len()
    }

    pub(super) fn step_mm(&self) -> f64 {
        self.step_mm
    }

    pub(super) fn blood(&self) -> (usize, Place) {
        self.blood
    }

    /// Where the axis passes a slice.
    pub(super) fn on_axis(&self, slice: usize) -> Place {
        self.on_axis[slice]
    }

    /// Height of a position in slices of the volume.
    pub(super) fn height(&self, position: Point3) -> f64 {
        self.image.frame().voxel(position)[self.axes[2]]
    }

    /// Which slice between apex and base has a number in the volume.
    pub(super) fn with_number(&self, number: usize) -> Option<usize> {
        self.numbers.iter().position(|&own| own == number)
    }

    /// Slices of the volume.
    pub(super) fn in_volume(&self) -> usize {
        self.image.frame().size()[self.axes[2]]
    }

    fn corner(&self, number: usize) -> Point3 {
        let mut voxel = Point3::origin();
        voxel[self.axes[2]] = number as f64;
        self.image.frame().position(voxel)
    }

    /// The place in a slice of the volume below or above a position.
    fn place(&self, number: usize, position: Point3) -> Place {
        let away = position - self.corner(number);
        Place::new(away.dot(&self.directions[0]), away.dot(&self.directions[1]))
    }

    /// The place of a position in a slice.
    pub(super) fn place_in(&self, slice: usize, position: Point3) -> Place {
        self.place(self.numbers[slice], position)
    }

    /// The position of a place.
    pub(super) fn position(&self, slice: usize, place: Place) -> Point3 {
        let [x, y] = self.directions;
        self.corner(self.numbers[slice]) + x * place.x + y * place.y
    }

    /// The value at a place, bilinear; `None` beyond the outermost voxels and where a value is no number.
    pub(super) fn value(&self, instant: usize, slice: usize, place: Place) -> Option<f32> {
        let voxel = self.voxels_from_mm * place;
        let size = self.image.frame().size();
        let strides = [1, size[0], size[0] * size[1]];
        let [u, v, across] = self.axes;
        let mut low = [0; 2];
        let mut share = [0.0; 2];
        for (n, axis) in [u, v].into_iter().enumerate() {
            let last = (size[axis] - 1) as f64;
            if !(0.0..=last).contains(&voxel[n]) {
                return None;
            }
            // An image one voxel wide has no second one.
            let floor = voxel[n].floor().min((last - 1.0).max(0.0));
            low[n] = floor as usize;
            share[n] = (voxel[n] - floor) as f32;
        }
        let values = &self.image.volumes()[instant];
        let first =
            low[0] * strides[u] + low[1] * strides[v] + self.numbers[slice] * strides[across];
        let right = if size[u] > 1 { strides[u] } else { 0 };
        let down = if size[v] > 1 { strides[v] } else { 0 };
        let row = |at: usize| values[at] * (1.0 - share[0]) + values[at + right] * share[0];
        let value = row(first) * (1.0 - share[1]) + row(first + down) * share[1];
        value.is_finite().then_some(value)
    }
}

/// Apex, base and blood.
fn needed(points: &MarkedPoints) -> Result<[Point3; 3], CineError> {
    let named = [
        (points.apex, "the apex"),
        (points.base, "the base"),
        (points.blood, "the point of the blood"),
    ];
    let mut found = [Point3::origin(); 3];
    for (found, (point, name)) in found.iter_mut().zip(named) {
        *found = point.ok_or(CineError::Missing(name))?;
        if !found.iter().all(|x| x.is_finite()) {
            return Err(CineError::NotFinite(name));
        }
    }
    Ok(found)
}

/// The axis across the slices: that along which planes of voxels are farthest apart; of equal ones that nearest to the long
/// axis.
fn axis_across(frame: &VolumeFrame, long: &Vector3) -> usize {
    let steps = frame.steps();
    let normals = [0, 1, 2].map(|axis| {
        steps[(axis + 1) % 3]
            .cross(&steps[(axis + 2) % 3])
            .normalize()
    });
    let distances = [0, 1, 2].map(|axis| normals[axis].dot(&steps[axis]).abs());
    let greatest = distances.iter().copied().fold(0.0, f64::max);
    let along = |axis: &usize| normals[*axis].dot(long).abs();
    let candidates = (0..3).filter(|&axis| distances[axis] * ALIKE >= greatest);
    candidates
        .max_by(|a, b| along(a).total_cmp(&along(b)))
        .unwrap_or(2)
}
