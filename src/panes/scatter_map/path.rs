//! Paths of a map: the points of one subject, or of one of its patches, in order of frames.

use std::ops::Range;

use super::point::ScatterPoint;

/// Where each path lies in the list of points.
pub fn paths(points: &[ScatterPoint]) -> impl Iterator<Item = Range<usize>> {
    let mut end = 0;
    points.chunk_by(ScatterPoint::shares_path).map(move |path| {
        end += path.len();
        end - path.len()..end
    })
}

/// Where a subject is between two frames, on each of its paths: on the straight line between their
/// points, and nowhere where a path lacks one that is needed.
pub fn places_between(
    points: &[ScatterPoint],
    subject: usize,
    [from, to]: [usize; 2],
    share: f64,
) -> Vec<[f64; 2]> {
    let place = |path: &[ScatterPoint], frame: usize| {
        let mut path = path.iter();
        let point = path.find(|point| point.frames.is_some_and(|[first, _]| first == frame));
        point.map(|point| point.at)
    };
    let between = |path: Range<usize>| {
        let path = &points[path];
        let start = place(path, from)?;
        if share <= 0.0 {
            return Some(start);
        }
        let end = place(path, to)?;
        Some([0, 1].map(|axis| start[axis] + share * (end[axis] - start[axis])))
    };
    paths(points)
        .filter(|path| points[path.start].subject == subject)
        .filter_map(between)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(subject: usize, patch: Option<usize>, frame: usize, x: f64) -> ScatterPoint {
        ScatterPoint {
            subject,
            patch,
            frames: Some([frame, frame + 1]),
            at: [x, 0.0],
            ..ScatterPoint::default()
        }
    }

    #[test]
    fn a_position_lies_on_every_path_that_has_the_frames_around_it() {
        let points = [
            point(0, None, 0, 9.0),
            point(1, Some(0), 0, 0.0),
            point(1, Some(0), 1, 4.0),
            point(1, Some(1), 0, 7.0),
            point(1, Some(1), 2, 8.0),
        ];
        let starts: Vec<usize> = paths(&points).map(|path| path.start).collect();
        assert_eq!(starts, [0, 1, 3]);
        assert_eq!(places_between(&points, 1, [0, 1], 0.25), [[1.0, 0.0]]);
        assert_eq!(
            places_between(&points, 1, [0, 1], 0.0),
            [[0.0, 0.0], [7.0, 0.0]]
        );
        assert!(places_between(&points, 2, [0, 1], 0.0).is_empty());
    }
}
