//! What a person takes away from a volume, or keeps of it, before a surface is made.

use serde::{Deserialize, Serialize};

use super::{Mask, VolumeFrame};
use crate::mesh::{Point3, Vector3};

/// One edit of a volume; the same at every instant. Positions are in the world (LPS, millimetres).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "Stored", into = "Stored")]
pub enum VolumeEdit {
    /// Nothing is kept on the side of a plane that its normal points to.
    CutPlane {
        /// A point of the plane.
        point: Point3,
        /// Its normal; any length but 0.
        normal: Vector3,
    },
    /// Nothing is kept within a sphere.
    SphereEraser {
        /// The middle of the sphere.
        centre: Point3,
        /// Its radius in millimetres.
        radius_mm: f64,
    },
    /// Of what lies above the threshold, only the connected component of the most voxels is kept.
    LargestComponent,
    /// Of what lies above the threshold, only the connected component at this position is kept: that of the nearest voxel
    /// above it, since a wall moves away from where it was clicked.
    ComponentAt(Point3),
    /// What lies below the threshold and is enclosed on all sides counts as inside.
    FillHoles,
}

/// Why a volume cannot be edited so.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum VolumeEditError {
    /// Values and a grid do not belong together.
    #[error("{values} values for {voxels} voxels")]
    Count {
        /// How many values there are.
        values: usize,
        /// How many there should be.
        voxels: usize,
    },
    /// The threshold is no number.
    #[error("the threshold of the edits is not a finite number")]
    Threshold,
    /// A position or a length of an edit is no number.
    #[error("edit {number}: a position, normal or radius is not a finite number")]
    NotFinite {
        /// Which, from 1.
        number: usize,
    },
    /// A plane without a side.
    #[error("edit {number}: the normal of the plane has no length")]
    NoNormal {
        /// Which, from 1.
        number: usize,
    },
    /// A sphere of negative size.
    #[error("edit {number}: the radius of the sphere is {radius_mm} mm")]
    Radius {
        /// Which, from 1.
        number: usize,
        /// Its radius.
        radius_mm: f64,
    },
}

impl VolumeEdit {
    /// Whether it takes away whatever is at a position, by the position alone.
    pub fn erases(&self, position: Point3) -> bool {
        match *self {
            Self::CutPlane { point, normal } => (position - point).dot(&normal) > 0.0,
            Self::SphereEraser { centre, radius_mm } => (position - centre).norm() <= radius_mm,
            Self::LargestComponent | Self::ComponentAt(_) | Self::FillHoles => false,
        }
    }

    /// Whether its numbers say a place: as the first thing that [`edited`] asks of each edit.
    ///
    /// # Errors
    /// If a number is not finite, a normal has no length or a radius is negative; `number` is the edit's, from 1.
    pub fn check(&self, number: usize) -> Result<(), VolumeEditError> {
        let finite = |coordinates: &[f64]| coordinates.iter().all(|x| x.is_finite());
        match self {
            Self::CutPlane { point, normal } => {
                if !finite(point.coords.as_slice()) || !finite(normal.as_slice()) {
                    return Err(VolumeEditError::NotFinite { number });
                }
                if normal.amax() == 0.0 {
                    return Err(VolumeEditError::NoNormal { number });
                }
            }
            Self::SphereEraser { centre, radius_mm } => {
                if !finite(centre.coords.as_slice()) || !radius_mm.is_finite() {
                    return Err(VolumeEditError::NotFinite { number });
                }
                if *radius_mm < 0.0 {
                    let radius_mm = *radius_mm;
                    return Err(VolumeEditError::Radius { number, radius_mm });
                }
            }
            Self::ComponentAt(point) => {
                if !finite(point.coords.as_slice()) {
                    return Err(VolumeEditError::NotFinite { number });
                }
            }
            Self::LargestComponent | Self::FillHoles => {}
        }
        Ok(())
    }
}

/// Values of one volume, i fastest, after edits in their order: later ones see what earlier ones left.
///
/// What is taken away gets the least value of the volume, or one below the threshold where that is none; of a hole that is
/// filled, each value v ≤ t gets its mirror image 2t − v, so that an isosurface at the threshold t does not notice it. Values that
/// are missing (NaN) lie below every threshold: they can be taken away and filled.
/// Where nothing lies above the threshold, edits of components leave everything as it is.
///
/// # Errors
/// If counts differ, the threshold is not finite, or an edit says no place.
pub fn edited(
    values: &[f32],
    frame: &VolumeFrame,
    edits: &[VolumeEdit],
    threshold: f64,
) -> Result<Vec<f32>, VolumeEditError> {
    let count = VolumeEditError::Count {
        values: values.len(),
        voxels: frame.voxel_count(),
    };
    if values.len() != frame.voxel_count() {
        return Err(count);
    }
    if !threshold.is_finite() {
        return Err(VolumeEditError::Threshold);
    }
    for (number, edit) in (1..).zip(edits) {
        edit.check(number)?;
    }
    let background = background(values, threshold);
    let mut values = values.to_vec();
    for edit in edits {
        let above = |values: &[f32]| Mask::above(frame.size(), values, threshold);
        match edit {
            VolumeEdit::CutPlane { .. } | VolumeEdit::SphereEraser { .. } => {
                erase(&mut values, frame, edit, background);
            }
            VolumeEdit::LargestComponent => {
                let inside = above(&values).map_err(|_| count)?;
                keep(
                    &mut values,
                    &inside,
                    &inside.largest_component(),
                    background,
                );
            }
            VolumeEdit::ComponentAt(position) => {
                let inside = above(&values).map_err(|_| count)?;
                if let Some(voxel) = nearest(&inside, frame, *position) {
                    keep(
                        &mut values,
                        &inside,
                        &inside.component_at(voxel),
                        background,
                    );
                }
            }
            VolumeEdit::FillHoles => {
                let inside = above(&values).map_err(|_| count)?;
                fill(&mut values, &inside, &inside.holes_filled(), threshold);
            }
        }
    }
    Ok(values)
}

/// The least value, if it lies below the threshold; else one that does.
fn background(values: &[f32], threshold: f64) -> f32 {
    let finite = values.iter().copied().filter(|value| value.is_finite());
    let least = finite.fold(f32::INFINITY, f32::min);
    if f64::from(least) < threshold {
        return least;
    }
    let below = threshold - threshold.abs().max(1.0);
    below.max(f64::from(f32::MIN)) as f32
}

/// Takes away what an edit erases by position.
fn erase(values: &mut [f32], frame: &VolumeFrame, edit: &VolumeEdit, background: f32) {
    let [nx, ny, _] = frame.size();
    let step = frame.steps()[0];
    for (number, row) in values.chunks_mut(nx).enumerate() {
        let (j, k) = ((number % ny) as f64, (number / ny) as f64);
        let first = frame.position(Point3::new(0.0, j, k));
        for (i, value) in row.iter_mut().enumerate() {
            if edit.erases(first + step * i as f64) {
                *value = background;
            }
        }
    }
}

/// Takes away what is inside and not to be kept.
fn keep(values: &mut [f32], inside: &Mask, kept: &Mask, background: f32) {
    let places = inside.inside().iter().zip(kept.inside());
    for (value, (&inside, &kept)) in values.iter_mut().zip(places) {
        if inside && !kept {
            *value = background;
        }
    }
}

/// Lifts what is filled above the threshold.
fn fill(values: &mut [f32], inside: &Mask, filled: &Mask, threshold: f64) {
    let least = (threshold as f32)
        .next_up()
        .max((threshold + threshold.abs() * 1e-6) as f32);
    let places = inside.inside().iter().zip(filled.inside());
    for (value, (&inside, &filled)) in values.iter_mut().zip(places) {
        if filled && !inside {
            let mirrored = (2.0 * threshold - f64::from(*value)) as f32;
            // The larger of the two is never NaN.
            *value = mirrored.max(least).min(f32::MAX);
        }
    }
}

/// The voxel of a mask nearest to a position; of equal ones the first.
fn nearest(inside: &Mask, frame: &VolumeFrame, position: Point3) -> Option<[usize; 3]> {
    let [nx, ny, _] = inside.size();
    let voxels = inside.inside().iter().enumerate().filter(|(_, is)| **is);
    let places = voxels.map(|(voxel, _)| [voxel % nx, voxel / nx % ny, voxel / nx / ny]);
    let away = |place: &[usize; 3]| {
        let centre = frame.position(Point3::from(place.map(|n| n as f64)));
        (centre - position).norm_squared()
    };
    places
        .map(|place| (away(&place), place))
        .min_by(|(a, _), (b, _)| a.total_cmp(b))
        .map(|(_, place)| place)
}

/// An edit as files keep it: positions as three numbers.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Stored {
    CutPlane { point: [f64; 3], normal: [f64; 3] },
    SphereEraser { centre: [f64; 3], radius_mm: f64 },
    LargestComponent,
    ComponentAt([f64; 3]),
    FillHoles,
}

impl From<Stored> for VolumeEdit {
    fn from(stored: Stored) -> Self {
        match stored {
            Stored::CutPlane { point, normal } => Self::CutPlane {
                point: point.into(),
                normal: normal.into(),
            },
            Stored::SphereEraser { centre, radius_mm } => Self::SphereEraser {
                centre: centre.into(),
                radius_mm,
            },
            Stored::LargestComponent => Self::LargestComponent,
            Stored::ComponentAt(point) => Self::ComponentAt(point.into()),
            Stored::FillHoles => Self::FillHoles,
        }
    }
}

impl From<VolumeEdit> for Stored {
    fn from(edit: VolumeEdit) -> Self {
        match edit {
            VolumeEdit::CutPlane { point, normal } => Self::CutPlane {
                point: point.into(),
                normal: normal.into(),
            },
            VolumeEdit::SphereEraser { centre, radius_mm } => Self::SphereEraser {
                centre: centre.into(),
                radius_mm,
            },
            VolumeEdit::LargestComponent => Self::LargestComponent,
            VolumeEdit::ComponentAt(point) => Self::ComponentAt(point.into()),
            VolumeEdit::FillHoles => Self::FillHoles,
        }
    }
}

#[cfg(test)]
mod tests;
