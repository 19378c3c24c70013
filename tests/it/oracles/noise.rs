//! Noise against the published table, numpy's scales and the moments of closed form.

use super::*;
use cardiomorph::analysis::experiments::{
    NoiseFamily, NoiseReference, coordinate_variance, noise_sigma, published_tau,
};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

#[test]
fn the_targets_are_those_of_table_3_1() {
    let case = Case::load("noise", "targets");
    let table = &case.value["expected"]["table_3_1"];
    let column = |name: &str| -> Vec<f64> {
        let values = table[name].as_array().unwrap().iter();
        values.map(|v| v.as_f64().unwrap()).collect()
    };
    for (family, name) in NoiseFamily::ALL
        .into_iter()
        .zip(["uniform", "gaussian", "poisson"])
    {
        for (percent, expected) in column("percent").into_iter().zip(column(name)) {
            let found = 100.0 * published_tau(family, percent).unwrap();
            assert!((found - expected).abs() < 1e-12, "{name} {percent}");
        }
        assert_eq!(published_tau(family, 3.0), None);
    }
}

#[test]
fn levels_are_shares_of_the_variance_that_numpy_finds() {
    for name in ["scale_ico162", "scale_torus200"] {
        let case = Case::load("noise", name);
        let (points, _) = case.input_mesh("mesh");
        let expected = &case.value["expected"];
        let variance = expected["signal_variance_per_coordinate"].as_f64().unwrap();
        assert!((coordinate_variance(&points) / variance - 1.0).abs() < 1e-12);
        for row in expected["rows_percent_var_sigma_uniformhalfwidth"]
            .as_array()
            .unwrap()
        {
            let at = |column: usize| row[column].as_f64().unwrap();
            let sigma = noise_sigma(std::slice::from_ref(&points), at(0), NoiseReference::Shape);
            assert!((sigma / at(2) - 1.0).abs() < 1e-12, "{name} {}", at(0));
            assert!((3.0_f64.sqrt() * sigma / at(3) - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn draws_have_the_moments_of_their_family() {
    const DRAWS: usize = 200_000;
    let case = Case::load("noise", "moments");
    let sigma = case.value["inputs"]["sigma"].as_f64().unwrap();
    for (family, skewness, kurtosis) in [
        (NoiseFamily::Uniform, 0.0, -1.2),
        (NoiseFamily::Gaussian, 0.0, 0.0),
        (NoiseFamily::Poisson, 0.1_f64.sqrt(), 0.1),
    ] {
        let mut random = ChaCha8Rng::seed_from_u64(11);
        let draws: Vec<f64> = (0..DRAWS)
            .map(|_| family.draw(sigma, &mut random))
            .collect();
        let mean = draws.iter().sum::<f64>() / DRAWS as f64;
        let central =
            |power: i32| draws.iter().map(|x| (x - mean).powi(power)).sum::<f64>() / DRAWS as f64;
        let (variance, name) = (central(2), family.name());
        assert!(mean.abs() <= 0.01 * sigma, "{name} {mean}");
        assert!(
            (variance / sigma.powi(2) - 1.0).abs() <= 0.015,
            "{name} {variance}"
        );
        let (skew, kurt) = (
            central(3) / variance.powf(1.5),
            central(4) / variance.powi(2) - 3.0,
        );
        assert!((skew - skewness).abs() <= 0.05, "{name} {skew}");
        assert!((kurt - kurtosis).abs() <= 0.05, "{name} {kurt}");
        let largest = draws.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        if family == NoiseFamily::Uniform {
            assert!(largest <= 3.0_f64.sqrt() * sigma);
        }
        if family == NoiseFamily::Poisson {
            // All on the lattice σ (k − 10) / √10.
            let off = |x: &f64| {
                let k = x / sigma * 10.0_f64.sqrt();
                (k - k.round()).abs()
            };
            assert!(draws.iter().all(|x| off(x) < 1e-9));
        }
    }
}
