//! Sectors of the bull's-eye in the unit disc, x to the right and y up.

use crate::analysis::segments::{Level, Segment, ring};

/// Angle between corners of drawn arcs: within half a pixel up to a radius of 200, within two up to 1,000.
const ARC_STEP_RAD: f64 = 0.06;

/// Ink for numbers on a colour: dark on light ones, light on dark ones.
pub fn ink_on([red, green, blue]: [u8; 3]) -> [u8; 3] {
    let light = 0.299 * f32::from(red) + 0.587 * f32::from(green) + 0.114 * f32::from(blue);
    if light > 140.0 {
        [0x16, 0x18, 0x1c]
    } else {
        [0xf4, 0xf6, 0xf8]
    }
}

fn edges(segment: Segment) -> [f64; 2] {
    let [middle, half] = segment.sector_rad();
    [middle - half, middle + half]
}

fn arc([from, to]: [f64; 2], radius: f64) -> impl Iterator<Item = [f64; 2]> {
    let steps = ((to - from).abs() / ARC_STEP_RAD).ceil().max(1.0) as usize;
    (0..=steps).map(move |step| {
        let (sin, cos) = (from + (to - from) * step as f64 / steps as f64).sin_cos();
        [radius * cos, radius * sin]
    })
}

/// Pairs of points on the inner and the outer arc of a segment, along it.
pub fn sector_strip(segment: Segment) -> Vec<[[f64; 2]; 2]> {
    let [inner, outer] = ring(segment.level());
    let edges = edges(segment);
    let pairs = arc(edges, inner).zip(arc(edges, outer));
    pairs.map(|(near, far)| [near, far]).collect()
}

/// Around a segment.
pub fn sector_outline(segment: Segment) -> Vec<[f64; 2]> {
    let [inner, outer] = ring(segment.level());
    let [from, to] = edges(segment);
    let mut points: Vec<[f64; 2]> = arc([from, to], outer).collect();
    if inner > 0.0 {
        points.extend(arc([to, from], inner));
    }
    points
}

/// The line at which a segment begins, from its inner to its outer arc; the apex has none.
pub fn sector_line(segment: Segment) -> Option<[[f64; 2]; 2]> {
    if segment.level() == Level::Apex {
        return None;
    }
    let (sin, cos) = edges(segment)[0].sin_cos();
    Some(ring(segment.level()).map(|radius| [radius * cos, radius * sin]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::segments::segment_on_plot;

    fn area(points: &[[f64; 2]]) -> f64 {
        let next = points.iter().cycle().skip(1);
        let sum: f64 = (points.iter().zip(next))
            .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
            .sum();
        0.5 * sum.abs()
    }

    #[test]
    fn the_sectors_fill_the_disc() {
        let whole: f64 = Segment::all().map(|s| area(&sector_outline(s))).sum();
        assert!((whole - std::f64::consts::PI).abs() < 0.01, "{whole}");
        for segment in Segment::all() {
            let strip = sector_strip(segment);
            let [near, far] = strip[strip.len() / 2];
            let middle = [0.5 * (near[0] + far[0]), 0.5 * (near[1] + far[1])];
            assert_eq!(segment_on_plot(middle), Some(segment));
        }
    }

    #[test]
    fn ink_is_dark_on_light_and_light_on_dark() {
        assert_eq!(ink_on([255; 3]), [0x16, 0x18, 0x1c]);
        assert_eq!(ink_on([0x2b, 0x6c, 0xb0]), [0xf4, 0xf6, 0xf8]);
    }
}
