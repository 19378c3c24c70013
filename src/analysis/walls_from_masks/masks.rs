//! Masks of a left ventricle: which voxels are cavity, wall and right ventricle at each instant.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::image::{Image, VolumeFrame};

use super::MaskError;

/// What a voxel is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tissue {
    /// Nothing of these.
    #[default]
    Other,
    /// Blood of the left ventricle, with papillary muscles.
    Cavity,
    /// Myocardium of the left ventricle.
    Wall,
    /// Blood of the right ventricle.
    RightCavity,
}

/// Which value of a label image stands for which tissue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaskLabels {
    /// Cavity of the left ventricle.
    pub cavity: i32,
    /// Myocardium of the left ventricle.
    pub wall: i32,
    /// Cavity of the right ventricle, by which the septum is found; it may be absent.
    pub right: Option<i32>,
}

impl Default for MaskLabels {
    /// Those of the ACDC challenge.
    fn default() -> Self {
        Self {
            cavity: 3,
            wall: 2,
            right: Some(1),
        }
    }
}

/// Labels that an error names at most.
const MAX_NAMED: usize = 16;
/// Positions of grids that differ by less, as a share of a voxel, are equal: files hold 32-bit numbers.
const SAME_PLACE: f64 = 1e-3;

/// The tissues on one grid at each of at least one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Masks {
    frame: VolumeFrame,
    instants: Vec<Arc<[Tissue]>>,
}

impl Masks {
    /// Tissues by the labels of an image.
    ///
    /// # Errors
    /// If two tissues have one label, or no voxel of any instant is cavity or none is wall.
    pub fn from_labels(image: &Image, labels: &MaskLabels) -> Result<Self, MaskError> {
        let [cavity, wall] = [labels.cavity, labels.wall];
        if let Some(&label) = [cavity, wall]
            .iter()
            .find(|&&label| Some(label) == labels.right)
        {
            return Err(MaskError::LabelTwice { label });
        }
        if cavity == wall {
            return Err(MaskError::LabelTwice { label: cavity });
        }
        let tissue = |&value: &f32| {
            let label = value.round();
            if label == cavity as f32 {
                Tissue::Cavity
            } else if label == wall as f32 {
                Tissue::Wall
            } else if labels.right.is_some_and(|right| label == right as f32) {
                Tissue::RightCavity
            } else {
                Tissue::Other
            }
        };
        let instants: Vec<Arc<[Tissue]>> = (image.volumes().iter())
            .map(|volume| volume.iter().map(tissue).collect())
            .collect();
        for (wanted, label, name) in [
            (Tissue::Cavity, cavity, "cavity"),
            (Tissue::Wall, wall, "wall"),
        ] {
            if !instants.iter().any(|instant| instant.contains(&wanted)) {
                return Err(MaskError::LabelAbsent {
                    label,
                    tissue: name,
                    present: present(image),
                });
            }
        }
        Ok(Self {
            frame: *image.frame(),
            instants,
        })
    }

    /// Tissues by a mask of the cavity and one of the whole ventricle up to the epicardium, or of its wall alone. A voxel
    /// is inside where its value is at least one half.
    ///
    /// # Errors
    /// If grids or numbers of instants differ.
    pub fn from_pair(endo: &Image, epi: &Image) -> Result<Self, MaskError> {
        same_grid(endo.frame(), epi.frame(), 0)?;
        if endo.volumes().len() != epi.volumes().len() {
            return Err(MaskError::InstantsDiffer {
                endo: endo.volumes().len(),
                epi: epi.volumes().len(),
            });
        }
        let instants = endo.volumes().iter().zip(epi.volumes());
        let tissue = |(&endo, &epi): (&f32, &f32)| match (endo >= 0.5, epi >= 0.5) {
            (true, _) => Tissue::Cavity,
            (false, true) => Tissue::Wall,
            (false, false) => Tissue::Other,
        };
        Ok(Self {
            frame: *endo.frame(),
            instants: instants
                .map(|(endo, epi)| endo.iter().zip(epi.iter()).map(tissue).collect())
                .collect(),
        })
    }

    /// Tissues voxel by voxel, i fastest.
    ///
    /// # Errors
    /// If there is no instant, or one with more or fewer voxels than the grid.
    pub fn new(frame: VolumeFrame, instants: Vec<Arc<[Tissue]>>) -> Result<Self, MaskError> {
        let voxels = frame.voxel_count();
        if instants.is_empty() {
            return Err(MaskError::Empty);
        }
        match instants.iter().position(|instant| instant.len() != voxels) {
            None => Ok(Self { frame, instants }),
            Some(instant) => Err(MaskError::GridsDiffer {
                instant,
                sizes: [frame.size(), [instants[instant].len(), 1, 1]],
            }),
        }
    }

    /// The instants of several masks one after the other, as where every frame is a file of its own.
    ///
    /// # Errors
    /// If there is none, or grids differ.
    pub fn joined(parts: Vec<Self>) -> Result<Self, MaskError> {
        let mut parts = parts.into_iter();
        let mut whole = parts.next().ok_or(MaskError::Empty)?;
        for part in parts {
            same_grid(&whole.frame, &part.frame, whole.instants.len())?;
            whole.instants.extend(part.instants);
        }
        Ok(whole)
    }

    /// Only the instants at which anything of the left ventricle is drawn, and their numbers: often only end-diastole and
    /// end-systole of a beat are.
    ///
    /// # Errors
    /// If there is none.
    pub fn drawn(self) -> Result<(Self, Vec<usize>), MaskError> {
        let of_ventricle = |tissue: &Tissue| matches!(tissue, Tissue::Cavity | Tissue::Wall);
        let instants = self.instants.into_iter().enumerate();
        let (numbers, instants): (Vec<usize>, Vec<_>) = instants
            .filter(|(_, voxels)| voxels.iter().any(of_ventricle))
            .unzip();
        if instants.is_empty() {
            return Err(MaskError::Empty);
        }
        let frame = self.frame;
        Ok((Self { frame, instants }, numbers))
    }

    /// Where the voxels stand.
    pub fn frame(&self) -> &VolumeFrame {
        &self.frame
    }

    /// The tissues of each instant, i fastest, then j, then k.
    pub fn instants(&self) -> &[Arc<[Tissue]>] {
        &self.instants
    }

    /// Voxels of a tissue at an instant.
    pub fn count(&self, instant: usize, tissue: Tissue) -> usize {
        let voxels = self.instants.get(instant).map_or(&[][..], |voxels| voxels);
        voxels.iter().filter(|&&voxel| voxel == tissue).count()
    }
}

/// Values that occur in an image, ascending.
fn present(image: &Image) -> Vec<i32> {
    let mut found = BTreeSet::new();
    for value in image.volumes().iter().flat_map(|volume| volume.iter()) {
        if value.is_finite() && *value != 0.0 && found.len() < MAX_NAMED {
            found.insert(value.round() as i32);
        }
    }
    found.into_iter().collect()
}

fn same_grid(first: &VolumeFrame, other: &VolumeFrame, instant: usize) -> Result<(), MaskError> {
    let [x, y, z] = first.size().map(|n| n as f64);
    let shortest = first.spacing().into_iter().fold(f64::INFINITY, f64::min);
    // Corners of the grid, so that small differences of directions count by what they move.
    let corners =
        [[0.0; 3], [x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]].map(crate::mesh::Point3::from);
    let apart = |corner| (first.position(corner) - other.position(corner)).norm();
    let same = first.size() == other.size()
        && corners
            .into_iter()
            .all(|corner| apart(corner) <= SAME_PLACE * shortest);
    if same {
        return Ok(());
    }
    Err(MaskError::GridsDiffer {
        instant,
        sizes: [first.size(), other.size()],
    })
}
