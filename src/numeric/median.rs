//! The middle of numbers in any order.

/// The lower median, which is one of the values; 0 without values.
pub fn lower_median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = (values.len() - 1) / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_middle_value_or_the_lower_of_two() {
        assert_eq!(lower_median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(lower_median(vec![4.0, 1.0, 3.0, 2.0]), 2.0);
        assert_eq!(lower_median(Vec::new()), 0.0);
    }
}
