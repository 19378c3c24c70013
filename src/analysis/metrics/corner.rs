//! The formulas at sides and corners of a face, for one number or for several side by side.

use std::f64::consts::PI;

use crate::numeric::{Arithmetic, Lanes, three};

/// One entry per axis.
pub(super) type Axes<T> = [T; 3];

#[inline(always)]
pub(super) fn dot<T: Arithmetic>(a: Axes<T>, b: Axes<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
pub(super) fn minus<T: Arithmetic>(a: Axes<T>, b: Axes<T>) -> Axes<T> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Relative rates of length ⟨w, d⟩ / |d|², w = d_B − d_A, of a side d at A and at B; `inverse` are 1 / |d|².
#[inline(always)]
pub(super) fn stretch<T: Arithmetic>(a: Axes<T>, b: Axes<T>, inverse: [T; 2]) -> [T; 2] {
    let w = minus(b, a);
    [dot(w, a) * inverse[0], dot(w, b) * inverse[1]]
}

/// Terms of eq. 3.3 at the corners a, b, c, over |pq|²|pr|², from the rates of the sides ab, bc, ca.
#[inline(always)]
pub(super) fn corner_terms<T: Arithmetic>(s: [T; 3]) -> [T; 3] {
    [s[0] - s[2], s[1] - s[0], s[2] - s[1]]
}

/// |pq|²|pr|² at the corners a, b, c from the squared lengths of the sides ab, bc, ca.
#[inline(always)]
pub(super) fn raw_units<T: Arithmetic>(l: [T; 3]) -> [T; 3] {
    [l[0] * l[2], l[1] * l[0], l[2] * l[1]]
}

#[inline(always)]
pub(super) fn times<T: Arithmetic>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// Energy of a face from its terms: (Σ_c |T_c|)² where printed, else Σ_c T_c².
#[inline(always)]
pub(super) fn energy<T: Arithmetic>(t: [T; 3], printed: bool) -> T {
    if printed {
        let sum = t[0].abs() + t[1].abs() + t[2].abs();
        sum * sum
    } else {
        dot(t, t)
    }
}

/// Derivative of [`energy`] along each term; where printed, the subgradient that is 0 at 0.
#[inline(always)]
pub(super) fn energy_gradient<T: Arithmetic>(t: [T; 3], printed: bool) -> [T; 3] {
    let two = T::splat(2.0);
    if printed {
        let sum = two * (t[0].abs() + t[1].abs() + t[2].abs());
        three(|c| sum * t[c].sign())
    } else {
        three(|c| two * t[c])
    }
}

/// Twice the area of a face abc and the products of the two sides at each of its corners.
#[inline(always)]
pub(super) fn face_shape<T: Arithmetic>(a: Axes<T>, b: Axes<T>, c: Axes<T>) -> (T, [T; 3]) {
    let (ab, bc, ca) = (minus(b, a), minus(c, b), minus(a, c));
    let normal = [
        ab[1] * bc[2] - ab[2] * bc[1],
        ab[2] * bc[0] - ab[0] * bc[2],
        ab[0] * bc[1] - ab[1] * bc[0],
    ];
    // Cosines times lengths: with the doubled area they give angles without a division.
    let products = [-dot(ab, ca), -dot(ab, bc), -dot(bc, ca)];
    (dot(normal, normal).sqrt(), products)
}

/// Cotangents of the angles at the corners; zero in a face of zero area.
#[inline(always)]
pub(super) fn cotangents<T: Arithmetic>((doubled_area, products): (T, [T; 3])) -> [T; 3] {
    three(|c| products[c].over(doubled_area))
}

/// Angles at the corners, in radians; the third is π less the two others.
#[inline(always)]
pub(super) fn angles_rad((doubled_area, products): (Lanes, [Lanes; 3])) -> [Lanes; 3] {
    let half_turn = Lanes::splat(PI);
    let first = Lanes::angle_rad(doubled_area, products[0]);
    let second = Lanes::angle_rad(doubled_area, products[1]);
    // An arc tangent saved: angles of a triangle add up to half a turn.
    let rest = half_turn - first - second;
    // Without area the angles need not add up: coincident corners have none.
    let third = |lane: usize| {
        if doubled_area.0[lane] > 0.0 {
            rest.0[lane]
        } else if products[2].0[lane] < 0.0 {
            PI
        } else {
            0.0
        }
    };
    [
        first,
        second,
        Lanes([third(0), third(1), third(2), third(3)]),
    ]
}

/// Derivative along the relative lengths of the sides ab, bc, ca of Σ_c g_c θ_c, θ the angles at a, b, c.
///
/// By the law of cosines dθ_a = cot c (s₁ − s₂) + cot b (s₁ − s₀) with s the rates of relative length.
#[inline(always)]
pub(super) fn angle_gradient<T: Arithmetic>(cotangents: [T; 3], g: [T; 3]) -> [T; 3] {
    three(|e| {
        let (next, across) = ((e + 1) % 3, (e + 2) % 3);
        cotangents[e] * (g[across] - g[next]) + cotangents[next] * (g[across] - g[e])
    })
}

/// K of a neighbourhood from its gathered angle deficits and areas, against a sphere of the whole area.
#[inline(always)]
pub(super) fn density<T: Arithmetic>(turn: T, area: T, total_area: T) -> T {
    turn.over(area) * total_area * T::splat(1.0 / (4.0 * PI))
}
