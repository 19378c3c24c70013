//! How well scores separate two classes.

/// Area under the ROC curve: the probability that a positive case has a higher score than a negative one, a draw
/// counting half (Mann and Whitney's U over the number of pairs); one half where a class is empty.
pub(super) fn auc(scores: &[f64], positive: &[bool]) -> f64 {
    let mut order: Vec<usize> = (0..scores.len()).collect();
    order.sort_by(|&i, &j| scores[i].total_cmp(&scores[j]));
    let (mut below, mut pairs) = (0_usize, 0.0);
    let mut at = 0;
    while at < order.len() {
        let equal = order[at..]
            .iter()
            .take_while(|&&i| scores[i] == scores[order[at]])
            .count();
        // Not a number equals nothing, itself included.
        let group = &order[at..at + equal.max(1)];
        let ups = group.iter().filter(|&&i| positive[i]).count();
        let downs = group.len() - ups;
        // Equal scores count half: neither order is right or wrong.
        pairs += ups as f64 * (below as f64 + 0.5 * downs as f64);
        below += downs;
        at += group.len();
    }
    let ups = positive.iter().filter(|&&up| up).count();
    if ups == 0 || below == 0 {
        0.5
    } else {
        pairs / (ups * below) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn one_class_above_the_other_is_one_and_draws_count_half() {
        assert_eq!(auc(&[1.0, 2.0, 3.0, 4.0], &[false, false, true, true]), 1.0);
        assert_eq!(
            auc(&[1.0, 2.0, 3.0, 4.0], &[true, false, true, false]),
            0.25
        );
        assert_eq!(auc(&[5.0; 4], &[true, false, true, false]), 0.5);
        assert_eq!(auc(&[1.0, 2.0], &[true, true]), 0.5);
    }

    proptest! {
        #[test]
        fn it_counts_pairs(scores in prop::collection::vec(0_u8..6, 14)) {
            let positive: Vec<bool> = (0..14).map(|i| i % 3 == 0).collect();
            let scores: Vec<f64> = scores.into_iter().map(f64::from).collect();
            let mut pairs = Vec::new();
            for i in (0..14).filter(|&i| positive[i]) {
                for j in (0..14).filter(|&j| !positive[j]) {
                    let difference = scores[i] - scores[j];
                    pairs.push(if difference == 0.0 { 0.5 } else { f64::from(u8::from(difference > 0.0)) });
                }
            }
            let mean = pairs.iter().sum::<f64>() / pairs.len() as f64;
            prop_assert!((auc(&scores, &positive) - mean).abs() < 1e-12);
        }
    }
}
