//! One smooth surface on coarser and finer meshes is at one distance from another.

use super::*;

/// A ventricle-like egg at the phase of contraction `t`: it narrows, shortens, twists, and one side moves less.
fn beating(points: &[Point3], t: f64) -> Vec<Point3> {
    points
        .iter()
        .map(|p| {
            let narrow = 1.0 - 0.25 * t * (1.0 + 0.4 * p.x);
            let (sin, cos) = (0.3 * t * p.z).sin_cos();
            let (x, y) = (0.7 * narrow * p.x, 0.7 * narrow * p.y);
            Point3::new(
                cos * x - sin * y,
                sin * x + cos * y,
                (1.0 - 0.1 * t) * (1.2 + 0.15 * p.x) * p.z,
            )
        })
        .collect()
}

/// Distances of every metric with its weights on meshes of growing fineness.
fn assert_converged(meshes: &[TriMesh; 3], wanted: [usize; 3]) {
    assert_eq!(meshes.each_ref().map(|mesh| mesh.vertices().len()), wanted);
    for kind in METRICS {
        let distance = |mesh: &TriMesh| {
            let [a, b] = [0.0, 1.0].map(|t| beating(mesh.vertices(), t));
            norms(mesh.faces(), MetricParams::of(kind), &a, &b).distance()
        };
        let [coarse, middle, fine] = meshes.each_ref().map(distance);
        for distance in [coarse, middle] {
            assert!(near(distance, fine, 0.05), "{kind:?}: {distance} {fine}");
        }
    }
}

#[test]
fn distances_of_one_closed_surface_are_the_same_on_any_mesh() {
    let spheres = [3, 4, 5].map(|level| phantom::sphere(level, 1.0));
    assert_converged(&spheres, [642, 2_562, 10_242]);
}

#[test]
fn distances_of_one_open_surface_are_the_same_on_any_mesh() {
    let bowls =
        [(16, 40), (32, 80), (64, 160)].map(|(rings, around)| phantom::bowl(1.0, rings, around));
    assert_converged(&bowls, [641, 2_561, 10_241]);
}
