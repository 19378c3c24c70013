//! Masks that lack something.

use proptest::prelude::*;
use std::sync::Arc;

use crate::analysis::walls_from_masks::{
    FrameWallError, MaskError, MaskLabels, Masks, Tissue, WallError, WallParams, Walls,
    walls_from_masks,
};
use crate::image::{Image, VolumeFrame};
use crate::mesh::{Point3, Vector3};
use crate::progress::{Progress, Stopped};

use super::phantom::{Phantom, with_slices};

fn made(masks: &Masks) -> Result<Walls, WallError> {
    walls_from_masks(
        masks,
        &WallParams::default().check().unwrap(),
        &Progress::default(),
    )
}

fn says(walls: &Walls, words: &str) -> bool {
    walls
        .notices
        .iter()
        .any(|notice| notice.text.contains(words))
}

/// Volume of the epicardium of the first frame over that of the intact phantom.
fn kept(walls: &Walls) -> f64 {
    walls.fits[1].volume_ml / made(&Phantom::default().masks()).unwrap().fits[1].volume_ml
}

#[test]
fn an_empty_slice_and_a_hole_in_the_wall_are_bridged_and_told() {
    let masks = Phantom::default().masks();
    let walls = made(&with_slices(
        &masks,
        |[_, _, k], t| if k == 4 { Tissue::Other } else { t },
    ))
    .unwrap();
    assert!(says(&walls, "slice 5: empty"));
    assert!((kept(&walls) - 1.0).abs() < 0.02, "{}", kept(&walls));
    let side = masks.frame().size()[0];
    let in_wall = |t| t == Tissue::Wall;
    let hole = with_slices(&masks, |[i, j, k], t| {
        if k == 3 && in_wall(t) && i > side / 2 && j.abs_diff(side / 2) < 6 {
            Tissue::Other
        } else {
            t
        }
    });
    let walls = made(&hole).unwrap();
    assert!(
        says(&walls, "slice 4: the wall is open"),
        "{:?}",
        walls.notices
    );
    assert!((kept(&walls) - 1.0).abs() < 0.02);
    assert!(walls.fits.iter().all(|fit| fit.foldovers == 0));
}

#[test]
fn a_slice_with_little_wall_says_nothing_about_the_epicardium_and_at_the_base_it_is_cut_off() {
    let masks = Phantom::default().masks();
    let side = masks.frame().size()[0];
    let open_at = |slice: usize| {
        with_slices(&masks, |[i, _, k], t| {
            if k == slice && t == Tissue::Wall && 2 * i > side - 20 {
                Tissue::Other
            } else {
                t
            }
        })
    };
    let walls = made(&open_at(4)).unwrap();
    assert!(
        says(&walls, "slice 5: the wall lies along"),
        "{:?}",
        walls.notices
    );
    assert!((kept(&walls) - 1.0).abs() < 0.02, "{}", kept(&walls));
    let walls = made(&open_at(0)).unwrap();
    assert!(
        says(&walls, "slice 1 above the plane of the valve"),
        "{:?}",
        walls.notices
    );
    assert!(kept(&walls) < 0.93);
}

#[test]
fn without_an_apex_the_walls_are_closed_below_the_last_slice() {
    let masks = Phantom::default().masks();
    let walls = made(&with_slices(
        &masks,
        |[_, _, k], t| if k > 5 { Tissue::Other } else { t },
    ))
    .unwrap();
    for fit in &walls.fits {
        assert_eq!(fit.foldovers, 0);
        assert!(
            (fit.volume_ml / fit.mask_volume_ml - 1.0).abs() < 1e-3,
            "{fit:?}"
        );
    }
}

#[test]
fn a_cavity_that_vanishes_between_slices_leaves_a_narrow_one() {
    let masks = Phantom::default().masks();
    let walls = made(&with_slices(&masks, |[_, _, k], t| match t {
        Tissue::Cavity if k == 4 => Tissue::Wall,
        other => other,
    }))
    .unwrap();
    assert!(says(
        &walls,
        "slice 5: no cavity between slices that have one"
    ));
    assert!(walls.fits.iter().all(|fit| fit.foldovers == 0));
}

#[test]
fn too_little_is_a_typed_error_with_the_frame() {
    let masks = Phantom::default().masks();
    let only = |slices: usize| {
        with_slices(
            &masks,
            |[_, _, k], t| if k < slices { t } else { Tissue::Other },
        )
    };
    let reason = |masks: &Masks| match made(masks).unwrap_err() {
        WallError::Frame { frame: 0, reason } => reason,
        other => panic!("{other}"),
    };
    assert_eq!(
        reason(&only(1)),
        FrameWallError::FewSlices {
            tissue: "wall",
            slices: 1,
            needed: 3
        }
    );
    assert_eq!(reason(&only(0)), FrameWallError::NoCavity);
    let without =
        |gone: Tissue| with_slices(&masks, |_, t| if t == gone { Tissue::Other } else { t });
    assert_eq!(reason(&without(Tissue::Wall)), FrameWallError::NoWall);
    assert_eq!(reason(&without(Tissue::Cavity)), FrameWallError::NoCavity);
    // Labels in another order: the "cavity" is the right ventricle.
    let swapped = with_slices(&masks, |_, t| match t {
        Tissue::Cavity => Tissue::RightCavity,
        Tissue::RightCavity => Tissue::Cavity,
        other => other,
    });
    assert!(matches!(reason(&swapped), FrameWallError::NotEnclosed { share } if share < 0.5));
    // An error of the second frame names it.
    let second = vec![
        Arc::clone(&masks.instants()[0]),
        Arc::from(vec![Tissue::Other; masks.frame().voxel_count()]),
    ];
    let second = Masks::new(*masks.frame(), second).unwrap();
    assert_eq!(
        made(&second).unwrap_err().to_string(),
        "frame 1: the cavity is empty"
    );
    assert_eq!(second.drawn().unwrap().1, [0]);
}

#[test]
fn images_that_are_no_masks_are_refused() {
    let frame = |nk| {
        VolumeFrame::new(
            [2, 2, nk],
            Point3::origin(),
            [Vector3::x(), Vector3::y(), Vector3::z()],
        )
        .unwrap()
    };
    let image = |nk: usize, value: f32| {
        Image::new(frame(nk), vec![vec![value; 4 * nk].into()], None).unwrap()
    };
    let absent = Masks::from_labels(&image(3, 2.0), &MaskLabels::default()).unwrap_err();
    assert_eq!(
        absent,
        MaskError::LabelAbsent {
            label: 3,
            tissue: "cavity",
            present: vec![2]
        }
    );
    assert_eq!(
        absent.to_string(),
        "no voxel has label 3 (cavity); labels that occur: 2"
    );
    let twice = MaskLabels {
        wall: 3,
        ..MaskLabels::default()
    };
    assert_eq!(
        Masks::from_labels(&image(3, 3.0), &twice),
        Err(MaskError::LabelTwice { label: 3 })
    );
    let differ = Masks::from_pair(&image(3, 1.0), &image(4, 1.0)).unwrap_err();
    assert!(
        matches!(differ, MaskError::GridsDiffer { instant: 0, .. }),
        "{differ}"
    );
    let two = Masks::from_pair(&image(3, f32::NAN), &image(3, 0.6)).unwrap();
    assert_eq!(two.count(0, Tissue::Wall), 12);
    assert_eq!(Masks::joined(Vec::new()), Err(MaskError::Empty));
}

#[test]
fn a_stopped_run_says_so() {
    let progress = Progress::default();
    progress.stop();
    let params = WallParams::default().check().unwrap();
    let stopped = walls_from_masks(&Phantom::default().masks(), &params, &progress);
    assert_eq!(stopped.unwrap_err(), WallError::Stopped(Stopped));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// Whatever voxels hold, there is a wall or a reason.
    #[test]
    fn no_voxels_make_it_panic(
        size in [1_usize..9, 1_usize..9, 1_usize..12],
        steps in [0.5_f64..3.0, 0.5_f64..3.0, 0.5_f64..12.0],
        seeds in prop::collection::vec(0_u8..6, 1000),
    ) {
        let axes = [Vector3::x() * steps[0], Vector3::y() * steps[1], Vector3::z() * steps[2]];
        let frame = VolumeFrame::new(size, Point3::origin(), axes).unwrap();
        let tissue = |n: usize| match seeds[n % 1000] {
            0 | 1 => Tissue::Cavity,
            2 | 3 => Tissue::Wall,
            4 => Tissue::RightCavity,
            _ => Tissue::Other,
        };
        let voxels: Vec<Tissue> = (0..frame.voxel_count()).map(tissue).collect();
        if let Ok(walls) = made(&Masks::new(frame, vec![voxels.into()]).unwrap()) {
            prop_assert_eq!(walls.fits.len(), 2);
        }
    }
}
