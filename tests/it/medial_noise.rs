//! How atoms stand noise on the vertices: the table by which the default smoothing was chosen.

use cardiomorph::analysis::medial::{MedialParams, MedialSurface, medial_surface};
use cardiomorph::mesh::{Point3, TriMesh, Vector3, phantom};
use cardiomorph::progress::Progress;

const THICKNESS: f64 = 8.0;

/// Uniform noise of this standard deviation on every coordinate, the same every time.
fn rough(mesh: &TriMesh, sigma: f64, seed: f64) -> TriMesh {
    let draw = |k: f64| {
        let x = (k * 12.9898 + seed * 78.233).sin() * 43758.5453;
        3_f64.sqrt() * sigma * (2.0 * (x - x.floor()) - 1.0)
    };
    let points: Vec<Point3> = (mesh.vertices().iter().enumerate())
        .map(|(vertex, point)| {
            let first = 3.0 * vertex as f64;
            point + Vector3::new(draw(first), draw(first + 1.0), draw(first + 2.0))
        })
        .collect();
    TriMesh::new(points, mesh.faces().clone()).unwrap()
}

/// Root mean squares of the error of radii, in percent, and of the angle of normals, in degrees, and the number of ends.
fn errors(surface: &MedialSurface) -> (f64, f64, usize) {
    let count = surface.atoms.len() as f64;
    let half = 0.5 * THICKNESS;
    let radii = surface
        .atoms
        .iter()
        .map(|a| (a.radius / half - 1.0).powi(2));
    let turns = (surface.normals.iter().zip(&surface.atoms))
        .map(|(normal, atom)| normal.angle(&atom.position.coords).to_degrees().powi(2));
    (
        100.0 * (radii.sum::<f64>() / count).sqrt(),
        (turns.sum::<f64>() / count).sqrt(),
        surface.end.iter().flatten().count(),
    )
}

#[test]
#[ignore = "prints a table"]
fn the_default_smoothing_is_chosen_by_this_table() {
    for level in [3, 4, 5] {
        for percent in [0.0, 1.0, 2.5, 5.0] {
            let sigma = percent / 100.0 * THICKNESS;
            let [endo, epi] = [(20.0, 0.5), (20.0 + THICKNESS, 9.5)]
                .map(|(radius, seed)| rough(&phantom::sphere(level, radius), sigma, seed));
            for smoothing in [0.0, 0.125, 0.25, 0.3, 0.375, 0.5] {
                let params = MedialParams {
                    smoothing,
                    ..MedialParams::default()
                };
                let params = params.check().unwrap();
                let found = medial_surface(&endo, &[&epi], &params, &Progress::default());
                let Ok(found) = found else {
                    println!("level {level}, noise {percent} %, smoothing {smoothing}: no wall");
                    continue;
                };
                let (radius, normal, ends) = errors(&found);
                println!(
                    "level {level}, noise {percent} %, smoothing {smoothing}: radius {radius:.2} %, \
                     normal {normal:.2}°, {ends} false ends"
                );
            }
        }
    }
}
