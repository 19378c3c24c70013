//! Solves with small dense symmetric positive definite matrices, many different ones after one another.

/// Replaces a symmetric positive definite matrix, given row by row, by its factor: A = L Lᵀ.
///
/// Only the lower triangle of the `size` rows is read and written. No memory is asked for: this is for loops
/// over very many small matrices. A pivot that is not positive becomes the least positive number, so that
/// the factor stays finite: the caller's matrix is definite but for round-off.
///
/// Source: Golub and Van Loan, *Matrix Computations*, 4th ed., section 4.2.5.
pub fn factorise_positive(matrix: &mut [f64], size: usize) {
    for i in 0..size {
        for j in 0..=i {
            let (before, row) = matrix.split_at_mut(i * size);
            if i == j {
                let along: f64 = row[..j].iter().map(|x| x * x).sum();
                row[j] = (row[j] - along).max(f64::MIN_POSITIVE).sqrt();
            } else {
                let other = &before[j * size..][..=j];
                let along: f64 = row[..j].iter().zip(other).map(|(x, y)| x * y).sum();
                row[j] = (row[j] - along) / other[j];
            }
        }
    }
}

/// Replaces b by L⁻¹ b, L a factor of [`factorise_positive`]; |L⁻¹ b|² is bᵀ A⁻¹ b.
pub fn solve_lower(factor: &[f64], b: &mut [f64]) {
    let size = b.len();
    for i in 0..size {
        let row = &factor[i * size..][..=i];
        let known: f64 = row[..i].iter().zip(&*b).map(|(x, y)| x * y).sum();
        b[i] = (b[i] - known) / row[i];
    }
}

/// Replaces b by A⁻¹ b, from the factor of A that [`factorise_positive`] makes.
pub fn solve_positive(factor: &[f64], b: &mut [f64]) {
    solve_lower(factor, b);
    let size = b.len();
    for i in (0..size).rev() {
        let known: f64 = (i + 1..size).map(|j| factor[j * size + i] * b[j]).sum();
        b[i] = (b[i] - known) / factor[i * size + i];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_factor_is_that_of_the_text_book() {
        // Entries above the diagonal are not looked at.
        let mut a = [4.0, 9.0, 9.0, 12.0, 37.0, 9.0, -16.0, -43.0, 98.0];
        factorise_positive(&mut a, 3);
        assert_eq!(a, [2.0, 9.0, 9.0, 6.0, 1.0, 9.0, -8.0, 5.0, 3.0]);
        let mut b = [2.0, 7.0, 0.0];
        solve_lower(&a, &mut b);
        assert_eq!(b, [1.0, 1.0, 1.0]);
    }

    #[test]
    fn a_matrix_that_is_singular_by_round_off_has_a_finite_factor() {
        let mut a = [1.0, 1.0, 1.0, 1.0 - f64::EPSILON];
        factorise_positive(&mut a, 2);
        assert!(a.iter().all(|entry| entry.is_finite()) && a[3] > 0.0);
        factorise_positive(&mut [], 0);
        solve_positive(&[], &mut []);
    }

    proptest! {
        #[test]
        fn a_solution_put_back_gives_the_right_hand_side(
            size in 1_usize..9,
            entries in prop::collection::vec(-1.0_f64..1.0, 64),
            right in prop::collection::vec(-1.0_f64..1.0, 8),
        ) {
            // B Bᵀ + 1: definite, with eigenvalues of 1 to 65.
            let a: Vec<f64> = (0..size * size)
                .map(|at| {
                    let (i, j) = (at / size, at % size);
                    let along: f64 = (0..8).map(|k| entries[i * 8 + k] * entries[j * 8 + k]).sum();
                    along + f64::from(u8::from(i == j))
                })
                .collect();
            let (mut factor, mut x) = (a.clone(), right[..size].to_vec());
            factorise_positive(&mut factor, size);
            solve_positive(&factor, &mut x);
            for (row, b) in a.chunks(size).zip(&right) {
                let image: f64 = row.iter().zip(&x).map(|(a, x)| a * x).sum();
                prop_assert!((image - b).abs() < 1e-13);
            }
            let mut half = right[..size].to_vec();
            solve_lower(&factor, &mut half);
            let norm2: f64 = half.iter().map(|x| x * x).sum();
            let product: f64 = x.iter().zip(&right).map(|(x, b)| x * b).sum();
            prop_assert!((norm2 - product).abs() < 1e-13);
        }
    }
}
