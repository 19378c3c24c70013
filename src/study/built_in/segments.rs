//! The 17 segments of the American Heart Association on the model's own coordinates.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, TAU};

/// Segment 1–17 of a place on the wall.
///
/// Basal, mid and apical thirds reach from the base to the tip of the cavity, whose cap is 17;
/// basal and mid thirds have six segments of 60°, the apical one four of 90°. `around_rad`
/// counts from the middle of the septum towards the anterior wall; `height_share` from the
/// tip of the cavity (0) to the base (1).
///
/// Source: Cerqueira et al. (2002), Circulation 105(4), 539–542. The share of the cap, 0.06 of
/// the cavity, is ours: the standard says "beyond the end of the cavity".
pub(super) fn aha_segment(height_share: f64, around_rad: f64) -> u8 {
    const CAP_SHARE: f64 = 0.06;
    if height_share < CAP_SHARE {
        return 17;
    }
    // Sectors of a third in their order from the septal insertion of the anterior wall:
    // anterior, anteroseptal, inferoseptal, inferior, inferolateral, anterolateral.
    let from_anterior = FRAC_PI_2 - around_rad;
    if height_share < 1.0 / 3.0 {
        13 + sector(from_anterior, FRAC_PI_2, 4)
    } else if height_share < 2.0 / 3.0 {
        7 + sector(from_anterior, FRAC_PI_3, 6)
    } else {
        1 + sector(from_anterior, FRAC_PI_3, 6)
    }
}

/// Index of the sector of `width` around multiples of it.
fn sector(angle: f64, width: f64, count: u8) -> u8 {
    let turned = (angle + 0.5 * width).rem_euclid(TAU);
    ((turned / width) as u8).min(count - 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_lie_where_the_standard_draws_them() {
        let degrees = |angle: f64| angle.to_radians();
        // (height share, degrees from the septum towards the anterior wall, segment)
        for (height, angle, segment) in [
            (0.9, 90.0, 1),
            (0.9, 30.0, 2),
            (0.9, -30.0, 3),
            (0.9, -90.0, 4),
            (0.9, 210.0, 5),
            (0.9, 150.0, 6),
            (0.5, 90.0, 7),
            (0.5, 150.0, 12),
            (0.2, 90.0, 13),
            (0.2, 0.0, 14),
            (0.2, 270.0, 15),
            (0.2, 180.0, 16),
            (0.0, 77.0, 17),
        ] {
            assert_eq!(aha_segment(height, degrees(angle)), segment);
        }
    }
}
