//! Slices of other breath-holds.

use crate::analysis::walls_from_masks::{WallParams, walls_from_masks};
use crate::progress::Progress;

use super::phantom::{Phantom, walls};

fn with_shifts(shifts: &[(usize, [f64; 2])]) -> Phantom {
    let mut phantom = Phantom {
        shifts: vec![[0.0; 2]; 12],
        ..Phantom::default()
    };
    for &(slice, shift) in shifts {
        phantom.shifts[slice] = shift;
    }
    phantom
}

#[test]
fn shifts_are_found_reported_and_taken_back() {
    let put_in = [(2, [6.0, -4.0]), (5, [-5.0, 5.0]), (6, [-5.0, 5.0])];
    let phantom = with_shifts(&put_in);
    let straight = walls(&Phantom::default().masks());
    let shifted = walls(&phantom.masks());
    let numbers: Vec<usize> = shifted.shifts.iter().map(|shift| shift.slice).collect();
    assert_eq!(numbers, [3, 6, 7]);
    for (found, (_, [x, y])) in shifted.shifts.iter().zip(put_in) {
        let base = phantom.own(phantom.frame().origin());
        let own = phantom.own(phantom.frame().origin() + found.shift_mm) - base;
        assert!((own.x - x).hypot(own.y - y) < 1.0, "{own:?} for {x}, {y}");
        assert!(own.z.abs() < 1e-9);
    }
    let notes = shifted
        .notices
        .iter()
        .filter(|n| n.text.contains("another breath-hold"));
    assert_eq!(notes.count(), 3);
    for (a, b) in straight.fits.iter().zip(&shifted.fits) {
        assert!(
            (a.volume_ml / b.volume_ml - 1.0).abs() < 0.01,
            "{a:?} {b:?}"
        );
        assert!(b.mean_mm < 0.5, "{b:?}");
    }
    for (a, b) in straight
        .sequence
        .surfaces()
        .iter()
        .zip(shifted.sequence.surfaces())
    {
        for (a, b) in a.frames().iter().zip(b.frames()) {
            let off = a
                .vertices()
                .iter()
                .zip(b.vertices())
                .map(|(a, b)| (a - b).norm());
            assert!(off.sum::<f64>() / (a.vertices().len() as f64) < 0.7);
        }
    }
}

#[test]
fn half_a_stack_in_another_breath_hold_is_moved_as_one() {
    let lower: Vec<(usize, [f64; 2])> = (6..12).map(|slice| (slice, [9.0, 4.0])).collect();
    let walls = walls(&with_shifts(&lower).masks());
    assert!(walls.shifts.len() >= 3, "{:?}", walls.shifts);
    let first = walls.shifts[0].shift_mm;
    for shift in &walls.shifts {
        assert!((shift.shift_mm - first).norm() < 1e-9);
        assert!((shift.shift_mm.norm() - 9.85).abs() < 2.5, "{shift:?}");
    }
}

#[test]
fn shifts_stay_where_they_are_to_stay() {
    let params = WallParams {
        correct_shifts: false,
        ..WallParams::default()
    };
    let masks = with_shifts(&[(4, [8.0, 0.0])]).masks();
    let walls = walls_from_masks(&masks, &params.check().unwrap(), &Progress::default()).unwrap();
    assert!(walls.shifts.is_empty());
}
