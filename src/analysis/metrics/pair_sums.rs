//! Passes over edges, faces and vertices for a pair of poses; the hot path of every matrix.

use nalgebra::Matrix3;

use crate::mesh::Vector3;

use super::connectivity::Connectivity;
use super::corner::{corner_terms, energy, stretch};
use super::face_energy::of_corners;
use super::metric::Metric;
use super::params::{Corners, Form, Regulariser};
use super::pose::PreparedPose;

/// Values at pose A and at pose B.
pub(super) type Both = [f64; 2];

/// Sums run in as many lanes, so that additions need not wait for each other.
const LANES: usize = 4;

/// ⟨w, d_A⟩ / |d_A|² and ⟨w, R d_B⟩ / |d_B|² with w = R d_B − d_A, for the vectors d of each edge.
pub(super) fn stretches(
    a: &PreparedPose,
    b: &PreparedPose,
    rotation: &Matrix3<f64>,
    out: &mut Vec<Both>,
) {
    let count = a.inverse_length2.len();
    // The memory of the pair before is used again: a matrix allocates nothing per pair.
    out.resize(count, [0.0; 2]);
    let r: [[f64; 3]; 3] = [0, 1, 2].map(|row| [0, 1, 2].map(|column| rotation[(row, column)]));
    // Equal lengths that the compiler can see let it drop the checks and use vector instructions.
    let [ax, ay, az] = a.edge_axes.each_ref().map(|axis| &axis[..count]);
    let [bx, by, bz] = b.edge_axes.each_ref().map(|axis| &axis[..count]);
    let (over_a, over_b) = (&a.inverse_length2[..count], &b.inverse_length2[..count]);
    for (e, both) in out.iter_mut().enumerate() {
        let x = r[0][0] * bx[e] + r[0][1] * by[e] + r[0][2] * bz[e];
        let y = r[1][0] * bx[e] + r[1][1] * by[e] + r[1][2] * bz[e];
        let z = r[2][0] * bx[e] + r[2][1] * by[e] + r[2][2] * bz[e];
        let before = [ax[e], ay[e], az[e]];
        *both = stretch(before, [x, y, z], [over_a[e], over_b[e]]);
    }
}

/// Σ_f a_f of the energies of corners; `change`, one per vertex, multiplies their terms.
pub(super) fn angles(
    metric: &Metric,
    a: &PreparedPose,
    b: &PreparedPose,
    stretch: &[Both],
    change: Option<&[f64]>,
) -> Both {
    let mesh = &metric.mesh;
    let printed = metric.params.form == Form::Printed;
    match (metric.params.corners, change, printed) {
        // The default has a loop of its own, without options inside, since matrices of poses spend their time here.
        (Corners::ScaleFree, None, false) => plain_angles(mesh, a, b, stretch),
        _ => general_angles(metric, a, b, stretch, change, printed),
    }
}

/// Σ_f a_f Σ_c t_c², the default: t are the differences of the stretches of a face's sides.
fn plain_angles(mesh: &Connectivity, a: &PreparedPose, b: &PreparedPose, stretch: &[Both]) -> Both {
    let face = |edges: &[u32; 3], weight: Both| -> Both {
        let s = edges.map(|e| stretch[e as usize]);
        [0, 1].map(|side| weight[side] * energy(corner_terms(s.map(|both| both[side])), false))
    };
    let (faces, last_faces) = mesh.face_edges.as_chunks::<LANES>();
    let (of_a, last_of_a) = a.face_weight.as_chunks::<LANES>();
    let (of_b, last_of_b) = b.face_weight.as_chunks::<LANES>();
    // Several sums side by side: additions need not wait for each other.
    let mut sums = [[0.0; 2]; LANES];
    for (faces, (of_a, of_b)) in faces.iter().zip(of_a.iter().zip(of_b)) {
        for lane in 0..LANES {
            let term = face(&faces[lane], [of_a[lane], of_b[lane]]);
            sums[lane][0] += term[0];
            sums[lane][1] += term[1];
        }
    }
    for (edges, (&of_a, &of_b)) in last_faces.iter().zip(last_of_a.iter().zip(last_of_b)) {
        let term = face(edges, [of_a, of_b]);
        sums[0][0] += term[0];
        sums[0][1] += term[1];
    }
    total(sums)
}

/// The same with raw corners, curvature change as a factor, or absolute values.
fn general_angles(
    metric: &Metric,
    a: &PreparedPose,
    b: &PreparedPose,
    stretch: &[Both],
    change: Option<&[f64]>,
    printed: bool,
) -> Both {
    let raw = metric.params.corners == Corners::Raw;
    let mut sums = [0.0; 2];
    let faces = metric.mesh.face_edges.iter().zip(&metric.mesh.triangles);
    for ((edges, triangle), (wa, wb)) in faces.zip(a.face_weight.iter().zip(&b.face_weight)) {
        let s = edges.map(|e| stretch[e as usize]);
        let factor = change.map_or([1.0; 3], |change| triangle.map(|v| change[v as usize]));
        for (side, (pose, weight)) in [(a, wa), (b, wb)].into_iter().enumerate() {
            let l = raw.then(|| edges.map(|e| pose.length2[e as usize]));
            let s = s.map(|both| both[side]);
            sums[side] += weight * of_corners(s, l, Some(factor), printed).energy;
        }
    }
    sums
}

/// Σ_p a_p (K_p(B) − K_p(A))² with the weights of A and of B.
pub(super) fn curvature(metric: &Metric, a: &PreparedPose, b: &PreparedPose) -> Both {
    let count = a.curvature.len();
    let (ka, kb) = (&a.curvature[..count], &b.curvature[..count]);
    weighted_sums(a, b, metric.params.area_weights, |v| {
        (kb[v] - ka[v]) * (kb[v] - ka[v])
    })
}

/// λ Σ_p a_p |X_p|² with the weights of A and of B.
pub(super) fn regulariser(
    metric: &Metric,
    a: &PreparedPose,
    b: &PreparedPose,
    rotation: &Matrix3<f64>,
    translation: &Vector3,
) -> Both {
    // The term is off: a pass over all vertices is saved.
    if metric.params.lambda == 0.0 {
        return [0.0; 2];
    }
    let count = metric.mesh.vertex_count;
    let r: [[f64; 3]; 3] = [0, 1, 2].map(|row| [0, 1, 2].map(|column| rotation[(row, column)]));
    let shift = [translation.x, translation.y, translation.z];
    let [ax, ay, az] = a.axes.each_ref().map(|axis| &axis[..count]);
    let [bx, by, bz] = b.axes.each_ref().map(|axis| &axis[..count]);
    let by_area = metric.params.regulariser == Regulariser::Area;
    let sums = weighted_sums(a, b, by_area, |v| {
        let x = r[0][0] * bx[v] + r[0][1] * by[v] + r[0][2] * bz[v] + shift[0] - ax[v];
        let y = r[1][0] * bx[v] + r[1][1] * by[v] + r[1][2] * bz[v] + shift[1] - ay[v];
        let z = r[2][0] * bx[v] + r[2][1] * by[v] + r[2][2] * bz[v] + shift[2] - az[v];
        x * x + y * y + z * z
    });
    [
        a.regulariser_factor * sums[0],
        b.regulariser_factor * sums[1],
    ]
}

/// Σ_p w_p term(p) with the shares of area at A and at B, or with w = 1.
fn weighted_sums(
    a: &PreparedPose,
    b: &PreparedPose,
    by_area: bool,
    term: impl Fn(usize) -> f64,
) -> Both {
    let count = a.vertex_share.len();
    let (wa, wb) = (&a.vertex_share[..count], &b.vertex_share[..count]);
    let mut sums = [[0.0; LANES]; 2];
    // The rest is added to the first lane, in a fixed order.
    let whole = count - count % LANES;
    let mut add = |lane: usize, v: usize| {
        let value = term(v);
        sums[0][lane] += if by_area { wa[v] } else { 1.0 } * value;
        sums[1][lane] += if by_area { wb[v] } else { 1.0 } * value;
    };
    for start in (0..whole).step_by(LANES) {
        for lane in 0..LANES {
            add(lane, start + lane);
        }
    }
    for v in whole..count {
        add(0, v);
    }
    sums.map(|lanes| lanes.iter().sum())
}

fn total(lanes: [Both; LANES]) -> Both {
    [0, 1].map(|side| lanes.iter().map(|lane| lane[side]).sum())
}
