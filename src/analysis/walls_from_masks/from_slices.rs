//! What a stack of slices shows of a ventricle: outlines around an axis, and where the septum lies.

use crate::mesh::{Point3, Vector3};
use crate::progress::Progress;
use crate::study::{Anatomy, Notice};

use super::planes::{Place, Planes};
use super::preparation::{Preparation, Prepared, SliceShift};
use super::radial::SquaredRadius;
use super::region::Region;
use super::shape::{RadialFrame, RadialSlice, WallShape};
use super::shifts::slice_shifts;
use super::slices::{FrameSlices, SliceRegions};
use super::{CheckedWallParams, Masks, Tissue, WallError};

/// Directions nearer to an axis of the world than this are exactly on it: files hold 32-bit numbers.
const ON_AXIS: f64 = 1e-6;

/// A stack of slices, as it becomes outlines around an axis.
pub(super) struct SliceStack;

impl SliceStack {
    /// Outlines of all instants.
    ///
    /// # Errors
    /// At the first instant that shows no ventricle, or if it was asked to stop.
    pub fn of(
        masks: &Masks,
        params: &CheckedWallParams,
        progress: &Progress,
    ) -> Result<Preparation, WallError> {
        let planes = Planes::of(masks);
        let mut slices = Vec::with_capacity(masks.instants().len());
        for (frame, voxels) in masks.instants().iter().enumerate() {
            let found = FrameSlices::of(&planes, voxels);
            slices.push(found.map_err(|reason| WallError::Frame { frame, reason })?);
            progress.step()?;
        }
        let shifts = match params.get().correct_shifts {
            true => slice_shifts(&planes, &slices),
            false => vec![Place::zeros(); planes.count()],
        };
        let marked = params.get().septum;
        let septal_rad = marked
            .and_then(|septum| marked_septal_rad(&planes, masks, septum))
            .or_else(|| septal_rad(&planes, masks));
        let mut notices = Vec::new();
        if septal_rad.is_none() {
            notices.push(Notice::info(
                "no right ventricle in the masks, and no septum was marked: the septum is not known, and the first ray points to the left of the slices",
            ));
        }
        let reported = reported(&planes, &shifts);
        notices.extend(reported.iter().map(|SliceShift { slice, shift_mm }| {
            Notice::info(format!(
                "slice {slice} stood {:.1} mm beside its neighbours (another breath-hold) and was put back",
                shift_mm.norm()
            ))
        }));
        let frames = slices
            .into_iter()
            .map(|frame| prepared(&planes, frame, &shifts));
        Ok(Preparation {
            frames: frames.collect(),
            septal_rad,
            shifts: reported,
            notices,
            planes,
        })
    }
}

/// Shifts that are not zero, by the number of the slice in the volume.
fn reported(planes: &Planes, shifts: &[Place]) -> Vec<SliceShift> {
    let mut reported: Vec<SliceShift> = (shifts.iter().enumerate())
        .filter(|(_, shift)| shift.norm() > 0.0)
        .map(|(slice, &shift)| SliceShift {
            slice: planes.number_in_volume(slice) + 1,
            shift_mm: planes.direction(shift),
        })
        .collect();
    reported.sort_by_key(|shift| shift.slice);
    reported
}

fn prepared(planes: &Planes, frame: FrameSlices, shifts: &[Place]) -> Prepared {
    let mut outlines = [Vec::new(), Vec::new()];
    let mut centres = Vec::new();
    let mut radial = Vec::with_capacity(frame.slices.len());
    for (slice, regions) in (frame.lowest..).zip(&frame.slices) {
        let height = planes.height(slice);
        let centre = centre(planes, slice, regions);
        if let Some(centre) = centre {
            centres.push((height, centre));
        }
        let around = |region: &Option<Region>| {
            let (region, centre) = (region.as_ref()?, centre?);
            Some(SquaredRadius::of_region(planes, slice, region, centre))
        };
        let shift = shifts.get(slice).copied().unwrap_or_else(Place::zeros);
        radial.push(RadialSlice {
            height,
            centre: centre.map(|centre| centre - shift),
            cavity: around(&regions.cavity),
            heart: around(&regions.heart),
        });
        for (outline, region) in outlines.iter_mut().zip([&regions.cavity, &regions.heart]) {
            let sides = region.iter().flat_map(|region| region.outline());
            outline.extend(sides.map(|(middle, _)| (planes.place(slice, middle), height)));
        }
    }
    Prepared {
        radial: RadialFrame {
            slices: radial,
            thickness: planes.thickness,
            pixel: planes.pixel_mm(),
        },
        outlines,
        centres,
        notes: frame.notes,
    }
}

/// The point of a slice that radii are measured from: the middle of the cavity, or of the heart where there is none.
fn centre(planes: &Planes, slice: usize, regions: &SliceRegions) -> Option<Place> {
    let middle = |region: &Option<Region>| region.as_ref().and_then(Region::centre);
    let centre = middle(&regions.cavity).or_else(|| middle(&regions.heart))?;
    Some(planes.place(slice, centre))
}

/// The direction within slices from the middle of the left ventricle, over all slices of the first instant, to a point that
/// somebody marked; `None` where this lies on the axis itself.
fn marked_septal_rad(planes: &Planes, masks: &Masks, septum: Point3) -> Option<f64> {
    let voxels = masks.instants().first()?;
    let mut sum = Place::zeros();
    let mut count = 0;
    for slice in 0..planes.count() {
        let cavity = planes.region(voxels, slice, Tissue::Cavity);
        if let Some(centre) = cavity.centre() {
            sum += planes.place(slice, centre);
            count += 1;
        }
    }
    if count == 0 {
        return None;
    }
    let towards = planes.place_of(septum) - sum / f64::from(count);
    let direction = towards.try_normalize(planes.pixel_mm() * 1e-3)?;
    Some(direction.y.atan2(direction.x))
}

/// The direction within slices from the left ventricle to the right one, over all slices and instants that show it.
fn septal_rad(planes: &Planes, masks: &Masks) -> Option<f64> {
    let mut sum = Place::zeros();
    for voxels in masks.instants() {
        for slice in 0..planes.count() {
            let region = |tissue| planes.region(voxels, slice, tissue);
            let right = region(Tissue::RightCavity);
            let left = region(Tissue::Cavity).with(&region(Tissue::Wall));
            if let (Some(from), Some(to)) = (left.centre(), right.centre()) {
                let towards = planes.place(slice, to) - planes.place(slice, from);
                // Slices with little of the right ventricle say little of where its middle is.
                sum +=
                    towards.try_normalize(0.0).unwrap_or_else(Place::zeros) * right.count() as f64;
            }
        }
    }
    sum.try_normalize(0.0)
        .map(|direction| direction.y.atan2(direction.x))
}

/// Landmarks of an instant, with a note where the side of the anterior wall is an assumption.
pub(super) fn anatomy_of(
    masks: &Masks,
    planes: &Planes,
    shape: &WallShape,
    septal_rad: f64,
    notices: &mut Vec<Notice>,
) -> Option<Anatomy> {
    let apex = planes.position(shape.centre(shape.epi.apex), shape.epi.apex);
    let base = planes.position(shape.centre(shape.base), shape.base);
    let reach = (base - apex).norm();
    let septal = planes.direction(Place::new(septal_rad.cos(), septal_rad.sin())) * reach;
    let up = planes.position(Place::zeros(), 1.0) - planes.position(Place::zeros(), 0.0);
    let mut anterior = up.cross(&septal);
    if is_on_axes(&masks.frame().directions()) {
        // The file lost how the slices lie in the patient. What is left is how they are stored: rows to the right and columns
        // down, as seen from the apex.
        if !planes.seen_from_apex() {
            anterior = -anterior;
        }
        notices.push(Notice::info(
            "the slices lie exactly along the axes of the patient, as short-axis slices never do: the anterior wall is taken to \
             be at the top of the slices as they are stored",
        ));
    }
    Anatomy::from_landmarks(apex, base, base + septal, base + anterior)
}

fn is_on_axes(directions: &[Vector3; 3]) -> bool {
    directions
        .iter()
        .all(|direction| (direction.amax() - 1.0).abs() < ON_AXIS)
}
