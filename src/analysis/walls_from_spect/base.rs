//! The plane of the valve: where the counts of the wall fall.

use super::borders::median;
use super::rays::{ANGLES, Profiles, Rays};

/// A plane across the axis at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ValvePlane {
    /// Height along the axis.
    pub height: f64,
    /// Whether counts do not fall before the image ends.
    pub at_image_end: bool,
}

/// The plane at which counts of the middle of the wall fall to a share of what is usual, at the median over directions.
pub(super) fn valve_plane(
    rays: &Rays,
    profiles: &Profiles,
    middle: &[f64],
    wall_counts: f64,
    share: f64,
) -> Option<ValvePlane> {
    let level = share * wall_counts;
    let straight: Vec<usize> = (0..rays.rows)
        .filter(|&row| rays.is_straight(row))
        .collect();
    let counts = |row: usize, angle: usize| {
        // A direction with its neighbours: single rays are noisy.
        let near = [ANGLES - 1, 0, 1].map(|by| row * ANGLES + (angle + by) % ANGLES);
        let found = near.map(|ray| profiles.at(ray, middle.get(ray).copied().unwrap_or(0.0)));
        found.iter().sum::<f64>() / 3.0
    };
    let (mut heights, mut ends) = (Vec::new(), 0);
    for angle in 0..ANGLES {
        let mut before: Option<f64> = None;
        let mut found = None;
        for &row in &straight {
            let now = counts(row, angle);
            if !now.is_finite() {
                // The image ends between this row and the one before.
                found = Some((rays.height(row) - 0.5 * rays.row_mm(), true));
                break;
            }
            if now < level && rays.height(row) > rays.height(0) {
                let part = before.map_or(0.5, |b| ((b - level) / (b - now)).clamp(0.0, 1.0));
                found = Some((rays.height(row) - rays.row_mm() * (1.0 - part), false));
                // A defect of perfusion is no valve: counts above it must not rise again.
                let above = straight.iter().filter(|&&other| other > row);
                let risen = above.filter(|&&other| counts(other, angle) > level).count();
                if risen < 2 {
                    break;
                }
            }
            before = Some(now);
        }
        let top = straight
            .last()
            .map(|&row| (rays.height(row) + 0.5 * rays.row_mm(), true));
        let (height, at_end) = found.or(top)?;
        heights.push(height);
        ends += usize::from(at_end);
    }
    Some(ValvePlane {
        height: median(heights)?,
        at_image_end: 2 * ends > ANGLES,
    })
}
