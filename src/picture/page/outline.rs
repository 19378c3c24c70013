//! Outlines of letters, curve by curve, for whatever draws them: pixels, SVG, a typeface.

use ab_glyph::{OutlineCurve, Point};

/// What takes an outline. Points are those of the typeface, y up.
pub(super) trait OutlineSink {
    /// Begins a closed curve.
    fn move_to(&mut self, to: Point);
    /// A straight line.
    fn line_to(&mut self, to: Point);
    /// A quadratic curve.
    fn quad_to(&mut self, by: Point, to: Point);
    /// A cubic curve, from where the last one ended.
    fn cubic_to(&mut self, from: Point, by: [Point; 2], to: Point);
    /// Ends a closed curve.
    fn close(&mut self);
}

/// Gives a sink the curves of one letter: a curve that does not begin where the last one ended begins another closed one.
pub(super) fn trace(curves: &[OutlineCurve], sink: &mut impl OutlineSink) {
    let mut pen = None;
    for curve in curves {
        let (from, to) = match *curve {
            OutlineCurve::Line(from, to)
            | OutlineCurve::Quad(from, _, to)
            | OutlineCurve::Cubic(from, _, _, to) => (from, to),
        };
        if pen != Some(from) {
            if pen.is_some() {
                sink.close();
            }
            sink.move_to(from);
        }
        match *curve {
            OutlineCurve::Line(..) => sink.line_to(to),
            OutlineCurve::Quad(_, by, _) => sink.quad_to(by, to),
            OutlineCurve::Cubic(_, first, second, _) => sink.cubic_to(from, [first, second], to),
        }
        pen = Some(to);
    }
    if pen.is_some() {
        sink.close();
    }
}
