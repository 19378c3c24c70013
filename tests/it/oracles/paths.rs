//! Cheapest paths against SciPy's L-BFGS-B on gradients by JAX.

use cardiomorph::analysis::geodesics::{GeodesicParams, GeodesicPath, geodesic};
use cardiomorph::analysis::metrics::Regulariser;

use super::*;

fn pose(case: &Case, end: &str) -> (Vec<Point3>, Faces) {
    let file = case.value["inputs"][end]["obj"].as_str().unwrap();
    mesh_of(&case.folder.join(file))
}

/// The sums of the text with a uniform regulariser, as the peer has them.
fn params(case: &Case) -> GeodesicParams {
    let stated = &case.value["params"];
    let kind = match stated["metric"].as_str().unwrap() {
        "iso" => MetricKind::Isometric,
        "ap" => MetricKind::AnglePreserving,
        "qc" => MetricKind::QuasiConformal,
        other => panic!("{other}"),
    };
    let form = match stated["form"].as_str().unwrap() {
        "printed" => Form::Printed,
        _ => Form::Bilinear,
    };
    let corners = if stated["normalised"].as_bool().unwrap() {
        Corners::ScaleFree
    } else {
        Corners::Raw
    };
    GeodesicParams {
        metric: MetricParams {
            lambda: stated["lam"].as_f64().unwrap(),
            regulariser: Regulariser::Uniform,
            ..as_printed(kind, form, corners)
        },
        interpolated_poses: stated["k_intermediate"].as_u64().unwrap() as u16,
        tolerance: 1e-6,
        max_iterations: 2_000,
        ..GeodesicParams::default()
    }
}

fn solved(case: &Case) -> GeodesicPath {
    let ((start, faces), (end, _)) = (pose(case, "start"), pose(case, "end"));
    let params = params(case).check().unwrap();
    geodesic(&faces, &start, &end, &params, &Progress::default()).unwrap()
}

fn paths_are_no_dearer(topic: &str, names: &[&str]) {
    for name in names {
        let case = Case::load(topic, name);
        let path = solved(&case);
        println!(
            "{name}: {:.9e} in {} iterations, peer {:.9e}, ratio {:.5}, converged {}",
            path.energy,
            path.iterations,
            case.number("energy_opt"),
            path.energy / case.number("energy_opt"),
            path.converged
        );
        close(name, path.energy_linear, case.number("energy_linear"), 1e-9);
        assert!(
            path.energy >= 0.0 && path.energy <= case.number("energy_bound"),
            "{name}"
        );
        assert_eq!(path.poses.len(), path.step_lengths.len() + 1);
    }
}

#[test]
fn paths_cost_no_more_than_the_peers() {
    paths_are_no_dearer(
        "interp",
        &[
            "iso_ico162_stretch",
            "iso_torus200_bend",
            "ap_norm_ico162_bump",
            "ap_raw_ico162_bump",
            "ap_printed_norm_ico162_bump",
            "qc_norm_ico162_bump",
            "qc_printed_raw_torus200_twist",
            "iso_ico42_rotate",
        ],
    );
}

#[test]
fn paths_with_curvature_change_as_a_factor_cost_no_more_than_the_peers() {
    paths_are_no_dearer(
        "interp_qc",
        &[
            "qc_printed_norm_torus200_twist",
            "qc_norm_ico162_bump_lowreg",
            "iso_ico42_stretch_k1",
        ],
    );
}
