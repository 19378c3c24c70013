//! The middle of numbers in any order.

/// The value in the middle, the mean of both of an even number; `None` without values.
pub fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_unstable_by(f64::total_cmp);
    let upper = *values.get(values.len() / 2)?;
    Some(0.5 * (values[(values.len() - 1) / 2] + upper))
}

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
    fn of_an_even_number_the_median_is_the_mean_of_both_in_the_middle() {
        assert_eq!(median(vec![3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(vec![4.0, 1.0, 3.0, 2.0]), Some(2.5));
        assert_eq!(median(Vec::new()), None);
    }

    #[test]
    fn it_is_the_middle_value_or_the_lower_of_two() {
        assert_eq!(lower_median(vec![3.0, 1.0, 2.0]), 2.0);
        assert_eq!(lower_median(vec![4.0, 1.0, 3.0, 2.0]), 2.0);
        assert_eq!(lower_median(Vec::new()), 0.0);
    }
}
