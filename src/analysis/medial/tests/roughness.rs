//! Noise of surfaces, told from themselves, and what is done for it.

use proptest::prelude::*;

use super::*;
use crate::analysis::medial::connectivity::Connectivity;
use crate::analysis::medial::roughness::Roughness;

fn noise_of(mesh: &TriMesh) -> f64 {
    let connectivity = Connectivity::new(&[vec![mesh]]).unwrap();
    Roughness::new(&connectivity).of(&connectivity, mesh.vertices())
}

/// Uniform noise on every coordinate.
fn with_noise(mesh: &TriMesh, sigma: f64, seed: f64) -> TriMesh {
    rough(mesh, 3.0_f64.sqrt() * sigma, seed)
}

fn shell(sigma: f64) -> [TriMesh; 2] {
    [(20.0, 0.5), (28.0, 9.5)]
        .map(|(radius, seed)| with_noise(&phantom::sphere(4, radius), sigma, seed))
}

#[test]
fn the_noise_that_is_told_is_the_noise_that_was_added() {
    for sigma in [0.05, 0.2, 0.5, 1.0] {
        let found = noise_of(&with_noise(&phantom::sphere(4, 20.0), sigma, 0.3));
        assert!((found / sigma - 1.0).abs() < 0.12, "{sigma}: {found}");
        let found = noise_of(&with_noise(&phantom::bowl(20.0, 24, 48), sigma, 0.7));
        assert!((found / sigma - 1.0).abs() < 0.2, "bowl, {sigma}: {found}");
    }
}

#[test]
fn smooth_surfaces_have_hardly_any_noise_and_no_more_smoothing_than_is_asked() {
    for mesh in [
        phantom::sphere(3, 20.0),
        phantom::sphere(4, 20.0),
        phantom::bowl(20.0, 12, 24),
        phantom::bowl(20.0, 24, 48),
    ] {
        let found = noise_of(&mesh);
        assert!(found < 0.04, "{} vertices: {found}", mesh.vertices().len());
    }
    let [endo, epi] = shell(0.0);
    let clean = surface(&endo, &[&epi], &usual()).unwrap();
    let error = |atom: &Atom| (atom.radius / 4.0 - 1.0).abs();
    assert!(clean.atoms.iter().map(error).fold(0.0, f64::max) < 0.002);
}

#[test]
fn radii_of_a_shell_stay_within_two_percent_under_noise_of_a_twentieth_of_its_thickness() {
    let [endo, epi] = shell(0.4);
    let found = surface(&endo, &[&epi], &usual()).unwrap();
    let count = found.atoms.len() as f64;
    let mean = |value: &dyn Fn(&Atom) -> f64| found.atoms.iter().map(value).sum::<f64>() / count;
    let error = mean(&|atom| (atom.radius / 4.0 - 1.0).powi(2)).sqrt();
    let bias = mean(&|atom| atom.radius / 4.0 - 1.0);
    assert!(error < 0.02 && bias.abs() < 0.01, "{error} {bias}");
    let turns = (found.normals.iter().zip(&found.atoms))
        .map(|(normal, atom)| normal.angle(&atom.position.coords).powi(2));
    let turn = (turns.sum::<f64>() / count).sqrt().to_degrees();
    assert!(turn < 2.0, "{turn}");
    assert!(found.end.iter().all(Option::is_none));
}

#[test]
fn noise_as_large_as_the_wall_gives_no_answer_or_finite_atoms() {
    for sigma in [4.0, 8.0, 16.0] {
        let [endo, epi] = shell(sigma);
        match surface(&endo, &[&epi], &usual()) {
            Ok(found) => assert!(all_finite(&found)),
            Err(error) => {
                let words = error.to_string();
                let reported = words.starts_with("noise: vertices are off by")
                    || words.contains("no inscribed sphere");
                assert!(reported, "{words}");
            }
        }
    }
}

#[test]
fn a_stopped_plan_stops() {
    let [endo, epi] = shell(0.4);
    let progress = Progress::default();
    progress.stop();
    let found = medial_surface(&endo, &[&epi], &usual(), &progress);
    assert!(matches!(found, Err(MedialError::Stopped(_))));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn noise_turns_and_grows_with_the_surface(
        angles in prop::array::uniform3(-3.0..3.0_f64), scale in 0.01..100.0_f64,
    ) {
        let mesh = with_noise(&phantom::sphere(3, 20.0), 0.3, 0.2);
        let turn = nalgebra::Rotation3::from_euler_angles(angles[0], angles[1], angles[2]);
        let there = moved(&mesh, |_, p| turn * (scale * p));
        prop_assert!((scale * noise_of(&mesh) / noise_of(&there) - 1.0).abs() < 1e-9);
    }
}
