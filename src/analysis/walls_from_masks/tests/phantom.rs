//! A ventricle between two half-ellipsoids, drawn on slices.

use std::f64::consts::PI;
use std::sync::Arc;

use crate::analysis::walls_from_masks::{Masks, Tissue, WallParams, Walls, walls_from_masks};
use crate::image::VolumeFrame;
use crate::mesh::{Point3, Vector3};
use crate::progress::Progress;

/// How it is drawn.
#[derive(Clone, Debug)]
pub struct Phantom {
    /// Half-axes across and along, of endocardium and epicardium at each instant, with the base in the middle of the ellipsoids.
    pub axes: Vec<[[f64; 2]; 2]>,
    pub pixel: f64,
    pub thickness: f64,
    /// What each slice, from the base on, stands off.
    pub shifts: Vec<[f64; 2]>,
    /// Whether there is a right ventricle, at negative x.
    pub right: bool,
}

impl Default for Phantom {
    fn default() -> Self {
        Self {
            axes: vec![[[25.0, 70.0], [34.0, 79.0]], [[17.0, 60.0], [31.0, 74.0]]],
            pixel: 1.5,
            thickness: 8.0,
            shifts: Vec::new(),
            right: true,
        }
    }
}

/// Side of the drawn square in millimetres.
const FIELD: f64 = 120.0;

impl Phantom {
    pub fn size(&self) -> [usize; 3] {
        let side = (FIELD / self.pixel).round() as usize;
        [side, side, (96.0 / self.thickness).ceil() as usize]
    }

    /// Slices from the base (k = 0) to the apex, whose first one has its upper side at z = 0, beside the axes of the world.
    pub fn frame(&self) -> VolumeFrame {
        let [turn, tilt] = [0.3_f64, 0.2_f64];
        let rotation = nalgebra::Rotation3::from_euler_angles(tilt, -0.1, turn);
        let middle = 0.5 * (FIELD - self.pixel);
        let origin = Point3::new(-middle, -middle, -0.5 * self.thickness);
        let steps = [
            Vector3::x() * self.pixel,
            -Vector3::y() * self.pixel,
            -Vector3::z() * self.thickness,
        ];
        let origin = Point3::new(origin.x, -origin.y, origin.z);
        VolumeFrame::new(self.size(), rotation * origin, steps.map(|s| rotation * s)).unwrap()
    }

    /// The position in the coordinates of the ellipsoids of a position in the world.
    pub fn own(&self, world: Point3) -> Point3 {
        let frame = self.frame();
        let voxel = frame.voxel(world);
        let middle = 0.5 * (FIELD - self.pixel);
        Point3::new(
            voxel.x * self.pixel - middle,
            middle - voxel.y * self.pixel,
            -(voxel.z + 0.5) * self.thickness,
        )
    }

    pub fn masks(&self) -> Masks {
        let [ni, nj, nk] = self.size();
        let middle = 0.5 * (FIELD - self.pixel);
        let instants = self.axes.iter().map(|axes| {
            let mut voxels = Vec::with_capacity(ni * nj * nk);
            for k in 0..nk {
                let [dx, dy] = self.shifts.get(k).copied().unwrap_or_default();
                for j in 0..nj {
                    for i in 0..ni {
                        let x = i as f64 * self.pixel - middle - dx;
                        let y = middle - j as f64 * self.pixel - dy;
                        let z = -(k as f64 + 0.5) * self.thickness;
                        voxels.push(self.tissue(axes, [x, y, z]));
                    }
                }
            }
            Arc::from(voxels)
        });
        Masks::new(self.frame(), instants.collect()).unwrap()
    }

    fn tissue(&self, [endo, epi]: &[[f64; 2]; 2], [x, y, z]: [f64; 3]) -> Tissue {
        let inside = |[a, c]: [f64; 2], x: f64| (x * x + y * y) / (a * a) + z * z / (c * c) <= 1.0;
        if inside(*endo, x) {
            Tissue::Cavity
        } else if inside(*epi, x) {
            Tissue::Wall
        } else if self.right && inside([28.0, 50.0], x + 24.0) {
            Tissue::RightCavity
        } else {
            Tissue::Other
        }
    }

    /// Volumes of endocardium and epicardium at an instant, in millilitres: ⅔ π a² c.
    pub fn volumes_ml(&self, instant: usize) -> [f64; 2] {
        self.axes[instant].map(|[a, c]| 2.0 / 3.0 * PI * a * a * c / 1000.0)
    }
}

pub fn walls(masks: &Masks) -> Walls {
    let params = WallParams::default().check().unwrap();
    walls_from_masks(masks, &params, &Progress::default()).unwrap()
}

/// The same masks with the voxels of a slice changed at all instants.
pub fn with_slices(masks: &Masks, change: impl Fn([usize; 3], Tissue) -> Tissue) -> Masks {
    let [ni, nj, _] = masks.frame().size();
    let instants = masks.instants().iter().map(|voxels| {
        let changed = voxels.iter().enumerate();
        changed
            .map(|(n, &t)| change([n % ni, n / ni % nj, n / (ni * nj)], t))
            .collect()
    });
    Masks::new(*masks.frame(), instants.collect()).unwrap()
}
