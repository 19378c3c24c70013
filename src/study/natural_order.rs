//! The order in which a person counts files and subjects: `g2` before `g10`.

use std::cmp::Ordering;

/// Compares runs of digits as numbers and everything else letter by letter, capitals as small
/// letters; names that differ only so are ordered as text.
pub fn natural_order(a: &str, b: &str) -> Ordering {
    let (mut left, mut right) = (a, b);
    loop {
        match (left.chars().next(), right.chars().next()) {
            (None, None) => return a.cmp(b),
            (None, _) => return Ordering::Less,
            (_, None) => return Ordering::Greater,
            (Some(x), Some(y)) if x.is_ascii_digit() && y.is_ascii_digit() => {
                let (number, other) = (leading_digits(left), leading_digits(right));
                match compare_numbers(number, other) {
                    Ordering::Equal => {
                        left = &left[number.len()..];
                        right = &right[other.len()..];
                    }
                    unequal => return unequal,
                }
            }
            (Some(x), Some(y)) => match x.to_lowercase().cmp(y.to_lowercase()) {
                Ordering::Equal => {
                    left = &left[x.len_utf8()..];
                    right = &right[y.len_utf8()..];
                }
                unequal => return unequal,
            },
        }
    }
}

fn leading_digits(text: &str) -> &str {
    let end = text
        .find(|c: char| !c.is_ascii_digit())
        .unwrap_or(text.len());
    &text[..end]
}

/// Numbers of any length, without turning them into integers that could overflow.
fn compare_numbers(a: &str, b: &str) -> Ordering {
    let (a, b) = (a.trim_start_matches('0'), b.trim_start_matches('0'));
    a.len().cmp(&b.len()).then_with(|| a.cmp(b))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn two_comes_before_ten() {
        let mut names = ["g10", "g2", "G1", "a_3", "g01b"];
        names.sort_by(|a, b| natural_order(a, b));
        assert_eq!(names, ["a_3", "G1", "g01b", "g2", "g10"]);
    }

    #[test]
    fn numbers_longer_than_any_integer_are_compared() {
        let (small, large) = ("1".repeat(50), "2".repeat(50));
        assert_eq!(natural_order(&small, &large), Ordering::Less);
    }

    proptest! {
        #[test]
        fn the_order_is_total(names in prop::collection::vec("[a-cA-C0-2é_]{0,6}", 3)) {
            let [a, b, c] = [&names[0], &names[1], &names[2]];
            prop_assert_eq!(natural_order(a, b), natural_order(b, a).reverse());
            if natural_order(a, b).is_le() && natural_order(b, c).is_le() {
                prop_assert!(natural_order(a, c).is_le());
            }
        }
    }
}
