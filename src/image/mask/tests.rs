//! What belongs to a mask, and what does not.

use proptest::prelude::*;

use super::*;
use crate::mesh::Vector3;

/// A mask of one slice, from rows of `#` and others.
fn slice(rows: &[&str]) -> Mask {
    let inside: Vec<bool> = rows.concat().chars().map(|c| c == '#').collect();
    Mask::new([rows[0].len(), rows.len(), 1], inside).unwrap()
}

fn rows(mask: &Mask) -> Vec<String> {
    let text = |row: &[bool]| row.iter().map(|&x| if x { '#' } else { '.' }).collect();
    mask.inside().chunks(mask.size()[0]).map(text).collect()
}

#[test]
fn labels_are_whole_numbers_and_padding_is_none() {
    let values = [
        0.0,
        1.0,
        2.0,
        3.0,
        2.5,
        f32::NAN,
        2.000_000_2,
        f32::INFINITY,
    ];
    let mask = Mask::of_labels([8, 1, 1], &values, &[2, 3]).unwrap();
    let expected = [false, false, true, true, false, false, true, false];
    assert_eq!(mask.inside(), expected);
    assert_eq!(Mask::of_labels([8, 1, 1], &values, &[]).unwrap().count(), 0);
    let above = Mask::above([8, 1, 1], &values, 2.0).unwrap();
    assert_eq!(above.count(), 4);
}

#[test]
fn counts_that_differ_are_refused() {
    assert_eq!(
        Mask::new([2, 2, 2], vec![true; 7]).unwrap_err().to_string(),
        "7 values for 8 voxels"
    );
    assert!(Mask::of_labels([usize::MAX, 2, 1], &[], &[1]).is_err());
    assert_eq!(
        Mask::new([0, 3, 1], Vec::new())
            .unwrap()
            .largest_component()
            .count(),
        0
    );
}

#[test]
fn the_largest_component_is_kept_and_corners_connect_nothing() {
    let mask = slice(&["##..#", "##..#", "..#..", "....#"]);
    assert_eq!(mask.component_sizes(), [4, 2, 1, 1]);
    assert_eq!(
        rows(&mask.largest_component()),
        ["##...", "##...", ".....", "....."]
    );
    assert_eq!(
        rows(&mask.component_at([4, 0, 0])),
        ["....#", "....#", ".....", "....."]
    );
    assert_eq!(mask.component_at([2, 0, 0]).count(), 0);
    assert_eq!(mask.component_at([9, 0, 0]).count(), 0);
    // Of equal ones the first.
    let pair = slice(&["#.#"]);
    assert_eq!(rows(&pair.largest_component()), ["#.."]);
}

#[test]
fn holes_are_what_no_way_leads_out_of() {
    let ring = slice(&[".....", ".###.", ".#.#.", ".###.", "....."]);
    let filled = [".....", ".###.", ".###.", ".###.", "....."];
    assert_eq!(rows(&ring.holes_filled_in_slices(2)), filled);
    // Through its only slice every hole leads out of the grid.
    assert_eq!(ring.holes_filled(), ring);
    assert_eq!(ring.holes_filled_in_slices(7), ring);
    let mut shell = vec![true; 125];
    shell[62] = false;
    let shell = Mask::new([5, 5, 5], shell).unwrap();
    assert_eq!(shell.holes_filled().count(), 125);
}

#[test]
fn a_volume_counts_voxels_wherever_and_however_they_stand() {
    let steps = [
        Vector3::new(0.0, 2.0, 0.0),
        Vector3::new(1.5, 0.0, 0.0),
        Vector3::new(0.0, 0.0, 10.0),
    ];
    let frame = VolumeFrame::new([3, 2, 1], Point3::new(5.0, 6.0, 7.0), steps).unwrap();
    let mask = Mask::new([3, 2, 1], vec![false, true, false, false, false, true]).unwrap();
    assert!((mask.volume_ml(&frame) - 0.06).abs() < 1e-15);
    assert_eq!(
        mask.positions(&frame),
        [Point3::new(5.0, 8.0, 7.0), Point3::new(6.5, 10.0, 7.0)]
    );
    assert_eq!(mask.values(), [0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
}

proptest! {
    #[test]
    fn filling_and_choosing_twice_changes_nothing_more(inside in prop::collection::vec(any::<bool>(), 4 * 5 * 6)) {
        let mask = Mask::new([4, 5, 6], inside).unwrap();
        let filled = mask.holes_filled();
        prop_assert_eq!(&filled.holes_filled(), &filled);
        prop_assert!(mask.inside().iter().zip(filled.inside()).all(|(a, b)| !a || *b));
        let largest = mask.largest_component();
        prop_assert_eq!(&largest.largest_component(), &largest);
        prop_assert_eq!(largest.count(), mask.component_sizes().into_iter().max().unwrap_or(0));
        prop_assert_eq!(mask.component_sizes().iter().sum::<usize>(), mask.count());
    }
}
