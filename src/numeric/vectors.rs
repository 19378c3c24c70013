//! Inner products and sums of long vectors.

/// Sums run in as many lanes, so that additions need not wait for each other.
const LANES: usize = 8;

/// Σ aᵢ bᵢ of vectors of equal length.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (a, rest_a) = a.as_chunks::<LANES>();
    let (b, rest_b) = b.as_chunks::<LANES>();
    let mut sums = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            sums[lane] += a[lane] * b[lane];
        }
    }
    let rest: f64 = rest_a.iter().zip(rest_b).map(|(a, b)| a * b).sum();
    sums.iter().sum::<f64>() + rest
}

/// Adds `factor` · `source` to `target`, of equal length.
pub fn add_scaled(target: &mut [f64], factor: f64, source: &[f64]) {
    for (t, s) in target.iter_mut().zip(source) {
        *t += factor * s;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_and_sums_of_any_length_are_those_of_the_plain_loop() {
        for size in [0, 1, 7, 8, 9, 16, 21] {
            // Small whole numbers: no order of summation rounds.
            let a: Vec<f64> = (0..size).map(|i| f64::from(i % 5) - 2.0).collect();
            let b: Vec<f64> = (0..size).map(|i| f64::from(i * i % 7) + 1.0).collect();
            let sum: f64 = a.iter().zip(&b).map(|(x, y)| x * y).sum();
            assert_eq!(dot(&a, &b), sum);
            let mut target = a.clone();
            add_scaled(&mut target, 3.0, &b);
            assert!((0..size as usize).all(|i| target[i] == a[i] + 3.0 * b[i]));
        }
    }
}
