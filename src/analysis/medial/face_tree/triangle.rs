//! The nearest point of one triangle.

use crate::mesh::Point3;

/// The nearest point of a triangle with the weights of its corners.
///
/// Source: C. Ericson, *Real-Time Collision Detection* (2005), section 5.1.5: by the regions of the corners and sides.
pub(super) fn nearest_on_triangle(point: Point3, [a, b, c]: [Point3; 3]) -> ([f64; 3], Point3) {
    let (ab, ac) = (b - a, c - a);
    let ap = point - a;
    let (d1, d2) = (ab.dot(&ap), ac.dot(&ap));
    // Corners, then sides, then the face: signs say in whose region the point lies, without a root.
    if d1 <= 0.0 && d2 <= 0.0 {
        return ([1.0, 0.0, 0.0], a);
    }
    let bp = point - b;
    let (d3, d4) = (ab.dot(&bp), ac.dot(&bp));
    if d3 >= 0.0 && d4 <= d3 {
        return ([0.0, 1.0, 0.0], b);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let part = d1 / (d1 - d3);
        return ([1.0 - part, part, 0.0], a + part * ab);
    }
    let cp = point - c;
    let (d5, d6) = (ab.dot(&cp), ac.dot(&cp));
    if d6 >= 0.0 && d5 <= d6 {
        return ([0.0, 0.0, 1.0], c);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let part = d2 / (d2 - d6);
        return ([1.0 - part, 0.0, part], a + part * ac);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let part = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return ([0.0, 1.0 - part, part], b + part * (c - b));
    }
    let whole = va + vb + vc;
    let (v, w) = (vb / whole, vc / whole);
    ([1.0 - v - w, v, w], a + v * ab + w * ac)
}
