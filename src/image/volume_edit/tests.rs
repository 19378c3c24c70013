//! Edits of a volume of two blocks that a bridge joins, one with a hole.
#![allow(clippy::unwrap_used)] // A test that fails here says so.

use proptest::prelude::*;

use super::*;

const SIZE: [usize; 3] = [11, 5, 5];

/// Steps of 2 mm from (−10, 0, 5) on.
fn frame() -> VolumeFrame {
    let steps = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| axis * 2.0);
    VolumeFrame::new(SIZE, Point3::new(-10.0, 0.0, 5.0), steps).unwrap()
}

/// 100 in two blocks at i = 0 to 4 and 6 to 9, the first with a hole in its middle; 10 elsewhere.
fn blocks() -> Vec<f32> {
    let mut values = vec![10.0; 11 * 25];
    for (voxel, value) in values.iter_mut().enumerate() {
        let [i, j, k] = [voxel % 11, voxel / 11 % 5, voxel / 55];
        let hole = [i, j, k] == [2, 2, 2];
        if !hole && (i < 5 || (6..10).contains(&i)) {
            *value = 100.0;
        }
    }
    values
}

fn done(edits: &[VolumeEdit]) -> Vec<f32> {
    edited(&blocks(), &frame(), edits, 50.0).unwrap()
}

fn above(values: &[f32]) -> usize {
    values.iter().filter(|v| **v > 50.0).count()
}

fn at(i: f64) -> Point3 {
    frame().position(Point3::new(i, 2.0, 2.0))
}

#[test]
fn the_largest_component_or_that_at_a_place_is_kept() {
    assert_eq!(above(&blocks()), 124 + 100);
    assert_eq!(above(&done(&[VolumeEdit::LargestComponent])), 124);
    assert_eq!(above(&done(&[VolumeEdit::ComponentAt(at(8.0))])), 100);
    // A click beside it means the nearest.
    assert_eq!(above(&done(&[VolumeEdit::ComponentAt(at(30.0))])), 100);
}

#[test]
fn planes_and_spheres_take_away_by_position() {
    let cut = VolumeEdit::CutPlane {
        point: at(7.5),
        normal: Vector3::new(0.2, 0.0, 0.0),
    };
    assert_eq!(above(&done(&[cut])), 124 + 50);
    let other_side = VolumeEdit::CutPlane {
        point: at(7.5),
        normal: -Vector3::x(),
    };
    assert_eq!(above(&done(&[other_side])), 50);
    let sphere = VolumeEdit::SphereEraser {
        centre: at(8.0),
        radius_mm: 2.0,
    };
    assert_eq!(above(&done(&[sphere])), 124 + 93);
    let nothing = VolumeEdit::SphereEraser {
        centre: at(8.2),
        radius_mm: 0.0,
    };
    assert_eq!(done(&[nothing]), blocks());
}

#[test]
fn a_hole_is_filled_with_the_mirror_image_of_its_values() {
    let filled = done(&[VolumeEdit::FillHoles]);
    assert_eq!(above(&filled), 125 + 100);
    assert_eq!(filled[2 + 11 * (2 + 5 * 2)], 90.0);
}

#[test]
fn later_edits_see_what_earlier_ones_left() {
    let erase = VolumeEdit::SphereEraser {
        centre: at(2.0),
        radius_mm: 100.0,
    };
    assert_eq!(above(&done(&[erase, VolumeEdit::LargestComponent])), 0);
    let half = VolumeEdit::CutPlane {
        point: at(2.5),
        normal: -Vector3::x(),
    };
    // Two of five layers are left of the first block: the second is the larger one now.
    let kept = done(&[half, VolumeEdit::LargestComponent]);
    assert_eq!(above(&kept), 100);
    // A hole that a cut opens is none.
    let opened = done(&[half, VolumeEdit::FillHoles]);
    assert_eq!(above(&opened), 50 + 100);
}

#[test]
fn what_is_taken_away_lies_below_the_threshold_and_what_is_filled_above() {
    for threshold in [-5.0, 0.0, 10.0, 99.9] {
        let erase = VolumeEdit::SphereEraser {
            centre: at(5.0),
            radius_mm: 100.0,
        };
        let gone = edited(&blocks(), &frame(), &[erase], threshold).unwrap();
        assert!(
            gone.iter().all(|v| f64::from(*v) < threshold),
            "{threshold}"
        );
        let mut values = blocks();
        values[2 + 11 * (2 + 5 * 2)] = f32::NAN;
        let filled = edited(&values, &frame(), &[VolumeEdit::FillHoles], threshold).unwrap();
        let hole = filled[2 + 11 * (2 + 5 * 2)];
        assert!(f64::from(hole) > threshold, "{threshold}: {hole}");
    }
}

#[test]
fn edits_that_say_no_place_are_refused_by_their_number() {
    let with = |edit| edited(&blocks(), &frame(), &[VolumeEdit::FillHoles, edit], 50.0);
    let point = at(1.0);
    let normal = Vector3::zeros();
    assert_eq!(
        with(VolumeEdit::CutPlane { point, normal }),
        Err(VolumeEditError::NoNormal { number: 2 })
    );
    let nowhere = Point3::new(f64::NAN, 0.0, 0.0);
    assert_eq!(
        with(VolumeEdit::ComponentAt(nowhere)),
        Err(VolumeEditError::NotFinite { number: 2 })
    );
    let centre = point;
    for (radius_mm, error) in [
        (
            -1.0,
            VolumeEditError::Radius {
                number: 2,
                radius_mm: -1.0,
            },
        ),
        (f64::INFINITY, VolumeEditError::NotFinite { number: 2 }),
    ] {
        assert_eq!(
            with(VolumeEdit::SphereEraser { centre, radius_mm }),
            Err(error)
        );
    }
    assert_eq!(
        edited(&blocks(), &frame(), &[], f64::NAN),
        Err(VolumeEditError::Threshold)
    );
    assert_eq!(
        edited(&[1.0], &frame(), &[], 0.5),
        Err(VolumeEditError::Count {
            values: 1,
            voxels: 275
        })
    );
}

#[test]
fn an_edit_is_stored_with_plain_numbers() {
    let edits = vec![
        VolumeEdit::CutPlane {
            point: Point3::new(1.0, 2.0, 3.0),
            normal: Vector3::new(0.0, 0.1, -1.0),
        },
        VolumeEdit::SphereEraser {
            centre: Point3::new(-1.0, 0.5, 0.0),
            radius_mm: 12.5,
        },
        VolumeEdit::LargestComponent,
        VolumeEdit::ComponentAt(Point3::new(4.0, 5.0, 6.0)),
        VolumeEdit::FillHoles,
    ];
    let text = serde_json::to_string(&edits).unwrap();
    assert!(text.contains(r#"{"sphere_eraser":{"centre":[-1.0,0.5,0.0],"radius_mm":12.5}}"#));
    assert_eq!(
        serde_json::from_str::<Vec<VolumeEdit>>(&text).unwrap(),
        edits
    );
}

proptest! {
    #[test]
    fn numbers_of_any_kind_never_panic(
        values in prop::collection::vec(prop::num::f32::ANY, 275),
        numbers in prop::array::uniform4(prop::num::f64::ANY),
        threshold in prop::num::f64::ANY,
    ) {
        let [x, y, z, w] = numbers;
        let point = Point3::new(x, y, z);
        for edit in [
            VolumeEdit::CutPlane { point, normal: Vector3::new(w, x, y) },
            VolumeEdit::SphereEraser { centre: point, radius_mm: w },
            VolumeEdit::LargestComponent,
            VolumeEdit::ComponentAt(point),
            VolumeEdit::FillHoles,
        ] {
            if let Ok(values) = edited(&values, &frame(), &[edit], threshold) {
                prop_assert_eq!(values.len(), 275);
            }
        }
    }
}
