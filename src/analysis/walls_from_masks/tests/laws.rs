//! What must not change the walls, or must change them in a known way.

use nalgebra::{Rotation3, Translation3};
use std::sync::Arc;

use crate::analysis::walls_from_masks::{Masks, Tissue, Walls};
use crate::image::VolumeFrame;
use crate::mesh::{Point3, Vector3};

use super::phantom::{Phantom, walls};

fn farthest(a: &Walls, b: &Walls, of: impl Fn(Point3) -> Point3) -> f64 {
    let pairs = a.sequence.surfaces().iter().zip(b.sequence.surfaces());
    let meshes = pairs.flat_map(|(a, b)| a.frames().iter().zip(b.frames()));
    let vertices = meshes.flat_map(|(a, b)| a.vertices().iter().zip(b.vertices()));
    vertices
        .map(|(a, b)| (of(*a) - b).norm())
        .fold(0.0, f64::max)
}

#[test]
fn moving_and_turning_the_frame_moves_and_turns_the_walls() {
    let phantom = Phantom {
        shifts: vec![[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [7.0, 2.0]],
        ..Phantom::default()
    };
    let masks = phantom.masks();
    let motion =
        Translation3::new(120.0, -40.0, 7.0) * Rotation3::from_euler_angles(0.4, -1.2, 2.0);
    let frame = masks.frame();
    let steps: [Vector3; 3] = frame.steps().map(|step| motion * step);
    let moved = VolumeFrame::new(frame.size(), motion * frame.origin(), steps).unwrap();
    let moved = Masks::new(moved, masks.instants().to_vec()).unwrap();
    assert!(farthest(&walls(&masks), &walls(&moved), |p| motion * p) < 1e-8);
}

#[test]
fn the_order_of_slices_and_of_axes_in_the_file_does_not_matter() {
    let masks = Phantom::default().masks();
    let expected = walls(&masks);
    let frame = masks.frame();
    let [ni, nj, nk] = frame.size();
    let [di, dj, dk] = frame.steps();
    let turned = |instants: Vec<Arc<[Tissue]>>, size, origin, steps| {
        Masks::new(VolumeFrame::new(size, origin, steps).unwrap(), instants).unwrap()
    };
    let read = |place: &dyn Fn(usize) -> usize| -> Vec<Arc<[Tissue]>> {
        let of = |voxels: &Arc<[Tissue]>| (0..voxels.len()).map(|n| voxels[place(n)]).collect();
        masks.instants().iter().map(of).collect()
    };
    let slice = ni * nj;
    let backwards = read(&|n| (nk - 1 - n / slice) * slice + n % slice);
    let last = frame.origin() + dk * (nk - 1) as f64;
    let backwards = turned(backwards, [ni, nj, nk], last, [di, dj, -dk]);
    assert!(farthest(&expected, &walls(&backwards), |p| p) < 1e-8);
    // Slices along the first axis.
    let across = read(&|n| (n % nk) * slice + n / nk % ni + (n / (nk * ni)) * ni);
    let across = turned(across, [nk, ni, nj], frame.origin(), [dk, di, dj]);
    assert!(farthest(&expected, &walls(&across), |p| p) < 1e-8);
}

#[test]
fn walls_of_a_frame_do_not_depend_on_threads() {
    let masks = Phantom::default().masks();
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .unwrap();
    let one = pool.install(|| walls(&masks));
    assert_eq!(one.sequence.surfaces(), walls(&masks).sequence.surfaces());
}
