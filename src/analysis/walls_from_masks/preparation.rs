//! Instants on their way from masks to surfaces.

use crate::mesh::Vector3;
use crate::study::Notice;

use super::planes::{Place, Planes};
use super::shape::RadialFrame;

/// A slice that stood beside its neighbours, because it was taken in another breath-hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceShift {
    /// Number of the slice in the volume, from 1.
    pub slice: usize,
    /// By what it stood off; its outlines were moved back by as much.
    pub shift_mm: Vector3,
}

/// One instant on its way to surfaces.
pub(super) struct Prepared {
    pub radial: RadialFrame,
    /// For endocardium and epicardium: places that the surface should pass through, as the mask has them, with heights.
    pub outlines: [Vec<(Place, f64)>; 2],
    /// For each slice of `radial`, from where its outlines are moved to the axis; empty where they stay.
    pub centres: Vec<(f64, Place)>,
    pub notes: Vec<String>,
}

/// What all instants have in common.
pub(super) struct Preparation {
    pub planes: Planes,
    pub frames: Vec<Prepared>,
    pub septal_rad: Option<f64>,
    pub shifts: Vec<SliceShift>,
    pub notices: Vec<Notice>,
}
