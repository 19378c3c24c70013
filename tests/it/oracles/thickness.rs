//! Laplace's equation in a wall of voxels against scipy and pyezzi.

use cardiomorph::analysis::thickness_methods::{LabelGrid, VoxelLabel, laplace_field};
use cardiomorph::progress::Progress;

use super::Case;

fn mean_and_spread(values: &[f64]) -> [f64; 2] {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    [mean, (squares / count).sqrt()]
}

#[test]
fn potential_and_field_lines_of_a_shell_are_those_of_scipy_and_pyezzi() {
    let case = Case::load("laplace", "laplace_sphere_0");
    let raw = std::fs::read(case.folder.join("laplace_sphere_0.in_labels.raw")).unwrap();
    let labels = (raw.as_chunks::<4>().0.iter())
        .map(|&bytes| match f32::from_le_bytes(bytes) {
            2.0 => VoxelLabel::Cavity,
            1.0 => VoxelLabel::Wall,
            _ => VoxelLabel::Outside,
        })
        .collect();
    let grid = LabelGrid::new([28; 3], [1.0; 3], labels).unwrap();
    let field = laplace_field(&grid, &Progress::default()).unwrap();
    let expected = &case.value["expected"];
    let number = |name: &str| expected[name].as_f64().unwrap();
    assert_eq!(grid.wall_voxels() as f64, number("n_wall"));
    let [mean, _] = mean_and_spread(&field.potential);
    assert!((mean - number("laplace_u_mean")).abs() < 1e-6, "{mean}");
    let at_radius = |values: &[f64], radius: f64, half: f64| -> Vec<f64> {
        let away = |voxel: u32| {
            let v = voxel as usize;
            let square = |x: usize| (x as f64 - 13.5).powi(2);
            (square(v % 28) + square(v / 28 % 28) + square(v / 784)).sqrt()
        };
        (field.voxels.iter().zip(values))
            .filter(|(voxel, _)| (away(**voxel) - radius).abs() < half)
            .map(|(_, &value)| value)
            .collect()
    };
    let profile = expected["laplace_u_radial_profile"].as_array().unwrap();
    for (radius, expected) in (6..).zip(profile) {
        let [found, _] = mean_and_spread(&at_radius(&field.potential, f64::from(radius), 0.5));
        assert!(
            (found - expected.as_f64().unwrap()).abs() < 1e-5,
            "{radius} {found}"
        );
    }
    // Far closer than was asked for: both solve the same difference equations.
    let [mean, spread] = mean_and_spread(&field.thickness);
    assert!((mean - number("pyezzi_mean")).abs() < 1e-7, "{mean}");
    assert!((spread - number("pyezzi_std")).abs() < 1e-7, "{spread}");
    let [mean, spread] = mean_and_spread(&at_radius(&field.thickness, 8.5, 0.75));
    assert!((mean - number("pyezzi_mid_mean")).abs() < 0.35, "{mean}");
    assert!((mean - number("analytic_thickness")).abs() < 0.6, "{mean}");
    assert!(spread <= 2.0 * number("pyezzi_mid_std"), "{spread}");
}
