//! Curves in the plane of poses and time, and points at equal steps along them.

/// Points at equal steps of arc length along the chords of a curve, both ends included.
///
/// A curve of no length is `samples` times its first point. Empty where the curve is.
pub fn resampled(curve: &[[f64; 3]], samples: usize) -> Vec<[f64; 3]> {
    let Some(first) = curve.first() else {
        return Vec::new();
    };
    let mut reached = vec![0.0; curve.len()];
    for (i, pair) in curve.windows(2).enumerate() {
        reached[i + 1] = reached[i] + distance(&pair[0], &pair[1]);
    }
    let whole = reached.last().copied().unwrap_or(0.0);
    // A subject that does not move has no direction in which to step.
    if whole <= 0.0 {
        return vec![*first; samples];
    }
    // Both ends are samples: one step fewer than points.
    let steps = samples.saturating_sub(1).max(1) as f64;
    let mut chord = 0;
    (0..samples)
        .map(|sample| {
            let length = whole * sample as f64 / steps;
            // Lengths ascend from sample to sample, so the search never goes back.
            while chord + 2 < curve.len() && reached[chord + 1] < length {
                chord += 1;
            }
            let (start, end) = (reached[chord], reached[chord + 1]);
            // Frames at one place have chords without length.
            let share = if end > start {
                ((length - start) / (end - start)).clamp(0.0, 1.0)
            } else {
                0.0
            };
            let (a, b) = (&curve[chord], &curve[chord + 1]);
            [0, 1, 2].map(|axis| a[axis] + share * (b[axis] - a[axis]))
        })
        .collect()
}

fn distance(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    (a.iter().zip(b).map(|(a, b)| (a - b).powi(2)))
        .sum::<f64>()
        .sqrt()
}
